// SFC 0 SET_CLK, 1 READ_CLK, 64 TIME_TCK (S7-SFC-02, -22).
#include <algorithm>
#include <array>

#include "system/call.h"

namespace merker::system {
namespace {

// The date alone, with midnight as its time.
bool validDate(const std::uint8_t* dateAndTime) {
  std::array<std::uint8_t, 8> midnight{};
  std::copy_n(dateAndTime, 3, midnight.begin());
  midnight[7] = dateAndTime[7] & 0x0F;  // day of the week
  return cpu::fromDateAndTime(midnight.data()).has_value();
}

}  // namespace

void setClock(Sfc<0>& a) {
  const Region time = a.composite("PDT", 8, cpu::Access::Read);
  if (!time) return a.parameterError("PDT", time.error);
  const auto milliseconds = cpu::fromDateAndTime(time.data);
  constexpr std::uint32_t kWrongDate = 0x8080, kWrongTime = 0x8081;
  if (!milliseconds) return a.status(validDate(time.data) ? kWrongTime : kWrongDate);
  a.cpu().setClock(*milliseconds);
  a.status(0);
}

void readClock(Sfc<1>& a) {
  const Region time = a.composite("CDT", 8, cpu::Access::Write);
  if (!time) return a.parameterError("CDT", time.error);
  const auto now = cpu::toDateAndTime(a.cpu().clock().milliseconds(a.machine().clock));
  std::copy(now.begin(), now.end(), time.data);
  a.status(0);
}

// 0 … 2147483647 ms since the last warm or cold restart, then from 0 again; stands still in STOP.
void timeTick(Sfc<64>& a) {
  a.set("RET_VAL", static_cast<std::uint32_t>(a.cpu().systemTime().ns / 1'000'000 & 0x7FFFFFFF));
}

}  // namespace merker::system
