// What the screen and the programmer show of a SINUMERIK beyond the monitor, for `merker diag`:
// alarms, fine error coding, control bits, the screens of a STOP.
#pragma once

#include <nlohmann/json.hpp>

#include "control/cnc.h"

namespace merker::app {

void printScreens(cnc::Cnc& control);
nlohmann::ordered_json screensToJson(cnc::Cnc& control);

}  // namespace merker::app
