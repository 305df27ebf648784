// The actual parameters of a CALL: what is written behind the formal names, checked against the
// declaration.
#pragma once

#include <map>
#include <optional>

#include "step7/block_compiler.h"

namespace merker::step7 {

// Called block and, for an FB, the data it works on.
struct CallTarget {
  BlockId id;
  const block::Block* block = nullptr;
  std::int32_t instanceDb = -1;               // CALL FB n, DB m
  const block::Variable* instance = nullptr;  // CALL #inst
  // "FC 1 (AD_DT_TM)": a library function says who it is.
  std::string name() const {
    return block->symbol.empty() ? toString(id) : toString(id) + " (" + block->symbol + ")";
  }
  bool isFunction() const { return id.kind == BlockKind::FC || id.kind == BlockKind::SFC; }
};

struct Actual {
  std::optional<Access> access;  // operand, variable or constant; nothing for NIL and P#…
  bool nil = false;
  bool isPointer = false;  // P#DB10.DBX4.0 WORD 5
  std::uint16_t db = 0;
  std::uint32_t pointer = 0;
  TypeCode anyType = TypeCode::Void;  // with a count: ANY; Void: POINTER
  std::uint16_t anyCount = 0;
  std::size_t begin = 0, end = 0;

  bool isConstant() const {
    return access && access->kind == Access::Kind::Machine &&
           access->operand.kind == mc7::OperandKind::Constant;
  }
};

using Actuals = std::map<const block::Variable*, Actual>;

class CallParameters {
 public:
  CallParameters(BlockCompiler& compiler, const CallTarget& target)
      : c_(compiler), target_(target) {}
  // Reads ( name := actual, … ) or, as the editor shows it, one name := actual a line. Empty
  // optional after a problem.
  std::optional<Actuals> read();
  // Whether a library function is called and none of the names is a parameter of it: the caller
  // means his own block of this number, which is not in the program.
  bool ofAnotherBlock();
  // Past the list of a block that is not known: the name is the problem, not its parameters.
  void skip();

 private:
  bool body(bool bracketed);
  void skipParameter();
  bool parameter();
  bool actual(Actual& out);
  bool pointer(Actual& out);
  bool check(const block::Variable& formal, Actual& actual);
  bool checkElementary(const block::Variable& formal, Actual& actual);
  bool checkConstant(const block::Variable& formal, Actual& actual);
  bool checkComposite(const block::Variable& formal, const Actual& actual);
  bool checkNumber(const block::Variable& formal, const Actual& actual);
  bool checkForwarding(const block::Variable& formal, const Actual& actual);
  bool complete(std::size_t begin);
  bool acceptBracket();
  bool atParameterLine();
  bool noneKnown();
  const block::Variable* formal(std::string_view name) const;
  bool problem(ProblemCode code, std::size_t begin, std::size_t end, const auto&... arguments) {
    c_.problems().add(code, c_.at(begin, end), arguments...);
    return false;
  }
  bool mismatch(const block::Variable& formal, const Actual& actual);

  BlockCompiler& c_;
  const CallTarget& target_;
  Actuals actuals_;
};

}  // namespace merker::step7
