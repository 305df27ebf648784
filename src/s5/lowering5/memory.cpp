// Operands: images, flags, data words, the words of timers and counters.
#include "lowering5/lowering.h"

namespace merker::translate5 {
namespace {

using icode::Opcode;
using icode::Space;
using icode::Value;
using mc5::Area;
using mc5::Operand;
using mc5::OperandKind;
using mc5::Width;

constexpr std::uint32_t kOutputBit = 14, kCellValue = 0x3FF;  // OP-33

std::optional<Space> imageOf(Area area) {
  switch (area) {
    case Area::Input:
      return Space::Input;
    case Area::Output:
      return Space::Output;
    case Area::Flag:
      return Space::Flag;
    default:
      return std::nullopt;
  }
}

void need(Lowering& l, std::uint32_t words, bool write) {
  std::uint32_t& bytes = write ? l.needs.dataWritten : l.needs.dataRead;
  bytes = std::max(bytes, 2 * words);
}

// A word whose low byte comes first, from one whose high byte does, and back.
Value turned(Lowering& l, Value word) {
  return l.to.withNumber(Opcode::Shr, l.to.make(Opcode::SwapBytes, word), 16);
}

Value loadWord(Lowering& l, Space space, std::uint32_t byte) {
  return turned(l, l.to.load(space, byte, 2));
}

void storeWord(Lowering& l, std::uint32_t word, Value value) {
  l.to.store(Space::Data, 2 * word, 2, turned(l, value));
}

Value readData(Lowering& l) {
  const std::uint32_t word = l.operand().value;
  const Width width = l.operand().width;
  need(l, width == Width::Double ? word + 2 : word + 1, false);
  if (width == Width::Left) return l.to.load(Space::Data, 2 * word + 1, 1);
  if (width == Width::Right) return l.to.load(Space::Data, 2 * word, 1);
  const Value first = loadWord(l, Space::Data, 2 * word);
  if (width != Width::Double) return first;
  const Value second = loadWord(l, Space::Data, 2 * (word + 1));
  return l.to.make(Opcode::Or, l.to.withNumber(Opcode::Shl, first, 16), second);
}

void writeData(Lowering& l, Value value) {
  const std::uint32_t word = l.operand().value;
  const Width width = l.operand().width;
  need(l, width == Width::Double ? word + 2 : word + 1, true);
  if (width == Width::Left || width == Width::Right)
    return l.to.store(Space::Data, 2 * word + (width == Width::Left ? 1 : 0), 1,
                      l.to.make(Opcode::Zext8, value));
  if (width != Width::Double) return storeWord(l, word, value);
  storeWord(l, word, l.to.withNumber(Opcode::Shr, value, 16));
  storeWord(l, word + 1, value);
}

unsigned bytesOf(Width width) { return width == Width::Double ? 4 : width == Width::Word ? 2 : 1; }

Value readCell(Lowering& l) {
  const Value word = loadWord(l, Space::Instance, cellPlace(l));
  return l.to.make(Opcode::And, word, l.to.constant(kCellValue));
}

}  // namespace

bool isCell(const Operand& operand) {
  return operand.kind == OperandKind::Timer || operand.kind == OperandKind::Counter;
}

std::uint32_t cellPlace(const Lowering& l) {
  const Operand& operand = l.operand();
  if (operand.kind == OperandKind::Timer) return operand.value * l.target.timerBytes;
  return l.target.counters + operand.value * l.target.counterBytes;
}

std::optional<BytePlace> bitPlace(Lowering& l, bool write) {
  const Operand& operand = l.operand();
  if (operand.kind != OperandKind::Memory || operand.width != Width::Bit) return std::nullopt;
  if (operand.area == Area::Data) {
    need(l, operand.value + 1, false);
    if (write) need(l, operand.value + 1, true);
    return BytePlace{Space::Data, 2 * operand.value + operand.bit / 8u, operand.bit % 8u};
  }
  const auto space = imageOf(operand.area);
  if (!space) return std::nullopt;
  return BytePlace{*space, operand.value, operand.bit};
}

namespace {

// The byte of the data word; guards that it is there. Limits are whole words.
Value dataPlace(Lowering& l, Value word, bool write) {
  const Value place = l.to.withNumber(Opcode::Shl, word, 1);
  l.to.guard(l.to.make(Opcode::Below, place, l.to.limit(Space::Data, write)));
  return place;
}

}  // namespace

Value readDataAt(Lowering& l, Value word) {
  return turned(l, l.to.loadAt(Space::Data, dataPlace(l, word, false), 0, 2));
}

void writeDataAt(Lowering& l, Value word, Value value) {
  l.to.storeAt(Space::Data, dataPlace(l, word, true), 0, 2, turned(l, value));
}

// Of timers and counters the output, or a bit of their word (P T 5.3).
std::optional<Value> readBit(Lowering& l) {
  const Operand& operand = l.operand();
  if (isCell(operand)) {
    const bool output = operand.width != Width::Bit;
    if (output && operand.kind == OperandKind::Counter)
      return l.to.make(Opcode::NotEqual, readCell(l), l.to.constant(0));
    const std::uint32_t bit = output ? kOutputBit : operand.bit;
    return l.to.withNumber(Opcode::BitOf, l.to.load(Space::Instance, cellPlace(l) + bit / 8, 1),
                           bit % 8);
  }
  const auto place = bitPlace(l, false);
  if (!place) return std::nullopt;
  return l.to.withNumber(Opcode::BitOf, l.to.load(place->space, place->byte, 1), place->bit);
}

std::optional<Value> readOperand(Lowering& l) {
  const Operand& operand = l.operand();
  if (isCell(operand)) return readCell(l);
  if (operand.kind == OperandKind::Constant) return l.to.constant(operand.value);
  if (operand.kind != OperandKind::Memory) return std::nullopt;
  if (operand.area == Area::Data) return readData(l);
  const auto space = imageOf(operand.area);
  if (!space) return std::nullopt;
  return l.to.load(*space, operand.value, bytesOf(operand.width));
}

bool writeOperand(Lowering& l, Value value) {
  const Operand& operand = l.operand();
  if (operand.area == Area::Data) {
    writeData(l, value);
    return true;
  }
  const auto space = imageOf(operand.area);
  if (!space) return false;
  const unsigned bytes = bytesOf(operand.width);
  if (bytes == 1) value = l.to.make(Opcode::Zext8, value);
  l.to.store(*space, operand.value, bytes, value);
  return true;
}

}  // namespace merker::translate5
