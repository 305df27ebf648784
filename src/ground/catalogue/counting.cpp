#include "catalogue/counting.h"

namespace merker {
namespace {

// Channel of the terminal x.y
constexpr std::uint8_t at(unsigned byte, unsigned bit) {
  return static_cast<std::uint8_t>(8 * byte + bit);
}

constexpr CountingPins kPins312[] = {
    {{at(0, 0), 2}, {at(0, 1), 3}, {at(0, 2), 4}, {at(0, 6), 8}, {at(0, 0), 14}},
    {{at(0, 3), 5}, {at(0, 4), 6}, {at(0, 5), 7}, {at(0, 7), 9}, {at(0, 1), 15}},
};
// The 313C has the first three.
constexpr CountingPins kPins314[] = {
    {{at(0, 0), 2}, {at(0, 1), 3}, {at(0, 2), 4}, {at(1, 4), 16}, {at(0, 0), 22}},
    {{at(0, 3), 5}, {at(0, 4), 6}, {at(0, 5), 7}, {at(1, 5), 17}, {at(0, 1), 23}},
    {{at(0, 6), 8}, {at(0, 7), 9}, {at(1, 0), 12}, {at(1, 6), 18}, {at(0, 2), 24}},
    {{at(1, 1), 13}, {at(1, 2), 14}, {at(1, 3), 15}, {at(1, 7), 19}, {at(0, 3), 25}},
};
constexpr std::uint32_t kFrequencies[] = {60, 30, 10, 5, 2, 1};

constexpr std::span<const std::uint32_t> kAll(kFrequencies);
constexpr std::span<const CountingPins> kFour(kPins314);
constexpr CountingType k312{"X1", kPins312, kAll.subspan(2)};
constexpr CountingType k313{"X2", kFour.first(3), kAll.subspan(1)};
constexpr CountingType k3132{"X1", kFour.first(3), kAll.subspan(1)};
constexpr CountingType k314{"X2", kFour, kAll};

}  // namespace

// The on-board terminals tell the types apart: the 313C-2 has no analog ones.
const CountingType* countingType(const CpuModel& model) {
  switch (model.onBoard.counters) {
    case 2:
      return &k312;
    case 3:
      return model.onBoard.analogInputs > 0 ? &k313 : &k3132;
    case 4:
      return &k314;
    default:
      return nullptr;
  }
}

}  // namespace merker
