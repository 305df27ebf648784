// What the checks of a program (//=) saw.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "check/check.h"
#include "clock/instant.h"

namespace merker::block {

struct CheckFailure {
  Instant time;      // when the term was judged
  std::string text;  // "AKKU1 = W#16#8000: is W#16#7FFF"
};

// `reached` counts how often it was evaluated; behind a jump the passes that went on to the next
// instruction count, if there were any.
struct CheckResult {
  const Check* check = nullptr;
  std::uint64_t reached = 0;
  std::vector<CheckFailure> failures;  // the first few
};

}  // namespace merker::block
