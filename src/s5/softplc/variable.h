// Values of operands as somebody outside the program sees them.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "address/reference.h"
#include "softplc/operating_system.h"

namespace merker::sinumerik {

using address::Reference;

// Data blocks that the system made take no values from a programmer but the trigger DW 9 of DB 1
// (3.1, S5-DB-12, OP-03): then the reason, else empty.
std::string whySystemOwned(const OperatingSystem& os, const Reference& reference);
// "there is no DB 5", for an operand that cannot be read.
std::string whyMissing(const OperatingSystem& os, const Reference& reference);
// Why this operand did not take the value that was written: whySystemOwned, a terminal that no
// module has, what a timer or counter takes.
std::string whyRefused(const OperatingSystem& os, const Reference& reference);
// E, A, M, D; T and Z: width Bit is the output, any other the value as LC loads it; P: what the
// output modules give out, nothing while the PLC is not in RUN. Nothing if there is no such
// operand.
std::optional<std::uint32_t> readValue(const OperatingSystem& os, const Reference& reference);
// Inputs and P: the terminal, from where the image takes it. Timers: base and digits as a start
// operation takes them; counters: three digits. False: there is no such operand or terminal, or
// the digits are not decimal.
bool writeValue(OperatingSystem& os, const Reference& reference, std::uint32_t value);
// The same, but an input is written into the process image: until the next cycle reads it anew.
bool writeImage(OperatingSystem& os, const Reference& reference, std::uint32_t value);
// E, A and M only.
bool forceValue(OperatingSystem& os, const Reference& reference, std::uint32_t value);

}  // namespace merker::sinumerik
