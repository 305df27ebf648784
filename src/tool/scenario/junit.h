// Test results as JUnit XML, the form that CI servers read.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "scenario/test_result.h"

namespace merker::simulator {

// One test suite per file, one test case per scenario or self-checking program; times are virtual
// seconds.
void writeJunit(const std::vector<TestResult>& results, std::ostream& out);

// "plant.scn:12: at 6.800 s: expected A 1.2 = 1, A 1.2 is 0".
std::string describe(const Failure& failure);

}  // namespace merker::simulator
