// The fields of the screens that a programmer shows of a STOP, by their names there (8.2, 8.3).
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "softplc/operating_system.h"

namespace merker::sinumerik {

// TIEFE, BEF-REG, XX-NR, VKE, NAU … of the interrupt stack, the control bits, and FEHLCODE, ALARM,
// XXX1 to XXX3, ZOB2 of the fine coding, in any case: "01", "3309", "PB 5", "-", "1". Nothing if
// there is no such field.
std::optional<std::string> interruptField(const OperatingSystem& os, std::string_view name);
std::string interruptFields();  // their names

// "1": the block that waits innermost, "1 ADR", "1 REL", "1 DB" of it, "ENTRIES": how many wait.
std::optional<std::string> blockField(const OperatingSystem& os, std::string_view name);
std::string blockFields();

// "BEF-REG 3309, SAZ 002A, XX-NR PB 5, …": what tells most in one line.
std::string stopLine(const OperatingSystem& os);

}  // namespace merker::sinumerik
