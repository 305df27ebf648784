// {"point": "begin"/"end"/"stop", "once": bool}: where a variable table monitors or modifies.
#pragma once

#include "monitor/variable_table.h"
#include "workbench/fields.h"

namespace merker::workbench {

// Nothing: at once, or whenever there is something to tell.
std::optional<monitor::Trigger> triggerOf(const Fields& fields);

}  // namespace merker::workbench
