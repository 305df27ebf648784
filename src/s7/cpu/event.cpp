#include "cpu/event.h"

namespace merker::cpu {
namespace {

struct Row {
  Event event;
  std::string_view text;
};

constexpr Row kRows[] = {
    {Event::WarmRestartManual, "request for manual warm restart"},
    {Event::WarmRestartAutomatic, "request for automatic warm restart"},
    {Event::HotRestartManual, "request for manual hot restart"},
    {Event::HotRestartAutomatic, "request for automatic hot restart"},
    {Event::ColdRestartManual, "request for manual cold restart"},
    {Event::ColdRestartAutomatic, "request for automatic cold restart"},
    {Event::CycleTimeExceeded, "cycle time exceeded"},
    {Event::RequestError, "OB request error: the OB is still being processed"},
    {Event::TimeOfDaySkippedByClock, "time-of-day interrupt skipped: the clock was set"},
    {Event::TimeOfDaySkippedByHalt, "time-of-day interrupt skipped while in HALT or STOP"},
    {Event::RequestOverflow, "too many requests for the OBs of one priority class"},
    {Event::ObMissing, "OB not loaded"},
    {Event::PowerOn, "power on"},
    {Event::StopToStartup, "mode transition from STOP to STARTUP"},
    {Event::StartupToRun, "mode transition from STARTUP to RUN"},
    {Event::StopBySwitch, "STOP by mode selector switch"},
    {Event::StopByProgrammer, "STOP by programming device"},
    {Event::HaltReached, "HALT: breakpoint reached"},
    {Event::HaltLeft, "HALT: breakpoint left"},
    {Event::MemoryReset, "memory reset by programming device"},
    {Event::MemoryResetBySwitch, "memory reset by mode selector switch"},
    {Event::MemoryResetAutomatic, "automatic memory reset: power on without buffered memory"},
    {Event::HaltToStop, "HALT left, mode transition to STOP"},
    {Event::MemoryResetDone, "memory reset done"},
    {Event::MemoryResetNeeded, "STOP: memory reset is necessary"},
    {Event::StopProgrammingError, "STOP by programming error (OB 121 not loaded)"},
    {Event::StopAccessError, "STOP by I/O access error (OB 122 not loaded)"},
    {Event::StopTimeError, "STOP by time error (OB 80 not loaded, or twice in one cycle)"},
    {Event::StopDiagnosticInterrupt, "STOP by diagnostic interrupt (OB 82 not loaded)"},
    {Event::StopInsertRemove, "STOP by removing or inserting a module (OB 83 not loaded)"},
    {Event::StopCpuHardware, "STOP by CPU hardware fault (OB 84 not loaded)"},
    {Event::StopProgramSequence, "STOP by program sequence error"},
    {Event::StopCommunication, "STOP by communication error (OB 87 not loaded)"},
    {Event::StopRackFailure, "STOP by rack failure (OB 86 not loaded)"},
    {Event::StopHardwareInterrupt, "STOP by hardware interrupt (OB not loaded)"},
    {Event::StopBracketStack, "STOP by error in the bracket stack"},
    {Event::StopMcrStack, "STOP by error in the MCR stack"},
    {Event::StopErrorNesting, "STOP: synchronous errors nested too deeply"},
    {Event::StopInterruptStack, "STOP: interrupts nested too deeply"},
    {Event::StopBlockNesting, "STOP: blocks nested too deeply"},
    {Event::StopLocalData, "STOP: local data exhausted"},
    {Event::StopUnknownOpcode, "STOP: unknown operation code"},
    {Event::StopCodeLength, "STOP: end of the block without BE"},
    {Event::StopCommand, "STOP by STOP command (SFC 46)"},
};

}  // namespace

std::string_view text(Event event) {
  for (const Row& row : kRows)
    if (row.event == event) return row.text;
  return "event";
}

}  // namespace merker::cpu
