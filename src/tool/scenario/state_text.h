// The operating state of a PLC in words, for messages.
#pragma once

#include <string>
#include <string_view>

#include "plc/controller.h"

namespace merker::simulator {

std::string_view modeName(controller::Mode mode);  // "RUN"
// "6105 Fehlender …, PB 5 word 3; BEF-REG 7509, SAZ …": why, and where the registers stood.
std::string stopText(const controller::Controller& plc);
// ": reason" in STOP, else nothing: what stands behind "the CPU does not start".
std::string because(const controller::Controller& plc);

}  // namespace merker::simulator
