// The pages of the sub-module 2.1 as rows of an answer (technology manual 6.3.3 to 6.3.6;
// PTP-PARAM): basic parameters, transmission, end of a telegram, reception, interface. What a
// choice makes meaningless is there and fixed.
#pragma once

#include "io/configuration.h"
#include "project/settings_edit.h"
#include "workbench/json.h"

namespace merker::workbench {

// Behind the rows that every module has.
void addSerialRows(const io::Parameters& parameters, Json& list);

// After another rate: times below its least ones become these (PTP-PARAM-37).
void raiseSerialTimes(project::SettingsEdit& edit, const project::ModulePlace& place);

}  // namespace merker::workbench
