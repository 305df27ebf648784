// What can go wrong around the PLC of a control, by the words of a scenario: "fault unit silent"
// (S5-ERR-02, S5-ERR-19; docs/formats/scenario.md).
#pragma once

#include <string>
#include <string_view>

namespace merker::cnc {

class Cnc;

// A subject is `unit`, `memory`, `coupling` … or a module: its name, "EB 4" or "AB 8". "" or what
// there is instead.
std::string setFault(Cnc& control, std::string_view subject, std::string_view kind, bool on);

}  // namespace merker::cnc
