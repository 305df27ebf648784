// The width of the operand that a value of a type takes.
#pragma once

#include "address/area.h"
#include "address/type_code.h"

namespace merker::block {

// TIMER, COUNTER and BLOCK_* are numbers of a word; what has no width of its own (DT, STRING …) is
// accessed by double words.
constexpr Width widthOf(unsigned bits) {
  return bits == 1 ? Width::Bit : bits == 8 ? Width::Byte : bits == 16 ? Width::Word : Width::DWord;
}
inline Width widthOf(TypeCode code) {
  return isParameterNumber(code) ? Width::Word : widthOf(bitWidth(code));
}

}  // namespace merker::block
