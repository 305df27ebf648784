// Operands for tests that need no compiler.
#pragma once

#include <map>
#include <string>

#include "scenario/term.h"

namespace merker::simulator {

inline address::Reference flag(Width width, std::uint32_t byte, TypeCode type = TypeCode::Void) {
  return {"M", address::memory(Area::Flag, width, bitAddress(byte)), -1, type};
}

// "MW 10", "MB 3", "MD 4", "M 1.0", "T 1", "Z 1", and "int", "dint", "real", "time" for typed
// variables.
inline Result<address::Reference> resolveFake(std::string_view text, const Position& at) {
  const std::map<std::string, address::Reference, std::less<>> known = {
      {"MW 10", flag(Width::Word, 10)},
      {"MB 3", flag(Width::Byte, 3)},
      {"MD 4", flag(Width::DWord, 4)},
      {"M 1.0", flag(Width::Bit, 1)},
      {"T 1", {"T 1", address::timer(1)}},
      {"Z 1", {"Z 1", address::counter(1)}},
      {"int", flag(Width::Word, 10, TypeCode::Int)},
      {"dint", flag(Width::DWord, 4, TypeCode::DInt)},
      {"real", flag(Width::DWord, 4, TypeCode::Real)},
      {"string",
       {"string", address::memory(Area::DataBlock, Width::Byte, 0), 1, TypeCode::String, false, 7}},
      {"dt",
       {"dt", address::memory(Area::DataBlock, Width::Byte, 0), 1, TypeCode::DateAndTime, false,
        8}},
      {"time", flag(Width::DWord, 4, TypeCode::Time)}};
  const auto found = known.find(text);
  if (found == known.end()) return makeProblem(ProblemCode::P0952, at, "an operand");
  return found->second;
}

inline Term term(std::string text) {
  Term result{std::move(text), {}, {}, {}, {}};
  resolveTerm(result, resolveFake);
  return result;
}

}  // namespace merker::simulator
