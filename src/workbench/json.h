// Values of the protocol.
#pragma once

#include <nlohmann/json.hpp>

#include "base/problem.h"
#include "base/result.h"

namespace merker::workbench {

using Json = nlohmann::json;
// What a request is answered with.
using Answer = Result<Json, Problems>;

// As text; bytes that are no UTF-8 are replaced.
std::string dump(const Json& json);
// {"code", "severity", "file", "line", "column", "text"}; `folder` in front of paths is cut off.
Json toJson(const Problem& problem, std::string_view folder = {});
Json toJson(const Problems& problems, std::string_view folder = {});

Problems one(Problem problem);
Position nowhere();

template <typename... Arguments>
Problems refused(ProblemCode code, const Arguments&... arguments) {
  return one(makeProblem(code, nowhere(), arguments...));
}

}  // namespace merker::workbench
