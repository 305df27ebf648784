// The 20 bytes that every OB finds at the beginning of its local data (S7-OBI).
#pragma once

#include <array>
#include <cstdint>

#include "address/block_id.h"
#include "cpu/error.h"
#include "cpu/real_time_clock.h"

namespace merker::cpu {

using StartInformation = std::array<std::uint8_t, 20>;
// Where the date and time are in it (S7-OBI-01).
constexpr std::uint32_t kDateInStart = 12;
// Whether these bytes of the local data of an OB have a part of them.
constexpr bool touchesDate(std::uint32_t byte, std::uint32_t bytes) {
  return byte < kDateInStart + std::tuple_size_v<DateAndTime> && byte + bytes > kDateInStart;
}

// Bytes 0..3 and 12..19, the same for all (S7-OBI-01).
StartInformation startInformation(std::uint8_t eventClass, std::uint8_t eventNumber,
                                  std::uint8_t priority, std::uint8_t ob, const DateAndTime& time);

// Puts a value of 1, 2 or 4 bytes at its place.
void setByte(StartInformation& info, unsigned at, unsigned value);
void setWord(StartInformation& info, unsigned at, std::uint32_t value);
void setDWord(StartInformation& info, unsigned at, std::uint32_t value);

// OB 121 and OB 122 (S7-OBI-13, -15).
StartInformation errorInformation(const SyncError& error, std::uint8_t priority, BlockId block,
                                  std::uint32_t offset, const DateAndTime& time);

// Priority classes (course 5.1; S7-BLK-07 … -16). 0 = there is no such OB.
std::uint8_t priorityOf(std::uint8_t ob);

}  // namespace merker::cpu
