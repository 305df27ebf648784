// Event numbers of the diagnostic buffer (S7-DIAG-02, -03) and their texts. Numbers as in the
// diagnostic events of the reference manual "System Software for S7-300/400, System and Standard
// Functions": the first digit says what kind, 8 beside it "going", 9 "coming".
#pragma once

#include <cstdint>
#include <string_view>

namespace merker::cpu {

enum class Event : std::uint16_t {
  WarmRestartManual = 0x1381,
  WarmRestartAutomatic = 0x1382,
  HotRestartManual = 0x1383,
  HotRestartAutomatic = 0x1384,
  ColdRestartManual = 0x1385,
  ColdRestartAutomatic = 0x1386,
  CycleTimeExceeded = 0x3501,
  RequestError = 0x3502,
  TimeOfDaySkippedByClock = 0x3505,
  TimeOfDaySkippedByHalt = 0x3506,
  RequestOverflow = 0x3507,
  ObMissing = 0x35A1,
  PowerOn = 0x4300,
  StopToStartup = 0x4301,
  StartupToRun = 0x4302,
  StopBySwitch = 0x4303,
  StopByProgrammer = 0x4304,
  HaltReached = 0x4305,
  HaltLeft = 0x4306,
  MemoryReset = 0x4307,
  MemoryResetBySwitch = 0x4308,
  MemoryResetAutomatic = 0x4309,
  HaltToStop = 0x430A,
  MemoryResetDone = 0x430E,
  MemoryResetNeeded = 0x4546,
  StopProgrammingError = 0x4562,
  StopAccessError = 0x4563,
  StopTimeError = 0x4568,
  StopDiagnosticInterrupt = 0x456A,
  StopInsertRemove = 0x456B,
  StopCpuHardware = 0x456C,
  StopProgramSequence = 0x456D,
  StopCommunication = 0x456E,
  StopRackFailure = 0x456F,
  StopHardwareInterrupt = 0x4570,
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
