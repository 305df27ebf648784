#include "jit/region_code.h"

namespace merker::jit {

using host::CondCode;
using icode::Op;
using icode::Opcode;

RegionCode::RegionCode(Unit& unit, const icode::Region& region)
    : unit_(unit),
      code_(unit.code),
      region_(region),
      places_(unit.code, region, unit.options.slots),
      isolated_(region.ops.size()),
      position_(region.ops.size()),
      tooNear_(unit.code.newLabel()) {}

RegionCode::Emit RegionCode::emitter(Opcode code) {
  static constexpr Emit kEmitters[] = {
#define ICODE(id, text, result, arguments, effect) &RegionCode::id,
#include "icode/icode.inc"
#undef ICODE
  };
  return kEmitters[static_cast<std::size_t>(code)];
}

bool RegionCode::write(std::uint32_t next) {
  next_ = next;
  entry();
  for (current_ = 0; current_ < region_.ops.size(); ++current_) {
    const Op& op = region_.ops[current_];
    noteIsolated(current_);
    if (!op.needed || op.late || op.code == Opcode::Constant || op.code == Opcode::BitOf) continue;
    places_.begin(current_);
    const bool broken = unit_.options.broken == op.code;
    if (!broken || icode::info(op.code).result != icode::Result::Nothing)
      (this->*emitter(op.code))(op);
    places_.releaseDying();
    if (broken) spoil(places_.spot(current_), 1u << position_[current_]);
  }
  return !places_.failed();
}

// The lowest bit is wrong, or the one that counts.
void RegionCode::spoil(const Spot& spot, std::uint32_t bit) {
  if (spot.kind == Spot::Kind::Register) code_.xor_(kPlaces[spot.number], bit);
  if (spot.kind == Spot::Kind::Slot) code_.xor_(slot(spot.number), bit);
}

// Bits alone in their register need no mask when they are written.
void RegionCode::noteIsolated(icode::Value value) {
  const Op& op = region_.ops[value];
  switch (op.code) {
    case Opcode::Constant:
      isolated_[value] = op.number <= 1;
      break;
    case Opcode::Get:
      isolated_[value] = icode::isBit(op.item);
      break;
    case Opcode::AndBit:
      isolated_[value] = isolated_[op.a] || isolated_[op.b];
      break;
    case Opcode::OrBit:
    case Opcode::XorBit:
      isolated_[value] = isolated_[op.a] && isolated_[op.b];
      break;
    case Opcode::NotBit:
      isolated_[value] = isolated_[op.a];
      break;
    default:
      isolated_[value] = icode::info(op.code).result == icode::Result::Bit &&
                         op.code != Opcode::BitOf && op.code != Opcode::BitAt;
  }
}

void RegionCode::need(const host::Mem& limit, std::uint32_t bytes) {
  if (bytes == 0) return;
  code_.cmp(limit, bytes);
  code_.jb(tooNear_);
}

// Only if the clock stays below the horizon until the last instruction, and the region finds what
// it needs.
void RegionCode::entry() {
  code_.bind(unit_.regions[region_.first]);
  code_.lea(host::rax, host::ptr(kClock, static_cast<int>(region_.ahead)));
  code_.cmp(host::rax, inState(unit_.layout.horizon));
  code_.jge(tooNear_);
  const icode::Needs& needs = region_.needs;
  const auto field = [](int at) { return host::dword_ptr(kState, at); };
  need(field(unit_.layout.data.length), needs.dataRead);
  need(field(unit_.layout.data.writable), needs.dataWritten);
  need(field(unit_.layout.instance.length), needs.instanceRead);
  need(field(unit_.layout.instance.writable), needs.instanceWritten);
  if (needs.local != 0 || needs.parameters != 0) {
    code_.mov(host::rax, inState(frames().top));
    need(host::dword_ptr(host::rax, frames().frame.localLength), needs.local);
    need(host::dword_ptr(host::rax, frames().frame.parameterCount), needs.parameters);
  }
  if (needs.relayOn) {
    code_.cmp(host::byte_ptr(kState, frames().relayOff), 0);
    code_.jne(tooNear_);
  }
  if (needs.noBrackets) {
    code_.mov(host::rax, inState(frames().brackets.first));
    code_.cmp(host::rax, inState(frames().brackets.end));
    code_.jne(tooNear_);
  }
}

}  // namespace merker::jit
