// Asynchronous errors (S7-ERR-01): their texts, and what the CPU does without their OB.
#pragma once

#include <optional>
#include <string>

#include "cpu/event.h"
#include "cpu/start_information.h"

namespace merker::cpu {

// STOP without the OB; nothing where the CPU goes on (OB 81).
std::optional<Event> stopWithout(std::uint8_t ob);
// OB 81 to 84, 86: a fault of hardware that comes and goes, not one of the program.
bool comesFromModule(std::uint8_t ob);
// Whether bytes 6 and 7 of its start information are the address of a module.
bool namesModule(std::uint16_t event);
// "module fault, coming: address 256"
std::string describe(const StartInformation& start);

}  // namespace merker::cpu
