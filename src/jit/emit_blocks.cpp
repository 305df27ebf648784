// AUF, TDB and the parameters of the running block.
#include "jit/region_code.h"

namespace merker::jit {

using icode::Op;

namespace {

constexpr int at(std::size_t field) { return static_cast<int>(field); }
constexpr int kBlockSize = sizeof(cpu::DataBlock);
constexpr int kOpen = at(offsetof(cpu::DataBlock, open));

host::Mem openField(std::size_t field, std::uint32_t bytes) {
  return {host::rax, kOpen + at(field), bytes};
}

}  // namespace

// A register's content is read as it was written: 16 bytes and 8. So the host has it at once.
void copyBlock(host::Assembler& code, const host::Gp& to, int toAt, const host::Gp& from,
               int fromAt) {
  code.movups(host::xmm0, host::xmmword_ptr(from, fromAt));
  code.mov(host::rcx, host::qword_ptr(from, fromAt + 16));
  code.movups(host::xmmword_ptr(to, toAt), host::xmm0);
  code.mov(host::qword_ptr(to, toAt + 16), host::rcx);
}

void swapBlocks(host::Assembler& code) {
  code.movups(host::xmm1, host::xmmword_ptr(kMachine, offset::kDb));
  code.mov(host::rax, host::qword_ptr(kMachine, offset::kDb + 16));
  copyBlock(code, kMachine, offset::kDb, kMachine, offset::kDi);
  code.movups(host::xmmword_ptr(kMachine, offset::kDi), host::xmm1);
  code.mov(host::qword_ptr(kMachine, offset::kDi + 16), host::rax);
}

// rax: where the data block of this number stands, or would stand. Number 0 and numbers beyond the
// model's are the interpreter's business.
void RegionCode::loadBlock(const Op& op, const asmjit::Label& out) {
  if (places_.isConstant(op.a)) {
    const std::uint32_t number = places_.constant(op.a);
    if (number == 0 || static_cast<std::int64_t>(number) > unit_.model->highestDb) code_.jmp(out);
    code_.mov(host::rax, host::qword_ptr(kMachine, offset::kDataBlocks));
    code_.add(host::rax, static_cast<int>(number) * kBlockSize);
    return;
  }
  const host::Gp number = places_.in(op.a, host::eax);
  code_.lea(host::edx, host::ptr(number.r64(), -1));
  code_.cmp(host::edx, static_cast<std::int32_t>(unit_.model->highestDb));
  code_.jae(out);
  code_.imul(host::rax, number.r64(), kBlockSize);
  code_.add(host::rax, host::qword_ptr(kMachine, offset::kDataBlocks));
}

// A missing block has length 0 and number 0.
void RegionCode::Open(const Op& op) {
  if (unit_.layout.blocks) return openLinked(op);
  const auto wanted = icode::Opening::of(op.place);
  const int block = op.space == icode::Space::Instance ? offset::kDi : offset::kDb;
  const asmjit::Label out = wayOut(op);
  loadBlock(op, out);
  code_.cmp(host::rax, host::qword_ptr(kMachine, offset::kDataBlocks + offset::kEnd));
  code_.jae(out);
  if (wanted.bytes == 0) {
    code_.cmp(openField(offsetof(cpu::OpenBlock, number), 2), 0);
    code_.je(out);
  } else {
    code_.cmp(openField(wanted.write ? offsetof(cpu::OpenBlock, writable)
                                     : offsetof(cpu::OpenBlock, length),
                        4),
              wanted.bytes);
    code_.jb(out);
  }
  if (wanted.moves)
    copyBlock(code_, kMachine, block == offset::kDb ? offset::kDi : offset::kDb, kMachine, block);
  copyBlock(code_, kMachine, block, host::rax, kOpen);
}

void RegionCode::SwapBlocks(const Op&) { swapBlocks(code_); }

void RegionCode::Parameter(const Op& op) {
  const host::Gp to = places_.out();
  code_.mov(host::rax, host::qword_ptr(kMachine, offset::kTop));
  code_.mov(host::rax, host::qword_ptr(host::rax, at(offsetof(cpu::Frame, parameters))));
  code_.mov(to, host::dword_ptr(host::rax, static_cast<int>(4 * op.number)));
}

}  // namespace merker::jit
