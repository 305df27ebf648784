// SFC 39 DIS_IRT, 40 EN_IRT: lock and unlock; SFC 41 DIS_AIRT, 42 EN_AIRT: delay (S7-SFC-15).
#include <algorithm>

#include "system/call.h"

namespace merker::system {
namespace {

constexpr std::uint32_t kWrongOb = 0x8090, kWrongModeOfLock = 0x8091, kNotDelayed = 0x8080;

// MODE 0 all, 1 the class that begins with OB_NR (10, 20, 30, 40 …), 2 the one OB; + 80 hex:
// without an entry in the diagnostic buffer.
struct Selection {
  std::uint8_t first = 0, last = 0;
  std::uint32_t error = 0;
};

template <typename A>
Selection selection(A& a) {
  const std::uint32_t mode = a.value("MODE") & 0x7F;
  const std::int32_t ob = a.integer("OB_NR");
  if (mode == 0) return {10, 87};
  if (mode > 2) return {.error = kWrongModeOfLock};
  if (ob < 10 || ob > 87) return {.error = kWrongOb};
  const auto first = static_cast<std::uint8_t>(ob);
  if (mode == 2) return {first, first};
  if (first % 10 != 0) return {.error = kWrongOb};
  return {first, static_cast<std::uint8_t>(first + 9)};
}

}  // namespace

void disableInterrupts(Sfc<39>& a) {
  const Selection which = selection(a);
  if (which.error != 0) return a.status(which.error);
  cpu::Interrupts& interrupts = a.cpu().interrupts();
  for (unsigned ob = which.first; ob <= which.last; ++ob)
    if (!interrupts.isLocked(static_cast<std::uint8_t>(ob)))
      interrupts.locked.push_back(static_cast<std::uint8_t>(ob));
  a.status(0);
}

void enableInterrupts(Sfc<40>& a) {
  const Selection which = selection(a);
  if (which.error != 0) return a.status(which.error);
  std::erase_if(a.cpu().interrupts().locked,
                [&](std::uint8_t ob) { return ob >= which.first && ob <= which.last; });
  a.status(0);
}

// RET_VAL of both: how often the delay has been asked for.
void delayInterrupts(Sfc<41>& a) { a.status(++a.machine().levels.back().delayed); }

void releaseInterrupts(Sfc<42>& a) {
  std::uint32_t& delayed = a.machine().levels.back().delayed;
  if (delayed == 0) return a.status(kNotDelayed);
  a.status(--delayed);
  a.machine().interrupt();  // what waits may begin
}

}  // namespace merker::system
