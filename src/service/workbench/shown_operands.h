// Another form of the operands of a network: symbols instead of addresses, or the reverse.
#pragma once

#include <map>
#include <string>

#include "graph/network.h"
#include "workbench/network_rows.h"

namespace merker::workbench {

// What stands in the text, by what is shown instead.
using WrittenOperands = std::map<std::string, std::string, std::less<>>;

WrittenOperands showOperands(graph::Network& network, const NetworkDisplay& display);

}  // namespace merker::workbench
