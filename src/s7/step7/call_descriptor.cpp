// POINTER and ANY as actual parameters: in the local data of the caller for a function, in the
// instance for a function block (S7-IND-11 … 15; code patterns, sections 2 and 3).
#include <algorithm>

#include "step7/call_compiler.h"
#include "step7/parameter_access.h"

namespace merker::step7 {

using block::Section;
using mc7::Operand;
using mc7::OperandKind;
using mc7::Operation;

namespace {

constexpr std::uint32_t kPointerBytes = 6;

struct AnyHeader {
  TypeCode type = TypeCode::Byte;
  std::uint32_t count = 1;
};

// Type code and repetition factor of a variable or operand (S7-IND-13, S7-IND-15).
AnyHeader anyHeader(const Access& access) {
  if (!access.type) {
    static constexpr TypeCode kByWidth[] = {TypeCode::Bool, TypeCode::Byte, TypeCode::Word,
                                            TypeCode::DWord};
    return {kByWidth[static_cast<int>(access.operand.width)], 1};
  }
  const block::Type& type = *access.type;
  if (isElementary(type.code) || type.code == TypeCode::DateAndTime) return {type.code, 1};
  if (type.code == TypeCode::Array &&
      (isElementary(type.element->code) || type.element->code == TypeCode::DateAndTime)) {
    std::uint32_t count = 1;
    for (const block::Dimension& dimension : type.dimensions) count *= dimension.count();
    return {type.element->code, count};
  }
  return {TypeCode::Byte, block::sizeInBytes(type)};
}

// S7-IND-14
TypeCode typeOfNumber(const Operand& operand) {
  if (operand.kind == OperandKind::Timer) return TypeCode::Timer;
  if (operand.kind == OperandKind::Counter) return TypeCode::Counter;
  return operand.blockKind == BlockKind::FB   ? TypeCode::BlockFb
         : operand.blockKind == BlockKind::FC ? TypeCode::BlockFc
                                              : TypeCode::BlockDb;
}

}  // namespace

Operand CallCompiler::cell(const Cells& cells, std::uint32_t byte, Width width) const {
  return cells.inInstance ? instanceOperand(bitAddress(cells.byte + byte), width)
                          : local(width, cells.byte + byte);
}

CallCompiler::Cells CallCompiler::newCells(std::uint32_t bytes) {
  return {false, c_.localData().bytes(bytes)};
}

void CallCompiler::writeWord(const Cells& cells, std::uint32_t byte, std::uint32_t value) {
  constantTo(TypeCode::Word, mc7::constant(ConstantFormat::Integer, value),
             cell(cells, byte, Width::Word));
}

void CallCompiler::writeHeader(const Cells& cells, TypeCode type, std::uint32_t count) {
  put(Operation::LOAD, mc7::anyHeader(0x1000u | static_cast<std::uint32_t>(type)));
  put(Operation::TRANSFER, cell(cells, 0, Width::Word));
  writeWord(cells, 2, count);
}

// The actual parameter is of the type itself: it is handed on.
bool CallCompiler::isDescriptor(const Actual& actual, bool any) const {
  return actual.access && actual.access->variable && actual.access->type &&
         actual.access->type->code == (any ? TypeCode::Any : TypeCode::Pointer);
}

void CallCompiler::copyDescriptor(const Access& access, std::uint32_t bytes, const Cells& cells) {
  Access from = access;
  if (access.operand.kind == OperandKind::Parameter) {
    put(Operation::LOAD, mc7::number(OperandKind::ParameterAddress, access.operand.value));
    put(Operation::LAR1);
    from = machine(mc7::registerCrossing(Width::Word, 1, 0));
  } else if (access.operand.kind == OperandKind::RegisterIndirect) {
    from.operand.area = ownArea();
  }
  for (std::uint32_t byte = 0; byte < bytes;) {
    const Width width = bytes - byte == 4 ? Width::DWord : Width::Word;
    read(part(from, byte, width));
    put(Operation::TRANSFER, cell(cells, byte, width));
    byte += byteCount(width);
  }
}

// A variable of the own instance: AR2 with its offset.
void CallCompiler::descriptorInInstance(std::uint32_t offset, const Cells& cells) {
  load(exchanged_ ? mc7::DataBlockQuery::DbNumber : mc7::DataBlockQuery::DiNumber);
  put(Operation::TRANSFER, cell(cells, 0, Width::Word));
  put(Operation::ADD_AR2, mc7::number(OperandKind::Pointer, offset));
  put(Operation::TAR2);
  put(Operation::LAR2, ar2_);
  put(Operation::TRANSFER, cell(cells, 2, Width::DWord));
}

// Number of the data block and address: the POINTER, or the end of the ANY.
void CallCompiler::descriptorAddress(const Access& access, const Cells& cells) {
  const Operand& operand = access.operand;
  const Operand number = cell(cells, 0, Width::Word), address = cell(cells, 2, Width::DWord);
  if (access.kind == Access::Kind::Descriptor) {  // own composite parameter
    Access own;
    const block::Variable& parameter = *access.descriptor;
    own.operand = mc7::registerIndirect(Area::Instance, Width::Word, 2, parameter.address);
    if (c_.scope().block->id.kind == BlockKind::FC)
      own.operand =
          mc7::number(OperandKind::Parameter, c_.scope().names->parameterIndex(parameter));
    copyDescriptor(own, kPointerBytes, cells);
    if (operand.value == 0) return;
    put(Operation::LOAD, address);
    put(Operation::ADD_CONSTANT, mc7::constant(ConstantFormat::LongInteger, operand.value));
    return put(Operation::TRANSFER, address);
  }
  if (operand.kind == OperandKind::RegisterIndirect)
    return descriptorInInstance(operand.value, cells);
  if (operand.kind == OperandKind::Parameter) {  // own parameter of a function: its actual operand
    writeWord(cells, 0, 0);
    put(Operation::LOAD, mc7::number(OperandKind::ParameterAddress, operand.value));
    return put(Operation::TRANSFER, address);
  }
  Area area = operand.area;
  if (area == Area::DataBlock && access.openDb < 0) {
    if (exchanged_)
      put(Operation::LOAD, openNumber_);
    else
      load(mc7::DataBlockQuery::DbNumber);
    put(Operation::TRANSFER, number);
  } else if (area == Area::Instance) {
    load(exchanged_ ? mc7::DataBlockQuery::DbNumber : mc7::DataBlockQuery::DiNumber);
    put(Operation::TRANSFER, number);
  } else {
    writeWord(cells, 0, static_cast<std::uint32_t>(std::max(access.openDb, 0)));
  }
  if (area == Area::Local) area = Area::CallerLocal;
  if (area == Area::Instance) area = Area::DataBlock;
  put(Operation::LOAD, mc7::constant(ConstantFormat::Pointer, pointer(area, operand.value)));
  put(Operation::TRANSFER, address);
}

void CallCompiler::descriptorOfNumber(const Operand& operand, const Cells& cells) {
  writeHeader(cells, typeOfNumber(operand), 1);
  constantTo(TypeCode::DWord, mc7::constant(ConstantFormat::LongInteger, 0),
             cell(cells, 4, Width::DWord));
  writeWord(cells, 8, operand.value);
}

// A POINTER (6 bytes) or ANY (10 bytes).
void CallCompiler::descriptor(const Actual& actual, bool any, const Cells& cells) {
  Cells end = cells;
  end.byte += any ? 4 : 0;
  if (isDescriptor(actual, any)) return copyDescriptor(*actual.access, any ? 10 : 6, cells);
  if (actual.nil || actual.isPointer) {
    const bool counted = actual.anyType != TypeCode::Void;
    if (any)
      writeHeader(cells, actual.nil || counted ? actual.anyType : TypeCode::Byte,
                  actual.nil ? 0
                  : counted  ? actual.anyCount
                             : 1u);
    writeWord(end, 0, actual.db);
    put(Operation::LOAD, mc7::constant(ConstantFormat::Pointer, actual.pointer));
    return put(Operation::TRANSFER, cell(end, 2, Width::DWord));
  }
  const Operand& operand = actual.access->operand;
  if (operand.kind == OperandKind::Timer || operand.kind == OperandKind::Counter ||
      operand.kind == OperandKind::Block)
    return descriptorOfNumber(operand, cells);
  const AnyHeader content = anyHeader(*actual.access);
  if (any) writeHeader(cells, content.type, content.count);
  descriptorAddress(*actual.access, end);
}

}  // namespace merker::step7
