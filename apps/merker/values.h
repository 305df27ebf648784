// Values at the end of a run.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "scenario/trace.h"

namespace merker::app {

// "MW 10 = W#16#0005", a line each.
void printValues(const simulator::Watched& wanted, const controller::Controller& plc);
// The same as members of an object.
void addValues(const simulator::Watched& wanted, const controller::Controller& plc,
               nlohmann::ordered_json& object);
// Mode, whether it stopped by a fault, cycles, instructions.
void addState(const controller::Controller& plc, nlohmann::ordered_json& object);
// Data blocks that the program was to make (SFC 22) and did not: a message each.
bool allExist(const std::vector<address::Reference>& operands, const controller::Controller& plc);

}  // namespace merker::app
