// The elementary values of a declaration, one by one, each with its name and place:
// "Setpoint[2].Speed".
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "block/type.h"

namespace merker::block {

struct Element {
  std::string path;      // names joined by ".", indices as they are written: "a.b[1,2]"
  const Type& type;      // has neither members nor elements
  BitAddress at;         // from the beginning of the frame
  const Variable& name;  // whose name stands last in the path: its comment
};

// Returns false to end the walk.
using ElementVisitor = std::function<bool(const Element&)>;

// Visits the values in the order of their places; temporary variables are left out. A composite
// IN_OUT parameter is one value: the POINTER that stands in its place (S7-PAR-03).
bool forEachElement(const std::vector<Variable>& variables, const ElementVisitor& visit);

}  // namespace merker::block
