// The position of a problem in a text that came from no file.
#pragma once

#include "base/problem.h"

namespace merker::monitor {

inline Position nowhere() { return Position{"", 0, 0, 0}; }

}  // namespace merker::monitor
