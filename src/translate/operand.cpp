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

// Opened in this region: its length is only known when it runs.
bool reachable(Lowering& l, Space space, std::uint32_t end, bool write) {
  if (!l.to.isReopened(space)) return reach(l, space, end, write);
  icode::Builder& b = l.to;
  b.guard(b.make(Opcode::BelowEqual, b.constant(end), b.limit(space, write)));
  return true;
}

// Bit address of an operand that is only known when it runs.
struct Dynamic {
  Space space;
  Value address;
};

Value registerOf(Lowering& l) {
  return l.to.get(l.operand().reg == 2 ? icode::Item::Ar2 : icode::Item::Ar1);
}

std::optional<Dynamic> dynamic(Lowering& l) {
  const Operand& o = l.operand();
  const auto space = spaceOf(o.area);
  if (!space) return std::nullopt;
  if (o.kind == OperandKind::RegisterIndirect) {
    const Value low = l.to.make(Opcode::And, registerOf(l), l.to.constant(0xFFFFFF));
    return Dynamic{*space, l.to.make(Opcode::Add, low, l.to.constant(o.value))};
  }
  if (o.kind != OperandKind::MemoryIndirect) return std::nullopt;
  const auto from = spaceOf(o.pointerArea);
  if (!from || !reachable(l, *from, o.value + 4, false)) return std::nullopt;
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
  const Value limit =
      icode::isImage(d.space) ? b.constant(imageLength(l.model, d.space)) : b.limit(d.space, write);
  b.guard(b.make(Opcode::BelowEqual, end, limit));
  return byte;
}

// The pointer in the list behind the call.
Value parameter(Lowering& l) {
  l.needs.parameters = std::max(l.needs.parameters, l.operand().value + 1);
  return l.to.withNumber(Opcode::Parameter, icode::kNoValue, l.operand().value);
}

bool isCrossing(const Operand& o) {
  return o.kind == OperandKind::Parameter || o.kind == OperandKind::RegisterCrossing;
}

// The area stands in a pointer: of a parameter, or in an address register.
struct Crossing {
  Value pointer, bitAddress;
};
Crossing crossing(Lowering& l) {
  icode::Builder& b = l.to;
  const Operand& o = l.operand();
  if (o.kind == OperandKind::Parameter) {
    const Value pointer = parameter(l);
    return {pointer, b.make(Opcode::And, pointer, b.constant(0x7FFFF))};
  }
  const Value ar = registerOf(l);
  const Value low = b.make(Opcode::And, ar, b.constant(0xFFFFFF));
  return {ar, o.value == 0 ? low : b.make(Opcode::Add, low, b.constant(o.value))};
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
    if (!reachable(l, space, o.value / 8 + bytes, false)) return std::nullopt;
    return l.to.load(space, o.value / 8, bytes);
  }
  if (isCrossing(o)) {
    const Crossing c = crossing(l);
    return l.to.loadFrom(l.to.locate(c.pointer, c.bitAddress, {.bytes = bytes, .whole = true}),
                         bytes);
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
    if (!reachable(l, space, o.value / 8 + bytes, true)) return false;
    l.to.store(space, o.value / 8, bytes, value);
    return true;
  }
  if (isCrossing(o)) {
    const Crossing c = crossing(l);
    l.to.storeTo(
        l.to.locate(c.pointer, c.bitAddress, {.bytes = bytes, .whole = true, .write = true}), bytes,
        value);
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
    if (!reachable(l, space, o.value / 8 + 1, write)) return std::nullopt;
    return BitPlace{.space = space, .place = o.value / 8, .direct = o.value & 7};
  }
  if (isCrossing(o)) {
    const Crossing c = crossing(l);
    return BitPlace{.address = l.to.locate(c.pointer, c.bitAddress, {.write = write}),
                    .bit = l.to.make(Opcode::And, c.bitAddress, l.to.constant(7))};
  }
  if (!isIndirect(o)) return std::nullopt;
  const auto place = dynamic(l);
  if (!place) return std::nullopt;
  const Value byte = guarded(l, *place, 1, false, write);
  return BitPlace{.space = place->space,
                  .offset = byte,
                  .bit = l.to.make(Opcode::And, place->address, l.to.constant(7))};
}

std::optional<Value> numberOperand(Lowering& l) {
  const Operand& o = l.operand();
  switch (o.kind) {
    case OperandKind::TimerIndirect:
    case OperandKind::CounterIndirect:
    case OperandKind::BlockIndirect: {
      const auto space = spaceOf(o.pointerArea);
      if (!space || !reachable(l, *space, o.value + 2, false)) return std::nullopt;
      return l.to.load(*space, o.value, 2);
    }
    case OperandKind::TimerParameter:
    case OperandKind::CounterParameter:
    case OperandKind::BlockParameter:
      return l.to.withNumber(Opcode::Shr, parameter(l), 16);
    default:
      return std::nullopt;
  }
}

Value loadByte(Lowering& l, const BitPlace& place) {
  if (place.address != icode::kNoValue) return l.to.loadFrom(place.address, 1);
  return place.offset == icode::kNoValue ? l.to.load(place.space, place.place, 1)
                                         : l.to.loadAt(place.space, place.offset, 1);
}

void storeByte(Lowering& l, const BitPlace& place, Value byte) {
  if (place.address != icode::kNoValue)
    l.to.storeTo(place.address, 1, byte);
  else if (place.offset == icode::kNoValue)
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
