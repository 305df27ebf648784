// Operands in AWL notation, one printer per kind of operand.
#pragma once

#include <string>

#include "mc7/instruction.h"

namespace merker::mc7 {

// The letter of an area: "E", "A", "M", "DB", "DI", "L", "V", in pointers "P" for the periphery.
std::string_view areaName(Area area, Mnemonics mnemonics);
// "P#2.0"; with an area "P#E 0.0", as in a parameter list.
std::string pointerText(Area area, BitAddress address, Mnemonics mnemonics);
// Empty if there is no operand. The operation decides between PE and PA.
std::string operandText(const Instruction& instruction, Mnemonics mnemonics);

}  // namespace merker::mc7
