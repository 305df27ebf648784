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
    {Event::ColdRestartManual, "request for manual cold restart"},
    {Event::CycleTimeExceeded, "cycle time exceeded"},
    {Event::RequestError, "OB request error: the OB is still being processed"},
    {Event::PowerOn, "power on"},
    {Event::StopToStartup, "mode transition from STOP to STARTUP"},
    {Event::StartupToRun, "mode transition from STARTUP to RUN"},
    {Event::StopBySwitch, "STOP by mode selector switch"},
    {Event::StopByProgrammer, "STOP by programming device"},
    {Event::MemoryReset, "memory reset requested"},
    {Event::MemoryResetDone, "memory reset done"},
    {Event::StopProgrammingError, "STOP by programming error (OB 121 not loaded)"},
    {Event::StopAccessError, "STOP by I/O access error (OB 122 not loaded)"},
    {Event::StopTimeError, "STOP by time error (OB 80 not loaded, or twice in one cycle)"},
    {Event::StopProgramSequence, "STOP by program sequence error"},
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
