#include "interpreter/translate.h"

#include <algorithm>

#include "address/constant.h"
#include "cpu/start_information.h"
#include "interpreter/fault.h"
#include "mc7/listing.h"

namespace merker::interpreter {
namespace {

using mc7::OperandKind;
using mc7::Operation;

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

Op plain(Handler handler, std::uint32_t offset) {
  Op op;
  op.run = handler;
  op.offset = offset;
  return op;
}

bool isCall(const Op& op) { return op.operation == Operation::UC || op.operation == Operation::CC; }
bool isJump(const Op& op) { return op.kind == OperandKind::Jump; }

std::int32_t distance(std::int32_t found, std::size_t from, std::size_t unknown) {
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

// SPL jumps over its list.
std::int32_t behindList(const mc7::Listing& listing, const Op& op) {
  const std::size_t word = op.offset / 2 + 2 * (op.count + 1u);
  return word < listing.placeAt.size() ? listing.placeAt[word] : -1;
}

void resolveJumps(Translated& out, const mc7::Listing& listing) {
  const std::size_t unknown = out.instructionCount + 1;
  for (std::size_t i = 0; i < out.instructionCount; ++i) {
    Op& op = out.ops[i];
    if (isJump(op)) {
      op.target = distance(listing.target(listing.places[i]), i, unknown);
    } else if (op.kind == OperandKind::JumpList) {
      if (!listComplete(out.ops, i, out.instructionCount)) op.run = unknownCode;
      op.target = distance(behindList(listing, op), i, unknown);
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
  mc7::Listing listing = mc7::list(code);
  out.ops.reserve(listing.places.size() + 2);
  for (const mc7::Place& place : listing.places) {
    if (!place.known) {
      out.ops.push_back(plain(unknownCode, place.offset));
      continue;
    }
    Op& op = out.ops.emplace_back(makeOp(place.instruction, place.offset));
    if (!isCall(op)) continue;
    op.target = static_cast<std::int32_t>(place.firstParameter);
    op.count = place.parameters;
  }
  out.instructionCount = static_cast<std::uint32_t>(out.ops.size());
  const auto end = static_cast<std::uint32_t>(code.size());
  out.ops.push_back(plain(endOfCode, end));
  out.ops.push_back(plain(unknownCode, end));
  resolveJumps(out, listing);
  out.parameters = std::move(listing.parameters);
  return std::move(listing.placeAt);
}

namespace {

// Written over, it would not be the date that is shown behind cycles that were passed over.
bool touchesDate(const Op& op) {
  if (op.pointerArea == Area::Local && cpu::touchesDate(op.value, byteCount(Width::DWord)))
    return true;
  if (op.area != Area::Local) return false;
  return op.kind != OperandKind::Memory || cpu::touchesDate(op.value / 8, byteCount(op.width));
}

bool loadsTimer(const Op& op) {
  return op.kind == OperandKind::Timer &&
         (op.operation == Operation::LOAD || op.operation == Operation::LOAD_BCD);
}

}  // namespace

std::vector<cpu::Look> looksOf(const Translated& code) {
  std::vector<cpu::Look> looks;
  for (const Op& op : std::span(code.ops).first(code.instructionCount)) {
    const auto at = touchesDate(op)  ? cpu::Look::At::Date
                    : loadsTimer(op) ? cpu::Look::At::Timer
                                     : cpu::Look::At::Nothing;
    if (at != cpu::Look::At::Nothing)
      looks.push_back(
          {.at = at, .block = code.source->id, .offset = op.offset, .number = op.value});
  }
  return looks;
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
