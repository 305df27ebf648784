// Operands whose area is only known when the instruction runs: parameters of an FC and
// area-crossing address registers (S7-IND-06, S7-PAR-01).
#include <algorithm>

#include "jit/region_code.h"

namespace merker::jit {

using icode::Op;

namespace {

// The most frequent first.
constexpr Area kAreas[] = {Area::Flag,     Area::CallerLocal, Area::DataBlock, Area::Local,
                           Area::Instance, Area::Input,       Area::Output};

bool isImage(Area area) {
  return area == Area::Input || area == Area::Output || area == Area::Flag;
}
// Number of the image.
std::size_t imageOf(Area area) { return area == Area::Input ? 0 : area == Area::Output ? 1 : 2; }

}  // namespace

void RegionCode::Locate(const Op& op) {
  const icode::Access access = icode::Access::of(op.place);
  const host::Gp to = places_.out().r64();
  const asmjit::Label out = wayOut(op);
  if (!places_.isConstant(op.a)) {
    locateByte(op, out);
    const host::Gp pointer = places_.in(op.a, host::eax);
    if (pointer.id() != host::eax.id()) code_.mov(host::eax, pointer);
    code_.shr(host::eax, 24);
    locateAnywhere(access.write, to, out);
    return;
  }
  const auto area = static_cast<Area>(places_.constant(op.a) >> 24);
  if (std::find(std::begin(kAreas), std::end(kAreas), area) == std::end(kAreas)) {
    code_.jmp(out);
    return;
  }
  if (isInImage(op, area)) {
    code_.lea(to, host::ptr(kImages[imageOf(area)],
                            static_cast<int>(places_.constant(op.b) >> 3) - kBias));
    return;
  }
  locateByte(op, out);
  locateIn(area, access.write, to, out);
}

// Known now, without a look when it runs.
bool RegionCode::isInImage(const Op& op, Area area) const {
  if (!places_.isConstant(op.b) || !isImage(area)) return false;
  const icode::Access access = icode::Access::of(op.place);
  const std::uint32_t bit = places_.constant(op.b);
  return !(access.whole && (bit & 7) != 0) &&
         std::uint64_t{bit >> 3} + access.bytes <= unit_.layout.imageLengths[imageOf(area)];
}

// edx: byte, ecx: end of the access
void RegionCode::locateByte(const Op& op, const asmjit::Label& out) {
  const icode::Access access = icode::Access::of(op.place);
  const host::Gp address = places_.in(op.b, host::edx);
  if (address.id() != host::edx.id()) code_.mov(host::edx, address);
  if (access.whole) {
    code_.test(host::dl, 7);
    code_.jne(out);
  }
  code_.shr(host::edx, 3);
  code_.lea(host::ecx, host::ptr(host::rdx, static_cast<int>(access.bytes)));
}

// eax: area
void RegionCode::locateAnywhere(bool write, const host::Gp& to, const asmjit::Label& out) {
  const asmjit::Label done = code_.newLabel();
  for (const Area area : kAreas) {
    const asmjit::Label next = code_.newLabel();
    code_.cmp(host::eax, static_cast<int>(area));
    code_.jne(next);
    locateIn(area, write, to, out);
    code_.jmp(done);
    code_.bind(next);
  }
  code_.jmp(out);
  code_.bind(done);
}

void RegionCode::locateIn(Area area, bool write, const host::Gp& to, const asmjit::Label& out) {
  if (isImage(area)) {
    code_.cmp(host::ecx, unit_.layout.imageLengths[imageOf(area)]);
    code_.ja(out);
    code_.lea(to, host::ptr(kImages[imageOf(area)], host::rdx, 0, -kBias));
  } else if (area == Area::Local || area == Area::CallerLocal) {
    locateLocal(area == Area::CallerLocal, to, out);
  } else {
    const Layout::Open& open = area == Area::Instance ? unit_.layout.instance : unit_.layout.data;
    code_.cmp(host::ecx, host::dword_ptr(kState, write ? open.writable : open.length));
    code_.ja(out);
    code_.mov(to, inState(open.data));
    code_.add(to, host::rdx);
  }
}

void RegionCode::locateLocal(bool ofCaller, const host::Gp& to, const asmjit::Label& out) {
  const Layout::Frame& frame = frames().frame;
  const int back = ofCaller ? -frame.bytes : 0;
  code_.mov(host::rax, inState(frames().top));
  if (ofCaller) {
    code_.cmp(host::byte_ptr(host::rax, frame.first), 0);
    code_.jne(out);
  }
  const asmjit::Label called = code_.newLabel();
  code_.cmp(host::byte_ptr(host::rax, back + frame.first), 0);
  code_.je(called);
  constexpr int kWidest = 4;  // bytes of an access
  code_.cmp(host::edx, frames().watchedEnd);
  code_.jae(called);
  code_.cmp(host::edx, frames().watchedBegin - (kWidest - 1));
  code_.jae(out);
  code_.bind(called);
  code_.cmp(host::ecx, host::dword_ptr(host::rax, back + frame.localLength));
  code_.ja(out);
  code_.mov(to, host::qword_ptr(host::rax, back + frame.local));
  code_.add(to, host::rdx);
}

}  // namespace merker::jit
