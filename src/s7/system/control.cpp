// SFC 6 RD_SINFO, 43 RE_TRIGR, 44 REPL_VAL, 46 STP, 47 WAIT (S7-SFC-05, -16 … -18).
#include <algorithm>

#include "system/call.h"

namespace merker::system {
namespace {

// The first twelve bytes of start information: EV_CLASS EV_NUM PRIORITY NUM TYP2_3 TYP1 ZI1 ZI2_3.
// False: it has no place, which RET_VAL says.
bool store(Sfc<6>& a, Sfc<6>::Name parameter, const cpu::StartInformation& start) {
  constexpr std::uint32_t kBytes = 12;
  const Region target = a.structure(parameter, kBytes);
  if (!target) return a.parameterError(parameter, target.error), false;
  std::copy_n(start.begin(), kBytes, target.data);
  return true;
}

}  // namespace

void retriggerCycle(Sfc<43>& a) { a.cpu().retrigger(); }

// AKKU1 of the block that the error interrupted; only in OB 121 and OB 122.
void replaceValue(Sfc<44>& a) {
  constexpr std::uint32_t kNotInErrorOb = 0x8080;
  cpu::Level& level = a.machine().levels.back();
  if (!level.errorOb) return a.status(kNotInErrorOb);
  level.interrupted.accu[0] = a.value("VAL");
  a.status(0);
}

void stopCpu(Sfc<46>& a) { a.cpu().stop(cpu::Event::StopCommand); }

// Microseconds; higher classes interrupt it.
void waitFor(Sfc<47>& a) {
  const std::int32_t time = a.integer("WT");
  if (time <= 0) return;
  a.machine().levels.back().wait = Duration::microseconds(time).ns;
  a.machine().interrupt();
}

// Of the OB that runs, and of the startup before.
void readStartInformation(Sfc<6>& a) {
  if (store(a, "TOP_SI", a.machine().levels.back().start) &&
      store(a, "START_UP_SI", a.cpu().startup().information()))
    a.status(0);
}

}  // namespace merker::system
