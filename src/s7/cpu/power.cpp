// Power off and on, memory reset, the mode switch (S7-STATE-04, -05, -10; S7-CPU-31).
#include "cpu/cpu.h"

namespace merker::cpu {

// S7-STATE-10: the diagnostic buffer and the clock stay.
void Cpu::memoryReset(Event how) {
  stop(Event::StopByProgrammer);
  report(how);
  clearStacks();
  clearSystemMemory(true);
  forces_.release();
  activateDownload();
  if (program()) machine_.dataBlocks.load(*program());
  stoppedByFault_ = resetRequested_ = resumable_ = false;
  faults_.program = false;
  report(Event::MemoryResetDone);
}

void Cpu::requestMemoryReset() {
  stopByFault(Event::MemoryResetNeeded);
  resetRequested_ = true;
}

// HALT without power ends in STOP, whatever comes later.
void Cpu::powerOff() {
  if (!powered_) return;
  runningAtPowerOff_ = executes(mode_);
  if (runningAtPowerOff_) frozenAt_ = machine_.clock;
  resumable_ = runningAtPowerOff_;
  if (mode_ == Mode::Halt) {
    stopEvent_ = makeEvent(static_cast<std::uint16_t>(Event::HaltToStop),
                           std::string(text(Event::HaltToStop)), {});
    diagnostics_.add(stopEvent_);
  }
  mode_ = Mode::Stop;
  powered_ = false;
  standStill();
  modules_.supply(false);
}

void Cpu::powerOn(bool buffered) {
  if (powered_) return;
  powered_ = true;
  buffered_ = buffered;
  modules_.supply(true);
  if (buffered)
    report(Event::PowerOn);
  else
    memoryReset(Event::MemoryResetAutomatic);
  takePeriphery();  // what happened meanwhile, as in STOP
  if (!runningAtPowerOff_ || !switch_.allowsRun()) {
    clearStacks();
    clearSystemMemory(false);
    if (program()) machine_.dataBlocks.loadNonRetentive(*program());
    return;
  }
  const PowerOnStart wanted = parameters_.afterPowerOn;
  const CpuModel& model = *machine_.model;
  if (wanted == PowerOnStart::Hot && model.hotRestart && resumable_)
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

}  // namespace merker::cpu
