#include "plant/axis_inputs.h"

#include <algorithm>
#include <iterator>

namespace merker::plant {
namespace {

// As printed in the technology manual 4.2.4: Q0 Q1 Q2 Q3 (POS-PLANT-08).
struct Row {
  std::uint8_t type;
  const char* pattern;
  Stage stage;
};
constexpr Row kRows[] = {
    {1, "1010", Stage::RapidPlus},  {1, "1001", Stage::RapidMinus}, {1, "0110", Stage::CreepPlus},
    {1, "0101", Stage::CreepMinus}, {2, "1010", Stage::RapidPlus},  {2, "1001", Stage::RapidMinus},
    {2, "0010", Stage::CreepPlus},  {2, "0001", Stage::CreepMinus}, {3, "1110", Stage::RapidPlus},
    {3, "1101", Stage::RapidMinus}, {3, "0110", Stage::CreepPlus},  {3, "0101", Stage::CreepMinus},
    {4, "1100", Stage::RapidPlus},  {4, "0011", Stage::RapidMinus}, {4, "0100", Stage::CreepPlus},
    {4, "0001", Stage::CreepMinus},
};

constexpr std::uint8_t bitsOf(const char* pattern) {
  std::uint8_t bits = 0;
  for (unsigned i = 0; i < 4; ++i)
    if (pattern[i] == '1') bits = static_cast<std::uint8_t>(bits | 1u << i);
  return bits;
}

}  // namespace

Stage stageOf(std::uint8_t controlType, std::uint8_t contactors) {
  const auto found = std::find_if(std::begin(kRows), std::end(kRows), [&](const Row& row) {
    return row.type == controlType && bitsOf(row.pattern) == contactors;
  });
  return found == std::end(kRows) ? Stage::Off : found->stage;
}

}  // namespace merker::plant
