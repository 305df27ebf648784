// What the rows of encodings.inc say about their operand: everything that no field of the pattern
// fills in.
#pragma once

#include "mc7/operand.h"

namespace merker::mc7::operand_class {

constexpr Operand None{};

// Direct; the area comes from a field, or is M in the short forms.
constexpr Operand Bit = memory(Area::None, Width::Bit, 0);
constexpr Operand Byte = memory(Area::None, Width::Byte, 0);
constexpr Operand Word = memory(Area::None, Width::Word, 0);
constexpr Operand DWord = memory(Area::None, Width::DWord, 0);
constexpr Operand FlagBit = memory(Area::Flag, Width::Bit, 0);
constexpr Operand FlagByte = memory(Area::Flag, Width::Byte, 0);
constexpr Operand FlagWord = memory(Area::Flag, Width::Word, 0);
constexpr Operand FlagDWord = memory(Area::Flag, Width::DWord, 0);

constexpr Operand BitIndirect = memoryIndirect(Area::None, Width::Bit, Area::None, 0);
constexpr Operand ByteIndirect = memoryIndirect(Area::None, Width::Byte, Area::None, 0);
constexpr Operand WordIndirect = memoryIndirect(Area::None, Width::Word, Area::None, 0);
constexpr Operand DWordIndirect = memoryIndirect(Area::None, Width::DWord, Area::None, 0);

constexpr Operand BitRegister = registerIndirect(Area::None, Width::Bit, 1, 0);
constexpr Operand ByteRegister = registerIndirect(Area::None, Width::Byte, 1, 0);
constexpr Operand WordRegister = registerIndirect(Area::None, Width::Word, 1, 0);
constexpr Operand DWordRegister = registerIndirect(Area::None, Width::DWord, 1, 0);

constexpr Operand BitCrossing = registerCrossing(Width::Bit, 1, 0);
constexpr Operand ByteCrossing = registerCrossing(Width::Byte, 1, 0);
constexpr Operand WordCrossing = registerCrossing(Width::Word, 1, 0);
constexpr Operand DWordCrossing = registerCrossing(Width::DWord, 1, 0);

constexpr Operand formalParameter(Width width) {
  return {.kind = OperandKind::Parameter, .width = width};
}
constexpr Operand BitParameter = formalParameter(Width::Bit);
constexpr Operand ByteParameter = formalParameter(Width::Byte);
constexpr Operand WordParameter = formalParameter(Width::Word);
constexpr Operand DWordParameter = formalParameter(Width::DWord);
constexpr Operand ParameterAddress{.kind = OperandKind::ParameterAddress};

constexpr Operand Timer{.kind = OperandKind::Timer};
constexpr Operand TimerIndirect{.kind = OperandKind::TimerIndirect};
constexpr Operand TimerParameter{.kind = OperandKind::TimerParameter};
constexpr Operand Counter{.kind = OperandKind::Counter};
constexpr Operand CounterIndirect{.kind = OperandKind::CounterIndirect};
constexpr Operand CounterParameter{.kind = OperandKind::CounterParameter};

constexpr Operand Status{.kind = OperandKind::StatusBit};
constexpr Operand StatusWord{.kind = OperandKind::StatusWord};
constexpr Operand dataBlockInfo(DataBlockQuery query) {
  return number(OperandKind::DataBlockInfo, static_cast<std::uint32_t>(query));
}
constexpr Operand DbLength = dataBlockInfo(DataBlockQuery::DbLength);
constexpr Operand DiLength = dataBlockInfo(DataBlockQuery::DiLength);
constexpr Operand DbNumber = dataBlockInfo(DataBlockQuery::DbNumber);
constexpr Operand DiNumber = dataBlockInfo(DataBlockQuery::DiNumber);

constexpr Operand ConstantByte = constant(ConstantFormat::Byte, 0);
constexpr Operand ConstantBinary = constant(ConstantFormat::Binary, 0);
constexpr Operand ConstantInteger = constant(ConstantFormat::Integer, 0);
constexpr Operand ConstantCharacters = constant(ConstantFormat::Characters, 0);
constexpr Operand ConstantBytes = constant(ConstantFormat::Bytes, 0);
constexpr Operand ConstantWord = constant(ConstantFormat::Word, 0);
// 30 00: STEP 7 writes the first word of an ANY so (docs/formats/listing.md).
constexpr Operand ConstantHeader = anyHeader(0);
constexpr Operand ConstantCounter = constant(ConstantFormat::Counter, 0);
constexpr Operand ConstantDate = constant(ConstantFormat::Date, 0);
constexpr Operand ConstantS5Time = constant(ConstantFormat::S5Time, 0);
constexpr Operand ConstantReal = constant(ConstantFormat::Real, 0);
constexpr Operand ConstantLongBinary = constant(ConstantFormat::LongBinary, 0);
constexpr Operand ConstantLongInteger = constant(ConstantFormat::LongInteger, 0);
constexpr Operand ConstantPointer = constant(ConstantFormat::Pointer, 0);
constexpr Operand ConstantLongCharacters = constant(ConstantFormat::LongCharacters, 0);
constexpr Operand ConstantLongBytes = constant(ConstantFormat::LongBytes, 0);
constexpr Operand ConstantDWord = constant(ConstantFormat::DWord, 0);
constexpr Operand ConstantTime = constant(ConstantFormat::Time, 0);
constexpr Operand ConstantTimeOfDay = constant(ConstantFormat::TimeOfDay, 0);

constexpr Operand Offset{.kind = OperandKind::Pointer};
constexpr Operand Register2{.kind = OperandKind::AddressRegister, .reg = 2};
constexpr Operand Count{.kind = OperandKind::ShiftCount};
constexpr Operand Shift =
    Count;  // of a double word: AWL allows 0..32, some codes have room for 255
constexpr Operand Jump{.kind = OperandKind::Jump};
constexpr Operand JumpList{.kind = OperandKind::JumpList};

constexpr Operand block(OperandKind kind, BlockKind blockKind, std::uint8_t reg = 0) {
  return {.kind = kind, .reg = reg, .blockKind = blockKind};
}
constexpr Operand Db = block(OperandKind::Block, BlockKind::DB);
constexpr Operand Di = block(OperandKind::Block, BlockKind::DB, 1);
constexpr Operand Fb = block(OperandKind::Block, BlockKind::FB);
constexpr Operand Fc = block(OperandKind::Block, BlockKind::FC);
constexpr Operand Sfc = block(OperandKind::Block, BlockKind::SFC);
constexpr Operand Sfb = block(OperandKind::Block, BlockKind::SFB);
constexpr Operand DbIndirect = block(OperandKind::BlockIndirect, BlockKind::DB);
constexpr Operand DiIndirect = block(OperandKind::BlockIndirect, BlockKind::DB, 1);
constexpr Operand FbIndirect = block(OperandKind::BlockIndirect, BlockKind::FB);
constexpr Operand FcIndirect = block(OperandKind::BlockIndirect, BlockKind::FC);
constexpr Operand DbParameter = block(OperandKind::BlockParameter, BlockKind::DB);
constexpr Operand DiParameter = block(OperandKind::BlockParameter, BlockKind::DB, 1);
constexpr Operand FbParameter = block(OperandKind::BlockParameter, BlockKind::FB);
constexpr Operand FcParameter = block(OperandKind::BlockParameter, BlockKind::FC);

}  // namespace merker::mc7::operand_class
