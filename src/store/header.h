// Whether a file may be opened as a memory card, seen from its first bytes alone: somebody else's
// file is not even touched.
#pragma once

#include <cstdint>
#include <string>

namespace merker::store {

// In the header of the database: "MRKC", and the version of docs/formats/card.md.
constexpr std::uint32_t kApplicationId = 0x4D524B43;
constexpr std::int64_t kFormat = 1;

// Why not; empty if it may, or if there is no such file yet.
std::string whyNoCard(const std::string& file);

}  // namespace merker::store
