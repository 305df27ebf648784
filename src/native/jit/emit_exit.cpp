// Ways out of a region, and what they leave behind.
#include <algorithm>
#include <array>

#include "jit/region_code.h"

namespace merker::jit {

using host::CondCode;
using icode::Exit;
using icode::Op;

namespace {

CondCode conditionOf(icode::Opcode code) {
  switch (code) {
    case icode::Opcode::Equal:
      return CondCode::kE;
    case icode::Opcode::NotEqual:
      return CondCode::kNE;
    case icode::Opcode::Less:
      return CondCode::kL;
    case icode::Opcode::LessEqual:
      return CondCode::kLE;
    case icode::Opcode::Below:
      return CondCode::kB;
    case icode::Opcode::BelowEqual:
      return CondCode::kBE;
    default:
      return CondCode::kA;
  }
}

// Status bits that are known: neighbours are written in one go.
class StatusConstants {
 public:
  void note(int offset, std::uint32_t bit) { bits_[count_++] = {offset, bit}; }
  void write(host::Assembler& code) {
    std::sort(bits_.begin(), bits_.begin() + count_);
    for (unsigned at = 0, bytes = 0; at < count_; at += bytes) {
      bytes = atOnce(at);
      std::uint32_t together = 0;
      for (unsigned i = 0; i < bytes; ++i) together |= bits_[at + i].second << 8 * i;
      code.mov(host::Mem(kState, bits_[at].first, bytes), together);
    }
  }

 private:
  unsigned atOnce(unsigned at) const {
    for (const unsigned bytes : {4u, 2u}) {
      unsigned i = 1;
      while (i < bytes && at + i < count_ &&
             bits_[at + i].first == bits_[at].first + static_cast<int>(i))
        ++i;
      if (i == bytes) return bytes;
    }
    return 1;
  }
  std::array<std::pair<int, std::uint32_t>, icode::kItems> bits_{};  // where it lies, its value
  unsigned count_ = 0;
};

}  // namespace

std::vector<RegionCode::StateSpot> RegionCode::spotsOfStates(const Exit& exit) const {
  std::vector<StateSpot> spots(exit.states);
  for (std::uint32_t i = 0; i < exit.states; ++i) {
    const icode::Value value = region_.states[exit.firstState + i].value;
    const Op& op = region_.ops[value];
    spots[i].value = places_.spot(places_.root(value));
    if (op.late) spots[i] = {{}, places_.spot(op.a), {}};
    if (op.late && op.b != icode::kNoValue) spots[i].b = places_.spot(op.b);
  }
  return spots;
}

std::vector<Spot> RegionCode::spotsOfBytes(const Exit& exit) const {
  std::vector<Spot> spots(exit.bytes);
  for (std::uint32_t i = 0; i < exit.bytes; ++i)
    spots[i] = places_.spot(region_.bytes[exit.firstByte + i].value);
  return spots;
}

void RegionCode::wayOut(const Op& op, CondCode condition) {
  if (fused_) {
    const CondCode holds = *fused_;
    fused_.reset();
    const asmjit::Label zero = zero_;
    code_.j(condition == CondCode::kNZ ? holds : host::negateCond(holds), wayOut(op));
    if (zero.isValid()) code_.bind(zero);
    return;
  }
  const Bit b = bit(op.a);
  const host::Gp reg = places_.in(b.root, host::eax);
  if (b.position < 8)
    code_.test(reg.r8(), 1u << b.position);
  else
    code_.test(reg, static_cast<std::int32_t>(1u << b.position));
  code_.j(condition, wayOut(op));
}

asmjit::Label RegionCode::wayOut(const Op& op) {
  const asmjit::Label label = code_.newLabel();
  const Exit& exit = region_.exits[op.number];
  const asmjit::Label front = frontOf(exit);
  waysOut_.push_back({label, op.number, spotsOfStates(exit), spotsOfBytes(exit), zero_, front});
  zero_ = {};
  return label;
}

void RegionCode::Guard(const Op& op) { wayOut(op, CondCode::kZ); }
void RegionCode::BranchIf(const Op& op) { wayOut(op, CondCode::kNZ); }
void RegionCode::BranchUnless(const Op& op) { wayOut(op, CondCode::kZ); }

void RegionCode::Leave(const Op& op) {
  const Exit& exit = region_.exits[op.number];
  checkStack(exit, frontOf(exit));
  writeState(exit, spotsOfStates(exit), spotsOfBytes(exit));
  charge(exit);
  goOn(exit, next_);
}

void RegionCode::charge(const Exit& exit) {
  if (exit.cost != 0) code_.add(kClock, static_cast<std::int32_t>(exit.cost));
  if (exit.instructions != 0) code_.add(kCount, exit.instructions);
}

void RegionCode::goTo(std::uint32_t instruction, std::uint32_t next) {
  const bool compiled = instruction < unit_.regions.size() && unit_.regions[instruction].isValid();
  if (compiled && instruction == next) return;
  if (compiled) {
    code_.jmp(unit_.regions[instruction]);
    return;
  }
  code_.mov(host::eax, instruction);
  code_.jmp(unit_.epilogue);
}

host::Gp RegionCode::fetch(const Spot& spot, const host::Gp& scratch) {
  return places_.fetch(spot, scratch);
}

void RegionCode::writeLate(const icode::StateWrite& write, const StateSpot& spot) {
  const Op& op = region_.ops[write.value];
  if (op.code == icode::Opcode::Zext16) return writeWord(write, spot.a);
  CondCode condition = conditionOf(op.code);
  const bool real = op.code == icode::Opcode::LessReal;
  if (!real && spot.a.kind == Spot::Kind::Constant && spot.b.kind != Spot::Kind::Constant)
    return writeCompared(write, spot.b, spot.a, host::reverseCond(condition));
  if (!real) return writeCompared(write, spot.a, spot.b, condition);
  code_.movd(host::xmm0, fetch(spot.a, host::eax));  // as b > a: no number gives 0
  code_.movd(host::xmm1, fetch(spot.b, host::eax));
  code_.ucomiss(host::xmm1, host::xmm0);
  writeCondition(write, condition);
}

void RegionCode::writeWord(const icode::StateWrite& write, const Spot& spot) {
  code_.movzx(host::eax, fetch(spot, host::eax).r16());
  if (icode::isBit(write.item)) {
    code_.and_(host::eax, 1);
    code_.mov(host::byte_ptr(kState, offsetOf(write.item)), host::al);
  } else {
    code_.mov(host::dword_ptr(kState, offsetOf(write.item)), host::eax);
  }
}

void RegionCode::writeCompared(const icode::StateWrite& write, const Spot& a, const Spot& b,
                               CondCode condition) {
  const host::Gp left = fetch(a, host::eax);
  if (b.kind == Spot::Kind::Constant)
    code_.cmp(left, static_cast<std::int32_t>(b.number));
  else
    code_.cmp(left, fetch(b, host::ecx));
  writeCondition(write, condition);
}

void RegionCode::writeCondition(const icode::StateWrite& write, CondCode condition) {
  if (unit_.options.broken == region_.ops[write.value].code)
    condition = host::negateCond(condition);
  code_.set(condition, host::byte_ptr(kState, offsetOf(write.item)));
}

// Bytes come last: registers may still stand in one that is written here.
void RegionCode::writeState(const Exit& exit, const std::vector<StateSpot>& states,
                            const std::vector<Spot>& bytes) {
  if (exit.swapped && unit_.options.broken != icode::Opcode::SwapBlocks) swapBlocks(unit_);
  StatusConstants constants;
  for (std::uint32_t i = 0; i < exit.states; ++i) {
    const icode::StateWrite& write = region_.states[exit.firstState + i];
    const Spot& spot = states[i].value;
    if (icode::isBit(write.item) && spot.kind == Spot::Kind::Constant)
      constants.note(offsetOf(write.item), spot.number & 1);
    else if (region_.ops[write.value].late)
      writeLate(write, states[i]);
    else
      writeItem(write, spot);
  }
  constants.write(code_);
  if (exit.position != Exit::kNoPosition)
    code_.mov(host::dword_ptr(kState, frames().position), exit.position);
  for (std::uint32_t i = 0; i < exit.bytes; ++i)
    writeByte(region_.bytes[exit.firstByte + i], bytes[i]);
}

void RegionCode::writeItem(const icode::StateWrite& write, const Spot& spot) {
  const bool isBit = icode::isBit(write.item);
  const host::Mem to(kState, offsetOf(write.item), isBit ? 1u : 4u);
  if (spot.kind == Spot::Kind::Constant) {
    code_.mov(to, spot.number);
    return;
  }
  host::Gp from = fetch(spot, host::eax);
  if (!isBit) {
    code_.mov(to, from);
    return;
  }
  const Bit b = bit(write.value);
  if (!b.isolated || b.position != 0) {
    turn(host::eax, from, b.position, 0);
    if (!b.isolated) code_.and_(host::eax, 1);
    from = host::eax;
  }
  code_.mov(to, from.r8());
}

void RegionCode::writeByte(const icode::ByteWrite& write, const Spot& spot) {
  const bool local = write.space == icode::Space::Local;
  if (places_.isAt(spot, write.space, write.place)) return;
  const host::Mem to = local ? host::byte_ptr(host::rcx, static_cast<int>(write.place))
                             : inImage(write.space, write.place, 1);
  if (local) {
    code_.mov(host::rcx, inState(frames().top));
    code_.mov(host::rcx, host::qword_ptr(host::rcx, frames().frame.local));
  }
  if (spot.kind == Spot::Kind::Constant) {
    code_.mov(to, spot.number & 0xFF);
    return;
  }
  code_.mov(to, fetch(spot, host::eax).r8());
}

void RegionCode::writeWaysOut() {
  for (const WayOut& way : waysOut_) {
    code_.bind(way.label);
    if (way.zero.isValid()) {
      code_.test(host::eax, host::eax);
      code_.je(way.zero);
    }
    const Exit& exit = region_.exits[way.exit];
    checkStack(exit, way.front);
    writeState(exit, way.states, way.bytes);
    charge(exit);
    // A guard leaves its own instruction to the interpreter, even where a region begins with it.
    const bool guard = exit.instructions == 0 && exit.to == region_.first;
    if (guard) {
      code_.mov(host::eax, exit.to);
      code_.jmp(unit_.epilogue);
    } else {
      goOn(exit, UINT32_MAX);
    }
  }
  code_.bind(tooNear_);
  code_.mov(host::eax, region_.first);
  code_.jmp(unit_.epilogue);
}

}  // namespace merker::jit
