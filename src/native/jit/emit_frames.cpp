// From block to block in frames of the owner (Layout::Frames): what its engine does to enter and to
// leave a block, for blocks with compiled code. Written once for all blocks.
#include <bit>

#include "jit/ways.h"

namespace merker::jit {

using Frames = Layout::Frames;

namespace {

// ax: entries of the list
void depth(host::Assembler& code, const Layout::List& list, unsigned entryBytes) {
  code.mov(host::rax, inState(list.end));
  code.sub(host::rax, inState(list.first));
  if (entryBytes != 1) code.shr(host::eax, std::countr_zero(entryBytes));
}
// edx: number of a block; then its code in rdx, or the carry flag if the interpreter must do it:
// the block has no compiled code, or nesting depth, local data or the memory for frames end.
void writeCanCall(host::Assembler& code, const Frames& frames, const Layout::List& blocks) {
  const asmjit::Label no = code.newLabel();
  code.mov(host::rax, inState(blocks.first));
  code.mov(host::rcx, inState(blocks.end));
  code.lea(host::rdx, host::ptr(host::rax, host::rdx, 3));
  code.cmp(host::rdx, host::rcx);
  code.jae(no);
  code.mov(host::rdx, host::qword_ptr(host::rdx));
  code.test(host::rdx, host::rdx);
  code.je(no);
  code.cmp(host::qword_ptr(host::rdx, frames.code.native), 0);
  code.je(no);
  code.mov(host::rcx, inState(frames.top));
  code.cmp(host::rcx, inState(frames.callLimit));
  code.jae(no);
  code.mov(host::eax, host::dword_ptr(host::rdx, frames.code.localBytes));
  code.add(host::eax, host::dword_ptr(host::rcx, frames.frame.localEnd));
  code.cmp(host::eax, frames.localBytes);
  code.ja(no);
  code.clc();
  code.ret();
  code.bind(no);
  code.stc();
  code.ret();
}

// The new frame at `frame`, but for what the caller gets back. rdx: code of the block.
void writeNewFrame(host::Assembler& code, const Frames& frames, const host::Gp& caller,
                   const host::Gp& frame) {
  const Layout::Frame& at = frames.frame;
  code.mov(host::esi, host::dword_ptr(host::rdx, frames.code.localBytes));
  code.mov(host::eax, host::dword_ptr(caller, at.localLength));
  code.add(host::rax, host::qword_ptr(caller, at.local));
  code.mov(host::edi, host::dword_ptr(caller, at.localEnd));
  code.add(host::edi, host::esi);
  code.mov(host::qword_ptr(frame, at.code), host::rdx);
  code.mov(host::qword_ptr(frame, at.resume), 0);  // and `first`
  code.mov(host::qword_ptr(frame, at.local), host::rax);
  code.mov(host::dword_ptr(frame, at.localLength), host::esi);
  code.mov(host::dword_ptr(frame, at.localEnd), host::edi);
  code.mov(host::qword_ptr(frame, at.parameters), host::r8);
  code.mov(host::dword_ptr(frame, at.parameterCount), host::r9d);
}

// What the caller gets back.
void writeKept(host::Assembler& code, const Layout& layout, const host::Gp& frame) {
  const Layout::Frame& at = layout.frames->frame;
  copyBlocks(code, frame, at.data, kState, layout.data.begin);
  code.mov(host::eax, host::dword_ptr(kState, layout.offsetOf(icode::Item::Ar2)));
  code.mov(host::dword_ptr(frame, at.ar2), host::eax);
}

// What it finds unchanged.
void writeDepths(host::Assembler& code, const Layout& layout, const host::Gp& frame) {
  const Frames& frames = *layout.frames;
  const Layout::Frame& at = frames.frame;
  code.movzx(host::eax, host::byte_ptr(kState, frames.relayActive));
  code.mov(host::byte_ptr(frame, at.relayActive), host::al);
  relayDepth(code, frames);
  code.mov(host::word_ptr(frame, at.relayDepth), host::ax);
  bracketDepth(code, frames);
  code.mov(host::word_ptr(frame, at.bracketDepth), host::ax);
}

void writeRelayOn(host::Assembler& code, const Frames& frames) {
  code.mov(host::byte_ptr(kState, frames.relayActive), 0);
  code.mov(host::byte_ptr(kState, frames.relayOff), 0);
}

// rdx: code of the block, esi: instruction behind the call, edi: offset of the call, r8 and r9d:
// parameter list and its length. `kept`: what the caller gets back is there already.
void writePush(host::Assembler& code, const Layout& layout, bool kept) {
  const host::Gp caller = host::rcx, frame = host::r10;
  const Frames& frames = *layout.frames;
  code.mov(caller, inState(frames.top));
  code.mov(host::dword_ptr(kState, frames.position), host::edi);
  code.mov(host::dword_ptr(caller, frames.frame.resume), host::esi);
  code.lea(frame, host::ptr(caller, frames.frame.bytes));
  writeNewFrame(code, frames, caller, frame);
  if (!kept) writeKept(code, layout, frame);
  writeDepths(code, layout, frame);
  code.mov(inState(frames.top), frame);
  code.add(frame, frames.frame.bytes);
  code.mov(inState(frames.end), frame);
  code.mov(host::rax, inState(frames.level));
  code.inc(host::dword_ptr(host::rax, frames.levelBlocks));
  writeRelayOn(code, frames);  // a block begins without the master control relay
}

// Reached by a call of the host, whose return address goes at once: the host only remembers it as
// the place where the ret of leaveBlock will lead.
void writeEnterBlock(host::Assembler& code, const Layout& layout) {
  code.add(host::rsp, 8);
  writePush(code, layout, false);
  code.mov(host::rdx, host::qword_ptr(host::rdx, layout.frames->code.native));
  code.xor_(host::eax, host::eax);
  code.jmp(host::qword_ptr(host::rdx));
}

void writeLeaveBlock(host::Assembler& code, const Layout& layout) {
  const host::Gp frame = host::r10;
  const Frames& frames = *layout.frames;
  const Layout::Frame& at = frames.frame;
  code.mov(frame, inState(frames.top));
  copyBlocks(code, kState, layout.data.begin, frame, at.data);
  code.mov(host::eax, host::dword_ptr(frame, at.ar2));
  code.mov(host::dword_ptr(kState, layout.offsetOf(icode::Item::Ar2)), host::eax);
  writeRelayOn(code, frames);
  code.mov(inState(frames.end), frame);
  code.sub(frame, at.bytes);
  code.mov(inState(frames.top), frame);
  code.mov(host::rax, inState(frames.level));
  code.dec(host::dword_ptr(host::rax, frames.levelBlocks));
  code.mov(host::rdx, host::qword_ptr(frame, at.code));
  code.mov(host::rdx, host::qword_ptr(host::rdx, frames.code.native));
  code.mov(host::eax, host::dword_ptr(frame, at.resume));
  code.push(host::qword_ptr(host::rdx, host::rax, 3));
  code.ret();
}

}  // namespace

void relayDepth(host::Assembler& code, const Frames& frames) { depth(code, frames.relays, 1); }
void bracketDepth(host::Assembler& code, const Frames& frames) {
  depth(code, frames.brackets, frames.bracketBytes);
}

BlockWays writeBlockWays(host::Assembler& code, const Layout& layout) {
  const Frames& frames = *layout.frames;
  const auto here = [&] {
    const asmjit::Label label = code.newLabel();
    code.bind(label);
    return label;
  };
  BlockWays ways;
  ways.enterWithout = here();
  code.xor_(host::r8d, host::r8d);
  code.xor_(host::r9d, host::r9d);
  ways.enterBlock = here();
  writeEnterBlock(code, layout);
  ways.leaveBlock = here();
  writeLeaveBlock(code, layout);
  ways.pushFrame = here();
  writePush(code, layout, false);
  code.ret();
  ways.pushKept = here();
  writePush(code, layout, true);
  code.ret();
  ways.canCallFunction = here();
  writeCanCall(code, frames, frames.functions);
  ways.canCallFunctionBlock = here();
  writeCanCall(code, frames, frames.functionBlocks);
  return ways;
}

}  // namespace merker::jit
