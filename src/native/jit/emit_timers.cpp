// Timers and counters.
#include "jit/region_code.h"

namespace merker::jit {

using icode::Field;
using icode::Op;

const Layout::Cells& RegionCode::cells(Field field) const {
  return icode::isTimer(field) ? unit_.layout.timers : unit_.layout.counters;
}
// From the first timer or counter on.
int RegionCode::offsetOf(Field field, const Op& op) const {
  const int cell = static_cast<int>(op.number) * cells(field).bytes;
  return cell + unit_.layout.fields[static_cast<std::size_t>(field)];
}
int RegionCode::timerEnd(const Op& op) const {
  return static_cast<int>(op.number) * unit_.layout.timers.bytes + unit_.layout.timerEnd;
}

void RegionCode::runs(const Op& op, const host::Mem& end) {
  code_.lea(host::rax, host::ptr(kClock, static_cast<int>(op.place)));
  code_.cmp(host::rax, end);
  flag(host::CondCode::kL);
}

void RegionCode::TimerRuns(const Op& op) {
  code_.mov(host::rcx, inState(unit_.layout.timers.first));
  runs(op, host::qword_ptr(host::rcx, timerEnd(op)));
}

// Where it begins, to rcx.
void RegionCode::loadCell(const Layout::Cells& cells, icode::Value number) {
  code_.imul(host::ecx, places_.in(number, host::ecx), cells.bytes);
  code_.add(host::rcx, inState(cells.first));
}

void RegionCode::TimerRunsOf(const Op& op) {
  loadCell(unit_.layout.timers, op.a);
  runs(op, host::qword_ptr(host::rcx, unit_.layout.timerEnd));
}

// Of what runs, in units, rounded up; otherwise what was left when it was stopped.
void RegionCode::TimerUnits(const Op& op) {
  const auto at = [&](Field which) { return offsetOf(which, op); };
  const host::Gp to = places_.out();
  const asmjit::Label done = code_.newLabel(), tens = code_.newLabel(), divide = code_.newLabel();
  code_.mov(host::rcx, inState(unit_.layout.timers.first));
  code_.movzx(to, host::word_ptr(host::rcx, at(Field::TimerFrozen)));
  code_.cmp(host::byte_ptr(host::rcx, at(Field::TimerStarted)), 0);
  code_.je(done);
  code_.xor_(to, to);
  code_.lea(host::rdx, host::ptr(kClock, static_cast<int>(op.place)));
  code_.mov(host::rax, host::qword_ptr(host::rcx, timerEnd(op)));
  code_.sub(host::rax, host::rdx);
  code_.jle(done);
  code_.movzx(host::edx, host::byte_ptr(host::rcx, at(Field::TimerBase)));
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
  code_.mov(host::rcx, inState(cells(which).first));
  return {host::rcx, offsetOf(which, op), bytes};
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

host::Mem RegionCode::fieldOf(const Op& op, icode::Value number, std::uint32_t bytes) {
  const auto which = static_cast<Field>(op.place);
  loadCell(cells(which), number);
  return {host::rcx, unit_.layout.fields[op.place], bytes};
}

void RegionCode::FieldByteOf(const Op& op) {
  const host::Mem from = fieldOf(op, op.a, 1);
  code_.movzx(places_.out(), from);
}
void RegionCode::FieldWordOf(const Op& op) {
  const host::Mem from = fieldOf(op, op.a, 2);
  code_.movzx(places_.out(), from);
}
void RegionCode::SetFieldByteOf(const Op& op) {
  const host::Mem to = fieldOf(op, op.b, 1);
  code_.mov(to, places_.in(op.a, host::eax).r8());
}
void RegionCode::SetFieldWordOf(const Op& op) {
  const host::Mem to = fieldOf(op, op.b, 2);
  code_.mov(to, places_.in(op.a, host::eax).r16());
}

}  // namespace merker::jit
