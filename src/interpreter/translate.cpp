#include "interpreter/translate.h"

#include <algorithm>

#include "address/constant.h"
#include "base/bytes.h"
#include "interpreter/fault.h"

namespace merker::interpreter {
namespace {

using mc7::OperandKind;
using mc7::Operation;

constexpr std::uint32_t kJump = 0x700B;

struct KindForm {
  OperandKind kind;
  Form form;
};
constexpr KindForm kForms[] = {
    {OperandKind::None, Form::None},
    {OperandKind::Memory, Form::Memory},
    {OperandKind::MemoryIndirect, Form::Memory},
    {OperandKind::RegisterIndirect, Form::Memory},
    {OperandKind::RegisterCrossing, Form::Memory},
    {OperandKind::Parameter, Form::Memory},
    {OperandKind::Timer, Form::Timer},
    {OperandKind::TimerIndirect, Form::Timer},
    {OperandKind::TimerParameter, Form::Timer},
    {OperandKind::Counter, Form::Counter},
    {OperandKind::CounterIndirect, Form::Counter},
    {OperandKind::CounterParameter, Form::Counter},
    {OperandKind::StatusBit, Form::StatusBit},
    {OperandKind::Constant, Form::Constant},
    {OperandKind::Pointer, Form::Constant},
    {OperandKind::ShiftCount, Form::Constant},
};

Form generalForm(OperandKind kind) {
  for (const KindForm& row : kForms)
    if (row.kind == kind) return row.form;
  return Form::Other;
}

bool isCall(const Op& op) { return op.operation == Operation::UC || op.operation == Operation::CC; }
bool hasList(const Op& op) {
  return isCall(op) && (op.blockKind == BlockKind::FC || op.blockKind == BlockKind::SFC);
}

// Entries of the parameter list at `at` (MC7 section 7.2); 0 if there is none.
std::uint32_t listEntries(std::span<const std::uint8_t> code, std::size_t at, const Op& call) {
  if (at + 4 > code.size() || loadWord(&code[at]) != kJump) return 0;
  const std::uint32_t words = loadWord(&code[at + 2]);
  const bool direct = call.kind == OperandKind::Block;
  if (!direct || words < 4 || words % 2 != 0 || at + words * 2u > code.size()) return 0;
  return (words - 2) / 2;
}

Op plain(Handler handler, std::uint32_t offset) {
  Op op;
  op.run = handler;
  op.offset = offset;
  return op;
}

bool isJump(const Op& op) { return op.kind == OperandKind::Jump; }

std::int32_t distance(const OpByWord& opAt, std::int64_t offset, std::size_t from,
                      std::size_t unknown) {
  const bool inside = offset >= 0 && offset / 2 < static_cast<std::int64_t>(opAt.size());
  const std::int32_t found = inside ? opAt[static_cast<std::size_t>(offset / 2)] : -1;
  const std::size_t to = found < 0 ? unknown : static_cast<std::size_t>(found);
  return static_cast<std::int32_t>(static_cast<std::int64_t>(to) - static_cast<std::int64_t>(from));
}

// The entries of SPL must be SPA instructions directly behind it.
bool listComplete(const std::vector<Op>& ops, std::size_t at, std::uint32_t instructions) {
  const Op& op = ops[at];
  for (std::uint32_t k = 1; k <= op.count; ++k) {
    if (at + k >= instructions) return false;
    const Op& entry = ops[at + k];
    if (entry.operation != Operation::SPA || entry.offset != op.offset + 4 * k) return false;
  }
  return true;
}

void resolveJumps(Translated& out, const OpByWord& opAt) {
  const std::size_t unknown = out.instructionCount + 1;
  for (std::size_t i = 0; i < out.instructionCount; ++i) {
    Op& op = out.ops[i];
    if (isJump(op)) {
      const std::int64_t words = static_cast<std::int32_t>(op.value);
      op.target = distance(opAt, op.offset + words * 2, i, unknown);
    } else if (op.kind == OperandKind::JumpList) {
      if (!listComplete(out.ops, i, out.instructionCount)) op.run = unknownCode;
      op.target = distance(opAt, op.offset + 4 * (op.count + 1), i, unknown);
    }
  }
}

}  // namespace

// E, A, M inside the model's limits, DB, DI and L have handlers of their own.
Form Translator::directForm(Op& op) const {
  const bool whole = op.width == Width::Bit || (op.value & 7) == 0;
  if (op.area == Area::DataBlock) return Form::Data;
  if (op.area == Area::Instance) return Form::Instance;
  if (op.area == Area::Local) return Form::Local;
  const std::uint32_t byte = op.value / 8;
  if (!whole || byte + byteCount(op.width) > cpu::imageLength(model_, op.area)) return Form::Memory;
  return Form::Image;
}

Form Translator::formOf(const mc7::Instruction& instruction, Op& op) const {
  if (op.kind != OperandKind::Memory) return generalForm(op.kind);
  const Form form = directForm(op);
  if (handlers_.find(instruction.operation, form, op.width) == nullptr) return Form::Memory;
  if (form == Form::Image) op.value = cpu::imageBase(model_, op.area) + op.value / 8;
  return form;
}

Op Translator::makeOp(const mc7::Instruction& instruction, std::uint32_t offset) const {
  const mc7::Operand& operand = instruction.operand;
  Op op;
  op.cost = model_.time(mc7::info(instruction.operation).time);
  op.value = operand.value;
  op.offset = offset;
  op.operation = instruction.operation;
  op.kind = operand.kind;
  op.area = operand.area;
  op.pointerArea = operand.pointerArea;
  op.width = operand.width;
  op.reg = operand.reg;
  op.mask = static_cast<std::uint8_t>(1u << (operand.value & 7));
  op.blockKind = operand.blockKind;
  if (operand.kind == OperandKind::Constant)
    op.width = bitWidth(operand.format) == 32 ? Width::DWord : Width::Word;
  if (operand.kind == OperandKind::JumpList) op.count = static_cast<std::uint16_t>(operand.value);
  const Form form = formOf(instruction, op);
  const Handler handler = handlers_.find(instruction.operation, form, op.width);
  op.run = handler == nullptr ? unknownCode : handler;
  return op;
}

OpByWord Translator::translate(std::span<const std::uint8_t> code, Translated& out) const {
  OpByWord opAt(code.size() / 2 + 1, -1);
  std::size_t at = 0, skipUntil = 0;  // behind the JU over a parameter list
  while (at + 1 < code.size()) {
    const auto offset = static_cast<std::uint32_t>(at);
    opAt[at / 2] = static_cast<std::int32_t>(out.ops.size());
    const auto decoded = mc7::decode(code.subspan(at));
    if (!decoded) {
      out.ops.push_back(plain(unknownCode, offset));
      at += 2;
      continue;
    }
    Op op = makeOp(decoded->instruction, offset);
    at += decoded->length;
    if (skipUntil > at) {
      at = skipUntil;
      skipUntil = 0;
    }
    if (hasList(op)) {
      const std::uint32_t entries = listEntries(code, at, op);
      op.target = static_cast<std::int32_t>(out.parameters.size());
      op.count = static_cast<std::uint16_t>(entries);
      for (std::uint32_t i = 0; i < entries; ++i)
        out.parameters.push_back(loadDWord(&code[at + 4 + 4 * i]));
      skipUntil = entries == 0 ? 0 : at + 4 + 4 * entries;
    }
    out.ops.push_back(op);
  }
  out.instructionCount = static_cast<std::uint32_t>(out.ops.size());
  if (opAt.back() < 0 && code.size() % 2 == 0)
    opAt.back() = static_cast<std::int32_t>(out.ops.size());
  const auto end = static_cast<std::uint32_t>(code.size());
  out.ops.push_back(plain(endOfCode, end));
  out.ops.push_back(plain(unknownCode, end));
  resolveJumps(out, opAt);
  return opAt;
}

std::uint32_t localUse(const Translated& code) {
  std::uint32_t end = 0;
  for (const Op& op : code.ops)
    if (op.kind == OperandKind::Memory && op.area == Area::Local)
      end = std::max(end, op.value / 8 + byteCount(op.width));
    else if (op.pointerArea == Area::Local)
      end = std::max(end, op.value + 4);
  return std::min<std::uint32_t>(end, 65'536);
}

}  // namespace merker::interpreter
