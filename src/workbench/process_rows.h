// Plants as rows of an answer, and their values as they are now.
#pragma once

#include "plant/plants.h"
#include "workbench/json.h"

namespace merker::workbench {

Json plantRows(const plant::Plants& plants);
// {name: {value: number}}
Json plantValues(const plant::Plants& plants);

}  // namespace merker::workbench
