// SFC 6 RD_SINFO, 43 RE_TRIGR, 44 REPL_VAL, 46 STP, 47 WAIT (S7-SFC-05, -16 … -18).
#include "base/bytes.h"
#include "system/arguments.h"

namespace merker::system {
void retriggerCycle(Arguments& a) { a.cpu().retrigger(); }

// AKKU1 of the block that the error interrupted; only in OB 121 and OB 122.
void replaceValue(Arguments& a) {
  constexpr std::uint32_t kNotInErrorOb = 0x8080;
  cpu::Level& level = a.machine().levels.back();
  if (!level.errorOb) return a.status(kNotInErrorOb);
  level.interrupted.accu[0] = a.value(0);
  a.status(0);
}

void stopCpu(Arguments& a) { a.cpu().stop(cpu::Event::StopCommand); }

// Microseconds; higher classes interrupt it.
void waitFor(Arguments& a) {
  const std::int32_t time = a.integer(0);
  if (time <= 0) return;
  a.machine().levels.back().wait = Duration::microseconds(time).ns;
  a.machine().interrupt();
}

// Of the OB that runs, and of the startup before; EV_CLASS EV_NUM PRIORITY NUM TYP2_3 TYP1 ZI1
// ZI2_3: the first twelve bytes of start information.
void readStartInformation(Arguments& a) {
  constexpr std::uint32_t kBytes = 12;
  const cpu::StartInformation* sources[] = {&a.machine().levels.back().start, &a.cpu().lastStart()};
  for (std::size_t i = 0; i < 2; ++i) {
    const Region target = a.structure(i, kBytes);
    if (!target) return a.parameterError(i, target.error);
    std::copy_n(sources[i]->begin(), kBytes, target.data);
  }
  a.status(0);
}

}  // namespace merker::system
