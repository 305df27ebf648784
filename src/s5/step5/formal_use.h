// Which operations take which formal operands (9.4.1 … 9.4.6, 9.4.12; S5-SUBST-01 … -06).
#pragma once

#include <string_view>

#include "mc5/block.h"
#include "mc5/instruction.h"

namespace merker::step5 {

// The kinds that the operation takes, if the parameter is none of them; else empty.
std::string_view kindsInstead(mc5::Operation operation, const mc5::Parameter& parameter);

}  // namespace merker::step5
