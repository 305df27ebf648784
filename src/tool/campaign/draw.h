// Values drawn for a seed: the same on every machine, whatever else a campaign varies
// (docs/compatibility.md, Campaigns).
#pragma once

#include <cstdint>
#include <string_view>

#include "campaign/definition.h"

namespace merker::campaign {

// Evenly in (0, 1), of 52 bits: the first eight bytes of the SHA-256 of "merker draw SEED NAME".
double evenly(std::uint64_t seed, std::string_view name);
// The value below which a standard normal variable stays with probability p, 0 < p < 1.
double normalQuantile(double p);
// In nine significant digits, so that libraries whose logarithm differs in the last bit agree.
double drawn(const Draw& draw, std::uint64_t seed, std::string_view name);
// For a generator of a plant.
std::uint32_t plantSeed(std::uint64_t seed, std::string_view name);

// The number of twelve significant digits next to it: 0.85, not 0.8500000000000001.
double shortened(double value);

}  // namespace merker::campaign
