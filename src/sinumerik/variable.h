// Values of operands as somebody outside the program sees them.
#pragma once

#include <cstdint>
#include <optional>

#include "mc5/operand.h"
#include "sinumerik/operating_system.h"

namespace merker::sinumerik {

// An operand in memory, a timer or a counter; of data with the number of its block.
struct Variable {
  mc5::Operand operand;
  std::uint16_t dataBlock = 0;
};

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
