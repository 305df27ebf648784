// 16#0131: what a CPU offers to programming devices.
#include <span>

#include "system/szl.h"

namespace merker::system {
namespace {

// Test and installation functions by the number of their subfunction (docs/compatibility.md).
constexpr std::uint8_t kTestFunctions[] = {0x01, 0x02, 0x03, 0x04, 0x05, 0x08, 0x09, 0x0C,
                                           0x0D, 0x0E, 0x0F, 0x10, 0x11, 0x12, 0x13};
// Trigger events: at once, system trigger, begin and end of the cycle, transition to STOP, area of
// code addresses.
constexpr std::uint8_t kTriggers[] = {0, 1, 2, 3, 4, 6};

void addBits(SzlList& list, std::span<const std::uint8_t> bits, std::size_t bytes) {
  const std::size_t begin = list.data.size();
  list.data.resize(begin + bytes);
  for (const std::uint8_t bit : bits)
    list.data[begin + bit / 8] |= static_cast<std::uint8_t>(1u << bit % 8);
}

// INDEX 2: functions (6 bytes), 12 bytes, triggers (3 bytes).
void testFunctions(SzlList& list) {
  constexpr std::size_t kFunctions = 6, kSegments = 12, kEvents = 3;
  list.word(2);
  addBits(list, kTestFunctions, kFunctions);
  list.data.resize(list.data.size() + kSegments);
  addBits(list, kTriggers, kEvents);
  list.data.resize(list.recordLength);
}

}  // namespace

void szlOffers(const SzlSource& source, std::uint32_t index, SzlList& list) {
  index == 2 ? testFunctions(list) : szlConnections(source, index, list);
}

}  // namespace merker::system
