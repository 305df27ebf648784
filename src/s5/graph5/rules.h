// What KOP and FUP of STEP 5 know (chapter 10 of the manual of SINUMERIK 810/820).
#pragma once

#include "graph/rules.h"

namespace merker::graph5 {

const graph::Rules& rules();

}  // namespace merker::graph5
