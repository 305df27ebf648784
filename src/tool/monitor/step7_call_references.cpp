// The actual parameters of a call: in the list behind it, or in the instance it was given.
#include <fmt/format.h>

#include "base/bytes.h"
#include "block/width.h"
#include "mc7/disassembly.h"
#include "mc7/operand_text.h"
#include "monitor/step7_references.h"

namespace merker::monitor {
namespace {

using mc7::OperandKind;

Use useOf(block::Section section) {
  if (section == block::Section::Input) return Use::Read;
  return section == block::Section::InOut ? Use::ReadWrite : Use::Write;
}

bool isFunction(const mc7::Operand& block) {
  return block.kind == OperandKind::Block &&
         (block.blockKind == BlockKind::FC || block.blockKind == BlockKind::SFC);
}

bool isFunctionBlock(const mc7::Operand& block) {
  return block.kind == OperandKind::Block &&
         (block.blockKind == BlockKind::FB || block.blockKind == BlockKind::SFB);
}

// The STRING of a data block that lies here; null if none does.
const block::Type* stringAt(const std::vector<block::Variable>& variables, BitAddress at) {
  for (const block::Variable& one : variables) {
    if (!one.type || at < one.address || at >= one.address + block::sizeInBits(*one.type)) continue;
    if (one.type->code == TypeCode::String) return one.type.get();
    return stringAt(one.type->members, at - one.address);
  }
  return nullptr;
}

// A parameter STRING without a length takes shorter ones.
std::uint32_t bytesOf(const block::Type& formal, const Descriptor& what,
                      const block::Program& program) {
  const auto db = program.find({BlockKind::DB, what.db});
  const block::Type* actual = formal.code != TypeCode::String || db == program.end()
                                  ? nullptr
                                  : stringAt(db->second.variables, pointerAddress(what.pointer));
  return block::sizeInBytes(actual == nullptr ? formal : *actual);
}

}  // namespace

// MC7 section 7.2
std::size_t Step7References::parameterList(const mc7::Instruction& call,
                                           std::span<const std::uint8_t> code) {
  const int entries = isFunction(call.operand) ? mc7::parameterListLength(code) : -1;
  if (entries <= 0) return 0;
  const auto count = static_cast<std::size_t>(entries);
  const block::Block* target = called(call.operand);
  const auto formal =
      target == nullptr ? std::vector<const block::Variable*>{} : block::parameters(*target);
  for (std::size_t i = 0; i < formal.size() && i < count; ++i)
    if (formal[i]->type) parameter(*formal[i], loadDWord(&code[4 + 4 * i]), call);
  return 4 + 4 * count;
}

void Step7References::parameter(const block::Variable& formal, std::uint32_t entry,
                                const mc7::Instruction& call) {
  const TypeCode type = formal.type->code;
  const Use use = useOf(formal.section);
  const Area area = pointerArea(entry);
  const BitAddress address = pointerAddress(entry);
  // A pointer instead of a number: the block was passed one itself.
  const bool pointer = area >= Area::Peripheral && area <= Area::CallerLocal;
  if (isParameterNumber(type)) return pointer ? void() : number(type, entry >> 16, use, call);
  if (!isElementary(type))
    return composite(formal, area == Area::CallerLocal ? Area::Local : area, address, call);
  if (area == Area::DataBlock || (area >= Area::Peripheral && area <= Area::Flag))
    add(mc7::memory(area, block::widthOf(type), address),
        area == Area::DataBlock ? opened_.db() : -1, use, call);
}

// Values of elementary type were read where the CALL laid them down.
void Step7References::instanceParameters(const mc7::Instruction& call) {
  const block::Block* target = isFunctionBlock(call.operand) ? called(call.operand) : nullptr;
  if (target == nullptr || !call_) return;
  for (const block::Variable* formal : block::parameters(*target)) {
    if (!formal->type) continue;
    const TypeCode type = formal->type->code;
    const bool described =
        type == TypeCode::Any || type == TypeCode::Pointer || block::isStoredAsPointer(*formal);
    if (described) composite(*formal, Area::Instance, formal->address, call);
    if (!isParameterNumber(type)) continue;
    if (const auto value = bytes_.value(Area::Instance, formal->address, Width::Word))
      number(type, *value, useOf(formal->section), call);
  }
}

// Where the POINTER or ANY at this place leads, if it is a constant.
void Step7References::composite(const block::Variable& formal, Area area, BitAddress at,
                                const mc7::Instruction& call) {
  const Use use = useOf(formal.section);
  if (formal.type->code == TypeCode::Any) {
    const auto any = bytes_.any(area, at);
    if (!any) return;
    if (isParameterNumber(any->type)) return number(any->type, any->pointer & 0xFFFF, use, call);
    return range(*any, any->count * bitWidth(any->type),
                 fmt::format(" {} {}", merker::name(any->type), any->count), use, call);
  }
  const auto pointer = bytes_.pointer(area, at);
  if (!pointer) return;
  if (formal.type->code == TypeCode::Pointer) return range(*pointer, 1, "", use, call);
  const std::uint32_t bytes = bytesOf(*formal.type, *pointer, around_.program);
  range(*pointer, 8 * bytes, fmt::format(" BYTE {}", bytes), use, call);
}

void Step7References::number(TypeCode type, std::uint32_t value, Use use,
                             const mc7::Instruction& call) {
  if (type == TypeCode::Timer) return add(mc7::number(OperandKind::Timer, value), -1, use, call);
  if (type == TypeCode::Counter)
    return add(mc7::number(OperandKind::Counter, value), -1, use, call);
  const BlockKind kind = type == TypeCode::BlockFb   ? BlockKind::FB
                         : type == TypeCode::BlockFc ? BlockKind::FC
                                                     : BlockKind::DB;
  if (type != TypeCode::BlockSdb) add(mc7::blockOperand(kind, value), -1, Use::Call, call);
}

void Step7References::range(const Descriptor& what, std::uint32_t bits, const std::string& length,
                            Use use, const mc7::Instruction& call) {
  const Area area = pointerArea(what.pointer);
  const bool data = area == Area::DataBlock;
  if ((!data && (area < Area::Peripheral || area > Area::Flag)) || bits == 0) return;
  const BitAddress at = pointerAddress(what.pointer);
  CrossReference row;
  row.key = address::memory(area, Width::Byte, at);
  row.bits = bits;
  row.db = data && what.db != 0 ? what.db : -1;
  const std::string place = mc7::pointerText(area, at, around_.options.mnemonics);
  row.operand = (row.db < 0 ? place : fmt::format("P#DB{}.{}", row.db, place.substr(2))) + length;
  add(std::move(row), use, call);
}

}  // namespace merker::monitor
