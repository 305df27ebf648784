// Values of operands as somebody outside the program sees them.
#pragma once

#include <cstdint>
#include <optional>

#include "mc5/variable.h"
#include "sinumerik/operating_system.h"

namespace merker::sinumerik {

using mc5::Variable;

// E, A, M, D; T and Z: width Bit is the output, any other the value as LC loads it; P: what the
// output modules give out, nothing while the PLC is not in RUN. Nothing if there is no such
// operand.
std::optional<std::uint32_t> readValue(const OperatingSystem& os, const Variable& variable);
// Inputs and P: the terminal, from where the image takes it. Timers: base and digits as a start
// operation takes them; counters: three digits. False: there is no such operand.
bool writeValue(OperatingSystem& os, const Variable& variable, std::uint32_t value);
// E, A and M only.
bool forceValue(OperatingSystem& os, const Variable& variable, std::uint32_t value);

}  // namespace merker::sinumerik
