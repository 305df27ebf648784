#include "system/arguments.h"

#include <algorithm>

#include "base/bytes.h"

namespace merker::system {
namespace {

using cpu::Access;
using cpu::ErrorCode;

// A system function has no local data of its own: L and V both are those of the block that calls
// it.
Area inCaller(Area area) { return area == Area::CallerLocal ? Area::Local : area; }

struct Block {
  std::uint8_t* data = nullptr;
  std::uint32_t length = 0;
  std::uint32_t writable = 0;
  ErrorCode error = ErrorCode::None;
};

Block dataBlock(cpu::Machine& m, std::uint32_t number) {
  cpu::OpenBlock open = m.dataBlocks.open(number);
  if (open.number == 0) return {.error = ErrorCode::DbMissing};
  return {open.data, open.length, open.writable};
}

Block blockOf(cpu::Machine& m, Area area, std::uint32_t db, Access access) {
  const bool data = area == Area::DataBlock || area == Area::Instance || area == Area::None;
  if (db != 0 && data) return dataBlock(m, db);
  const cpu::Registers& r = m.registers;
  const std::uint32_t length = m.areas.length(area);
  switch (area) {
    case Area::Input:
    case Area::Output:
    case Area::Flag:
      return {m.image + m.areas.base(area), length, length};
    case Area::DataBlock:
      return {r.db.data, r.db.length, r.db.writable};
    case Area::Instance:
      return {r.di.data, r.di.length, r.di.writable};
    case Area::Local:
      return {m.top->local, m.top->localLength, m.top->localLength};
    default:
      return {.error = access == Access::Read ? ErrorCode::AreaRead : ErrorCode::AreaWrite};
  }
}

// An instance is read and written without a detour: SFB 44 has 44 parameters. Null: not within
// `length` bytes.
std::uint8_t* inInstance(const cpu::OpenBlock& instance, std::uint32_t length, Width width,
                         BitAddress address) {
  const std::uint32_t byte = address / 8;
  const bool fits = byte + byteCount(width) <= length;
  return fits && (width == Width::Bit || address % 8 == 0) ? instance.data + byte : nullptr;
}

}  // namespace

Arguments::Where Arguments::placeOf(std::size_t i) const {
  if (call_.block.kind == BlockKind::SFB || call_.block.kind == BlockKind::FB)
    return {Area::Instance, (call_.machine.registers.ar2 & 0xFFFFFF) + places_[i].address};
  const std::size_t entry = function_.parameters[i].entry;
  if (entry >= call_.parameters.size()) return {};
  const std::uint32_t pointer = call_.parameters[entry];
  return {inCaller(pointerArea(pointer)), pointerAddress(pointer)};
}

bool Arguments::has(std::size_t i) {
  const Where where = placeOf(i);
  std::uint32_t ignored = 0;
  return !cpu::read(call_.machine, where.area, places_[i].width, where.address, ignored);
}

std::uint32_t Arguments::value(std::size_t i) {
  const Where where = placeOf(i);
  const Width width = places_[i].width;
  const cpu::OpenBlock& instance = call_.machine.registers.di;
  const std::uint8_t* byte = where.area == Area::Instance
                                 ? inInstance(instance, instance.length, width, where.address)
                                 : nullptr;
  if (byte != nullptr && width == Width::Bit) return *byte >> (where.address % 8) & 1u;
  if (byte != nullptr) return cpu::loadBytes(byte, width);
  std::uint32_t result = 0;
  note(cpu::read(call_.machine, where.area, width, where.address, result));
  return result;
}

void Arguments::set(std::size_t i, std::uint32_t value) {
  const Where where = placeOf(i);
  const Width width = places_[i].width;
  const cpu::OpenBlock& instance = call_.machine.registers.di;
  std::uint8_t* byte = where.area == Area::Instance
                           ? inInstance(instance, instance.writable, width, where.address)
                           : nullptr;
  if (byte != nullptr && width == Width::Bit) {
    const auto bit = static_cast<std::uint8_t>(1u << where.address % 8);
    *byte = static_cast<std::uint8_t>(value != 0 ? *byte | bit : *byte & ~bit);
    return;
  }
  if (byte != nullptr) return cpu::storeBytes(byte, width, value);
  note(cpu::write(call_.machine, where.area, width, where.address, value));
}

AnyPointer Arguments::any(std::size_t i) {
  const Where where = placeOf(i);
  std::uint32_t words[3] = {};
  for (unsigned k = 0; k < 3; ++k)
    note(cpu::read(call_.machine, where.area, k == 2 ? Width::Word : Width::DWord,
                   where.address + 32 * k, words[k]));
  return {.syntax = static_cast<std::uint8_t>(words[0] >> 24),
          .type = static_cast<TypeCode>(words[0] >> 16 & 0xFF),
          .count = words[0] & 0xFFFF,
          .db = static_cast<std::uint16_t>(words[1] >> 16),
          .pointer = words[1] << 16 | words[2]};
}

AnyPointer Arguments::pointer(std::size_t i) {
  const Where where = placeOf(i);
  std::uint32_t db = 0, pointer = 0;
  note(cpu::read(call_.machine, where.area, Width::Word, where.address, db));
  note(cpu::read(call_.machine, where.area, Width::DWord, where.address + 16, pointer));
  return {.db = static_cast<std::uint16_t>(db), .pointer = pointer};
}

Region Arguments::composite(std::size_t i, std::uint32_t bytes, Access access) {
  const Region result = region(pointer(i), bytes, access);
  if (!result) good_ = false;
  return result;
}

Region Arguments::region(const AnyPointer& where, std::uint32_t bytes, Access access) {
  return regionOf(call_.machine, where, bytes, access);
}

Region regionOf(cpu::Machine& machine, const AnyPointer& where, std::uint32_t bytes,
                Access access) {
  const bool reads = access == Access::Read;
  const Block block = blockOf(machine, inCaller(pointerArea(where.pointer)), where.db, access);
  if (block.error != ErrorCode::None) return {.error = block.error};
  const std::uint32_t address = where.pointer & 0xFFFFFF, byte = address / 8;
  if (address % 8 != 0)
    return {.error = reads ? ErrorCode::AlignmentRead : ErrorCode::AlignmentWrite};
  if (byte > block.length || bytes > block.length - byte)
    return {.error = reads ? ErrorCode::LengthRead : ErrorCode::LengthWrite};
  if (!reads && byte + bytes > block.writable) return {.error = ErrorCode::ProtectedDb};
  if (inCaller(pointerArea(where.pointer)) == Area::Local)
    cpu::lookAtLocal(machine, *machine.top, byte, bytes);
  return {.data = block.data + byte, .length = bytes};
}

Region Arguments::structure(std::size_t i, std::uint32_t bytes) {
  const AnyPointer where = any(i);
  if (where.syntax != AnyPointer{}.syntax) return region(pointer(i), bytes, Access::Write);
  if (byteCount(where) < bytes) return {.error = ErrorCode::LengthWrite};
  return region(where, bytes, Access::Write);
}

std::optional<std::size_t> Arguments::returnParameter() const {
  const auto& list = function_.parameters;
  for (std::size_t i = 0; i < list.size(); ++i)
    if (list[i].section == block::Section::Return) return i;
  return std::nullopt;
}

void Arguments::status(std::uint32_t code) {
  if (const auto i = returnParameter()) set(*i, code);
  if ((code & 0x8000) != 0) good_ = false;
}

void Arguments::parameterError(std::size_t i, std::uint32_t code) {
  const auto number = static_cast<std::uint32_t>(function_.parameters[i].entry + 1);
  status(0x8000 | number << 8 | code);
}

std::uint32_t byteCount(const AnyPointer& any) {
  if (any.type == TypeCode::Bool) return (any.count + 7) / 8;
  if (isParameterNumber(any.type)) return 0;
  return any.count * bitWidth(any.type) / 8;
}

}  // namespace merker::system
