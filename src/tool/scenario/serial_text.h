// Characters of a serial line as scenarios write them: "text", 1F, 00..FF, 55*128, STX, BCC.
#pragma once

#include <string>
#include <string_view>

#include "scenario/step_line.h"
#include "serial/rk512.h"

namespace merker::simulator {

// False: a problem was added. BCC is the exclusive or of what the text has before it, !BCC a wrong
// one.
bool parseCharacters(const StepLine& line, std::string_view text, serial::Bytes& bytes);
// "02 10 'ABC' 0D": for messages, at most 64 characters.
std::string showCharacters(const serial::Bytes& bytes);

// DB10.DBB4, DX5.DBB0, MB100, EB0, AB4, T16, Z1; nothing if it is none of these.
std::optional<serial::LinkJob> parseArea(std::string_view text);

}  // namespace merker::simulator
