// Timers and counters of the CPU.
#include "jit/region_code.h"

namespace merker::jit {

using cpu::S5Counter;
using cpu::S5Timer;
using icode::Field;
using icode::Op;

namespace {

constexpr int offsetOfField(Field field) {
  constexpr std::size_t kOffsets[] = {
      offsetof(S5Timer, kind),     offsetof(S5Timer, startEdge),  offsetof(S5Timer, enableEdge),
      offsetof(S5Timer, started),  offsetof(S5Timer, held),       offsetof(S5Timer, base),
      offsetof(S5Timer, frozen),   offsetof(S5Counter, count),    offsetof(S5Counter, setEdge),
      offsetof(S5Counter, upEdge), offsetof(S5Counter, downEdge), offsetof(S5Counter, enableEdge)};
  return static_cast<int>(kOffsets[static_cast<std::size_t>(field)]);
}

}  // namespace

// S7-TMR: started and not yet over, the delays started and over; SS and SA also while held.
void RegionCode::TimerStatus(const Op& op) {
  const int timer = static_cast<int>(op.number * sizeof(S5Timer));
  const auto field = [&](std::size_t at) {
    return host::byte_ptr(host::rcx, timer + static_cast<int>(at));
  };
  const host::Gp to = places_.out();
  code_.mov(host::rcx, host::qword_ptr(host::rsp, kTimers));
  code_.lea(host::rax, host::ptr(kClock, static_cast<int>(op.place)));
  code_.cmp(host::rax,
            host::qword_ptr(host::rcx, timer + static_cast<int>(offsetof(S5Timer, end))));
  code_.setl(host::al);
  code_.movzx(host::edx, field(offsetof(S5Timer, kind)));
  code_.mov(to, host::edx);
  code_.sub(host::edx, static_cast<int>(S5Timer::Kind::OnDelay));
  code_.cmp(host::edx, 2);
  code_.setb(host::dl);
  code_.xor_(host::al, host::dl);
  code_.and_(host::al, field(offsetof(S5Timer, started)));
  code_.cmp(to, static_cast<int>(S5Timer::Kind::StoredOnDelay));
  code_.setae(host::dl);
  code_.and_(host::dl, field(offsetof(S5Timer, held)));
  code_.or_(host::al, host::dl);
  code_.movzx(to, host::al);
}

// Of what runs, in units, rounded up; otherwise what was left when it was stopped.
void RegionCode::TimerUnits(const Op& op) {
  const int timer = static_cast<int>(op.number * sizeof(S5Timer));
  const auto at = [&](std::size_t field) { return timer + static_cast<int>(field); };
  const host::Gp to = places_.out();
  const asmjit::Label done = code_.newLabel(), tens = code_.newLabel(), divide = code_.newLabel();
  code_.mov(host::rcx, host::qword_ptr(host::rsp, kTimers));
  code_.movzx(to, host::word_ptr(host::rcx, at(offsetof(S5Timer, frozen))));
  code_.cmp(host::byte_ptr(host::rcx, at(offsetof(S5Timer, started))), 0);
  code_.je(done);
  code_.xor_(to, to);
  code_.lea(host::rdx, host::ptr(kClock, static_cast<int>(op.place)));
  code_.mov(host::rax, host::qword_ptr(host::rcx, at(offsetof(S5Timer, end))));
  code_.sub(host::rax, host::rdx);
  code_.jle(done);
  code_.movzx(host::edx, host::byte_ptr(host::rcx, at(offsetof(S5Timer, base))));
  code_.mov(host::ecx, 10'000'000);  // ns
  code_.bind(tens);
  code_.sub(host::edx, 1);
  code_.js(divide);
  code_.imul(host::rcx, host::rcx, 10);
  code_.jmp(tens);
  code_.bind(divide);
  code_.lea(host::rax, host::ptr(host::rax, host::rcx, 0, -1));
  code_.xor_(host::edx, host::edx);
  code_.div(host::rcx);
  code_.movzx(to, host::ax);
  code_.bind(done);
}

host::Mem RegionCode::field(const Op& op, std::uint32_t bytes) {
  const auto which = static_cast<Field>(op.place);
  const bool timer = icode::isTimer(which);
  const std::size_t size = timer ? sizeof(S5Timer) : sizeof(S5Counter);
  code_.mov(host::rcx, host::qword_ptr(host::rsp, timer ? kTimers : kCounters));
  return {host::rcx, static_cast<int>(op.number * size) + offsetOfField(which), bytes};
}

void RegionCode::FieldByte(const Op& op) {
  const host::Gp to = places_.out();
  code_.movzx(to, field(op, 1));
}
void RegionCode::FieldWord(const Op& op) {
  const host::Gp to = places_.out();
  code_.movzx(to, field(op, 2));
}
void RegionCode::SetFieldByte(const Op& op) {
  const host::Mem to = field(op, 1);
  code_.mov(to, places_.in(op.a, host::eax).r8());
}
void RegionCode::SetFieldWord(const Op& op) {
  const host::Mem to = field(op, 2);
  code_.mov(to, places_.in(op.a, host::eax).r16());
}

}  // namespace merker::jit
