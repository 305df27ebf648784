// SFC 28 SET_TINT, 29 CAN_TINT, 30 ACT_TINT, 31 QRY_TINT (S7-SFC-12).
#include "system/ob_interrupts.h"

namespace merker::system {
namespace {

constexpr std::uint32_t kWrongTime = 0x8091, kWrongPeriod = 0x8092;
constexpr std::uint32_t kNotSet = 0x80A0, kInThePast = 0x80A1;

template <typename A>
auto* timeOfDayOf(A& a) {
  return interruptOf(a, &cpu::Interrupts::findTimeOfDay);
}

}  // namespace

// Seconds and milliseconds of the start do not count.
void setTimeOfDay(Sfc<28>& a) {
  cpu::TimeOfDayInterrupt* interrupt = timeOfDayOf(a);
  if (interrupt == nullptr) return a.status(kWrongOb);
  const Region time = a.composite("SDT", 8, cpu::Access::Read);
  if (!time) return a.parameterError("SDT", time.error);
  const auto start = cpu::fromDateAndTime(time.data);
  if (!start) return a.status(kWrongTime);
  const std::uint32_t period = a.value("PERIOD");
  if (!cpu::isPeriod(period)) return a.status(kWrongPeriod);
  const auto kind = static_cast<cpu::Period>(period);
  const std::int64_t minute = *start - *start % 60'000;
  const std::int64_t now = a.cpu().clock().milliseconds(a.machine().clock);
  if (kind == cpu::Period::Once && minute <= now) return a.status(kInThePast);
  *interrupt = {.ob = interrupt->ob, .set = true, .period = kind, .start = minute};
  a.status(0);
}

void cancelTimeOfDay(Sfc<29>& a) {
  cpu::TimeOfDayInterrupt* interrupt = timeOfDayOf(a);
  if (interrupt == nullptr) return a.status(kWrongOb);
  if (!interrupt->active && !interrupt->set) return a.status(kNotSet);
  interrupt->active = interrupt->set = false;
  a.status(0);
}

void activateTimeOfDay(Sfc<30>& a) {
  cpu::TimeOfDayInterrupt* interrupt = timeOfDayOf(a);
  if (interrupt == nullptr) return a.status(kWrongOb);
  if (!interrupt->set) return a.status(kNotSet);
  const std::int64_t now = a.cpu().clock().milliseconds(a.machine().clock);
  interrupt->due = cpu::nextTimeOfDay(interrupt->start, interrupt->period, now);
  if (interrupt->due < 0) return a.status(kInThePast);
  interrupt->active = true;
  interrupt->expired = false;
  a.machine().interrupt();
  a.status(0);
}

void queryTimeOfDay(Sfc<31>& a) { answerQuery(a, timeOfDayOf(a)); }

}  // namespace merker::system
