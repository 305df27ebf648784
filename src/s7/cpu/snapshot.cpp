#include "cpu/snapshot.h"

#include <algorithm>

#include "cpu/cpu.h"

namespace merker::cpu {
namespace {

void fill(std::vector<std::uint8_t>& to, const std::vector<std::uint8_t>& from) {
  std::copy_n(from.begin(), std::min(from.size(), to.size()), to.begin());
}

}  // namespace

Snapshot Cpu::snapshot() const {
  const Areas& areas = machine_.areas;
  Snapshot result;
  retention_.keep(result.memory, Extent::All, state_.standing());
  result.memory.running = running();
  result.images.assign(areas.image.begin(), areas.image.begin() + areas.flagBase);
  result.inputs = areas.inputs;
  result.outputs = areas.outputs;
  result.run = state_.executing();
  result.position = switch_.position();
  result.stoppedByFault = state_.stoppedByFault();
  result.timersHeld = timersHeld_;
  if (!result.run && state_.stopEvent().event != 0)
    result.stopEvent = {toRetentive(state_.stopEvent())};
  result.interrupts = interrupts_.list();
  result.systemTime = systemTime().ns;
  cycle_.save(result);
  return result;
}

void Cpu::takeTimes(const Snapshot& from, Duration shift) {
  prepareInterrupts();
  interrupts_.take(from.interrupts, shift);
  systemStart_ = machine_.clock - Duration{from.systemTime};
  cycle_.take(from, shift, machine_.clock);
}

// As it was: no restart, no event, no OB.
void Cpu::take(const Snapshot& from, std::shared_ptr<const block::Program> program) {
  const Duration shift{machine_.clock.ns - from.memory.now};
  quiet_.forget();
  state_.stopQuietly();
  loadMemory_.download(std::move(program));
  activateDownload();
  clearSystemMemory(Extent::All);
  machine_.dataBlocks.load(*this->program());
  log_.clear();
  retention_.takeBack(from.memory, Extent::All);
  retention_.takeMeters(from.memory);
  fill(machine_.areas.image, from.images);
  if (!modules_.connected()) fill(machine_.areas.inputs, from.inputs);
  fill(machine_.areas.outputs, from.outputs);
  modules_.written(0, static_cast<std::uint32_t>(machine_.areas.outputs.size()));
  services_.restart();
  switch_ = {};
  switch_.turn(from.position, machine_.clock);
  faults_.program = from.stoppedByFault;
  resetRequested_ = false;
  timersHeld_ = from.timersHeld;
  state_.takeStop(from.stopEvent.empty() ? DiagnosticEvent{} : toEvent(from.stopEvent[0], shift),
                  from.stoppedByFault);
  takeTimes(from, shift);
  if (!from.run) return;
  state_.runQuietly();
  modules_.disableOutputs(false);
  cycle_.monitor(cycle_.began());
}

}  // namespace merker::cpu
