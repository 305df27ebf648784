// SFC 2 SET_RTM, 3 CTRL_RTM, 4 READ_RTM (S7-SFC-03, S7-CPU-32).
#include "system/call.h"

namespace merker::system {
namespace {

template <typename A>
cpu::RuntimeMeter* meterOf(A& a) {
  constexpr std::uint32_t kUnknown = 0x8080;
  const std::uint32_t number = a.value("NR");
  auto& meters = a.cpu().runtimeMeters();
  if (number < meters.size()) return &meters[number];
  a.status(kUnknown);
  return nullptr;
}

}  // namespace

void setRuntimeMeter(Sfc<2>& a) {
  constexpr std::uint32_t kNegative = 0x8081;
  cpu::RuntimeMeter* meter = meterOf(a);
  if (meter == nullptr) return;
  const std::int32_t hours = a.integer("PV");
  if (hours < 0) return a.status(kNegative);
  meter->set(hours, a.machine().clock);
  a.status(0);
}

void switchRuntimeMeter(Sfc<3>& a) {
  cpu::RuntimeMeter* meter = meterOf(a);
  if (meter == nullptr) return;
  if (a.flag("S"))
    meter->start(a.machine().clock);
  else
    meter->stop(a.machine().clock);
  a.status(0);
}

void readRuntimeMeter(Sfc<4>& a) {
  constexpr std::uint32_t kOverflow = 0x8081;
  const cpu::RuntimeMeter* meter = meterOf(a);
  if (meter == nullptr) return;
  const Instant now = a.machine().clock;
  a.set("CQ", meter->running);
  a.set("CV", static_cast<std::uint32_t>(meter->hours(now)));
  a.status(meter->overflow(now) ? kOverflow : 0);
}

}  // namespace merker::system
