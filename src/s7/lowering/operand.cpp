// Operands in memory: where they lie, and what must hold so that they can be reached.
#include <algorithm>

#include "lowering/lowering.h"

namespace merker::translate {

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

namespace {

// Notes what the region needs; false if the operand is known to be out of range.
bool reach(Lowering& l, Space space, std::uint32_t end, bool write) {
  const auto atLeast = [end](std::uint32_t& limit) { limit = std::max(limit, end); };
  switch (l.to.held(space)) {
    case Space::Data:
      atLeast(write ? l.needs.dataWritten : l.needs.dataRead);
      return true;
    case Space::Instance:
      atLeast(write ? l.needs.instanceWritten : l.needs.instanceRead);
      return true;
    case Space::Local:
      if (l.inside != nullptr) return end <= l.inside->localBytes;
      atLeast(l.needs.local);
      return true;
    default:
      return end <= imageLength(l.model, space);
  }
}

}  // namespace

Value limitOf(Lowering& l, Space space, bool write) {
  if (l.inside != nullptr && space == Space::Local) return l.to.constant(l.inside->localBytes);
  return icode::isImage(space) ? l.to.constant(imageLength(l.model, space))
                               : l.to.limit(space, write);
}

// What may be written may be read.
bool isReached(Lowering& l, Space space, Value byte, std::uint32_t end, bool write) {
  const Value limit = limitOf(l, space, write), writable = limitOf(l, space, true);
  return std::any_of(l.reached.begin(), l.reached.end(), [&](const Reach& known) {
    return known.byte == byte && known.end >= end &&
           (known.limit == limit || known.limit == writable);
  });
}

// Opened in this region: its length is only known when it runs. One guard does for what the next
// instructions need of it.
bool reachable(Lowering& l, Space space, std::uint32_t end, bool write) {
  if (!l.to.isReopened(space)) return reach(l, space, end, write);
  if (isReached(l, space, icode::kNoValue, end, write)) return true;
  icode::Builder& b = l.to;
  const Wanted next = lookout(l, space);
  const Value limit = b.limit(space, write || next.write);
  const std::uint32_t last = std::max(end, next.end);
  b.guard(b.make(Opcode::BelowEqual, b.constant(last), limit));
  l.reached.push_back({icode::kNoValue, limit, last});
  return true;
}

namespace {

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
    return l.to.load(space, l.at(space, o.value / 8), bytes);
  }
  const auto place = indirectPlace(l, {.bytes = bytes, .whole = true});
  return place ? std::optional(loadBytes(l, *place, bytes)) : std::nullopt;
}

bool writeOperand(Lowering& l, Width width, Value value) {
  const Operand& o = l.operand();
  const unsigned bytes = byteCount(width);
  if (bytes == 1) value = l.to.make(Opcode::Zext8, value);
  if (isDirect(o, width)) {
    const Space space = *spaceOf(o.area);
    if (!reachable(l, space, o.value / 8 + bytes, true)) return false;
    l.to.store(space, l.at(space, o.value / 8), bytes, value);
    return true;
  }
  const auto place = indirectPlace(l, {.bytes = bytes, .whole = true, .write = true});
  if (place) storeBytes(l, *place, bytes, value);
  return place.has_value();
}

std::optional<BitPlace> bitPlace(Lowering& l, bool write) {
  const Operand& o = l.operand();
  if (const auto known = l.ahead.find(l.place); known != l.ahead.end()) return known->second;
  if (!isDirect(o, Width::Bit)) return indirectPlace(l, {.write = write});
  const Space space = *spaceOf(o.area);
  if (!reachable(l, space, o.value / 8 + 1, write)) return std::nullopt;
  return BitPlace{.space = space, .place = l.at(space, o.value / 8), .direct = o.value & 7};
}

std::optional<Value> numberOperand(Lowering& l) {
  const Operand& o = l.operand();
  switch (o.kind) {
    case OperandKind::TimerIndirect:
    case OperandKind::CounterIndirect:
    case OperandKind::BlockIndirect: {
      const auto space = spaceOf(o.pointerArea);
      if (!space || !reachable(l, *space, o.value + 2, false)) return std::nullopt;
      return l.to.load(*space, l.at(*space, o.value), 2);
    }
    case OperandKind::TimerParameter:
    case OperandKind::CounterParameter:
    case OperandKind::BlockParameter: {
      const auto pointer = parameterPointer(l);
      if (!pointer) return std::nullopt;
      return l.to.withNumber(Opcode::Shr, *pointer, 16);
    }
    default:
      return std::nullopt;
  }
}

Value loadBytes(Lowering& l, const BitPlace& place, unsigned bytes) {
  if (place.address != icode::kNoValue) return l.to.loadFrom(place.address, bytes);
  return place.offset == icode::kNoValue
             ? l.to.load(place.space, place.place, bytes)
             : l.to.loadAt(place.space, place.offset, place.place, bytes);
}

void storeBytes(Lowering& l, const BitPlace& place, unsigned bytes, Value value) {
  if (place.address != icode::kNoValue)
    l.to.storeTo(place.address, bytes, value);
  else if (place.offset == icode::kNoValue)
    l.to.store(place.space, place.place, bytes, value);
  else
    l.to.storeAt(place.space, place.offset, place.place, bytes, value);
}

Value withBit(Lowering& l, const BitPlace& place, Value byte, Value bit) {
  return place.bit == icode::kNoValue ? l.to.withBit(byte, bit, place.direct)
                                      : l.to.make3(Opcode::InsertAt, byte, bit, place.bit);
}

Value bitIn(Lowering& l, const BitPlace& place, Value byte) {
  return place.bit == icode::kNoValue ? l.to.bitOf(byte, place.direct)
                                      : l.to.make(Opcode::BitAt, byte, place.bit);
}

}  // namespace merker::translate
