#include "cpu/snapshot.h"

#include <algorithm>

#include "cpu/cpu.h"

namespace merker::cpu {
namespace {

void fill(std::vector<std::uint8_t>& to, const std::vector<std::uint8_t>& from) {
  std::copy_n(from.begin(), std::min(from.size(), to.size()), to.begin());
}

}  // namespace

RetentiveRanges Cpu::wholeMemory() const {
  return {machine_.areas.flagBytes, machine_.timers.size(), machine_.counters.size()};
}

Snapshot Cpu::snapshot() const {
  const Areas& areas = machine_.areas;
  Snapshot result;
  keep(result.memory, wholeMemory(), true);
  result.images.assign(areas.image.begin(), areas.image.begin() + areas.flagBase);
  result.inputs = areas.inputs;
  result.outputs = areas.outputs;
  result.run = executes(mode_);
  result.position = switch_.position();
  result.stoppedByFault = stoppedByFault_;
  result.timersHeld = timersHeld_;
  if (!result.run && stopEvent_.event != 0) result.stopEvent = {toRetentive(stopEvent_)};
  result.interrupts = interrupts_;
  result.systemTime = systemTime().ns;
  result.scan = scan_;
  result.cycleTimes = cycleTimes_;
  result.cycleBegan = cycleStart_.ns;
  result.nextCycle = nextCycle_.ns;
  return result;
}

// Meters go on: this is no power failure.
void Cpu::takeMeters(const block::RetentiveData& data, Duration shift) {
  for (std::size_t i = 0; i < std::min(runtimeMeters_.size(), data.meters.size()); ++i) {
    const block::RetentiveMeter& meter = data.meters[i];
    runtimeMeters_[i] = {meter.counted, meter.running, Instant{meter.since} + shift};
  }
}

namespace {

// Of the interrupts that this program has; when they are due is nothing to trust a file with.
void takeInterrupts(Interrupts& to, const Interrupts& from, Instant now, Duration shift) {
  for (CyclicInterrupt& cyclic : to.cyclic) {
    cyclic.begin(now);
    const auto same = [&](const CyclicInterrupt& one) { return one.ob == cyclic.ob; };
    const auto old = std::ranges::find_if(from.cyclic, same);
    if (old != from.cyclic.end()) cyclic.next = std::clamp(old->next + shift, now, cyclic.next);
  }
  for (const DelayInterrupt& old : from.delay)
    if (DelayInterrupt* delay = to.findDelay(old.ob)) {
      *delay = old;
      delay->due = old.due + shift;
    }
  for (const TimeOfDayInterrupt& old : from.timeOfDay)
    if (TimeOfDayInterrupt* time = to.findTimeOfDay(old.ob)) *time = old;
  to.locked = from.locked;
}

}  // namespace

// A cycle that has not begun yet, or began long ago, begins now.
void Cpu::takeTimes(const Snapshot& from, Duration shift) {
  const Instant now = machine_.clock;
  prepareInterrupts();
  takeInterrupts(interrupts_, from.interrupts, now, shift);
  systemStart_ = now - Duration{from.systemTime};
  scan_ = from.scan;
  cycleTimes_ = from.cycleTimes;
  constexpr Duration kLongest = Duration::seconds(60);
  cycleStart_ = std::clamp(Instant{from.cycleBegan} + shift, now - kLongest, now);
  nextCycle_ = std::clamp(Instant{from.nextCycle} + shift, now, now + kLongest);
}

// As it was: no restart, no event, no OB.
void Cpu::take(const Snapshot& from, std::shared_ptr<const block::Program> program) {
  const Duration shift{machine_.clock.ns - from.memory.now};
  if (mode_ != Mode::Stop) change(Mode::Stop);
  frozenAt_ = machine_.clock;
  standStill();
  loadMemory_.download(std::move(program));
  activateDownload();
  clearSystemMemory(true);
  machine_.dataBlocks.load(*this->program());
  diagnostics_.clear();
  takeBack(from.memory, wholeMemory(), true);
  takeMeters(from.memory, shift);
  fill(machine_.areas.image, from.images);
  if (!modules_.connected()) fill(machine_.areas.inputs, from.inputs);
  fill(machine_.areas.outputs, from.outputs);
  modules_.written(0, static_cast<std::uint32_t>(machine_.areas.outputs.size()));
  services_.restart();
  switch_ = {};
  switch_.turn(from.position, machine_.clock);
  stoppedByFault_ = faults_.program = from.stoppedByFault;
  resetRequested_ = false;
  timersHeld_ = from.timersHeld;
  stopEvent_ = from.stopEvent.empty() ? DiagnosticEvent{} : toEvent(from.stopEvent[0], shift);
  takeTimes(from, shift);
  if (!from.run) return;
  change(Mode::Startup);
  change(Mode::Run);
  modules_.disableOutputs(false);
  monitoring_.begin(cycleStart_, cycleMonitoring());
}

}  // namespace merker::cpu
