// The operand of an instruction, with what stands before it to reach it, as the bytes that `graph`
// keeps for us.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "mc7/operand.h"

namespace merker::graph7 {

struct OperandCode {
  std::vector<std::uint8_t> before;  // machine code: AUF DB 5, the way to a member of a parameter
  mc7::Operand operand;
};

std::string pack(std::span<const std::uint8_t> before, const mc7::Operand& operand);
OperandCode unpack(const std::string& packed);

}  // namespace merker::graph7
