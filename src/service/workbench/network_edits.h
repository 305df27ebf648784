// Changes of networks, and copies of what is in them.
#pragma once

#include "workbench/elsewhere.h"

namespace merker::workbench {

Answer copyElements(const Call& call);
Answer editNetwork(const Call& call);

}  // namespace merker::workbench
