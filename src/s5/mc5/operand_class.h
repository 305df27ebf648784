// What the rows of encodings.inc say about their operand: everything that no field of the pattern
// fills in.
#pragma once

#include "mc5/operand.h"

namespace merker::mc5::operand_class {

constexpr Operand memory(Area area, Width width) {
  return {.kind = OperandKind::Memory, .area = area, .width = width};
}
constexpr Operand constant(Format format) {
  return {.kind = OperandKind::Constant, .format = format};
}
constexpr Operand block(BlockType type) { return {.kind = OperandKind::Block, .block = type}; }

constexpr Operand None{};

// E or A: a field says which.
constexpr Operand Bit = memory(Area::Input, Width::Bit);
constexpr Operand Byte = memory(Area::Input, Width::Byte);
constexpr Operand Word = memory(Area::Input, Width::Word);
constexpr Operand Double = memory(Area::Input, Width::Double);
constexpr Operand FlagBit = memory(Area::Flag, Width::Bit);
constexpr Operand FlagByte = memory(Area::Flag, Width::Byte);
constexpr Operand FlagWord = memory(Area::Flag, Width::Word);
constexpr Operand FlagDouble = memory(Area::Flag, Width::Double);
constexpr Operand PeripheralByte = memory(Area::Peripheral, Width::Byte);
constexpr Operand PeripheralWord = memory(Area::Peripheral, Width::Word);
constexpr Operand DataBit = memory(Area::Data, Width::Bit);
constexpr Operand DataLeft = memory(Area::Data, Width::Left);
constexpr Operand DataRight = memory(Area::Data, Width::Right);
constexpr Operand DataWord = memory(Area::Data, Width::Word);
constexpr Operand DataDouble = memory(Area::Data, Width::Double);

constexpr Operand Timer{.kind = OperandKind::Timer, .width = Width::Word};
constexpr Operand Counter{.kind = OperandKind::Counter, .width = Width::Word};
constexpr Operand TimerBit{.kind = OperandKind::Timer, .width = Width::Bit};
constexpr Operand CounterBit{.kind = OperandKind::Counter, .width = Width::Bit};

constexpr Operand ConstantByte = constant(Format::Byte);
constexpr Operand ConstantHex = constant(Format::Hex);
constexpr Operand ConstantCounter = constant(Format::Counter);
constexpr Operand ConstantTime = constant(Format::Time);
constexpr Operand ConstantFixed = constant(Format::Fixed);
constexpr Operand ConstantCharacters = constant(Format::Characters);
constexpr Operand ConstantBytes = constant(Format::Bytes);
constexpr Operand ConstantBinary = constant(Format::Binary);
constexpr Operand ConstantFloat = constant(Format::Float);
constexpr Operand ConstantSignedByte = constant(Format::SignedByte);
constexpr Operand ConstantOther = constant(Format::Other);

constexpr Operand Count{.kind = OperandKind::Count};
constexpr Operand Jump{.kind = OperandKind::Jump};
constexpr Operand Formal{.kind = OperandKind::Formal};
constexpr Operand Pb = block(BlockType::Pb);
constexpr Operand Sb = block(BlockType::Sb);
constexpr Operand Fb = block(BlockType::Fb);
constexpr Operand Db = block(BlockType::Db);

}  // namespace merker::mc5::operand_class
