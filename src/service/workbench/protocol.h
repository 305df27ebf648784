// The table of the protocol, protocol.def, as the program reads it.
#pragma once

#include <span>

#include "workbench/method.h"
#include "workbench/shape.h"

namespace merker::workbench {

struct MethodRow {
  std::string_view name;
  Needs::State state;
  std::string_view feature;  // empty: none
  Kind kind;
  Shape fields, result;
};

std::span<const MethodRow> methodRows();
const MethodRow* findMethodRow(std::string_view name);

// Without "event"; null: there is none of this name.
const Shape* eventShape(std::string_view name);

// P1316 for a field that the request does not have.
std::optional<Problem> unknownField(const Method& method, const Json& request);

}  // namespace merker::workbench
