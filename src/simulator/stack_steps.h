// expect ustack SAZ = 002A, expect bstack 1 = PB 5: what a programmer shows of a STOP.
#pragma once

#include <string>
#include <string_view>

#include "block/check.h"
#include "controller/controller.h"

namespace merker::simulator {

struct StackField {
  std::string stack, name, value;  // "USTACK", "SAZ", "002A", as written
};

// Takes "ustack" or "bstack" off the left side of a comparison; false: it is another operand.
bool takeStack(std::string_view& left, StackField& field);

// Values are hexadecimal digits, with or without KH, or names of blocks.
bool holds(const StackField& field, block::Relation relation, const controller::Controller& plc);
// "SAZ is 0030", or why nothing is there to see.
std::string actualValue(const StackField& field, const controller::Controller& plc);

}  // namespace merker::simulator
