// Whether an answer or an event is what protocol.def promises.
#pragma once

#include "workbench/protocol.h"

namespace merker::workbench::test {

// The first thing in `value` that is not as the shape has it, with its place; empty if all is.
std::string mismatch(const Shape& shape, const Json& value, const std::string& place);

}  // namespace merker::workbench::test
