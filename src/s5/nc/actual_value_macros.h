// FB 56 VORSCHUB, FB 57 SCHLEPPA, FB 58 SPINDIST: MB 224 says what is wanted, MW 225 and MW 227
// get it (S5-FM-12 … -18).
#pragma once

#include "nc/control.h"
#include "nc/macro_error.h"

namespace merker::nc {

Error readFeed(sinumerik::Machine& machine, const Control& control);
Error readFollowingError(sinumerik::Machine& machine, const Control& control);
Error readSpindleSpeed(sinumerik::Machine& machine, const Control& control);

}  // namespace merker::nc
