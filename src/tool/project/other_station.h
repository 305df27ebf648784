// Another station that this one is connected to: a project folder of its own.
#pragma once

#include <string>

#include "base/problem.h"

namespace merker::project {

struct OtherStation {
  std::string name;    // in front of its operands: Press/E 0.0
  std::string folder;  // as the project names it
  Position named;
};

}  // namespace merker::project
