// Calls and returns in frames of the owner (Layout::Frames); what is written there stands in
// emit_frames.cpp.
#include "jit/region_code.h"

namespace merker::jit {

using icode::Op;

void RegionCode::CanCall(const Op& op) {
  if (places_.isConstant(op.a))
    code_.mov(host::edx, places_.constant(op.a));
  else
    code_.mov(host::edx, places_.in(op.a, host::edx));
  code_.call(region_.calls[op.place].functionBlock ? asmjit::imm(unit_.ways.canCallFunctionBlock)
                                                   : asmjit::imm(unit_.ways.canCallFunction));
  code_.jc(wayOut(op));
}

// Behind CanCall: rdx.
void RegionCode::Call(const Op& op) {
  const icode::CallSite& site = region_.calls[op.place];
  const icode::Exit& exit = region_.exits[op.number];
  writeState(exit, spotsOfStates(exit), spotsOfBytes(exit));
  charge(exit);
  code_.mov(host::esi, site.resume);
  code_.mov(host::edi, site.offset);
  if (site.parameters == 0) {
    code_.call(asmjit::imm(unit_.ways.enterWithout));
    return;
  }
  code_.mov(host::r8,
            reinterpret_cast<std::uintptr_t>(unit_.answers.parameters + site.firstParameter));
  code_.mov(host::r9d, site.parameters);
  code_.call(asmjit::imm(unit_.ways.enterBlock));
}

// A compiled block has called, and master control relay and brackets are as the block found them.
void RegionCode::CanReturn(const Op& op) {
  const asmjit::Label out = wayOut(op);
  const Layout::Frame& at = frames().frame;
  code_.mov(host::rcx, inState(frames().top));
  code_.cmp(host::byte_ptr(host::rcx, at.first), 0);
  code_.jne(out);
  code_.cmp(host::byte_ptr(host::rcx, at.relayActive), 0);
  code_.jne(out);
  relayDepth(code_, frames());
  code_.cmp(host::ax, host::word_ptr(host::rcx, at.relayDepth));
  code_.jne(out);
  bracketDepth(code_, frames());
  code_.cmp(host::ax, host::word_ptr(host::rcx, at.bracketDepth));
  code_.jne(out);
  code_.mov(host::rax, host::qword_ptr(host::rcx, at.code - at.bytes));
  code_.cmp(host::qword_ptr(host::rax, frames().code.native), 0);
  code_.je(out);
}

void RegionCode::Return(const Op& op) {
  const icode::Exit& exit = region_.exits[op.number];
  writeState(exit, spotsOfStates(exit), spotsOfBytes(exit));
  charge(exit);
  code_.jmp(asmjit::imm(unit_.ways.leaveBlock));
}

}  // namespace merker::jit
