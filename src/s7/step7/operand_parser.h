// Reads one operand of an instruction and resolves it: absolute, symbolic, local, indirect,
// constant.
#pragma once

#include <optional>

#include "block/width.h"
#include "step7/access.h"
#include "step7/compiler.h"
#include "step7/cursor.h"
#include "step7/interfaces.h"
#include "step7/mnemonic_use.h"
#include "step7/operand_words.h"
#include "step7/path.h"

namespace merker::step7 {

// A source may write SLD 0 to SLD 32 and P#0.0 to P#4095.7; the code has room for more, and a
// disassembler shows it.
enum class Limits : std::uint8_t { OfLanguage, OfCode };

// What an operand may refer to at its place.
struct Scope {
  const source::SourceFile* file = nullptr;
  Mnemonics mnemonics = Mnemonics::German;
  bool anyMnemonics = false;   // monitor and checks: E and I alike
  MnemonicUse* use = nullptr;  // null: a word of the other mnemonics is a problem
  const CompileOptions* options = nullptr;
  Interfaces* interfaces = nullptr;  // null: only `program`
  const block::Program* program = nullptr;
  const block::Block* block = nullptr;  // whose local names are visible; null outside of blocks
  const BlockNames* names = nullptr;    // of `block`
  Limits limits = Limits::OfLanguage;
  const CpuModel& model() const { return *options->model; }
  // [AR1,P#4095.7]; the code has room up to P#8191.7 (S7-IND-05).
  std::uint32_t highestOffset() const { return limits == Limits::OfLanguage ? 0x7FFF : 0xFFFF; }
  const block::Block* findBlock(BlockId id) const;
  MemberIndex* members() const;  // of what stays while blocks are compiled
  // A variable of the block; null if it declares no such name.
  const block::Variable* findVariable(std::string_view name) const {
    return names ? names->find(name) : nullptr;
  }
};

// A word of the other mnemonics was understood; `use` must be there.
void noteForeign(const Scope& scope, std::string_view word, const Position& place);

class OperandParser {
 public:
  // `transfers` holds the byte up to which local data are addressed absolutely; it grows.
  OperandParser(Cursor& cursor, const Scope& scope, Problems& problems, std::uint32_t& localTop)
      : cursor_(cursor), scope_(scope), problems_(problems), localTop_(localTop) {}

  // The operand at the cursor; nothing after a problem.
  std::optional<Access> parse();
  // A constant at the cursor, if one begins here.
  bool atConstant();
  std::optional<Access> constantOperand();

 private:
  std::optional<Access> dispatch();
  std::optional<Access> quoted();
  std::optional<Access> symbol(const std::string& name, std::size_t begin);
  bool isGlobalSymbol(std::string_view name) const;
  bool isOwnName(std::string_view name) const;
  std::optional<Access> unquoted(std::string_view name, std::size_t begin);
  std::optional<Access> local(std::string_view name, std::size_t begin);
  std::optional<Access> localVariable(const block::Variable& variable, std::size_t begin);
  std::optional<Access> parameterOfFunction(const block::Variable& variable, Access access,
                                            Place place);
  std::optional<Access> instanceVariable(const block::Variable& variable, Access access,
                                         Place place);
  std::optional<Access> numberParameter(const block::Variable& variable, Access access);
  std::optional<Access> placed(Access access, Area area, const Place& place, int reg);
  std::optional<Access> addressOf(std::size_t begin);
  std::optional<Access> word();
  std::optional<Access> memoryOperand(const MemoryWord& row);
  std::optional<Access> numbered(mc7::OperandKind direct, mc7::OperandKind indirect);
  std::optional<Access> blockOperand(BlockKind kind, bool instance);
  std::optional<Access> insideDataBlock(BlockId db, std::size_t begin);
  std::optional<Access> indirect(Area area, Width width, bool crossing);
  std::optional<Access> registerIndirect(Area area, Width width, bool crossing,
                                         std::string_view word);
  bool memoryPointer(Width width, mc7::Operand& out);
  bool bitAddressAt(Width width, BitAddress& out, std::size_t begin);
  bool checkRange(const MemoryWord& row, BitAddress address, std::size_t begin);
  bool checkSetting(std::optional<Mnemonics> which, std::string_view word, std::size_t begin);
  Access simple(const mc7::Operand& operand) const {
    Access access;
    access.operand = operand;
    return access;
  }
  Position at(std::size_t begin, std::size_t end) const {
    return scope_.file->position(begin, std::max(end, begin + 1) - begin);
  }
  template <typename... Arguments>
  std::nullopt_t problem(ProblemCode code, std::size_t begin, const Arguments&... arguments) {
    problems_.add(code, at(begin, cursor_.pos()), arguments...);
    return std::nullopt;
  }

  Cursor& cursor_;
  const Scope& scope_;
  Problems& problems_;
  std::uint32_t& localTop_;
  std::size_t begin_ = 0;
};

using block::widthOf;
bool isComposite(TypeCode code);

}  // namespace merker::step7
