// Event numbers of the diagnostic buffer that the CPU itself makes (S7-DIAG-02, -03), with their
// texts.
#pragma once

#include <cstdint>
#include <string_view>

namespace merker::cpu {

enum class Event : std::uint16_t {
  WarmRestartManual = 0x1381,
  WarmRestartAutomatic = 0x1382,
  ColdRestartManual = 0x1385,
  CycleTimeExceeded = 0x3501,
  RequestError = 0x3502,
  PowerOn = 0x4300,
  StopToStartup = 0x4301,
  StartupToRun = 0x4302,
  StopBySwitch = 0x4303,
  StopByProgrammer = 0x4304,
  MemoryReset = 0x4307,
  MemoryResetDone = 0x430E,
  StopProgrammingError = 0x4562,
  StopAccessError = 0x4563,
  StopTimeError = 0x4568,
  StopProgramSequence = 0x456D,
  StopBracketStack = 0x4571,
  StopMcrStack = 0x4572,
  StopErrorNesting = 0x4573,
  StopInterruptStack = 0x4574,
  StopBlockNesting = 0x4575,
  StopLocalData = 0x4576,
  StopUnknownOpcode = 0x4578,
  StopCodeLength = 0x457A,
  StopCommand = 0x457F
};

std::string_view text(Event event);

}  // namespace merker::cpu
