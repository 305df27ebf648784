// Files of the project that the simulator writes.
#pragma once

#include "workbench/fields.h"
#include "workbench/shared.h"

namespace merker::workbench {

// The field "path" with this ending: no other file is overwritten by mistake.
std::string pathOf(const Fields& fields, std::string_view ending);
// Whole or not at all; P1312 if it is there and is not to be replaced.
std::optional<Problem> putFile(Shared& shared, const std::string& path, std::string_view bytes,
                               bool replace);

}  // namespace merker::workbench
