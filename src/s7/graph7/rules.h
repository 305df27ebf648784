// What KOP and FUP of STEP 7 know.
#pragma once

#include "graph/rules.h"

namespace merker::graph7 {

const graph::Rules& rules();

}  // namespace merker::graph7
