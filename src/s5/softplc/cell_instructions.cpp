// Starting timers, counting, FR (9.3.4, 9.4.4).
#include "softplc/handlers.h"

namespace merker::sinumerik {
namespace {

using mc5::Instruction;
using mc5::OperandKind;
using mc5::Operation;

bool ended(Processor& p, bool done) {
  p.displays().orBit = p.displays().chain = false;
  return done;
}

template <TimerKind Kind>
bool start(Processor& p, const Instruction& i) {
  Machine& m = p.machine();
  Timer& timer = m.timers[i.operand.value];
  const auto& bases = p.environment().timeBases;
  return ended(p, timer.start(Kind, p.vke(), p.registers().low1(), m.clock, bases));
}

bool countUp(Processor& p, const Instruction& i) {
  return ended(p, p.machine().counters[i.operand.value].up(p.vke()));
}
bool countDown(Processor& p, const Instruction& i) {
  return ended(p, p.machine().counters[i.operand.value].down(p.vke()));
}

bool enable(Processor& p, const Instruction& i) {
  Machine& m = p.machine();
  const std::uint32_t number = i.operand.value;
  if (i.operand.kind == OperandKind::Timer) return ended(p, m.timers[number].enable(p.vke()));
  return ended(p, m.counters[number].enable(p.vke()));
}

constexpr HandlerRow kCellRows[] = {
    {Operation::TIMER_SI, start<TimerKind::SI>}, {Operation::TIMER_SV, start<TimerKind::SV>},
    {Operation::TIMER_SE, start<TimerKind::SE>}, {Operation::TIMER_SS, start<TimerKind::SS>},
    {Operation::TIMER_SA, start<TimerKind::SA>}, {Operation::COUNT_UP, countUp},
    {Operation::COUNT_DOWN, countDown},          {Operation::ENABLE, enable}};

}  // namespace

HandlerRows cellHandlers() { return kCellRows; }

}  // namespace merker::sinumerik
