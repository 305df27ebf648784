// Addresses of the program against the hardware configuration (S7-OPEN-32).
#pragma once

#include <cstdint>

#include "base/problem.h"
#include "block/block.h"

namespace merker::project {

struct Project;

// Of E and A, and of PE and PA. Standard: warnings for E and A, errors for PE and PA.
enum class AddressCheck : std::uint8_t { Standard, Off, Warning, Error };

// A problem for each direct E, A, PE or PA operand without a module. Nothing without a hardware
// configuration.
void checkAddresses(const Project& project, const block::Program& program, Problems& problems);

}  // namespace merker::project
