// Operands whose place is only known when they are executed: through a pointer in memory, an
// address register or a formal parameter (S7-IND-03 … -07, S7-PAR-01). Guards keep the access
// inside.
#include <algorithm>

#include "lowering/lowering.h"

namespace merker::translate {
namespace {

using icode::Access;
using icode::Opcode;
using icode::Space;
using icode::Value;
using mc7::Operand;
using mc7::OperandKind;
using mc7::Operation;

// Bit address: what is only known later, and what stands in the instruction.
struct Dynamic {
  Space space;
  Value low;
  std::uint32_t offset = 0;
};

Value registerOf(Lowering& l) {
  return l.to.get(l.operand().reg == 2 ? icode::Item::Ar2 : icode::Item::Ar1);
}
Value lowOf(Lowering& l, Value ar) { return l.to.make(Opcode::And, ar, l.to.constant(0xFFFFFF)); }

std::optional<Dynamic> dynamic(Lowering& l) {
  const Operand& o = l.operand();
  const auto space = spaceOf(o.area);
  if (!space) return std::nullopt;
  if (o.kind == OperandKind::RegisterIndirect)
    return Dynamic{*space, lowOf(l, registerOf(l)), o.value};
  if (o.kind != OperandKind::MemoryIndirect) return std::nullopt;
  const auto from = spaceOf(o.pointerArea);
  if (!from || !reachable(l, *from, o.value + 4, false)) return std::nullopt;
  const Value pointer = l.to.load(*from, l.at(*from, o.value), 4);
  return Dynamic{*space, l.to.make(Opcode::And, pointer, l.to.constant(0x7FFFF))};
}

bool endsLookout(const mc7::Place& place) {
  const Operation o = place.instruction.operation;
  const OperandKind kind = place.instruction.operand.kind;
  return !place.known || kind == OperandKind::Jump || kind == OperandKind::JumpList ||
         o == Operation::LAR1 || o == Operation::LAR2 || o == Operation::TAR ||
         o == Operation::TAR1 || o == Operation::ADD_AR1 || o == Operation::ADD_AR2 ||
         o == Operation::OPEN || o == Operation::SWAP_DB || o == Operation::UC ||
         o == Operation::CC || o == Operation::BE || o == Operation::BEA;
}

bool writes(Operation o) {
  return o == Operation::TRANSFER || o == Operation::ASSIGN || o == Operation::SET_BIT ||
         o == Operation::RESET_BIT || o == Operation::EDGE_POSITIVE ||
         o == Operation::EDGE_NEGATIVE;
}

// Those among the next instructions that `isMeant` means, until one leads elsewhere or changes an
// address register.
template <typename IsMeant, typename Do>
void lookAhead(const Lowering& l, std::uint32_t from, IsMeant isMeant, Do act) {
  constexpr std::uint32_t kFar = 32;
  const auto count = static_cast<std::uint32_t>(l.listing.places.size());
  for (std::uint32_t i = from; i < std::min(count, l.place + kFar); ++i) {
    const mc7::Place& place = l.listing.places[i];
    if (endsLookout(place)) return;
    if (isMeant(place.instruction.operand)) act(place.instruction);
  }
}

void include(Wanted& wanted, const mc7::Instruction& i) {
  wanted.end = std::max(wanted.end, i.operand.value / 8 + byteCount(i.operand.width));
  wanted.write |= writes(i.operation);
}

// What the instructions from here on need of the same register and area, so that one guard does for
// all of them.
struct WantedOfRegister : Wanted {
  bool whole = false;
};
WantedOfRegister lookout(const Lowering& l) {
  const Operand& here = l.operand();
  WantedOfRegister wanted;
  const auto same = [&](const Operand& o) {
    return o.kind == here.kind && o.reg == here.reg && o.area == here.area;
  };
  lookAhead(l, l.place, same, [&](const mc7::Instruction& i) {
    include(wanted, i);
    wanted.whole |= i.operand.width != Width::Bit;
  });
  return wanted;
}

void guardEnd(Lowering& l, Space space, Value byte, std::uint32_t end, bool write) {
  icode::Builder& b = l.to;
  const Value limit = limitOf(l, space, write);
  const Value last = end == 0 ? byte : b.make(Opcode::Add, byte, b.constant(end));
  b.guard(b.make(Opcode::BelowEqual, last, limit));
  l.reached.push_back({byte, limit, end});
}

Value isWhole(Lowering& l, Value address) {
  icode::Builder& b = l.to;
  return b.make(Opcode::Equal, b.make(Opcode::And, address, b.constant(7)), b.constant(0));
}

// A register at a whole byte, and an offset of whole bytes or, for a bit, of anything.
BitPlace aligned(Lowering& l, const Dynamic& d, const Access& access, const Wanted& wanted) {
  icode::Builder& b = l.to;
  b.guard(isWhole(l, d.low));
  const Value byte = b.withNumber(Opcode::Shr, d.low, 3);
  const std::uint32_t end = d.offset / 8 + access.bytes;
  if (!isReached(l, d.space, byte, end, access.write))
    guardEnd(l, d.space, byte, std::max(end, wanted.end), access.write || wanted.write);
  return {.space = d.space,
          .place = l.at(d.space, d.offset / 8),
          .offset = byte,
          .direct = d.offset & 7};
}

BitPlace anywhere(Lowering& l, const Dynamic& d, const Access& access) {
  icode::Builder& b = l.to;
  const Value address = b.make(Opcode::Add, d.low, b.constant(d.offset));
  const Value bit = b.make(Opcode::And, address, b.constant(7));
  if (access.whole) b.guard(b.make(Opcode::Equal, bit, b.constant(0)));
  const Value byte = b.withNumber(Opcode::Shr, address, 3);
  if (!isReached(l, d.space, byte, access.bytes, access.write))
    guardEnd(l, d.space, byte, access.bytes, access.write);
  return {.space = d.space, .place = l.at(d.space, 0), .offset = byte, .bit = bit};
}

// Of a block that stands in the region of its caller.
std::optional<BitPlace> knownLocal(const Lowering& l, Area area, std::uint32_t bit,
                                   std::uint32_t bytes) {
  if (l.inside == nullptr) return std::nullopt;
  const Inside& in = *l.inside;
  const bool caller = area == Area::CallerLocal;
  const std::uint32_t byte = bit / 8;
  if (byte + bytes > (caller ? in.callerLocalBytes : in.localBytes)) return std::nullopt;
  constexpr std::uint32_t kStartInformation = 20;  // S7-OBI-01: the date in it is watched
  if (caller && in.callerIsOb && byte < kStartInformation) return std::nullopt;
  return BitPlace{.space = Space::Local,
                  .place = (caller ? in.callerLocal : in.local) + byte,
                  .direct = bit & 7};
}

// Behind LAR1 P#M 10.0 the byte is known now. Other addresses need a look when it runs.
std::optional<BitPlace> known(Lowering& l, Area area, Value address, const Access& access) {
  constexpr std::uint32_t kHighest = 0x7FFFF;  // bit address
  const auto bit = l.to.number(address);
  if (!bit || *bit > kHighest || (access.whole && *bit % 8 != 0)) return std::nullopt;
  if (area == Area::Local || area == Area::CallerLocal)
    return knownLocal(l, area, *bit, access.bytes);
  const auto space = spaceOf(area);
  if (!space || !reachable(l, *space, *bit / 8 + access.bytes, access.write)) return std::nullopt;
  return BitPlace{.space = *space, .place = *bit / 8, .direct = *bit & 7};
}

// The area stands in a pointer: of a parameter, or in an address register.
std::optional<BitPlace> crossing(Lowering& l, const Access& access) {
  icode::Builder& b = l.to;
  const Operand& o = l.operand();
  Value pointer = icode::kNoValue, address = icode::kNoValue;
  if (o.kind == OperandKind::Parameter) {
    const auto entry = parameterPointer(l);
    if (!entry) return std::nullopt;
    pointer = *entry;
    address = b.make(Opcode::And, pointer, b.constant(0x7FFFF));
  } else {
    pointer = registerOf(l);
    address = lowOf(l, pointer);
    if (o.value != 0) address = b.make(Opcode::Add, address, b.constant(o.value));
  }
  if (const auto area = b.number(pointer))
    if (const auto place = known(l, static_cast<Area>(*area >> 24), address, access)) return place;
  if (l.inside != nullptr) return std::nullopt;  // it may be local data of a frame not yet written
  return BitPlace{
      .address = b.locate(pointer, address, access),
      .bit = access.whole ? icode::kNoValue : b.make(Opcode::And, address, b.constant(7))};
}

}  // namespace

Wanted lookout(const Lowering& l, Space space) {
  Wanted wanted;
  const auto direct = [space](const Operand& o) {
    return o.kind == OperandKind::Memory && spaceOf(o.area) == space;
  };
  lookAhead(l, l.place + 1, direct, [&](const mc7::Instruction& i) { include(wanted, i); });
  return wanted;
}

std::optional<Value> parameterPointer(Lowering& l) {
  const std::uint32_t index = l.operand().value;
  if (l.inside != nullptr && index >= l.inside->list.size()) return std::nullopt;
  if (l.inside != nullptr) return l.to.constant(l.inside->list[index]);
  l.needs.parameters = std::max(l.needs.parameters, l.operand().value + 1);
  return l.to.withNumber(Opcode::Parameter, icode::kNoValue, l.operand().value);
}

std::optional<BitPlace> indirectPlace(Lowering& l, const Access& access) {
  const OperandKind kind = l.operand().kind;
  if (kind == OperandKind::Parameter || kind == OperandKind::RegisterCrossing)
    return crossing(l, access);
  const auto d = dynamic(l);
  if (!d) return std::nullopt;
  const Value address = l.to.make(Opcode::Add, d->low, l.to.constant(d->offset));
  if (const auto place = known(l, l.operand().area, address, access)) return place;
  const bool constant = !access.whole || d->offset % 8 == 0;
  if (kind == OperandKind::MemoryIndirect)
    return access.whole ? aligned(l, *d, access, {}) : anywhere(l, *d, access);
  const WantedOfRegister wanted = lookout(l);
  const bool whole = wanted.whole || l.to.isGuarded(isWhole(l, d->low));
  return constant && whole ? aligned(l, *d, access, wanted) : anywhere(l, *d, access);
}

}  // namespace merker::translate
