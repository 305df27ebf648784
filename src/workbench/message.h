// One message of a browser: a JSON object, not nested deeper than the protocol allows.
#pragma once

#include <string_view>

#include "workbench/json.h"
#include "workbench/project_folder.h"

namespace merker::workbench {

constexpr std::size_t kDeepest = 32;

Result<Json> parseMessage(std::string_view text);
// 0: there is none.
std::int64_t requestId(const Json& request);

// The files that a problem names, relative to the project folder.
void relate(Json& problem, const ProjectFolder& folder);

}  // namespace merker::workbench
