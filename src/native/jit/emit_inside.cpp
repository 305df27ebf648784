// Blocks whose instructions stand in the region of their caller: nothing is written of a call but
// at an exit inside, and there all of it.
#include "jit/region_code.h"

namespace merker::jit {

using icode::Inlined;
using icode::Op;

namespace {

const Layout::List& tableOf(const Layout::Frames& frames, const Inlined& call) {
  return call.functionBlock ? frames.functionBlocks : frames.functions;
}

}  // namespace

// rdx: what the engine made of the block, which is there.
void RegionCode::loadCode(const Inlined& call) {
  code_.mov(host::rdx, inState(tableOf(frames(), call).first));
  code_.mov(host::rdx, host::qword_ptr(host::rdx, static_cast<int>(8 * call.number)));
}

// The block is the one that was translated, and nesting depth, local data and memory for frames do.
// The master control relay, which a called block finds switched off, is so anyway where one of its
// instructions asks (Needs::relayOn).
void RegionCode::CanInline(const Op& op) {
  const asmjit::Label out = wayOut(op);
  const Inlined& call = region_.inlined[op.place];
  const Layout::Frame& at = frames().frame;
  const Layout::List& table = tableOf(frames(), call);
  code_.mov(host::rax, inState(table.first));
  code_.add(host::rax, static_cast<int>(8 * call.number));
  code_.cmp(host::rax, inState(table.end));
  code_.jae(out);
  code_.mov(host::rdx, host::qword_ptr(host::rax));
  code_.test(host::rdx, host::rdx);
  code_.je(out);
  code_.mov(host::rax, reinterpret_cast<std::uintptr_t>(call.mark));
  code_.cmp(host::rax, host::qword_ptr(host::rdx, frames().code.mark));
  code_.jne(out);
  code_.mov(host::rcx, inState(frames().top));
  code_.lea(host::rax, host::ptr(host::rcx, static_cast<int>(call.depth) * at.bytes));
  code_.cmp(host::rax, inState(frames().callLimit));
  code_.jae(out);
  code_.mov(host::eax, host::dword_ptr(host::rcx, at.localEnd));
  code_.add(host::eax, call.localBytes);
  code_.cmp(host::eax, frames().localBytes);
  code_.ja(out);
}

// Behind the frame that runs, where it will be.
int RegionCode::frameOf(const Inlined& call) const {
  return static_cast<int>(call.depth + 1) * frames().frame.bytes;
}

void RegionCode::KeepFrame(const Op& op) {
  const Layout::Frame& at = frames().frame;
  const int frame = frameOf(region_.inlined[op.place]);
  code_.mov(host::rax, inState(frames().top));
  copyBlocks(code_, host::rax, frame + at.data, kState, unit_.layout.data.begin);
  if (places_.isConstant(op.a))
    code_.mov(host::dword_ptr(host::rax, frame + at.ar2), places_.constant(op.a));
  else
    code_.mov(host::dword_ptr(host::rax, frame + at.ar2), places_.in(op.a, host::edx));
}

void RegionCode::GiveBack(const Op& op) {
  const int frame = frameOf(region_.inlined[op.place]);
  code_.mov(host::rax, inState(frames().top));
  copyBlocks(code_, kState, unit_.layout.data.begin, host::rax, frame + frames().frame.data);
}

void RegionCode::pushFrame(const Inlined& call) {
  if (call.outer != 0) pushFrame(region_.inlined[call.outer - 1]);
  loadCode(call);
  code_.mov(host::esi, call.resume);
  code_.mov(host::edi, call.offset);
  code_.mov(host::r8, call.parameters == 0 ? 0 : reinterpret_cast<std::uintptr_t>(call.list));
  code_.mov(host::r9d, call.parameters);
  code_.call(asmjit::imm(call.keeps ? unit_.ways.pushKept : unit_.ways.pushFrame));
}

// On in the compiled code of that block, which knows the way to the interpreter, too.
void RegionCode::goInside(const icode::Exit& exit) {
  const Inlined& call = region_.inlined[exit.inside - 1];
  pushFrame(call);
  if (exit.position != call.offset)  // of a block that it called and that has ended
    code_.mov(host::dword_ptr(kState, frames().position), exit.position);
  code_.mov(host::rdx, host::qword_ptr(host::rdx, frames().code.native));
  code_.mov(host::eax, exit.to);
  code_.jmp(host::qword_ptr(host::rdx, host::rax, 3));
}

}  // namespace merker::jit
