// Whole numbers and REAL.
#include "jit/region_code.h"

namespace merker::jit {

using host::CondCode;
using icode::Op;
using Id = host::Inst::Id;

void RegionCode::binary(const Op& op, std::uint32_t instruction) {
  places_.apply(instruction, places_.outFrom(op.a), op.b);
}
void RegionCode::unary(const Op& op, std::uint32_t instruction) {
  code_.emit(instruction, places_.outFrom(op.a));
}
void RegionCode::shift(const Op& op, std::uint32_t instruction) {
  const host::Gp to = places_.outFrom(op.a);
  if (op.number != 0) code_.emit(instruction, to, asmjit::imm(op.number));
}

void RegionCode::Add(const Op& op) { binary(op, Id::kIdAdd); }
void RegionCode::Sub(const Op& op) { binary(op, Id::kIdSub); }
void RegionCode::And(const Op& op) { binary(op, Id::kIdAnd); }
void RegionCode::Or(const Op& op) { binary(op, Id::kIdOr); }
void RegionCode::Xor(const Op& op) { binary(op, Id::kIdXor); }
void RegionCode::Neg(const Op& op) { unary(op, Id::kIdNeg); }
void RegionCode::Not(const Op& op) { unary(op, Id::kIdNot); }
void RegionCode::Shl(const Op& op) { shift(op, Id::kIdShl); }
void RegionCode::Shr(const Op& op) { shift(op, Id::kIdShr); }
void RegionCode::Sar(const Op& op) { shift(op, Id::kIdSar); }
void RegionCode::Rotl(const Op& op) { shift(op, Id::kIdRol); }
void RegionCode::shiftBy(const Op& op, std::uint32_t instruction) {
  const host::Gp by = places_.in(op.b, host::ecx);
  if (by.id() != host::ecx.id()) code_.mov(host::ecx, by);
  code_.emit(instruction, places_.outFrom(op.a), host::cl);
}
void RegionCode::ShlBy(const Op& op) { shiftBy(op, Id::kIdShl); }
void RegionCode::ShrBy(const Op& op) { shiftBy(op, Id::kIdShr); }
void RegionCode::SarBy(const Op& op) { shiftBy(op, Id::kIdSar); }
void RegionCode::RotlBy(const Op& op) { shiftBy(op, Id::kIdRol); }
void RegionCode::SwapBytes(const Op& op) { unary(op, Id::kIdBswap); }

void RegionCode::Mul(const Op& op) {
  if (places_.isConstant(op.b)) {
    const host::Gp from = places_.in(op.a, host::eax);
    places_.releaseDying();
    code_.imul(places_.out(), from, static_cast<std::int32_t>(places_.constant(op.b)));
    return;
  }
  const host::Gp by = places_.in(op.b, host::eax);
  const host::Gp to = places_.outFrom(op.a);
  code_.imul(to, op.a == op.b ? to : by);
}

void RegionCode::divide(const Op& op) {
  const host::Gp by = places_.in(op.b, host::ecx);
  const host::Gp from = places_.in(op.a, host::eax);
  if (from.id() != host::eax.id()) code_.mov(host::eax, from);
  code_.cdq();
  code_.idiv(by);
}
void RegionCode::Div(const Op& op) {
  divide(op);
  code_.mov(places_.out(), host::eax);
}
void RegionCode::Mod(const Op& op) {
  divide(op);
  code_.mov(places_.out(), host::edx);
}
void RegionCode::MulHigh(const Op& op) {
  const host::Gp by = places_.in(op.b, host::ecx);
  const host::Gp from = places_.in(op.a, host::eax);
  if (from.id() != host::eax.id()) code_.mov(host::eax, from);
  code_.imul(by);
  code_.mov(places_.out(), host::edx);
}

void RegionCode::Sext16(const Op& op) {
  const host::Gp from = places_.in(op.a, host::eax);
  code_.movsx(places_.out(), from.r16());
}
void RegionCode::Zext16(const Op& op) {
  const host::Gp from = places_.in(op.a, host::eax);
  code_.movzx(places_.out(), from.r16());
}
void RegionCode::Zext8(const Op& op) {
  const host::Gp from = places_.in(op.a, host::eax);
  code_.movzx(places_.out(), from.r8());
}

void RegionCode::LowFrom(const Op& op) {
  code_.movzx(host::eax, places_.in(op.b, host::eax).r16());
  const host::Gp to = places_.outFrom(op.a);
  code_.and_(to, static_cast<std::int32_t>(0xFFFF'0000));
  code_.or_(to, host::eax);
}
void RegionCode::ByteFrom(const Op& op) {
  code_.movzx(host::eax, places_.in(op.b, host::eax).r8());
  const host::Gp to = places_.outFrom(op.a);
  code_.and_(to, static_cast<std::int32_t>(0xFFFF'FF00));
  code_.or_(to, host::eax);
}

void RegionCode::overflows(const Op& op, std::uint32_t instruction) {
  const host::Gp from = places_.in(op.a, host::eax);
  if (from.id() != host::eax.id()) code_.mov(host::eax, from);
  places_.apply(instruction, host::eax, op.b);
  flag(CondCode::kO);
}
// The sum itself may just have been computed: the flags tell.
bool RegionCode::isBehind(icode::Opcode code, const Op& op) const {
  icode::Value before = current_;
  while (before > 0 && isSilent(region_.ops[before - 1])) --before;
  if (before == 0) return false;
  const Op& sum = region_.ops[before - 1];
  return sum.code == code && sum.a == op.a && sum.b == op.b && unit_.options.broken != code;
}
void RegionCode::AddOverflows(const Op& op) {
  if (isBehind(icode::Opcode::Add, op)) return flag(CondCode::kO);
  overflows(op, Id::kIdAdd);
}
void RegionCode::SubOverflows(const Op& op) {
  if (isBehind(icode::Opcode::Sub, op)) return flag(CondCode::kO);
  overflows(op, Id::kIdSub);
}
void RegionCode::MulOverflows(const Op& op) {
  const host::Gp by = places_.in(op.b, host::ecx);
  const host::Gp from = places_.in(op.a, host::eax);
  if (from.id() != host::eax.id()) code_.mov(host::eax, from);
  code_.imul(host::eax, by);
  flag(CondCode::kO);
}

void RegionCode::real(const Op& op, std::uint32_t instruction) {
  code_.movd(host::xmm0, places_.in(op.a, host::eax));
  code_.movd(host::xmm1, places_.in(op.b, host::eax));
  code_.emit(instruction, host::xmm0, host::xmm1);
  places_.releaseDying();
  code_.movd(places_.out(), host::xmm0);
}
void RegionCode::AddReal(const Op& op) { real(op, Id::kIdAddss); }
void RegionCode::SubReal(const Op& op) { real(op, Id::kIdSubss); }
void RegionCode::MulReal(const Op& op) { real(op, Id::kIdMulss); }
void RegionCode::DivReal(const Op& op) { real(op, Id::kIdDivss); }

// a < b as b > a: then a number that is none gives 0.
void RegionCode::LessReal(const Op& op) {
  code_.movd(host::xmm0, places_.in(op.a, host::eax));
  code_.movd(host::xmm1, places_.in(op.b, host::eax));
  code_.ucomiss(host::xmm1, host::xmm0);
  flag(CondCode::kA);
}
void RegionCode::Ordered(const Op& op) {
  code_.movd(host::xmm0, places_.in(op.a, host::eax));
  code_.movd(host::xmm1, places_.in(op.b, host::eax));
  code_.ucomiss(host::xmm0, host::xmm1);
  flag(CondCode::kNP);
}

// Without the sign: 0, or an exponent of 1 to 254.
void RegionCode::Ordinary(const Op& op) {
  const host::Gp from = places_.in(op.a, host::eax);
  code_.lea(host::eax, host::ptr(from.r64(), from.r64()));
  code_.lea(host::ecx, host::ptr(host::rax, -0x0100'0000));
  code_.cmp(host::ecx, static_cast<std::int32_t>(0xFE00'0000));
  if (isForJump()) {  // 0 fails this, and is let through where it failed
    zero_ = code_.newLabel();
    fused_ = CondCode::kB;
    return;
  }
  code_.setb(host::cl);
  code_.test(host::eax, host::eax);
  code_.sete(host::al);
  code_.or_(host::al, host::cl);
  places_.releaseDying();
  code_.movzx(places_.out(), host::al);
}

void RegionCode::RootReal(const Op& op) {
  code_.movd(host::xmm0, places_.in(op.a, host::eax));
  code_.sqrtss(host::xmm0, host::xmm0);
  places_.releaseDying();
  code_.movd(places_.out(), host::xmm0);
}
void RegionCode::RealOf(const Op& op) {
  code_.xorps(host::xmm0, host::xmm0);
  code_.cvtsi2ss(host::xmm0, places_.in(op.a, host::eax));
  code_.movd(places_.out(), host::xmm0);
}
void RegionCode::Truncate(const Op& op) {
  code_.movd(host::xmm0, places_.in(op.a, host::eax));
  code_.cvttss2si(places_.out(), host::xmm0);
}
void RegionCode::Round(const Op& op) {
  code_.movd(host::xmm0, places_.in(op.a, host::eax));
  code_.cvtss2si(places_.out(), host::xmm0);
}

}  // namespace merker::jit
