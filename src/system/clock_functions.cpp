// SFC 0 SET_CLK, 1 READ_CLK, 64 TIME_TCK (S7-SFC-02, -22).
#include <algorithm>

#include "system/arguments.h"

namespace merker::system {
namespace {

void setClock(Arguments& a) {
  const Region time = a.composite(0, 8, cpu::Access::Read);
  if (!time) return a.parameterError(0, time.error);
  const auto milliseconds = cpu::fromDateAndTime(time.data);
  constexpr std::uint32_t kInvalid = 0x8080;
  if (!milliseconds) return a.status(kInvalid);
  a.cpu().setClock(*milliseconds);
  a.status(0);
}

void readClock(Arguments& a) {
  const Region time = a.composite(0, 8, cpu::Access::Write);
  if (!time) return a.parameterError(0, time.error);
  const auto now = cpu::toDateAndTime(a.cpu().clock().milliseconds(a.machine().clock));
  std::copy(now.begin(), now.end(), time.data);
  a.status(0);
}

// 0 … 2147483647 ms, then from 0 again.
void timeTick(Arguments& a) {
  a.set(0, static_cast<std::uint32_t>(a.machine().clock.ns / 1'000'000 & 0x7FFFFFFF));
}

}  // namespace

Functions clockFunctions() {
  using enum TypeCode;
  return {{BlockKind::SFC,
           0,
           "SET_CLK",
           {{"PDT", kIn, DateAndTime}, {"RET_VAL", kReturn, Int}},
           setClock},
          {BlockKind::SFC,
           1,
           "READ_CLK",
           {{"CDT", kOut, DateAndTime}, {"RET_VAL", kReturn, Int}},
           readClock},
          {BlockKind::SFC, 64, "TIME_TCK", {{"RET_VAL", kReturn, Time}}, timeTick}};
}

}  // namespace merker::system
