// One parameter of the hardware as a row of an answer (type Parameter of the protocol).
#pragma once

#include <utility>

#include "workbench/json.h"

namespace merker::workbench {

// `more`: what is possible: choices, min and max, a hint.
inline Json parameterRow(const char* key, const char* kind, Json value,
                         Json more = Json::object()) {
  more.update({{"key", key}, {"kind", kind}, {"value", std::move(value)}});
  return more;
}

}  // namespace merker::workbench
