// Bits and comparisons.
#include "jit/region_code.h"

namespace merker::jit {

using host::CondCode;
using icode::Op;

host::Gp RegionCode::clean(icode::Value bit, const host::Gp& scratch) {
  const host::Gp from = places_.in(bit, scratch);
  if (from.id() != scratch.id()) code_.mov(scratch, from);
  if (!isClean(bit)) code_.and_(scratch, 1);
  return scratch;
}

void RegionCode::BitOf(const Op& op) {
  const host::Gp to = places_.outFrom(op.a);
  if (op.number != 0) code_.shr(to, op.number);
}

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
  clean(op.b, host::eax);
  if (op.number != 0) code_.shl(host::eax, op.number);
  const host::Gp to = places_.outFrom(op.a);
  code_.and_(to, static_cast<std::int32_t>(~mask));
  code_.or_(to, host::eax);
}

void RegionCode::InsertAt(const Op& op) {
  const host::Gp by = places_.in(op.c, host::ecx);
  if (by.id() != host::ecx.id()) code_.mov(host::ecx, by);
  clean(op.b, host::eax);
  code_.shl(host::eax, host::cl);
  code_.mov(host::edx, 1);
  code_.shl(host::edx, host::cl);
  code_.not_(host::edx);
  const host::Gp to = places_.outFrom(op.a);
  code_.and_(to, host::edx);
  code_.or_(to, host::eax);
}

void RegionCode::SetWhere(const Op& op) {
  clean(op.b, host::eax);
  if (op.number != 0) code_.shl(host::eax, op.number);
  code_.or_(places_.outFrom(op.a), host::eax);
}

void RegionCode::ClearWhere(const Op& op) {
  clean(op.b, host::eax);
  if (op.number != 0) code_.shl(host::eax, op.number);
  code_.not_(host::eax);
  code_.and_(places_.outFrom(op.a), host::eax);
}

void RegionCode::AndBit(const Op& op) { binary(op, host::Inst::kIdAnd); }
void RegionCode::OrBit(const Op& op) { binary(op, host::Inst::kIdOr); }
void RegionCode::XorBit(const Op& op) { binary(op, host::Inst::kIdXor); }
void RegionCode::NotBit(const Op& op) { code_.xor_(places_.outFrom(op.a), 1); }

void RegionCode::ToWord(const Op& op) {
  const host::Gp to = places_.outFrom(op.a);
  if (!isClean(op.a)) code_.and_(to, 1);
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
  const auto isSilent = [&](const Op& op) {
    return !op.needed || op.late || op.code == icode::Opcode::Constant;
  };
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
  places_.apply(host::Inst::kIdCmp, places_.in(op.a, host::eax), op.b);
  flag(condition);
}

void RegionCode::Equal(const Op& op) { compare(op, CondCode::kE); }
void RegionCode::NotEqual(const Op& op) { compare(op, CondCode::kNE); }
void RegionCode::Less(const Op& op) { compare(op, CondCode::kL); }
void RegionCode::LessEqual(const Op& op) { compare(op, CondCode::kLE); }
void RegionCode::Below(const Op& op) { compare(op, CondCode::kB); }
void RegionCode::BelowEqual(const Op& op) { compare(op, CondCode::kBE); }

}  // namespace merker::jit
