// The runs of a campaign, numbered: each combination of the listed values, and each of them with
// each seed. The first parameter changes slowest, the seed quickest.
#pragma once

#include <cstdint>
#include <vector>

#include "campaign/definition.h"

namespace merker::campaign {

struct Choice {
  std::uint64_t number = 0;   // from 0
  std::uint64_t seed = 0;     // 0: none
  std::vector<Value> values;  // of the parameters, in their order
};

Choice choiceAt(const Definition& definition, std::uint64_t number);
// "plant.Vessel.stroke=20, seed=3", for people.
std::string describe(const Definition& definition, const Choice& choice);

// One of several machines: 3/16 has the runs 3, 19, 35 ... (counted from 1).
struct Shard {
  std::uint64_t number = 1, count = 1;
  bool has(std::uint64_t run) const { return run % count == number - 1; }
};
// "3/16"; nothing if it is none of at most 1,000,000.
std::optional<Shard> parseShard(std::string_view text);

}  // namespace merker::campaign
