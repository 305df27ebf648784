// From block to block: what cpu::Machine::enter and leave do, for blocks with compiled code.
#include "jit/region_code.h"

namespace merker::jit {

using icode::Op;

namespace {

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Winvalid-offsetof"
#define FIELD(type, name) static_cast<int>(offsetof(cpu::type, name))
constexpr int kFrameSize = sizeof(cpu::Frame), kLevelSize = sizeof(cpu::Level);
constexpr int kCode = FIELD(Frame, code), kResume = FIELD(Frame, resume),
              kFirst = FIELD(Frame, first), kLocal = FIELD(Frame, local),
              kLocalLength = FIELD(Frame, localLength), kLocalEnd = FIELD(Frame, localEnd),
              kParameters = FIELD(Frame, parameters),
              kParameterCount = FIELD(Frame, parameterCount), kKeptDb = FIELD(Frame, db),
              kKeptAr2 = FIELD(Frame, ar2), kKeptRelay = FIELD(Frame, mcrActive),
              kRelayDepth = FIELD(Frame, mcrDepth), kBracketDepth = FIELD(Frame, bracketDepth),
              kNative = FIELD(Code, native), kLocalBytes = FIELD(Code, localBytes),
              kLevelFrames = FIELD(Level, frames), kErrorOb = FIELD(Level, errorOb);
static_assert(FIELD(Frame, di) == kKeptDb + 24 && offset::kDi == offset::kDb + 24);
static_assert(kFirst == kResume + 4 && kLocal == kResume + 8);
#undef FIELD
#pragma GCC diagnostic pop

host::Mem machine(int at) { return host::qword_ptr(kMachine, at); }

// DB and DI register, which lie one behind the other.
void copyBlocks(host::Assembler& code, const host::Gp& to, int toAt, const host::Gp& from,
                int fromAt) {
  for (const int block : {0, 24}) copyBlock(code, to, toAt + block, from, fromAt + block);
}

// ax: entries of the vector
void depth(host::Assembler& code, int vector, unsigned shift) {
  code.mov(host::rax, machine(vector + offset::kEnd));
  code.sub(host::rax, machine(vector));
  if (shift != 0) code.shr(host::eax, shift);
}

constexpr unsigned kBracketShift = 2;

// edx: number of a block; then its code in rdx, or the carry flag if the interpreter must do it:
// the block has no compiled code, or nesting depth, local data or the memory for frames end.
void writeCanCall(host::Assembler& code, const CpuModel& model, int table) {
  const asmjit::Label no = code.newLabel();
  code.mov(host::rax, machine(table));
  code.mov(host::rcx, machine(table + offset::kEnd));
  code.lea(host::rdx, host::ptr(host::rax, host::rdx, 3));
  code.cmp(host::rdx, host::rcx);
  code.jae(no);
  code.mov(host::rdx, host::qword_ptr(host::rdx));
  code.test(host::rdx, host::rdx);
  code.je(no);
  code.cmp(host::qword_ptr(host::rdx, kNative), 0);
  code.je(no);
  code.mov(host::rcx, machine(offset::kTop));
  code.cmp(host::rcx, machine(offset::kCallLimit));
  code.jae(no);
  code.mov(host::eax, host::dword_ptr(host::rdx, kLocalBytes));
  code.add(host::eax, host::dword_ptr(host::rcx, kLocalEnd));
  code.cmp(host::eax, model.localBytes);
  code.ja(no);
  code.clc();
  code.ret();
  code.bind(no);
  code.stc();
  code.ret();
}

// rdx: code of the block, esi: instruction behind the call, edi: offset of the call, r8 and r9d:
// parameter list and its length. Reached by a call of the host, whose return address goes at once:
// the host only remembers it as the place where the ret of leaveBlock will lead.
void writeEnterBlock(host::Assembler& code) {
  const host::Gp caller = host::rcx, frame = host::r10;
  code.add(host::rsp, 8);
  code.mov(caller, machine(offset::kTop));
  code.mov(host::dword_ptr(kMachine, offset::kPosition), host::edi);
  code.mov(host::dword_ptr(caller, kResume), host::esi);
  code.lea(frame, host::ptr(caller, kFrameSize));
  code.mov(host::esi, host::dword_ptr(host::rdx, kLocalBytes));
  code.mov(host::eax, host::dword_ptr(caller, kLocalLength));
  code.add(host::rax, host::qword_ptr(caller, kLocal));
  code.mov(host::edi, host::dword_ptr(caller, kLocalEnd));
  code.add(host::edi, host::esi);
  code.mov(host::qword_ptr(frame, kCode), host::rdx);
  code.mov(host::qword_ptr(frame, kResume), 0);  // and kFirst
  code.mov(host::qword_ptr(frame, kLocal), host::rax);
  code.mov(host::dword_ptr(frame, kLocalLength), host::esi);
  code.mov(host::dword_ptr(frame, kLocalEnd), host::edi);
  code.mov(host::qword_ptr(frame, kParameters), host::r8);
  code.mov(host::dword_ptr(frame, kParameterCount), host::r9d);
  copyBlocks(code, frame, kKeptDb, kMachine, offset::kDb);
  code.mov(host::eax, host::dword_ptr(kMachine, offset::kAr2));
  code.mov(host::dword_ptr(frame, kKeptAr2), host::eax);
  code.movzx(host::eax, host::byte_ptr(kMachine, offset::kRelayActive));
  code.mov(host::byte_ptr(frame, kKeptRelay), host::al);
  depth(code, offset::kRelays, 0);
  code.mov(host::word_ptr(frame, kRelayDepth), host::ax);
  depth(code, offset::kBrackets, kBracketShift);
  code.mov(host::word_ptr(frame, kBracketDepth), host::ax);
  code.mov(machine(offset::kTop), frame);
  code.add(frame, kFrameSize);
  code.mov(machine(offset::kFrames + offset::kEnd), frame);
  code.mov(host::rax, machine(offset::kLevels + offset::kEnd));
  code.inc(host::dword_ptr(host::rax, kLevelFrames - kLevelSize));
  code.mov(host::byte_ptr(kMachine, offset::kRelayActive), 0);  // a block begins without MCR
  code.mov(host::byte_ptr(kMachine, offset::kRelayOff), 0);
  code.mov(host::rdx, host::qword_ptr(host::rdx, kNative));
  code.xor_(host::eax, host::eax);
  code.jmp(host::qword_ptr(host::rdx));
}

void writeLeaveBlock(host::Assembler& code) {
  const host::Gp frame = host::r10;
  code.mov(frame, machine(offset::kTop));
  copyBlocks(code, kMachine, offset::kDb, frame, kKeptDb);
  code.mov(host::eax, host::dword_ptr(frame, kKeptAr2));
  code.mov(host::dword_ptr(kMachine, offset::kAr2), host::eax);
  code.mov(host::byte_ptr(kMachine, offset::kRelayActive), 0);
  code.mov(host::byte_ptr(kMachine, offset::kRelayOff), 0);
  code.mov(machine(offset::kFrames + offset::kEnd), frame);
  code.sub(frame, kFrameSize);
  code.mov(machine(offset::kTop), frame);
  code.mov(host::rax, machine(offset::kLevels + offset::kEnd));
  code.dec(host::dword_ptr(host::rax, kLevelFrames - kLevelSize));
  code.mov(host::rdx, host::qword_ptr(frame, kCode));
  code.mov(host::rdx, host::qword_ptr(host::rdx, kNative));
  code.mov(host::eax, host::dword_ptr(frame, kResume));
  code.push(host::qword_ptr(host::rdx, host::rax, 3));
  code.ret();
}

}  // namespace

void writeBlockChanges(const Unit& unit) {
  host::Assembler& code = unit.code;
  code.bind(unit.enterWithout);
  code.xor_(host::r8d, host::r8d);
  code.xor_(host::r9d, host::r9d);
  code.bind(unit.enterBlock);
  writeEnterBlock(code);
  code.bind(unit.leaveBlock);
  writeLeaveBlock(code);
  code.bind(unit.canCallFunction);
  writeCanCall(code, *unit.model, offset::kFunctions);
  code.bind(unit.canCallFunctionBlock);
  writeCanCall(code, *unit.model, offset::kFunctionBlocks);
}

void RegionCode::CanCall(const Op& op) {
  if (places_.isConstant(op.a))
    code_.mov(host::edx, places_.constant(op.a));
  else
    code_.mov(host::edx, places_.in(op.a, host::edx));
  code_.call(region_.calls[op.place].functionBlock ? unit_.canCallFunctionBlock
                                                   : unit_.canCallFunction);
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
    code_.call(unit_.enterWithout);
    return;
  }
  code_.mov(host::r8,
            reinterpret_cast<std::uintptr_t>(unit_.answers.parameters + site.firstParameter));
  code_.mov(host::r9d, site.parameters);
  code_.call(unit_.enterBlock);
}

// Not the end of an OB, the caller has compiled code, and master control relay and brackets are as
// the block found them.
void RegionCode::CanReturn(const Op& op) {
  const asmjit::Label out = wayOut(op);
  code_.mov(host::rcx, machine(offset::kTop));
  code_.cmp(host::byte_ptr(host::rcx, kFirst), 0);
  code_.jne(out);
  code_.cmp(host::byte_ptr(host::rcx, kKeptRelay), 0);
  code_.jne(out);
  depth(code_, offset::kRelays, 0);
  code_.cmp(host::ax, host::word_ptr(host::rcx, kRelayDepth));
  code_.jne(out);
  depth(code_, offset::kBrackets, kBracketShift);
  code_.cmp(host::ax, host::word_ptr(host::rcx, kBracketDepth));
  code_.jne(out);
  code_.mov(host::rax, host::qword_ptr(host::rcx, kCode - kFrameSize));
  code_.cmp(host::qword_ptr(host::rax, kNative), 0);
  code_.je(out);
}

void RegionCode::Return(const Op& op) {
  const icode::Exit& exit = region_.exits[op.number];
  writeState(exit, spotsOfStates(exit), spotsOfBytes(exit));
  charge(exit);
  code_.jmp(unit_.leaveBlock);
}

}  // namespace merker::jit
