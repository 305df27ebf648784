#include "monitor/cross_reference.h"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>

#include "base/bytes.h"
#include "mc7/disassembly.h"
#include "mc7/operand_text.h"

namespace merker::monitor {
namespace {

using mc7::Operand;
using mc7::OperandKind;
using mc7::Operation;

constexpr Operation kWrites[] = {Operation::ASSIGN,   Operation::SET_BIT,  Operation::RESET_BIT,
                                 Operation::TRANSFER, Operation::TIMER_SI, Operation::TIMER_SV,
                                 Operation::TIMER_SE, Operation::TIMER_SS, Operation::TIMER_SA,
                                 Operation::ENABLE,   Operation::COUNT_UP, Operation::COUNT_DOWN,
                                 Operation::TAR1,     Operation::TAR2};
constexpr Operation kBoth[] = {Operation::EDGE_POSITIVE, Operation::EDGE_NEGATIVE};

Use useOf(Operation operation) {
  if (std::ranges::find(kWrites, operation) != std::end(kWrites)) return Use::Write;
  return std::ranges::find(kBoth, operation) != std::end(kBoth) ? Use::ReadWrite : Use::Read;
}

Use useOf(block::Section section) {
  if (section == block::Section::Input) return Use::Read;
  return section == block::Section::InOut ? Use::ReadWrite : Use::Write;
}

bool isCall(Operation operation) {
  return operation == Operation::UC || operation == Operation::CC;
}

// Inputs, outputs, flags, periphery, timers, counters, data blocks, blocks.
int rank(const CrossReference& r) {
  if (r.key.kind == OperandKind::Timer) return 4;
  if (r.key.kind == OperandKind::Counter) return 5;
  if (r.key.kind == OperandKind::Block) return 7 + static_cast<int>(r.key.blockKind);
  if (r.db >= 0) return 6;
  return r.key.area == Area::Input    ? 0
         : r.key.area == Area::Output ? 1
         : r.key.area == Area::Flag   ? 2
                                      : 3;
}

std::optional<source::SymbolAddress> symbolAddress(const Operand& key, bool output) {
  using Kind = source::SymbolAddress::Kind;
  source::SymbolAddress address;
  address.kind = key.kind == OperandKind::Timer     ? Kind::Timer
                 : key.kind == OperandKind::Counter ? Kind::Counter
                 : key.kind == OperandKind::Block   ? Kind::Block
                                                    : Kind::Memory;
  if (address.kind == Kind::Memory) {
    if (key.area == Area::DataBlock) return std::nullopt;
    address.area = key.area;
    address.width = key.width;
    address.address = key.value;
    address.peripheralOutput = key.area == Area::Peripheral && output;
  } else if (address.kind == Kind::Block) {
    address.block = {key.blockKind, static_cast<std::uint16_t>(key.value)};
  } else {
    address.number = static_cast<std::uint16_t>(key.value);
  }
  return address;
}

// One block, instruction by instruction.
class Walk {
 public:
  Walk(const block::Block& block, const block::Program& program, const source::SymbolTable& symbols,
       const CrossReferenceOptions& options, std::vector<CrossReference>& out)
      : block_(block), program_(program), symbols_(symbols), options_(options), out_(out) {}

  void run() {
    const std::span<const std::uint8_t> code(block_.code);
    while (at_ < code.size()) {
      const auto decoded = mc7::decode(code.subspan(at_));
      if (decoded) instruction(decoded->instruction);
      const std::size_t length = decoded ? decoded->length : 2;
      const bool call = decoded && isCall(decoded->instruction.operation);
      if (call) parameters(decoded->instruction, code.subspan(std::min(at_ + length, code.size())));
      at_ += length + (call ? skip_ : 0);
    }
  }

 private:
  void instruction(const mc7::Instruction& one) {
    const Operand& operand = one.operand;
    if (statementAt(block_, offset()).begin != statement_) openDb_ = -1;
    statement_ = statementAt(block_, offset()).begin;
    if (operand.kind == OperandKind::Memory || operand.kind == OperandKind::Timer ||
        operand.kind == OperandKind::Counter)
      add(operand, useOf(one.operation), one);
    if (operand.kind == OperandKind::Block) add(operand, Use::Call, one);
    if (one.operation == Operation::OPEN)
      openDb_ = operand.kind == OperandKind::Block && operand.reg == 0
                    ? static_cast<std::int32_t>(operand.value)
                    : -1;
    if (operand.pointerArea != Area::None) pointer(one);
  }

  // [MD 4], T [MW 4]: the pointer itself is read.
  void pointer(const mc7::Instruction& one) {
    const bool memory = one.operand.kind == OperandKind::MemoryIndirect;
    add(mc7::memory(one.operand.pointerArea, memory ? Width::DWord : Width::Word,
                    bitAddress(one.operand.value)),
        Use::Read, one);
  }

  void add(Operand key, Use use, const mc7::Instruction& one) {
    if (key.kind == OperandKind::Memory) {
      const bool data = key.area == Area::DataBlock;
      if (data ? openDb_ < 0 : key.area < Area::Peripheral || key.area > Area::Flag) return;
    }
    key.reg = 0;
    CrossReference row;
    row.key = key;
    row.db = key.kind == OperandKind::Memory && key.area == Area::DataBlock ? openDb_ : -1;
    row.use = use;
    row.place = sourcePlace(block_, offset());
    row.statement = statementNumber();
    row.instruction = mc7::text(one, options_.mnemonics);
    const bool output = use == Use::Write;
    row.operand =
        mc7::operandText({output ? Operation::TRANSFER : Operation::LOAD, key}, options_.mnemonics);
    if (key.kind == OperandKind::Block)
      row.operand = toString(BlockId{key.blockKind, static_cast<std::uint16_t>(key.value)});
    if (row.db >= 0) row.operand = fmt::format("DB{}.{}", row.db, row.operand);
    if (const auto address = symbolAddress(key, output))
      if (const source::Symbol* symbol = symbols_.findAddress(*address)) row.symbol = symbol->name;
    if (!listed(row)) out_.push_back(std::move(row));
  }

  // A CALL reads one operand several times.
  bool listed(const CrossReference& row) const {
    for (auto old = out_.rbegin(); old != out_.rend() && old->place.block == row.place.block;
         ++old) {
      if (statementAt(block_, old->place.offset).begin != statement_) return false;
      if (old->operand == row.operand && old->use == row.use) return true;
    }
    return false;
  }

  const block::Block* called(const Operand& operand) const {
    const BlockId id{operand.blockKind, static_cast<std::uint16_t>(operand.value)};
    const auto own = program_.find(id);
    if (own != program_.end()) return &own->second;
    if (options_.library == nullptr) return nullptr;
    const auto system = options_.library->find(id);
    return system == options_.library->end() ? nullptr : &system->second;
  }

  // The list behind a call of an FC or SFC (MC7 section 7.2).
  void parameters(const mc7::Instruction& call, std::span<const std::uint8_t> code) {
    skip_ = 0;
    const bool list =
        call.operand.kind == OperandKind::Block &&
        (call.operand.blockKind == BlockKind::FC || call.operand.blockKind == BlockKind::SFC);
    const int entries = list ? mc7::parameterListLength(code) : -1;
    if (entries <= 0) return;
    skip_ = 4 + 4 * static_cast<std::size_t>(entries);
    const block::Block* target = called(call.operand);
    if (target == nullptr) return;
    const std::vector<const block::Variable*> formal = block::parameters(*target);
    for (std::size_t i = 0; i < formal.size() && i < static_cast<std::size_t>(entries); ++i)
      parameter(*formal[i], loadDWord(&code[4 + 4 * i]), call);
  }

  void parameter(const block::Variable& formal, std::uint32_t entry, const mc7::Instruction& call) {
    if (!formal.type) return;
    const Use use = useOf(formal.section);
    const TypeCode type = formal.type->code;
    if (type == TypeCode::Timer)
      return add(mc7::number(OperandKind::Timer, entry >> 16), use, call);
    if (type == TypeCode::Counter)
      return add(mc7::number(OperandKind::Counter, entry >> 16), use, call);
    if (!isElementary(type)) return;
    const unsigned bits = bitWidth(type);
    const Width width = bits == 1    ? Width::Bit
                        : bits == 8  ? Width::Byte
                        : bits == 16 ? Width::Word
                                     : Width::DWord;
    add(mc7::memory(pointerArea(entry), width, pointerAddress(entry)), use, call);
  }

  std::uint32_t offset() const { return static_cast<std::uint32_t>(at_); }

  std::uint32_t statementNumber() const {
    const std::uint32_t network = networkAt(block_, offset());
    const std::uint32_t begin = network == 0 ? 0 : block_.networks[network - 1].offset;
    return static_cast<std::uint32_t>(
        std::count_if(block_.lines.begin(), block_.lines.end(), [&](const block::LineEntry& entry) {
          return entry.offset >= begin && entry.offset <= statement_;
        }));
  }

  const block::Block& block_;
  const block::Program& program_;
  const source::SymbolTable& symbols_;
  const CrossReferenceOptions& options_;
  std::vector<CrossReference>& out_;
  std::size_t at_ = 0, skip_ = 0;
  std::uint32_t statement_ = UINT32_MAX;
  std::int32_t openDb_ = -1;
};

}  // namespace

std::string_view name(Use use) {
  constexpr std::string_view kNames[] = {"R", "W", "RW", "-"};
  return kNames[static_cast<std::size_t>(use)];
}

std::vector<CrossReference> crossReferences(const block::Program& program,
                                            const source::SymbolTable& symbols,
                                            const CrossReferenceOptions& options) {
  std::vector<CrossReference> list;
  for (const auto& [id, block] : program)
    if (!block.code.empty()) Walk(block, program, symbols, options, list).run();
  std::stable_sort(list.begin(), list.end(), [](const CrossReference& a, const CrossReference& b) {
    return std::tuple(rank(a), a.db, a.key.value, a.key.width) <
           std::tuple(rank(b), b.db, b.key.value, b.key.width);
  });
  return list;
}

}  // namespace merker::monitor
