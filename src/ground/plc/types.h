// What any PLC tells about itself.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "check/check_result.h"
#include "clock/instant.h"

namespace merker::controller {

// S7-STATE. The PLC of a SINUMERIK has these, too; HALT only at its test functions.
enum class Mode : std::uint8_t { Stop, Startup, Run, Halt };

// One entry of the diagnostic buffer, newest last.
struct DiagnosticEntry {
  std::uint16_t event = 0;  // S7: 16#2521, 16#4562 … (S7-DIAG-01, -02); S5: the alarm, 6101 …
  Instant time;
  std::string text;  // "programming error: BCD conversion error", with block and position if known
};

using block::CheckFailure;
using block::CheckResult;

}  // namespace merker::controller
