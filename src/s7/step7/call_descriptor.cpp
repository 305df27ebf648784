// POINTER and ANY as actual parameters, built in the local data of the caller (S7-IND-11 … 15).
#include <algorithm>

#include "step7/call_compiler.h"

namespace merker::step7 {

using block::Section;
using mc7::Operand;
using mc7::OperandKind;
using mc7::Operation;

void CallCompiler::descriptorAddress(const Actual& actual, std::uint32_t dbByte,
                                     std::uint32_t pointerByte) {
  const Access& access = *actual.access;
  const Operand& operand = access.operand;
  const Operand db = local(Width::Word, dbByte), place = local(Width::DWord, pointerByte);
  const auto addOffset = [&](std::uint32_t offset) {
    if (offset) put(Operation::ADD_CONSTANT, mc7::constant(ConstantFormat::LongInteger, offset));
    put(Operation::TRANSFER, place);
  };
  if (access.kind == Access::Kind::Descriptor) {  // own composite parameter
    const std::uint32_t copy = c_.parameterCopy(*access.descriptor);
    put(Operation::LOAD, local(Width::Word, copy));
    put(Operation::TRANSFER, db);
    put(Operation::LOAD, local(Width::DWord, copy + 2));
    return addOffset(operand.value);
  }
  if (operand.kind == OperandKind::RegisterIndirect) {  // own instance: AR2 carries its offset
    put(Operation::LOAD, mc7::number(OperandKind::DataBlockInfo,
                                     static_cast<std::uint32_t>(mc7::DataBlockQuery::DiNumber)));
    put(Operation::TRANSFER, db);
    put(Operation::TAR2);
    return addOffset(operand.value);
  }
  if (operand.kind == OperandKind::Parameter) {  // own parameter of a function: its actual operand
    loadConstant(Width::Word, 0);
    put(Operation::TRANSFER, db);
    put(Operation::LOAD, mc7::number(OperandKind::ParameterAddress, operand.value));
    return addOffset(0);
  }
  Area area = operand.area;
  const bool openBlock = access.openDb < 0 && (area == Area::DataBlock || area == Area::Instance);
  if (openBlock) {
    const auto query =
        area == Area::DataBlock ? mc7::DataBlockQuery::DbNumber : mc7::DataBlockQuery::DiNumber;
    put(Operation::LOAD,
        mc7::number(OperandKind::DataBlockInfo, static_cast<std::uint32_t>(query)));
  } else {
    loadConstant(Width::Word, static_cast<std::uint32_t>(std::max(access.openDb, 0)));
  }
  put(Operation::TRANSFER, db);
  if (area == Area::Local) area = Area::CallerLocal;
  if (area == Area::Instance) area = Area::DataBlock;
  loadConstant(Width::DWord, pointer(area, operand.value));
  put(Operation::TRANSFER, place);
}

std::uint32_t CallCompiler::copyOfOwn(const Access& access, std::uint32_t bytes) {
  const block::Variable& own = *access.variable;
  if (own.section == Section::Temp) return own.address / 8;
  const std::uint32_t byte = c_.allocate(bytes);
  Access from = access;
  if (c_.scope().block->id.kind == BlockKind::FC) {
    put(Operation::LOAD, mc7::number(OperandKind::ParameterAddress, access.operand.value));
    put(Operation::LAR1);
    from = machine(mc7::registerCrossing(Width::Word, 1, 0));
  }
  for (std::uint32_t i = 0; i < bytes; i += 2)
    move(Width::Word, part(from, i, Width::Word), machine(local(Width::Word, byte + i)));
  return byte;
}

namespace {

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

}  // namespace

// Builds a POINTER (6 bytes) or ANY (10 bytes) in local data; returns its byte.
std::uint32_t CallCompiler::descriptor(const Actual& actual, bool any) {
  if (actual.access && actual.access->variable && actual.access->type &&
      actual.access->type->code == (any ? TypeCode::Any : TypeCode::Pointer))
    return copyOfOwn(*actual.access, any ? 10 : 6);
  const std::uint32_t byte = c_.allocate(any ? 10 : 6);
  const std::uint32_t db = byte + (any ? 4 : 0);
  const auto word = [&](std::uint32_t at, std::uint32_t value) {
    loadConstant(Width::Word, value);
    put(Operation::TRANSFER, local(Width::Word, at));
  };
  const auto header = [&](TypeCode type, std::uint32_t count) {
    if (!any) return;
    word(byte, 0x1000u | static_cast<std::uint32_t>(type));
    word(byte + 2, count);
  };
  if (actual.nil || actual.isPointer) {
    const bool counted = actual.anyType != TypeCode::Void;
    header(actual.nil ? TypeCode::Void
           : counted  ? actual.anyType
                      : TypeCode::Byte,
           actual.nil ? 0
           : counted  ? actual.anyCount
                      : 1u);
    word(db, actual.db);
    loadConstant(Width::DWord, actual.pointer);
    put(Operation::TRANSFER, local(Width::DWord, db + 2));
    return byte;
  }
  const Operand& operand = actual.access->operand;
  if (operand.kind == OperandKind::Timer || operand.kind == OperandKind::Counter ||
      operand.kind == OperandKind::Block) {
    const TypeCode type = operand.kind == OperandKind::Timer     ? TypeCode::Timer
                          : operand.kind == OperandKind::Counter ? TypeCode::Counter
                          : operand.blockKind == BlockKind::FB   ? TypeCode::BlockFb
                          : operand.blockKind == BlockKind::FC   ? TypeCode::BlockFc
                                                                 : TypeCode::BlockDb;
    header(type, 1);  // S7-IND-14
    loadConstant(Width::DWord, 0);
    put(Operation::TRANSFER, local(Width::DWord, db));
    word(db + 4, operand.value);
    return byte;
  }
  const AnyHeader content = anyHeader(*actual.access);
  header(content.type, content.count);
  descriptorAddress(actual, db, db + 2);
  return byte;
}

}  // namespace merker::step7
