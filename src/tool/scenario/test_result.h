// What came out of one scenario or one self-checking program.
#pragma once

#include <string>
#include <vector>

#include "base/problem.h"
#include "clock/instant.h"

namespace merker::simulator {

struct Failure {
  Position position;
  Instant time;
  std::string message;  // what was expected and what was there
};

struct TestResult {
  std::string file, name;
  Instant end;  // virtual time when it was over
  std::vector<Failure> failures;
  bool passed() const { return failures.empty(); }
};

}  // namespace merker::simulator
