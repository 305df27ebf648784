// Self-checking programs: sources with //= comments.
#pragma once

#include <string>
#include <string_view>

#include "plc/controller.h"
#include "scenario/test_result.h"

namespace merker::simulator {

// Whether a source contains a //= comment.
bool hasChecks(std::string_view source);

// Runs until the CPU stops itself or 10 s of virtual time have passed. Passed: no term failed,
// every //= line was reached at least once, no STOP through a fault.
TestResult runSelfChecks(const std::string& file, controller::Controller& plc);

}  // namespace merker::simulator
