// What any PLC tells about itself.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "block/check.h"
#include "clock/instant.h"

namespace merker::controller {

// S7-STATE. The PLC of a SINUMERIK knows STOP, STARTUP and RUN.
enum class Mode : std::uint8_t { Stop, Startup, Run, Halt };

// One entry of the diagnostic buffer, newest last.
struct DiagnosticEntry {
  std::uint16_t event = 0;  // S7: 16#2521, 16#4562 … (S7-DIAG-01, -02); S5: the alarm, 6101 …
  Instant time;
  std::string text;  // "programming error: BCD conversion error", with block and position if known
};

// What a check (//=) saw. `reached` counts how often it was evaluated; behind a jump the passes
// that went on to the next instruction count, if there were any.
struct CheckFailure {
  Instant time;      // when the term was judged
  std::string text;  // "AKKU1 = W#16#8000: is W#16#7FFF"
};
struct CheckResult {
  const block::Check* check = nullptr;
  std::uint64_t reached = 0;
  std::vector<CheckFailure> failures;  // the first few
};

}  // namespace merker::controller
