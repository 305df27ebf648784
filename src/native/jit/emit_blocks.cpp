// AUF, TDB and the parameters of the running block.
#include "jit/region_code.h"

namespace merker::jit {

using icode::Op;

// A register's content is read as it was written: 16 bytes and 8. So the host has it at once.
void copyBlock(host::Assembler& code, const host::Gp& to, int toAt, const host::Gp& from,
               int fromAt) {
  code.movups(host::xmm0, host::xmmword_ptr(from, fromAt));
  code.mov(host::rcx, host::qword_ptr(from, fromAt + 16));
  code.movups(host::xmmword_ptr(to, toAt), host::xmm0);
  code.mov(host::qword_ptr(to, toAt + 16), host::rcx);
}

void copyBlocks(host::Assembler& code, const host::Gp& to, int toAt, const host::Gp& from,
                int fromAt) {
  for (const int block : {0, Layout::kOpenBytes})
    copyBlock(code, to, toAt + block, from, fromAt + block);
}

void swapBlocks(const Unit& unit) {
  host::Assembler& code = unit.code;
  const int data = unit.layout.data.begin, instance = unit.layout.instance.begin;
  code.movups(host::xmm1, host::xmmword_ptr(kState, data));
  code.mov(host::rax, inState(data + 16));
  copyBlock(code, kState, data, kState, instance);
  code.movups(host::xmmword_ptr(kState, instance), host::xmm1);
  code.mov(inState(instance + 16), host::rax);
}

// rax: where the data block of this number stands, or would stand. Number 0 and numbers beyond the
// highest are the interpreter's business.
void RegionCode::loadBlock(const Op& op, const asmjit::Label& out) {
  const Layout::DataBlocks& blocks = frames().dataBlocks;
  if (places_.isConstant(op.a)) {
    const std::uint32_t number = places_.constant(op.a);
    if (number == 0 || number > blocks.highest) code_.jmp(out);
    code_.mov(host::rax, inState(blocks.list.first));
    code_.add(host::rax, static_cast<int>(number) * blocks.bytes);
    return;
  }
  const host::Gp number = places_.in(op.a, host::eax);
  code_.lea(host::edx, host::ptr(number.r64(), -1));
  code_.cmp(host::edx, blocks.highest);
  code_.jae(out);
  code_.imul(host::rax, number.r64(), blocks.bytes);
  code_.add(host::rax, inState(blocks.list.first));
}

// A missing block has length 0 and number 0.
void RegionCode::Open(const Op& op) {
  if (unit_.layout.blocks) return openLinked(op);
  const auto wanted = icode::Opening::of(op.place);
  const Layout::DataBlocks& blocks = frames().dataBlocks;
  const Layout::Open &to = openBlock(op.space), &found = blocks.open;
  const asmjit::Label out = wayOut(op);
  loadBlock(op, out);
  code_.cmp(host::rax, inState(blocks.list.end));
  code_.jae(out);
  if (wanted.bytes == 0) {
    code_.cmp(host::word_ptr(host::rax, found.number), 0);
    code_.je(out);
  } else {
    code_.cmp(host::dword_ptr(host::rax, wanted.write ? found.writable : found.length),
              wanted.bytes);
    code_.jb(out);
  }
  if (wanted.moves) copyBlock(code_, kState, otherThan(op.space).begin, kState, to.begin);
  copyBlock(code_, kState, to.begin, host::rax, found.begin);
}

void RegionCode::SwapBlocks(const Op&) { swapBlocks(unit_); }

void RegionCode::Parameter(const Op& op) {
  const host::Gp to = places_.out();
  code_.mov(host::rax, inState(frames().top));
  code_.mov(host::rax, host::qword_ptr(host::rax, frames().frame.parameters));
  code_.mov(to, host::dword_ptr(host::rax, static_cast<int>(4 * op.number)));
}

}  // namespace merker::jit
