#include "jit/places.h"

#include <algorithm>

namespace merker::jit {

using icode::kNoValue;
using icode::Value;

namespace {

constexpr std::uint32_t kLong = 12;  // operations

}  // namespace

host::Mem slot(std::uint32_t number, std::uint32_t size) {
  return host::Mem(host::rsp, static_cast<int>(8 * number), size);
}

Places::Places(host::Assembler& code, const icode::Region& region, std::uint32_t slots)
    : code_(code),
      region_(region),
      spots_(region.ops.size()),
      lastUse_(region.ops.size()),
      slotOwner_(std::min<std::size_t>(slots, kSlots), kNoValue) {
  owner_.fill(kNoValue);
  planUses(region);
}

// A late operation needs its arguments where it is read, a bit the word in which it stands.
void Places::use(Value value, std::uint32_t at) {
  if (value == kNoValue) return;
  lastUse_[value] = at;
  const icode::Op& op = region_.ops[value];
  if (op.late) lastUse_[op.a] = at;
  if (op.late && op.b != kNoValue) lastUse_[op.b] = at;
  if (op.code == icode::Opcode::BitOf) lastUse_[op.a] = at;
}

void Places::planUses(const icode::Region& region) {
  for (std::uint32_t i = 0; i < region.ops.size(); ++i) {
    const icode::Op& op = region.ops[i];
    if (op.code == icode::Opcode::Constant) spots_[i] = {Spot::Kind::Constant, op.number};
    if (!op.needed) continue;
    if (!op.late && op.code != icode::Opcode::BitOf) use(op.a, i), use(op.b, i), use(op.c, i);
    for (const std::uint32_t number : icode::ExitsOf(region, op)) {
      const icode::Exit& exit = region.exits[number];
      for (std::uint32_t k = 0; k < exit.states; ++k)
        use(region.states[exit.firstState + k].value, i);
      for (std::uint32_t k = 0; k < exit.bytes; ++k) use(region.bytes[exit.firstByte + k].value, i);
    }
  }
}

void Places::releaseDying() {
  for (Value& owner : owner_) {
    if (owner == kNoValue || owner == current_ || lastUse_[owner] > current_) continue;
    spots_[owner].kind = Spot::Kind::None;
    owner = kNoValue;
  }
}

bool Places::isArgument(Value value) const {
  const icode::Op& op = region_.ops[current_];
  return value == root(op.a) || value == root(op.b) || value == root(op.c) || value == current_;
}

// Nobody reads it any more, the current operation neither.
std::uint32_t Places::freeSlot() {
  for (std::uint32_t i = 0; i < slotOwner_.size(); ++i)
    if (slotOwner_[i] == kNoValue || lastUse_[slotOwner_[i]] < current_) return i;
  failed_ = true;
  slotOwner_.push_back(kNoValue);
  return 0;
}

// The value that is needed last goes to the stack frame. Values never change, so one that was there
// before need not be written again; it has no register then.
unsigned Places::makeRoom() {
  unsigned best = kPlaceCount;
  for (unsigned i = 0; i < kPlaceCount; ++i) {
    if (isArgument(owner_[i])) continue;
    if (best == kPlaceCount || lastUse_[owner_[i]] > lastUse_[owner_[best]]) best = i;
  }
  putAway(owner_[best], kPlaces[best]);
  return best;
}

void Places::putAway(Value value, const host::Gp& reg) {
  const auto isOver = [this](Value other) { return lastUse_[other] < current_; };
  if (!homes_) homes_.emplace(region_);
  if (const auto home = homes_->take(value, current_, isOver)) {
    if (home->changed) code_.mov(inImage(home->space, home->byte, 1), reg.r8());
    spots_[value] = {Spot::Kind::Image, Homes::key(home->space, home->byte)};
    return;
  }
  const std::uint32_t number = freeSlot();
  slotOwner_[number] = value;
  code_.mov(slot(number, 8), reg.r64());
  spots_[value] = {Spot::Kind::Slot, number};
}

unsigned Places::freePlace() {
  const bool forLong = lastUse_[current_] > current_ + kLong;
  for (unsigned i = 0; i < kPlaceCount; ++i) {
    const unsigned place = forLong ? kPlaceCount - 1 - i : i;
    if (owner_[place] == kNoValue) return place;
  }
  return makeRoom();
}

host::Gp Places::fetch(const Spot& at, const host::Gp& scratch) {
  switch (at.kind) {
    case Spot::Kind::Register:
      return kPlaces[at.number].r32();
    case Spot::Kind::Slot:
      code_.mov(scratch.r32(), slot(at.number));
      break;
    case Spot::Kind::Image:
      code_.movzx(scratch.r32(), Homes::memory(at.number));
      break;
    default:
      code_.mov(scratch.r32(), at.number);
  }
  return scratch.r32();
}

host::Gp Places::in64(Value value, const host::Gp& scratch) {
  const Spot at = spots_[value];
  if (at.kind != Spot::Kind::Slot) return fetch(at, scratch).r64();
  code_.mov(scratch.r64(), slot(at.number, 8));
  return scratch.r64();
}

host::Gp Places::in(Value value, const host::Gp& scratch) { return fetch(spots_[value], scratch); }

host::Gp Places::out() {
  const unsigned place = freePlace();
  owner_[place] = current_;
  spots_[current_] = {Spot::Kind::Register, place};
  return kPlaces[place].r32();
}

host::Gp Places::outFrom(Value value) {
  const Spot at = spots_[value];
  if (at.kind == Spot::Kind::Register && lastUse_[value] <= current_) {
    owner_[at.number] = current_;
    spots_[current_] = at;
    return kPlaces[at.number].r32();
  }
  const host::Gp reg = out();
  const host::Gp from = in(value, reg);
  if (from.id() != reg.id()) code_.mov(reg, from);
  return reg;
}

void Places::apply(std::uint32_t instruction, const host::Gp& reg, Value value, bool low) {
  const Spot at = spots_[value];
  switch (at.kind) {
    case Spot::Kind::Register:
      code_.emit(instruction, reg, kPlaces[at.number].r32());
      break;
    case Spot::Kind::Slot:
      code_.emit(instruction, reg, slot(at.number));
      break;
    case Spot::Kind::Image:
      if (low)
        code_.emit(instruction, reg.r8(), Homes::memory(at.number));
      else
        code_.emit(instruction, reg, fetch(at, host::edx).r32());
      break;
    default:
      code_.emit(instruction, reg, asmjit::imm(static_cast<std::int32_t>(at.number)));
  }
}

}  // namespace merker::jit
