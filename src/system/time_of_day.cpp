// SFC 28 SET_TINT, 29 CAN_TINT, 30 ACT_TINT, 31 QRY_TINT (S7-SFC-12).
#include "system/arguments.h"

namespace merker::system {
namespace {

constexpr std::uint32_t kWrongOb = 0x8090, kWrongTime = 0x8091, kWrongPeriod = 0x8092;
constexpr std::uint32_t kNotSet = 0x80A0, kInThePast = 0x80A1;

cpu::TimeOfDayInterrupt* interruptOf(Arguments& a) {
  const std::int32_t ob = a.integer(0);
  return ob < 0 ? nullptr : a.cpu().interrupts().findTimeOfDay(static_cast<std::uint32_t>(ob));
}

}  // namespace

// Seconds and milliseconds of the start do not count.
void setTimeOfDay(Arguments& a) {
  cpu::TimeOfDayInterrupt* interrupt = interruptOf(a);
  if (interrupt == nullptr) return a.status(kWrongOb);
  const Region time = a.composite(1, 8, cpu::Access::Read);
  if (!time) return a.parameterError(1, time.error);
  const auto start = cpu::fromDateAndTime(time.data);
  if (!start) return a.status(kWrongTime);
  const std::uint32_t period = a.value(2);
  if (!cpu::isPeriod(period)) return a.status(kWrongPeriod);
  const auto kind = static_cast<cpu::Period>(period);
  const std::int64_t minute = *start - *start % 60'000;
  const std::int64_t now = a.cpu().clock().milliseconds(a.machine().clock);
  if (kind == cpu::Period::Once && minute <= now) return a.status(kInThePast);
  *interrupt = {.ob = interrupt->ob, .set = true, .period = kind, .start = minute};
  a.status(0);
}

void cancelTimeOfDay(Arguments& a) {
  cpu::TimeOfDayInterrupt* interrupt = interruptOf(a);
  if (interrupt == nullptr) return a.status(kWrongOb);
  if (!interrupt->active && !interrupt->set) return a.status(kNotSet);
  interrupt->active = interrupt->set = false;
  a.status(0);
}

void activateTimeOfDay(Arguments& a) {
  cpu::TimeOfDayInterrupt* interrupt = interruptOf(a);
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

// STATUS: bit 1 locked, 2 activated, 4 OB loaded.
void queryTimeOfDay(Arguments& a) {
  const cpu::TimeOfDayInterrupt* interrupt = interruptOf(a);
  if (interrupt == nullptr) {
    a.set(1, 0);
    return a.status(kWrongOb);
  }
  const bool locked = a.cpu().interrupts().isLocked(interrupt->ob);
  a.set(1, locked * 2u | interrupt->active * 4u | a.cpu().hasOb(interrupt->ob) * 16u);
  a.status(0);
}

}  // namespace merker::system
