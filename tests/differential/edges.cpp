// Cases that come by chance too seldom: every pair of neighbouring edges in the accumulators, and
// timers that are looked at when they end.
#include "edges.h"

#include <iterator>
#include <random>

#include "case.h"
#include "mc7/encoding.h"

namespace merker::differential {
namespace {

using mc7::OperandKind;
using mc7::Operation;
using Code = std::vector<std::uint8_t>;

constexpr auto kCount = static_cast<std::uint32_t>(std::size(kEdges));
constexpr std::uint32_t kResults = 4 * kCount;  // flag bytes behind those of the edges
static_assert(kResults + 6 * kCount <= 256);

void append(Operation operation, const mc7::Operand& operand, Code& code) {
  (void)mc7::encode({operation, operand}, code);
}
mc7::Operand flag(Width width, std::uint32_t byte) {
  return mc7::memory(Area::Flag, width, bitAddress(byte, 0));
}
mc7::Operand constant(std::uint32_t value) { return mc7::constant(ConstantFormat::DWord, value); }

// Edge i, either known where the code is translated or only when it runs.
void load(std::uint32_t i, bool known, Code& code) {
  append(Operation::LOAD,
         known ? constant(kEdges[i % kCount]) : flag(Width::DWord, 4 * (i % kCount)), code);
}

// The row with the edge, or with a count, as its operand; nothing if it wants something else.
bool appendRow(std::size_t row, std::uint32_t i, Code& code) {
  const mc7::Encoding& encoding = mc7::encodings()[row];
  const Operation o = encoding.operation;
  if (o == Operation::BE || o == Operation::BEA || o == Operation::BEB) return false;
  mc7::Operand operand = encoding.operand;
  if (operand.kind == OperandKind::Constant)
    operand.value = bitWidth(operand.format) == 32 ? kEdges[i] : kEdges[i] & 0xFFFF;
  else if (operand.kind == OperandKind::ShiftCount)
    operand.value = i;
  else if (operand.kind != OperandKind::None)
    return false;
  return mc7::encode(encoding, operand, code);
}

// A jump over one instruction: where it leads a region begins, which knows no numbers and is
// compiled even if the one before left its rest to the interpreter.
void cut(Code& code) {
  append(Operation::SPA, {.kind = OperandKind::Jump, .value = 3}, code);
  append(Operation::NOP0, {}, code);
}

// What would stop the CPU if it were missing.
void addInterrupts(Case& c) {
  for (const std::uint16_t ob : {35, 40, 121}) c.blocks[{BlockKind::OB, ob}] = {0x65, 0x00};  // BE
}

}  // namespace

std::optional<Case> edgeCase(std::size_t row, std::uint32_t distance, bool known) {
  Case c;
  c.seed = static_cast<std::uint32_t>(4 * row + 1);
  Code& code = c.blocks[{BlockKind::OB, 1}];
  for (std::uint32_t i = 0; i < kCount; ++i) {
    append(Operation::LOAD, constant(kEdges[i]), code);
    append(Operation::TRANSFER, flag(Width::DWord, 4 * i), code);
  }
  bool any = false;
  for (std::uint32_t i = 0; i < kCount; ++i) {
    cut(code);
    load(i + distance, known, code);
    load(i, known, code);
    any = appendRow(row, i, code) || any;
    append(Operation::TRANSFER, flag(Width::DWord, kResults + 6 * i), code);
    append(Operation::LOAD_STW, {.kind = OperandKind::StatusWord}, code);
    append(Operation::TRANSFER, flag(Width::Word, kResults + 6 * i + 4), code);
  }
  if (!any) return std::nullopt;
  code.insert(code.end(), {0x65, 0x00});  // BE
  addInterrupts(c);
  return c;
}

Case timerCase(std::uint32_t seed) {
  constexpr std::uint32_t kTimers = 8, kLooks = 40;
  constexpr Operation kQueries[] = {Operation::AND, Operation::OR, Operation::AND_NOT,
                                    Operation::LOAD, Operation::LOAD_BCD};
  std::mt19937 random(seed);
  Case c;
  c.seed = seed * 4 + 1;
  Code& code = c.blocks[{BlockKind::OB, 1}];
  for (std::uint32_t i = 0; i < kLooks; ++i) {
    if (i % 4 == 0) cut(code);
    const Operation query = kQueries[random() % std::size(kQueries)];
    const bool bit = query != Operation::LOAD && query != Operation::LOAD_BCD;
    append(query, mc7::number(OperandKind::Timer, static_cast<std::uint32_t>(random() % kTimers)),
           code);
    append(bit ? Operation::ASSIGN : Operation::TRANSFER,
           flag(bit ? Width::Bit : Width::Word, 100 + 2 * i), code);
  }
  append(Operation::SPA, {.kind = OperandKind::Jump}, code);  // what was seen stays
  addInterrupts(c);
  return c;
}

Case nestingCase() {
  const auto call = [](std::uint32_t function, Code& code) {
    append(Operation::UC, mc7::blockOperand(BlockKind::FC, function), code);
  };
  Case c;
  c.seed = 1;
  Code& leaf = c.blocks[{BlockKind::FC, 1}];
  append(Operation::LOAD, flag(Width::Word, 22), leaf);
  append(Operation::INC, {.kind = OperandKind::ShiftCount, .value = 1}, leaf);
  append(Operation::TRANSFER, flag(Width::Word, 22), leaf);
  Code& itself = c.blocks[{BlockKind::FC, 4}];
  call(1, itself);
  call(4, itself);
  call(4, c.blocks[{BlockKind::OB, 1}]);
  for (auto& [id, code] : c.blocks) code.insert(code.end(), {0x65, 0x00});  // BE
  addInterrupts(c);
  return c;
}

// Behind SWAP the blocks have each other's lengths (fill of run.cpp: 40 and 64 bytes).
Case swapCase(std::uint32_t seed) {
  constexpr std::uint32_t kAccesses = 12;
  std::mt19937 random(seed);
  const auto below = [&](std::uint32_t n) { return static_cast<std::uint32_t>(random() % n); };
  Case c;
  c.seed = seed * 4 + 1;
  Code& code = c.blocks[{BlockKind::OB, 1}];
  append(Operation::OPEN, mc7::blockOperand(BlockKind::DB, 1 + below(2)), code);
  append(Operation::OPEN, mc7::blockOperand(BlockKind::DB, 1 + below(3), true), code);
  for (std::uint32_t i = 0; i < kAccesses; ++i) {
    cut(code);
    const Area area = below(2) == 0 ? Area::DataBlock : Area::Instance;
    const std::uint32_t byte = 34 + 2 * below(18);
    append(Operation::LAR1, mc7::constant(ConstantFormat::Pointer, pointer(area, 8 * byte)), code);
    if (below(3) != 0) append(Operation::SWAP_DB, {}, code);
    if (below(3) == 0) append(Operation::SWAP_DB, {}, code);
    const auto width = below(2) == 0 ? Width::Word : Width::DWord;
    append(below(2) == 0 ? Operation::LOAD : Operation::TRANSFER,
           below(2) == 0 ? mc7::registerIndirect(area, width, 1, bitAddress(0))
                         : mc7::registerCrossing(width, 1, 0),
           code);
  }
  append(Operation::SPA, {.kind = OperandKind::Jump}, code);
  addInterrupts(c);
  return c;
}

}  // namespace merker::differential
