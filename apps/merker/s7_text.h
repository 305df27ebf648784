// Clients of S7 communication as text.
#pragma once

#include <string>

#include "workbench/communication_view.h"

namespace merker::app {

std::string s7Text(const workbench::S7Outside& outside);

}  // namespace merker::app
