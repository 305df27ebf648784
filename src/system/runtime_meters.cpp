// SFC 2 SET_RTM, 3 CTRL_RTM, 4 READ_RTM (S7-SFC-03, S7-CPU-32).
#include "system/arguments.h"

namespace merker::system {
namespace {

cpu::RuntimeMeter* meterOf(Arguments& a) {
  constexpr std::uint32_t kUnknown = 0x8080;
  const std::uint32_t number = a.value(0);
  auto& meters = a.cpu().runtimeMeters();
  if (number < meters.size()) return &meters[number];
  a.status(kUnknown);
  return nullptr;
}

}  // namespace

void setRuntimeMeter(Arguments& a) {
  constexpr std::uint32_t kNegative = 0x8081;
  cpu::RuntimeMeter* meter = meterOf(a);
  if (meter == nullptr) return;
  const std::int32_t hours = a.integer(1);
  if (hours < 0) return a.status(kNegative);
  meter->set(hours, a.machine().clock);
  a.status(0);
}

void switchRuntimeMeter(Arguments& a) {
  cpu::RuntimeMeter* meter = meterOf(a);
  if (meter == nullptr) return;
  if (a.flag(1))
    meter->start(a.machine().clock);
  else
    meter->stop(a.machine().clock);
  a.status(0);
}

void readRuntimeMeter(Arguments& a) {
  enum { NR, CQ, CV };
  constexpr std::uint32_t kOverflow = 0x8081;
  const cpu::RuntimeMeter* meter = meterOf(a);
  if (meter == nullptr) return;
  const Instant now = a.machine().clock;
  a.set(CQ, meter->running);
  a.set(CV, static_cast<std::uint32_t>(meter->hours(now)));
  a.status(meter->overflow(now) ? kOverflow : 0);
}

}  // namespace merker::system
