// What the screen and the programmer show of a SINUMERIK PLC, for `merker diag`.
#pragma once

#include <nlohmann/json.hpp>

#include "control/cnc.h"

namespace merker::app {

void printDiagnosis(cnc::Cnc& control);
nlohmann::ordered_json diagnosisToJson(cnc::Cnc& control);

}  // namespace merker::app
