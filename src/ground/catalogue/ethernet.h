// Which CPUs and modules have an Ethernet interface.
#pragma once

#include "catalogue/cpu_model.h"
#include "catalogue/module_type.h"

namespace merker {

bool hasEthernet(const CpuModel& model);
bool hasEthernet(const ModuleType& type);
// Web pages and e-mails, too.
bool isItCp(const ModuleType& type);

}  // namespace merker
