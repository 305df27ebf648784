// SFC 32 SRT_DINT, 33 CAN_DINT, 34 QRY_DINT (S7-SFC-13).
#include "system/arguments.h"

namespace merker::system {
namespace {

constexpr std::uint32_t kWrongOb = 0x8090, kWrongTime = 0x8091, kNotStarted = 0x80A0;

cpu::DelayInterrupt* interruptOf(Arguments& a) {
  const std::int32_t ob = a.integer(0);
  return ob < 0 ? nullptr : a.cpu().interrupts().findDelay(static_cast<std::uint32_t>(ob));
}

}  // namespace

// 1 … 60000 ms; a running delay begins anew.
void startDelay(Arguments& a) {
  cpu::DelayInterrupt* interrupt = interruptOf(a);
  if (interrupt == nullptr) return a.status(kWrongOb);
  const std::int32_t time = a.longInteger(1);
  if (time < 1 || time > 60'000) return a.status(kWrongTime);
  *interrupt = {.ob = interrupt->ob,
                .active = true,
                .sign = static_cast<std::uint16_t>(a.value(2)),
                .milliseconds = static_cast<std::uint32_t>(time),
                .due = a.machine().clock + Duration::milliseconds(time)};
  a.machine().interrupt();  // the horizon may have come nearer
  a.status(0);
}

void cancelDelay(Arguments& a) {
  cpu::DelayInterrupt* interrupt = interruptOf(a);
  if (interrupt == nullptr) return a.status(kWrongOb);
  if (!interrupt->active) return a.status(kNotStarted);
  interrupt->active = false;
  a.status(0);
}

// STATUS: bit 1 locked, 2 running, 4 OB loaded.
void queryDelay(Arguments& a) {
  const cpu::DelayInterrupt* interrupt = interruptOf(a);
  if (interrupt == nullptr) {
    a.set(1, 0);
    return a.status(kWrongOb);
  }
  const bool locked = a.cpu().interrupts().isLocked(interrupt->ob);
  a.set(1, locked * 2u | interrupt->active * 4u | a.cpu().hasOb(interrupt->ob) * 16u);
  a.status(0);
}

}  // namespace merker::system
