// One side of a comparison, or a value that is set: a constant in AWL notation or an operand of the
// program.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "address/constant.h"
#include "address/reference.h"
#include "base/problem.h"

namespace merker::simulator {

struct Term {
  std::string text;  // as written
  Position position;
  std::optional<Constant> constant;
  address::Reference reference;        // unless it is a constant
  std::optional<std::string> content;  // a constant of a DATE_AND_TIME or STRING (long_value.h)
};

// What an operand's text stands for in the program at hand, and the constants of its language
// beside those of STEP 7.
struct Resolver {
  using Operands =
      std::function<Result<address::Reference>(std::string_view text, const Position& at)>;
  using Constants = std::function<std::optional<Constant>(std::string_view text)>;
  template <typename F>
  requires std::is_constructible_v<Operands, F> Resolver(
      F resolveOperands, Constants more = {},
      bool sinumerik = false)  // NOLINT: a plain function will do
      : operands(std::move(resolveOperands)), constants(std::move(more)), ofControl(sinumerik) {}

  Result<address::Reference> operator()(std::string_view text, const Position& at) const {
    return operands(text, at);
  }
  Operands operands;
  Constants constants;
  bool ofControl;  // a SINUMERIK: it has no rack and judges its faults itself
};
// The present value of an operand; nothing if it does not exist.
using Reader = std::function<std::optional<std::uint32_t>(const address::Reference&)>;

// Fills `constant` or `reference` from `text`. The problem if it is neither.
std::optional<Problem> resolveTerm(Term& term, const Resolver& resolver);
std::optional<Problem> resolveOperand(Term& term, const Resolver& resolver);
// Both sides of a comparison or assignment: beside a DATE_AND_TIME or STRING a constant is one of
// its type.
void resolvePair(Term& left, Term& right, const Resolver& resolver, Problems& problems);

// Bits of an operand: 1, 8, 16 or 32; 16 for timers and counters.
unsigned bitWidth(const address::Reference& reference);

// The constant as a value of this type: an integer becomes a DINT with its sign, or a REAL, where
// the operand is one.
Constant adapt(const Constant& constant, TypeCode type);

}  // namespace merker::simulator
