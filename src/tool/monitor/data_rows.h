// The values of a data block as rows of machine code: variable by variable, word by word.
#pragma once

#include "monitor/machine_code.h"

namespace merker::monitor {

// The variables with the values that they begin with and have; what no variable names in hex.
std::vector<MachineCodeRow> dataRows(const block::Block& block);
// Each word in the format of its declaration.
std::vector<MachineCodeRow> dataRows(const mc5::Block& block);

}  // namespace merker::monitor
