// Machine instructions to intermediate code: one function per operation, by table.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "icode/builder.h"
#include "lowering5/translate.h"

namespace merker::translate5 {

// What U( and O( save until ).
struct Bracket {
  icode::Value vke, orBit;
  bool isOr;
};

// The instruction that is being translated, and what a function may use for it.
struct Lowering {
  icode::Builder& to;
  icode::Needs& needs;
  const Target& target;
  const mc5::Decoded& decoded;
  std::uint32_t place, length;  // words: of the instruction, of the block
  std::vector<Bracket>& brackets;
  const mc5::Decoded* next = nullptr;  // the instruction behind this one
  mc5::Times extra;                    // of the formal operand
  const Sites* sites = nullptr;
  bool ended = false;   // the way on leads elsewhere: nothing may follow in this region
  unsigned words = 0;   // of what was translated, if it is more than this instruction
  bool leaves = false;  // often left to the processor: behind it the next region must begin

  const mc5::Operand& operand() const { return decoded.instruction.operand; }
  mc5::Times times() const {
    const mc5::Times own = mc5::times(*decoded.encoding, target.variant);
    return {own.shortest + extra.shortest, own.longest + extra.longest};
  }
  // Of the call, if it leads into another block here.
  std::optional<std::uint32_t> site() const {
    if (sites == nullptr || !mayLeave()) return std::nullopt;
    const auto found = sites->find(place);
    return found == sites->end() ? std::nullopt : std::optional(found->second);
  }
  bool mayLeave() const { return brackets.empty(); }  // inside brackets there is no way out
};

// False: not translated; the builder has not been touched.
using Lower = bool (*)(Lowering&);
struct Row {
  mc5::Operation operation;
  Lower lower;
};

std::span<const Row> bitRows();
std::span<const Row> moveRows();
std::span<const Row> numberRows();
std::span<const Row> jumpRows();
std::span<const Row> cellRows();
std::span<const Row> linkRows();
std::span<const Row> processingRows();

// Operands in memory, nothing if this one is not translated. A place is the byte with the bit.
struct BytePlace {
  icode::Space space;
  std::uint32_t byte;
  std::uint32_t bit;
};
std::optional<BytePlace> bitPlace(Lowering& l, bool write);
std::optional<icode::Value> readBit(Lowering& l);
std::optional<icode::Value> readOperand(Lowering& l);
bool writeOperand(Lowering& l, icode::Value value);
// A data word by a number that is known when it runs; the other way is the processor's.
icode::Value readDataAt(Lowering& l, icode::Value word);
void writeDataAt(Lowering& l, icode::Value word, icode::Value value);

// Timers and counters: byte of their word in Space::Instance; S Z, R T and R Z.
bool isCell(const mc5::Operand& operand);
std::uint32_t cellPlace(const Lowering& l);
bool setCell(Lowering& l);
bool resetCell(Lowering& l);

}  // namespace merker::translate5
