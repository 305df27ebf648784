// What a change brings: the errors that were not there before.
#pragma once

#include "base/problem.h"

namespace merker::workbench {

Problems freshErrors(const Problems& before, const Problems& after);

}  // namespace merker::workbench
