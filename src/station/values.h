// Values of operands as somebody outside the program sees them.
#pragma once

#include <cstdint>
#include <optional>

#include "cpu/cpu.h"
#include "mc7/reference.h"

namespace merker::station {

std::optional<std::uint32_t> readValue(cpu::Cpu& cpu, const mc7::Reference& reference);
// Inputs: the terminal. Everything else at once.
bool writeValue(cpu::Cpu& cpu, const mc7::Reference& reference, std::uint32_t value);
// E, A and M only.
bool forceValue(cpu::Cpu& cpu, const mc7::Reference& reference, std::uint32_t value);

}  // namespace merker::station
