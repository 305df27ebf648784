// The scan cycle (S7-CYCLE-02): cycle monitoring on, write outputs, read inputs, OB 1, operating
// system, again.
#include <algorithm>

#include "cpu/cpu.h"

namespace merker::cpu {
namespace {

// For OB 1 without cycle monitoring (runOb1): longer than any cycle may take.
constexpr Duration kLongestRun = Duration::seconds(60);

}  // namespace

void Cpu::step(Instant limit) {
  if (mode_ == Mode::Stop) {
    machine_.clock = std::max(machine_.clock, limit);
    return;
  }
  if (machine_.levels.empty())
    idle(limit);
  else
    runTop(limit);
  if (mode_ == Mode::Run) takeEvents();
}

void Cpu::idle(Instant limit) {
  if (mode_ == Mode::Startup) return enterRun();
  if (machine_.clock >= nextCycle_) return startCycle();
  machine_.clock = std::max(machine_.clock, std::min({limit, nextCycle_, nextEvent()}));
}

void Cpu::runTop(Instant limit) {
  Instant until = limit;
  if (mode_ == Mode::Run) until = std::min(until, nextEvent());
  if (Level& level = machine_.levels.back(); level.wait > 0) {  // SFC 47
    const Instant end =
        std::min(machine_.clock + Duration{level.wait}, std::max(until, machine_.clock));
    level.wait -= (end - machine_.clock).ns;
    machine_.clock = end;
    return;
  }
  machine_.horizon = until;
  machine_.levelEnded = false;
  engine_.run(machine_);
  if (mode_ == Mode::Stop) return;
  if (machine_.levelEnded)
    endLevel();
  else
    machine_.position = engine_.offset(*machine_.top);
}

void Cpu::enterRun() {
  mode_ = Mode::Run;
  ++checkpoints_;
  report(static_cast<std::uint16_t>(Event::StartupToRun), std::string(text(Event::StartupToRun)));
  nextCycle_ = cycleStart_ = machine_.clock;
  for (CyclicInterrupt& cyclic : interrupts_.cyclic)
    cyclic.next = machine_.clock + Duration::milliseconds(cyclic.milliseconds);
}

void Cpu::startCycle() {
  const Duration monitoring = Duration::milliseconds(machine_.model->cycleMonitoring);
  if (scan_ == 3) cycleTimes_.add(machine_.clock - cycleStart_);
  cycleStart_ = machine_.clock;
  watchdog_ = machine_.clock + monitoring;
  watchdogWarned_ = false;
  applyForces();
  machine_.areas.writeOutputs();
  machine_.areas.readInputs();
  reached(CyclePoint::Begin);
  applyForces();

  StartInformation start = startInformation(0x11, scan_, priorityOf(1), 1, dateAndTime());
  setWord(start, 6, static_cast<std::uint32_t>(cycleTimes_.previous));
  setWord(start, 8, static_cast<std::uint32_t>(cycleTimes_.shortest));
  setWord(start, 10, static_cast<std::uint32_t>(cycleTimes_.longest));
  scan_ = 3;
  startLevel(1, priorityOf(1), start, false);
}

void Cpu::endCycle() {
  ++cycles_;
  ++checkpoints_;
  nextCycle_ = machine_.clock + Duration{machine_.model->cycleTime};
  reached(CyclePoint::End);
  applyForces();
  if (observer_) observer_();
}

void Cpu::reached(CyclePoint point) {
  if (monitor_) monitor_(point);
}

void Cpu::applyForces() {
  for (const Force& force : forces_) {
    std::uint8_t& byte = machine_.areas.image[force.byte];
    byte = static_cast<std::uint8_t>((byte & ~force.mask) | (force.value & force.mask));
  }
}

void Cpu::runOb1() {
  if (mode_ != Mode::Run || !machine_.levels.empty()) return;
  const StartInformation start = startInformation(0x11, scan_, priorityOf(1), 1, dateAndTime());
  if (!startLevel(1, priorityOf(1), start, false)) return;
  const Instant latest = machine_.clock + kLongestRun;
  machine_.levelEnded = false;
  while (mode_ == Mode::Run && !(machine_.levelEnded && machine_.levels.size() == 1)) {
    if (machine_.clock >= latest) return stopByFault(Event::StopTimeError, "OB 1 does not end");
    if (machine_.levelEnded) endLevel();  // of an error OB
    machine_.levelEnded = false;
    machine_.horizon = latest;
    engine_.run(machine_);
  }
  if (mode_ == Mode::Run) endLevel();
}

}  // namespace merker::cpu
