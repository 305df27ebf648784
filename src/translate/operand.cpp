// Operands in memory: where they lie, and what must hold so that they can be reached.
#include <algorithm>

#include "translate/lowering.h"

namespace merker::translate {
namespace {

using icode::Opcode;
using icode::Space;
using icode::Value;
using mc7::Operand;
using mc7::OperandKind;

std::optional<Space> spaceOf(Area area) {
  switch (area) {
    case Area::Input:
      return Space::Input;
    case Area::Output:
      return Space::Output;
    case Area::Flag:
      return Space::Flag;
    case Area::DataBlock:
      return Space::Data;
    case Area::Instance:
      return Space::Instance;
    case Area::Local:
      return Space::Local;
    default:
      return std::nullopt;
  }
}

std::uint32_t imageLength(const CpuModel& model, Space space) {
  return space == Space::Flag ? model.flagBytes : model.imageBytes;
}

// Notes what the region needs; false if the operand lies outside for certain.
bool reach(Lowering& l, Space space, std::uint32_t end, bool write) {
  const auto atLeast = [end](std::uint32_t& limit) { limit = std::max(limit, end); };
  switch (space) {
    case Space::Data:
      atLeast(write ? l.needs.dataWritten : l.needs.dataRead);
      return true;
    case Space::Instance:
      atLeast(write ? l.needs.instanceWritten : l.needs.instanceRead);
      return true;
    case Space::Local:
      atLeast(l.needs.local);
      return true;
    default:
      return end <= imageLength(l.model, space);
  }
}

// Bit address of an operand that is only known when it runs.
struct Dynamic {
  Space space;
  Value address;
};

std::optional<Dynamic> dynamic(Lowering& l) {
  const Operand& o = l.operand();
  const auto space = spaceOf(o.area);
  if (!space) return std::nullopt;
  if (o.kind == OperandKind::RegisterIndirect) {
    const Value ar = l.to.get(o.reg == 2 ? icode::Item::Ar2 : icode::Item::Ar1);
    const Value low = l.to.make(Opcode::And, ar, l.to.constant(0xFFFFFF));
    return Dynamic{*space, l.to.make(Opcode::Add, low, l.to.constant(o.value))};
  }
  if (o.kind != OperandKind::MemoryIndirect) return std::nullopt;
  const auto from = spaceOf(o.pointerArea);
  if (!from || !reach(l, *from, o.value + 4, false)) return std::nullopt;
  const Value pointer = l.to.load(*from, o.value, 4);
  return Dynamic{*space, l.to.make(Opcode::And, pointer, l.to.constant(0x7FFFF))};
}

// Guards the access and gives the byte.
Value guarded(Lowering& l, const Dynamic& d, unsigned bytes, bool whole, bool write) {
  icode::Builder& b = l.to;
  if (whole)
    b.guard(b.make(Opcode::Equal, b.make(Opcode::And, d.address, b.constant(7)), b.constant(0)));
  const Value byte = b.withNumber(Opcode::Shr, d.address, 3);
  const Value end = b.make(Opcode::Add, byte, b.constant(bytes));
  const Value limit = icode::isImage(d.space)
                          ? b.constant(imageLength(l.model, d.space))
                          : b.of(write ? Opcode::WriteLimit : Opcode::Limit, d.space);
  b.guard(b.make(Opcode::BelowEqual, end, limit));
  return byte;
}

bool isIndirect(const Operand& o) {
  return (o.kind == OperandKind::RegisterIndirect || o.kind == OperandKind::MemoryIndirect) &&
         spaceOf(o.area);
}

bool isDirect(const Operand& o, Width width) {
  return o.kind == OperandKind::Memory && spaceOf(o.area) &&
         (width == Width::Bit || (o.value & 7) == 0);
}

}  // namespace

std::optional<Value> readOperand(Lowering& l, Width width) {
  const Operand& o = l.operand();
  const unsigned bytes = byteCount(width);
  if (isDirect(o, width)) {
    const Space space = *spaceOf(o.area);
    if (!reach(l, space, o.value / 8 + bytes, false)) return std::nullopt;
    return l.to.load(space, o.value / 8, bytes);
  }
  if (!isIndirect(o)) return std::nullopt;
  const auto place = dynamic(l);
  if (!place) return std::nullopt;
  return l.to.loadAt(place->space, guarded(l, *place, bytes, true, false), bytes);
}

bool writeOperand(Lowering& l, Width width, Value value) {
  const Operand& o = l.operand();
  const unsigned bytes = byteCount(width);
  if (bytes == 1) value = l.to.make(Opcode::Zext8, value);
  if (isDirect(o, width)) {
    const Space space = *spaceOf(o.area);
    if (!reach(l, space, o.value / 8 + bytes, true)) return false;
    l.to.store(space, o.value / 8, bytes, value);
    return true;
  }
  if (!isIndirect(o)) return false;
  const auto place = dynamic(l);
  if (!place) return false;
  l.to.storeAt(place->space, guarded(l, *place, bytes, true, true), bytes, value);
  return true;
}

std::optional<BitPlace> bitPlace(Lowering& l, bool write) {
  const Operand& o = l.operand();
  if (isDirect(o, Width::Bit)) {
    const Space space = *spaceOf(o.area);
    if (!reach(l, space, o.value / 8 + 1, write)) return std::nullopt;
    return BitPlace{.space = space, .place = o.value / 8, .direct = o.value & 7};
  }
  if (!isIndirect(o)) return std::nullopt;
  const auto place = dynamic(l);
  if (!place) return std::nullopt;
  const Value byte = guarded(l, *place, 1, false, write);
  return BitPlace{.space = place->space,
                  .offset = byte,
                  .bit = l.to.make(Opcode::And, place->address, l.to.constant(7))};
}

Value loadByte(Lowering& l, const BitPlace& place) {
  return place.offset == icode::kNoValue ? l.to.load(place.space, place.place, 1)
                                         : l.to.loadAt(place.space, place.offset, 1);
}

void storeByte(Lowering& l, const BitPlace& place, Value byte) {
  if (place.offset == icode::kNoValue)
    l.to.store(place.space, place.place, 1, byte);
  else
    l.to.storeAt(place.space, place.offset, 1, byte);
}

Value withBit(Lowering& l, const BitPlace& place, Value byte, Value bit) {
  return place.bit == icode::kNoValue ? l.to.make(Opcode::Insert, byte, bit, place.direct)
                                      : l.to.make3(Opcode::InsertAt, byte, bit, place.bit);
}

Value bitIn(Lowering& l, const BitPlace& place, Value byte) {
  if (place.bit == icode::kNoValue && place.direct == 0) return byte;  // only bit 0 counts
  return place.bit == icode::kNoValue ? l.to.withNumber(Opcode::BitOf, byte, place.direct)
                                      : l.to.make(Opcode::BitAt, byte, place.bit);
}

}  // namespace merker::translate
