// Power off and on, memory reset, the mode switch (S7-STATE-04, -05, -10; S7-CPU-31).
#include "cpu/cpu.h"

namespace merker::cpu {

// S7-STATE-10: the diagnostic buffer and the clock stay.
void Cpu::memoryReset(Event how) {
  stop(Event::StopByProgrammer);
  log_.report(how);
  clearStacks();
  clearSystemMemory(Extent::All);
  forces_.release();
  activateDownload();
  if (program()) machine_.dataBlocks.load(*program());
  state_.forgiveFault();
  resetRequested_ = faults_.program = false;
  log_.report(Event::MemoryResetDone);
}

void Cpu::requestMemoryReset() {
  stopByFault(Event::MemoryResetNeeded);
  resetRequested_ = true;
}

void Cpu::powerOff() {
  if (!powered_) return;
  powered_ = false;
  runningAtPowerOff_ = state_.losePower();
  modules_.supply(false);
}

void Cpu::powerOn(bool buffered) {
  if (powered_) return;
  powered_ = true;
  buffered_ = buffered;
  modules_.supply(true);
  if (buffered)
    log_.report(Event::PowerOn);
  else
    memoryReset(Event::MemoryResetAutomatic);
  takePeriphery();  // what happened meanwhile, as in STOP
  if (!runningAtPowerOff_ || !switch_.allowsRun()) {
    clearStacks();
    clearSystemMemory(Extent::Retentive);
    if (program()) machine_.dataBlocks.loadNonRetentive(*program());
    return;
  }
  const PowerOnStart wanted = parameters_.afterPowerOn;
  const CpuModel& model = *machine_.model;
  if (wanted == PowerOnStart::Hot && model.hotRestart && state_.resumable())
    restart(Restart::AutomaticHot);
  else if (wanted == PowerOnStart::Cold && model.coldRestart)
    restart(Restart::AutomaticCold);
  else
    restart(Restart::AutomaticWarm);
}

void Cpu::releaseSwitch() {
  if (!switch_.allowsRun()) switch_.turn(SwitchPosition::RunP, machine_.clock);
}

void Cpu::turnSwitch(SwitchPosition to) {
  const bool allowed = switch_.allowsRun();
  const bool reset = switch_.turn(to, machine_.clock);
  if (!powered_) return;
  if (!switch_.allowsRun()) stop(Event::StopBySwitch);
  if (reset) memoryReset(Event::MemoryResetBySwitch);
  if (switch_.allowsRun() && !allowed) restart(Restart::ManualWarm);
}

bool Cpu::running() const { return mode() != Mode::Stop || (!powered_ && runningAtPowerOff_); }

void Cpu::retentive(block::RetentiveData& data) const {
  retention_.keep(data, Extent::Retentive, state_.standing());
  data.running = running();
}

void Cpu::restore(const block::RetentiveData& data) {
  state_.startOff();
  powered_ = false;
  runningAtPowerOff_ = data.running;
  retention_.takeBack(data, Extent::Retentive);
}

}  // namespace merker::cpu
