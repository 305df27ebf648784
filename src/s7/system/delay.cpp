// SFC 32 SRT_DINT, 33 CAN_DINT, 34 QRY_DINT (S7-SFC-13).
#include "system/ob_interrupts.h"

namespace merker::system {
namespace {

constexpr std::uint32_t kWrongTime = 0x8091, kNotStarted = 0x80A0;

template <typename A>
auto* delayOf(A& a) {
  return interruptOf(a, &cpu::Interrupts::findDelay);
}

}  // namespace

// 1 … 60000 ms; a running delay begins anew.
void startDelay(Sfc<32>& a) {
  cpu::DelayInterrupt* interrupt = delayOf(a);
  if (interrupt == nullptr) return a.status(kWrongOb);
  const std::int32_t time = a.longInteger("DTIME");
  if (time < 1 || time > 60'000) return a.status(kWrongTime);
  *interrupt = {.ob = interrupt->ob,
                .active = true,
                .sign = static_cast<std::uint16_t>(a.value("SIGN")),
                .milliseconds = static_cast<std::uint32_t>(time),
                .due = a.machine().clock + Duration::milliseconds(time)};
  a.machine().interrupt();  // the horizon may have come nearer
  a.status(0);
}

void cancelDelay(Sfc<33>& a) {
  cpu::DelayInterrupt* interrupt = delayOf(a);
  if (interrupt == nullptr) return a.status(kWrongOb);
  if (!interrupt->active) return a.status(kNotStarted);
  interrupt->active = false;
  a.status(0);
}

void queryDelay(Sfc<34>& a) { answerQuery(a, delayOf(a)); }

}  // namespace merker::system
