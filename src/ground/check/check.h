// What a self-checking source says with //= about the state after an instruction (command line
// contract).
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/problem.h"

namespace merker::block {

enum class CheckRegister : std::uint8_t {
  VKE,
  STA,
  OR,
  OS,
  OV,
  A0,
  A1,
  BIE,
  ER,
  AKKU1,
  AKKU2,
  AKKU3,
  AKKU4,
  AR1,
  AR2,
  STW,
  DBNO,
  DINO
};

enum class Relation : std::uint8_t {
  Equal,
  NotEqual,
  Less,
  LessEqual,
  Greater,
  GreaterEqual,
  About
};

struct CheckValue {
  enum class Kind : std::uint8_t { Constant, Register, BitCode, ValueCode } kind = Kind::Constant;
  std::uint32_t constant = 0;
  CheckRegister reg = CheckRegister::VKE;
  // MC7 that queries (BitCode: the result is VKE) or loads (ValueCode: the result is AKKU1) an
  // operand; it runs on a copy of the registers, in the block and at the place of the check.
  std::vector<std::uint8_t> code;
  unsigned width = 32;  // bits
};

struct CheckTerm {
  CheckValue left, right;
  Relation relation = Relation::Equal;
  std::string text;  // as written, for the message
};

struct Check {
  std::uint32_t offset = 0;  // of the instruction after whose completion the check runs
  Position position;
  std::vector<CheckTerm> terms;
};

}  // namespace merker::block
