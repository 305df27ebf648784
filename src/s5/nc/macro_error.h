// Why a function macro stops the PLC: alarm 6114 with AKKU 1 = number of the macro, AKKU 2 = error
// (S5-FM-05).
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "softplc/machine.h"
#include "softplc/trap.h"

namespace merker::nc {

struct MacroError {
  std::uint16_t macro = 0;
  std::uint8_t number = 0;
  std::string_view german, english;
};

std::span<const MacroError> macroErrors();
// Of the accumulators in the interrupt stack: the high byte of AKKU 2 is not looked at. Null if
// that macro has no such error.
const MacroError* findMacroError(std::uint32_t akku1, std::uint32_t akku2);

// What AKKU 2 gets: nothing if all is well.
using Error = std::optional<std::uint16_t>;

// Accumulators and trap. Words: xxx2 = AKKU 2, xxx3 = number of the macro in BCD.
sinumerik::Trap macroTrap(sinumerik::Machine& machine, std::uint16_t macro, std::uint16_t error);

}  // namespace merker::nc
