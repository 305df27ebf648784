// Warm, hot and cold restart: what each keeps and clears (S7-STATE-04 … -09, -11; S7-MEM-02, -04).
#include <algorithm>

#include "cpu/cpu.h"
#include "cpu/levels.h"

namespace merker::cpu {

void Cpu::clearStacks() {
  cpu::clearStacks(machine_);
  state_.forgetProgram();
}

void Cpu::clearSystemMemory(Extent extent) {
  retention_.clear(extent);
  Areas& areas = machine_.areas;
  areas.clearImages();
  std::fill(areas.outputs.begin(), areas.outputs.end(), std::uint8_t{0});
  modules_.written(0, static_cast<std::uint32_t>(areas.outputs.size()));
}

// S7-STATE-09: all that waited is discarded.
void Cpu::prepareInterrupts() {
  requests_.clear();
  moduleEvents_.clear();
  interrupts_.prepare();
}

// A start that does not exist on this model, or that nothing allows now, leaves no trace.
bool Cpu::startRefused(Restart how) const {
  const CpuModel& model = *machine_.model;
  return !powered_ || resetRequested_ || !switch_.allowsRun() ||
         (isCold(how) && !model.coldRestart) ||
         (isHot(how) && (!model.hotRestart || (mode() == Mode::Stop && !state_.resumable())));
}

bool Cpu::restart(Restart how) {
  if (startRefused(how)) return false;
  if (mode() != Mode::Stop) stop(Event::StopByProgrammer);
  activateDownload();
  if (!hasOb(machine_, 1)) {  // S7-OPEN-39
    state_.refuseStart("OB 1 is not loaded");
    return false;
  }
  if (isHot(how) && !state_.resumable()) return false;
  if (isHot(how))
    beginHot();
  else
    beginWarm(isCold(how));
  beginStartup(how, machine_.levels.size());
  return true;
}

void Cpu::beginWarm(bool cold) {
  clearStacks();
  shiftTimers(state_.standing());  // S7-TMR-22: they stood still in STOP
  clearSystemMemory(cold ? Extent::All : Extent::Retentive);
  if (cold)
    machine_.dataBlocks.load(*program());  // S7-STATE-06, S7-MEM-04
  else
    machine_.dataBlocks.loadNonRetentive(*program());
  prepareInterrupts();
  services_.restart();
  systemStart_ = machine_.clock;
}

// S7-STATE-05: nothing is cleared; behind OB 101 the program goes on where it was interrupted.
void Cpu::beginHot() {
  shiftProgramTime(state_.standing());
  requests_.clearErrors();
}

void Cpu::beginStartup(Restart how, std::size_t interrupted) {
  cycle_.prepare(how);
  startup_.begin(how,
                 {.stopEvent = state_.stopEvent().event,
                  .buffered = buffered_,
                  .hotRestart = machine_.model->hotRestart,
                  .time = log_.dateAndTime()},
                 interrupted);
  log_.report(startup_.event());
  log_.report(Event::StopToStartup);
  state_.startup();
  faults_.program = false;
  const std::uint8_t ob = startup_.ob();
  if (hasOb(machine_, ob)) startLevel(machine_, ob, priorityOf(ob), startup_.information(), false);
}

}  // namespace merker::cpu
