// AUF, TDB and the parameters of the running block.
#include "jit/region_code.h"

namespace merker::jit {

using icode::Op;

namespace {

constexpr int at(std::size_t field) { return static_cast<int>(field); }
constexpr int kBlockShift = 5;
static_assert(sizeof(cpu::DataBlock) == 1u << kBlockShift);

}  // namespace

// rax: where the data block of this number stands, or would stand; rcx: behind the last one.
void RegionCode::loadBlock(const Op& op) {
  code_.mov(host::rcx, host::qword_ptr(kMachine, offset::kDataBlocks + offset::kEnd));
  if (places_.isConstant(op.a)) {
    code_.mov(host::rax, host::qword_ptr(kMachine, offset::kDataBlocks));
    code_.add(host::rax, static_cast<int>(places_.constant(op.a) << kBlockShift));
    return;
  }
  const host::Gp number = places_.in(op.a, host::eax);
  if (number.id() != host::eax.id()) code_.mov(host::eax, number);
  code_.shl(host::rax, kBlockShift);
  code_.add(host::rax, host::qword_ptr(kMachine, offset::kDataBlocks));
}

// Number 0, numbers beyond the model's and missing blocks are the interpreter's business.
void RegionCode::CanOpen(const Op& op) {
  const asmjit::Label out = wayOut(op);
  if (places_.isConstant(op.a)) {
    const std::uint32_t number = places_.constant(op.a);
    if (number == 0 || static_cast<std::int64_t>(number) > unit_.model->highestDb) code_.jmp(out);
  } else {
    const host::Gp number = places_.in(op.a, host::eax);
    code_.lea(host::edx, host::ptr(number.r64(), -1));
    code_.cmp(host::edx, static_cast<std::int32_t>(unit_.model->highestDb));
    code_.jae(out);
  }
  loadBlock(op);
  code_.cmp(host::rax, host::rcx);
  code_.jae(out);
  code_.cmp(host::byte_ptr(host::rax, at(offsetof(cpu::DataBlock, loaded))), 0);
  code_.je(out);
}

// Eight bytes at a time, as calls read them again.
void RegionCode::Open(const Op& op) {
  const int block = op.space == icode::Space::Instance ? offset::kDi : offset::kDb;
  const int data = at(offsetof(cpu::DataBlock, data));
  loadBlock(op);
  code_.mov(host::rcx, host::qword_ptr(host::rax, data));
  code_.mov(host::qword_ptr(kMachine, block + at(offsetof(cpu::OpenBlock, data))), host::rcx);
  code_.mov(host::rdx, host::qword_ptr(host::rax, data + offset::kEnd));
  code_.sub(host::edx, host::ecx);  // length
  code_.movzx(host::ecx, host::byte_ptr(host::rax, at(offsetof(cpu::DataBlock, readOnly))));
  code_.sub(host::ecx, 1);  // all bits, or 0 if read only
  code_.and_(host::ecx, host::edx);
  code_.shl(host::rcx, 32);
  code_.or_(host::rcx, host::rdx);
  code_.mov(host::qword_ptr(kMachine, block + at(offsetof(cpu::OpenBlock, length))), host::rcx);
  if (places_.isConstant(op.a))
    code_.mov(host::ecx, places_.constant(op.a));
  else
    code_.mov(host::ecx, places_.in(op.a, host::ecx));
  code_.mov(host::qword_ptr(kMachine, block + at(offsetof(cpu::OpenBlock, number))), host::rcx);
}

void RegionCode::SwapBlocks(const Op&) {
  for (int word = 0; word < at(sizeof(cpu::OpenBlock)); word += 8) {
    code_.mov(host::rax, host::qword_ptr(kMachine, offset::kDb + word));
    code_.mov(host::rcx, host::qword_ptr(kMachine, offset::kDi + word));
    code_.mov(host::qword_ptr(kMachine, offset::kDb + word), host::rcx);
    code_.mov(host::qword_ptr(kMachine, offset::kDi + word), host::rax);
  }
}

void RegionCode::Parameter(const Op& op) {
  const host::Gp to = places_.out();
  code_.mov(host::rax, host::qword_ptr(kMachine, offset::kTop));
  code_.mov(host::rax, host::qword_ptr(host::rax, at(offsetof(cpu::Frame, parameters))));
  code_.mov(to, host::dword_ptr(host::rax, static_cast<int>(4 * op.number)));
}

}  // namespace merker::jit
