// Bits and comparisons.
#include "jit/region_code.h"

namespace merker::jit {

using host::CondCode;
using icode::Op;

// A bit of a register is used where it stands: BitOf only says where, and what two bits make stands
// where one of them stood.
RegionCode::Bit RegionCode::bit(icode::Value value) const {
  const Op& op = region_.ops[value];
  if (op.code != icode::Opcode::BitOf) return {value, position_[value], isolated_[value]};
  const bool broken = unit_.options.broken == icode::Opcode::BitOf;
  return {op.a, broken ? op.number ^ 1 : op.number, false};
}

void RegionCode::turn(const host::Gp& to, const host::Gp& from, unsigned at, unsigned wanted) {
  static const bool kHasRorx = asmjit::CpuInfo::host().features().x86().hasBMI2();
  const bool moves = to.id() != from.id();
  if (moves && at != wanted && kHasRorx) {
    code_.rorx(to, from, (at - wanted) & 31);
    return;
  }
  if (moves) code_.mov(to, from);
  if (at > wanted) code_.shr(to, at - wanted);
  if (at < wanted) code_.shl(to, wanted - at);
}

// In a register that may be changed: its own if nobody needs it any more, otherwise `scratch`.
host::Gp RegionCode::moved(const Bit& bit, unsigned wanted, const host::Gp& scratch, bool isOther) {
  const host::Gp from = places_.in(bit.root, scratch);
  const host::Gp to = !isOther && places_.dies(bit.root) ? from : scratch;
  turn(to, from, bit.position, wanted);
  return to;
}

host::Gp RegionCode::alone(icode::Value value, unsigned wanted, icode::Value other) {
  const Bit b = bit(value);
  const host::Gp reg = moved(b, wanted, host::eax, b.root == other);
  if (!b.isolated) code_.and_(reg, static_cast<std::int32_t>(1u << wanted));
  return reg;
}

void RegionCode::BitOf(const Op&) {}

void RegionCode::BitAt(const Op& op) {
  const host::Gp by = places_.in(op.b, host::ecx);
  if (by.id() != host::ecx.id()) code_.mov(host::ecx, by);
  code_.shr(places_.outFrom(op.a), host::cl);
}

void RegionCode::Insert(const Op& op) {
  const std::uint32_t mask = 1u << op.number;
  if (places_.isConstant(op.b)) {
    const host::Gp to = places_.outFrom(op.a);
    if ((places_.constant(op.b) & 1) != 0)
      code_.or_(to, mask);
    else
      code_.and_(to, ~mask);
    return;
  }
  const Bit b = bit(op.b);
  const host::Gp reg = moved(b, op.number, host::eax, b.root == op.a);
  if (b.isolated) {
    const host::Gp to = places_.outFrom(op.a);
    code_.and_(to, static_cast<std::int32_t>(~mask));
    code_.or_(to, reg);
    return;
  }
  places_.apply(host::Inst::kIdXor, reg, op.a, op.number < 8);
  code_.and_(reg, static_cast<std::int32_t>(mask));
  code_.xor_(places_.outFrom(op.a), reg);
}

void RegionCode::InsertAt(const Op& op) {
  const host::Gp by = places_.in(op.c, host::ecx);
  if (by.id() != host::ecx.id()) code_.mov(host::ecx, by);
  const Bit b = bit(op.b);
  turn(host::eax, places_.in(b.root, host::eax), b.position, 0);
  if (!b.isolated) code_.and_(host::eax, 1);
  code_.shl(host::eax, host::cl);
  code_.mov(host::edx, 1);
  code_.shl(host::edx, host::cl);
  code_.not_(host::edx);
  const host::Gp to = places_.outFrom(op.a);
  code_.and_(to, host::edx);
  code_.or_(to, host::eax);
}

void RegionCode::SetWhere(const Op& op) {
  const host::Gp reg = alone(op.b, op.number, op.a);
  code_.or_(places_.outFrom(op.a), reg);
}

void RegionCode::ClearWhere(const Op& op) {
  const host::Gp reg = alone(op.b, op.number, op.a);
  code_.not_(reg);
  code_.and_(places_.outFrom(op.a), reg);
}

void RegionCode::bits(const Op& op, std::uint32_t instruction) {
  Bit a = bit(op.a), b = bit(op.b);
  if (!places_.dies(a.root)) std::swap(a, b);
  position_[current_] = static_cast<std::uint8_t>(a.position);
  if (a.position == b.position) {
    places_.apply(instruction, places_.outFrom(a.root), b.root, a.position < 8);
  } else if (places_.dies(a.root)) {
    const host::Gp other = moved(b, a.position, host::eax, b.root == a.root);
    code_.emit(instruction, places_.outFrom(a.root), other);
  } else {
    const host::Gp to = places_.out();
    turn(to, places_.in(b.root, to), b.position, a.position);
    places_.apply(instruction, to, a.root, a.position < 8);
  }
}

void RegionCode::AndBit(const Op& op) { bits(op, host::Inst::kIdAnd); }
void RegionCode::OrBit(const Op& op) { bits(op, host::Inst::kIdOr); }
void RegionCode::XorBit(const Op& op) { bits(op, host::Inst::kIdXor); }

// Where other bits do not count, a shorter constant does that inverts them, too.
void RegionCode::NotBit(const Op& op) {
  const Bit a = bit(op.a);
  position_[current_] = static_cast<std::uint8_t>(a.position);
  const bool longer = a.position == 7 && !a.isolated;
  code_.xor_(places_.outFrom(a.root), longer ? -128 : static_cast<std::int32_t>(1u << a.position));
}

void RegionCode::ToWord(const Op& op) {
  const Bit a = bit(op.a);
  host::Gp to;
  if (places_.dies(a.root)) {
    to = places_.outFrom(a.root);
    turn(to, to, a.position, 0);
  } else {
    to = places_.out();
    turn(to, places_.in(a.root, to), a.position, 0);
  }
  if (!a.isolated) code_.and_(to, 1);
}

bool RegionCode::isRead(const icode::Exit& exit, icode::Value value) const {
  for (std::uint32_t i = 0; i < exit.states; ++i)
    if (region_.states[exit.firstState + i].value == value) return true;
  for (std::uint32_t i = 0; i < exit.bytes; ++i)
    if (region_.bytes[exit.firstByte + i].value == value) return true;
  return false;
}

// A comparison directly in front of the only jump that needs it stays in the flags.
bool RegionCode::isForJump() const {
  icode::Value next = current_ + 1;
  while (isSilent(region_.ops[next])) ++next;
  const Op& op = region_.ops[next];
  if (op.code < icode::Opcode::Guard || op.code > icode::Opcode::BranchUnless || op.a != current_ ||
      !places_.isOnlyFor(next) || unit_.options.broken == region_.ops[current_].code)
    return false;
  for (const std::uint32_t number : icode::ExitsOf(region_, op))
    if (isRead(region_.exits[number], current_)) return false;
  return true;
}

void RegionCode::flag(CondCode condition) {
  if (isForJump()) {
    fused_ = condition;
    return;
  }
  code_.set(condition, host::al);
  places_.releaseDying();
  code_.movzx(places_.out(), host::al);
}

void RegionCode::compare(const Op& op, CondCode condition) {
  const host::Gp a = places_.in(op.a, host::eax);
  if (places_.isConstant(op.b) && places_.constant(op.b) == 0)
    code_.test(a, a);  // the same flags as cmp with 0
  else
    places_.apply(host::Inst::kIdCmp, a, op.b);
  flag(condition);
}

void RegionCode::Equal(const Op& op) { compare(op, CondCode::kE); }
void RegionCode::NotEqual(const Op& op) { compare(op, CondCode::kNE); }
void RegionCode::Less(const Op& op) { compare(op, CondCode::kL); }
void RegionCode::LessEqual(const Op& op) { compare(op, CondCode::kLE); }
void RegionCode::Below(const Op& op) { compare(op, CondCode::kB); }
void RegionCode::BelowEqual(const Op& op) { compare(op, CondCode::kBE); }

}  // namespace merker::jit
