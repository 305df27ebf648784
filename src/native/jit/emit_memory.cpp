// Registers, status bits and memory.
#include "jit/region_code.h"

namespace merker::jit {

using icode::Op;
using icode::Opcode;
using icode::Space;

namespace {

bool hasMovbe() {
  static const bool kHas = asmjit::CpuInfo::host().features().x86().hasMOVBE();
  return kHas;
}

}  // namespace

void RegionCode::Constant(const Op&) {}

void RegionCode::Get(const Op& op) {
  const host::Gp to = places_.out();
  const int at = offsetOf(op.item);
  if (icode::isBit(op.item))
    code_.movzx(to, host::byte_ptr(kState, at));
  else
    code_.mov(to, host::dword_ptr(kState, at));
}

// The image has a register of its own; Base of it only names it.
void RegionCode::Base(const Op& op) {
  if (icode::isImage(op.space)) return;
  const host::Gp to = places_.out().r64();
  if (op.space == Space::Local) {
    code_.mov(to, inState(frames().top));
    code_.mov(to, host::qword_ptr(to, frames().frame.local));
    return;
  }
  code_.mov(to, inState(openBlock(op.space).data));
}

host::Mem RegionCode::place(const Op& op, unsigned bytes) {
  const Op& address = region_.ops[op.a];
  if (address.code == Opcode::Base && icode::isImage(op.space))
    return inImage(op.space, op.place, bytes);
  return {places_.in64(op.a, host::rcx), static_cast<int>(op.place), bytes};
}

void RegionCode::Load8(const Op& op) {
  const host::Mem from = place(op, 1);
  code_.movzx(places_.out(), from);
}

// S7 memory has the high byte first.
void RegionCode::Load16(const Op& op) {
  const host::Mem from = place(op, 2);
  const host::Gp to = places_.out();
  code_.movzx(to, from);
  code_.rol(to.r16(), 8);
}
void RegionCode::Load32(const Op& op) {
  const host::Mem from = place(op, 4);
  const host::Gp to = places_.out();
  if (hasMovbe()) {
    code_.movbe(to, from);
    return;
  }
  code_.mov(to, from);
  code_.bswap(to);
}

void RegionCode::Store8(const Op& op) {
  const host::Mem to = place(op, 1);
  if (places_.isConstant(op.b))
    code_.mov(to, places_.constant(op.b) & 0xFF);
  else
    code_.mov(to, places_.in(op.b, host::eax).r8());
}
void RegionCode::Store16(const Op& op) {
  const host::Mem to = place(op, 2);
  const host::Gp from = places_.in(op.b, host::eax);
  if (hasMovbe()) {
    code_.movbe(to, from.r16());
    return;
  }
  if (from.id() != host::eax.id()) code_.mov(host::eax, from);
  code_.rol(host::ax, 8);
  code_.mov(to, host::ax);
}
void RegionCode::Store32(const Op& op) {
  const host::Mem to = place(op, 4);
  const host::Gp from = places_.in(op.b, host::eax);
  if (hasMovbe()) {
    code_.movbe(to, from);
    return;
  }
  if (from.id() != host::eax.id()) code_.mov(host::eax, from);
  code_.bswap(host::eax);
  code_.mov(to, host::eax);
}

void RegionCode::Index(const Op& op) {
  const host::Gp by = places_.in64(op.b, host::rax);
  const Op& base = region_.ops[op.a];
  if (base.code == Opcode::Base && icode::isImage(base.space)) {
    const host::Gp to = places_.out().r64();
    code_.lea(to, host::ptr(kImages[static_cast<std::size_t>(base.space)], by, 0, -kBias));
    return;
  }
  const host::Gp from = places_.in64(op.a, host::rcx);
  const host::Gp to = places_.out().r64();
  code_.lea(to, host::ptr(from, by));
}

void RegionCode::Limit(const Op& op) {
  const host::Gp to = places_.out();
  if (op.space == Space::Local) {
    code_.mov(host::rax, inState(frames().top));
    code_.mov(to, host::dword_ptr(host::rax, frames().frame.localLength));
    return;
  }
  code_.mov(to, host::dword_ptr(kState, openBlock(op.space).length));
}

void RegionCode::WriteLimit(const Op& op) {
  code_.mov(places_.out(), host::dword_ptr(kState, openBlock(op.space).writable));
}

// L DBLG, DILG, DBNO, DINO
void RegionCode::BlockInfo(const Op& op) {
  const bool instance = (op.number & 1) != 0;
  const Layout::Open& open = openBlock(instance ? Space::Instance : Space::Data);
  const host::Gp to = places_.out();
  if (op.number < 2)
    code_.mov(to, host::dword_ptr(kState, open.length));
  else
    code_.movzx(to, host::word_ptr(kState, open.number));
}

}  // namespace merker::jit
