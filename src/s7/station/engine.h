// Interpreter: the reference. Compiled: machine code of the host where there is a compiler for it,
// with the same results.
#pragma once

#include <cstdint>

namespace merker::station {

enum class Engine : std::uint8_t { Interpreter, Compiled };

}  // namespace merker::station
