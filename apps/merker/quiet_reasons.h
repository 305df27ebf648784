// merker bench --why: which cycles had to be computed, and why.
#pragma once

#include <string>

#include "build.h"
#include "clock/instant.h"

namespace merker::app {

// Runs the program from its start for so much virtual time and prints how many cycles were not the
// same as the one before, and why. What prevented it; empty if nothing did.
std::string tellWhy(const Build& built, Duration time);

}  // namespace merker::app
