// What a timer or counter takes from outside: the word that LC loads, with three BCD digits; a
// timer has its base above them (S7-SIM-03, S5-TIMER-11). Only a program may load other digits.
#pragma once

#include "address/reference.h"
#include "base/bcd.h"

namespace merker::controller {

inline bool isCell(const address::Reference& reference) {
  return address::isTimer(reference.operand) || address::isCounter(reference.operand);
}

inline bool isCellValue(address::OperandKind kind, std::uint32_t word) {
  const std::uint32_t highest = kind == address::OperandKind::Timer ? 0x3999 : 0x999;
  return word <= highest && fromBcd(word & 0xFFF, 3).has_value();
}

}  // namespace merker::controller
