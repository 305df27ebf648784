// From block to block in frames of jit (blocks.h).
#include <cstddef>

#include "jit/region_code.h"

namespace merker::jit {

using icode::Exit;
using icode::Op;
using icode::Way;

namespace {

constexpr int kFrameBytes = sizeof(Frame), kSite = offsetof(Frame, site),
              kBack = offsetof(Frame, back);
static_assert(sizeof(OpenBlock) == 32 && offsetof(Frame, open) == 0);

void copyOpen(host::Assembler& code, const host::Gp& to, int toAt, const host::Gp& from,
              int fromAt) {
  code.movups(host::xmm0, host::xmmword_ptr(from, fromAt));
  code.movups(host::xmm1, host::xmmword_ptr(from, fromAt + 16));
  code.movups(host::xmmword_ptr(to, toAt), host::xmm0);
  code.movups(host::xmmword_ptr(to, toAt + 16), host::xmm1);
}

}  // namespace

// The caller goes on behind its call of the host, whose return address moves to the stack of the
// blocks: so one stack frame does for all of them, and the host foresees the way back.
void writeEntrance(const Unit& unit) {
  const Layout::Blocks& blocks = *unit.layout.blocks;
  host::Assembler& code = unit.code;
  code.pop(host::rcx);
  code.mov(host::rdx, inState(blocks.top));
  copyOpen(code, host::rdx, 0, kState, unit.layout.data.begin);
  code.add(host::rdx, kFrameBytes);
  code.mov(host::qword_ptr(host::rdx, kSite), host::rax);
  code.mov(host::qword_ptr(host::rdx, kBack), host::rcx);
  code.mov(inState(blocks.top), host::rdx);
  code.xor_(host::eax, host::eax);
  const bool compiled = !unit.regions.empty() && unit.regions[0].isValid();
  code.jmp(compiled ? unit.regions[0] : unit.epilogue);
}

asmjit::Label RegionCode::frontOf(const Exit& exit) {
  if (exit.way == Way::On) return {};
  const asmjit::Label label = code_.newLabel();
  const Exit& front = region_.exits[exit.front];
  waysOut_.push_back({label, exit.front, spotsOfStates(front), spotsOfBytes(front), {}, {}});
  return label;
}

void RegionCode::checkStack(const Exit& exit, const asmjit::Label& front) {
  if (exit.way == Way::On) return;
  const bool call = exit.way == Way::Call;
  if (unit_.options.broken == (call ? icode::Opcode::CanCall : icode::Opcode::CanReturn)) return;
  code_.mov(host::rax, inState(unit_.layout.blocks->top));
  code_.cmp(host::rax, inState(call ? unit_.layout.blocks->last : unit_.layout.blocks->first));
  code_.je(front);
}

void RegionCode::goOn(const Exit& exit, std::uint32_t next) {
  if (exit.inside != 0) return goInside(exit);
  if (exit.way == Way::On) return goTo(exit.to, next);
  const Layout::Blocks& blocks = *unit_.layout.blocks;
  if (exit.way == Way::Call) {
    code_.mov(host::rax, inState(blocks.sites));
    code_.add(host::rax, static_cast<int>(exit.site * sizeof(Site)));
    code_.call(host::qword_ptr(host::rax, offsetof(Site, target)));
    return goTo(exit.to, next);
  }
  const host::Gp frame = host::rdx;
  code_.mov(frame, inState(blocks.top));
  code_.mov(host::rax, host::qword_ptr(frame, kSite));
  code_.mov(host::eax, host::dword_ptr(host::rax, offsetof(Site, resume)));
  code_.push(host::qword_ptr(frame, kBack));
  code_.sub(frame, kFrameBytes);
  code_.mov(inState(blocks.top), frame);
  copyOpen(code_, kState, unit_.layout.data.begin, frame, 0);
  code_.ret();
}

void RegionCode::openLinked(const Op& op) {
  const asmjit::Label out = wayOut(op);
  code_.mov(host::rax, inState(unit_.layout.blocks->dataBlocks));
  code_.add(host::rax, static_cast<int>(places_.constant(op.a) * sizeof(OpenBlock)));
  code_.cmp(host::qword_ptr(host::rax, offsetof(OpenBlock, data)), 0);
  code_.je(out);
  copyOpen(code_, kState, unit_.layout.data.begin, host::rax, 0);
}

}  // namespace merker::jit
