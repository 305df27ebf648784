// Values of operands as somebody outside the program sees them.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "address/reference.h"
#include "cpu/cpu.h"
#include "station/periphery.h"

namespace merker::station {

// `periphery`: null without a hardware configuration.
std::optional<std::uint32_t> readValue(cpu::Cpu& cpu, const Periphery* periphery,
                                       const address::Reference& reference);
// All bytes of a DATE_AND_TIME or STRING; empty if they do not exist.
std::span<std::uint8_t> bytesAt(cpu::Cpu& cpu, const address::Reference& reference);
// Inputs: what the module delivers. Everything else at once.
bool writeValue(cpu::Cpu& cpu, Periphery* periphery, const address::Reference& reference,
                std::uint32_t value);
// E and A only, as an S7-300 does: they are held around the program, not at each access.
bool forceValue(cpu::Cpu& cpu, const address::Reference& reference, std::uint32_t value);

}  // namespace merker::station
