// Block status and program status on the wire.
#pragma once

#include "s7comm/test_job.h"

namespace merker::s7comm {

// The parameters behind the common ones, and the data.
Error readBreakpoint(View parameters, BlockWatch& watch);  // the block and its address alone
Error readBlockWatch(TestFunction function, View parameters, View data, BlockWatch& watch);

}  // namespace merker::s7comm
