#include "cpu/start_information.h"

#include <algorithm>

#include "base/bytes.h"

namespace merker::cpu {

StartInformation startInformation(std::uint8_t eventClass, std::uint8_t eventNumber,
                                  std::uint8_t priority, std::uint8_t ob, const DateAndTime& time) {
  StartInformation info{eventClass, eventNumber, priority, ob};
  std::copy(time.begin(), time.end(), info.begin() + kDateInStart);
  return info;
}

void setByte(StartInformation& info, unsigned at, unsigned value) {
  info[at] = static_cast<std::uint8_t>(value);
}
void setWord(StartInformation& info, unsigned at, std::uint32_t value) {
  storeWord(&info[at], value);
}
void setDWord(StartInformation& info, unsigned at, std::uint32_t value) {
  storeDWord(&info[at], value);
}

StartInformation errorInformation(const SyncError& error, std::uint8_t priority, BlockId block,
                                  std::uint32_t offset, const DateAndTime& time) {
  const bool access = error.peripheral();
  StartInformation info =
      startInformation(access ? 0x29 : 0x25, static_cast<std::uint8_t>(error.code), priority,
                       access ? 122 : 121, time);
  setByte(info, 4, 0x80u | static_cast<unsigned>(block.kind));  // 88 OB, 8C FC, 8E FB
  setByte(info, 5, error.accessByte());
  setWord(info, 6, error.detail);
  setWord(info, 8, block.number);
  setWord(info, 10, offset);
  return info;
}

std::uint8_t priorityOf(std::uint8_t ob) {
  struct Row {
    std::uint8_t first, last, priority, step;
  };
  constexpr Row kRows[] = {{1, 1, 1, 0},    {10, 17, 2, 0},  {20, 23, 3, 1},
                           {30, 38, 7, 1},  {40, 47, 16, 1}, {50, 51, 24, 0},
                           {60, 60, 25, 0}, {80, 87, 26, 0}, {100, 102, 27, 0}};
  for (const Row& row : kRows)
    if (ob >= row.first && ob <= row.last)
      return static_cast<std::uint8_t>(row.priority + (ob - row.first) * row.step);
  return 0;
}

}  // namespace merker::cpu
