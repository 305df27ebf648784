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
#undef FIELD
#pragma GCC diagnostic pop

host::Mem machine(int at) { return host::qword_ptr(kMachine, at); }

// DB and DI register, which lie one behind the other.
void copyBlocks(host::Assembler& code, const host::Gp& to, int toAt, const host::Gp& from,
                int fromAt) {
  for (int word = 0; word < 48; word += 8) {
    code.mov(host::rax, host::qword_ptr(from, fromAt + word));
    code.mov(host::qword_ptr(to, toAt + word), host::rax);
  }
}

// ax: entries of the vector
void depth(host::Assembler& code, int vector, unsigned shift) {
  code.mov(host::rax, machine(vector + offset::kEnd));
  code.sub(host::rax, machine(vector));
  if (shift != 0) code.shr(host::rax, shift);
}

// Bytes of local data as pairs.
void localLength(host::Assembler& code, const host::Gp& to, const host::Gp& block) {
  code.mov(to, host::dword_ptr(block, kLocalBytes));
  code.inc(to);
  code.and_(to, -2);
}

constexpr unsigned kBracketShift = 2;

}  // namespace

// rdx: code of the block, rcx: frame of the caller, rsi and edi: parameter list and its length.
void writeEnterBlock(host::Assembler& code) {
  const host::Gp frame = host::r8;
  code.lea(frame, host::ptr(host::rcx, kFrameSize));
  localLength(code, host::r9d, host::rdx);
  code.mov(host::r10d, host::dword_ptr(host::rcx, kLocalLength));
  code.add(host::r10, host::qword_ptr(host::rcx, kLocal));
  code.mov(host::r11d, host::dword_ptr(host::rcx, kLocalEnd));
  code.add(host::r11d, host::r9d);
  code.mov(host::qword_ptr(frame, kCode), host::rdx);
  code.mov(host::dword_ptr(frame, kResume), 0);
  code.mov(host::byte_ptr(frame, kFirst), 0);
  code.mov(host::qword_ptr(frame, kLocal), host::r10);
  code.mov(host::dword_ptr(frame, kLocalLength), host::r9d);
  code.mov(host::dword_ptr(frame, kLocalEnd), host::r11d);
  code.mov(host::qword_ptr(frame, kParameters), host::rsi);
  code.mov(host::dword_ptr(frame, kParameterCount), host::edi);
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
  code.mov(host::rcx, machine(offset::kTop));
  copyBlocks(code, kMachine, offset::kDb, host::rcx, kKeptDb);
  code.mov(host::eax, host::dword_ptr(host::rcx, kKeptAr2));
  code.mov(host::dword_ptr(kMachine, offset::kAr2), host::eax);
  code.mov(host::byte_ptr(kMachine, offset::kRelayActive), 0);
  code.mov(host::byte_ptr(kMachine, offset::kRelayOff), 0);
  code.mov(machine(offset::kFrames + offset::kEnd), host::rcx);
  code.sub(host::rcx, kFrameSize);
  code.mov(machine(offset::kTop), host::rcx);
  code.mov(host::rax, machine(offset::kLevels + offset::kEnd));
  code.dec(host::dword_ptr(host::rax, kLevelFrames - kLevelSize));
  code.mov(host::rdx, host::qword_ptr(host::rcx, kCode));
  code.mov(host::rdx, host::qword_ptr(host::rdx, kNative));
  code.mov(host::eax, host::dword_ptr(host::rcx, kResume));
  code.jmp(host::qword_ptr(host::rdx, host::rax, 3));
}

// The block has compiled code, and neither nesting depth nor local data nor the memory for frames
// comes to its end.
void RegionCode::CanCall(const Op& op) {
  const asmjit::Label out = wayOut(op);
  const int table =
      region_.calls[op.place].functionBlock ? offset::kFunctionBlocks : offset::kFunctions;
  const host::Gp number = places_.in64(op.a, host::rdx);
  code_.mov(host::rax, machine(table));
  code_.mov(host::rcx, machine(table + offset::kEnd));
  code_.sub(host::rcx, host::rax);
  code_.shr(host::rcx, 3);
  code_.cmp(number, host::rcx);
  code_.jae(out);
  code_.mov(host::rax, host::qword_ptr(host::rax, number, 3));
  code_.test(host::rax, host::rax);
  code_.je(out);
  code_.cmp(host::qword_ptr(host::rax, kNative), 0);
  code_.je(out);
  localLength(code_, host::edx, host::rax);
  code_.mov(host::rcx, machine(offset::kTop));
  code_.add(host::edx, host::dword_ptr(host::rcx, kLocalEnd));
  code_.cmp(host::edx, unit_.model->localBytes);
  code_.ja(out);
  code_.mov(host::rcx, machine(offset::kLevels + offset::kEnd));
  code_.cmp(host::dword_ptr(host::rcx, kLevelFrames - kLevelSize), unit_.model->nesting);
  code_.ja(out);
  code_.cmp(host::byte_ptr(host::rcx, kErrorOb - kLevelSize), 0);  // other depth
  code_.jne(out);
  code_.mov(host::rcx, machine(offset::kFrames + offset::kEnd));
  code_.cmp(host::rcx, machine(offset::kFrames + offset::kCapacity));
  code_.je(out);
}

void RegionCode::Call(const Op& op) {
  const icode::CallSite& site = region_.calls[op.place];
  const icode::Exit& exit = region_.exits[op.number];
  const host::Gp number = places_.in64(op.a, host::rdx);
  code_.mov(host::rcx, machine(site.functionBlock ? offset::kFunctionBlocks : offset::kFunctions));
  code_.mov(host::rdx, host::qword_ptr(host::rcx, number, 3));
  writeState(exit, spotsOfStates(exit), spotsOfBytes(exit));
  charge(exit);
  code_.mov(host::dword_ptr(kMachine, offset::kPosition), site.offset);
  code_.mov(host::rcx, machine(offset::kTop));
  code_.mov(host::dword_ptr(host::rcx, kResume), site.resume);
  code_.mov(host::rsi,
            reinterpret_cast<std::uintptr_t>(unit_.answers.parameters + site.firstParameter));
  code_.mov(host::edi, site.parameters);
  code_.jmp(unit_.enterBlock);
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
