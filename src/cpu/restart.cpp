// Operating states and what each change keeps and clears (S7-STATE, S7-MEM-02, -04).
#include <algorithm>

#include "cpu/cpu.h"

namespace merker::cpu {

void Cpu::clearStacks() {
  machine_.levels.clear();
  machine_.frames.resize(1);
  machine_.top = &machine_.frames.back();
  machine_.brackets.clear();
  machine_.mcrStack.clear();
  machine_.mcrActive = machine_.mcrOff = machine_.levelEnded = false;
  machine_.registers = {};
}

// Flags, timers, counters: all of them, or those beyond the retentive ranges (S7-STATE-09).
void Cpu::clearSystemMemory(bool all) {
  const RetentiveRanges kept = all ? RetentiveRanges{0, 0, 0} : retentiveRanges();
  Areas& areas = machine_.areas;
  std::fill(areas.image.begin() + areas.flagBase + kept.flags, areas.image.end(), std::uint8_t{0});
  std::fill(machine_.timers.begin() + static_cast<std::ptrdiff_t>(kept.timers),
            machine_.timers.end(), S5Timer{});
  std::fill(machine_.counters.begin() + static_cast<std::ptrdiff_t>(kept.counters),
            machine_.counters.end(), S5Counter{});
  areas.clearImages();
}

bool Cpu::restart(Restart how) {
  const bool cold = how == Restart::ManualCold;
  if (!powered_ || (cold && !machine_.model->coldRestart)) return false;
  if (mode_ != Mode::Stop) stop(Event::StopByProgrammer);
  if (!hasOb(1)) {  // S7-OPEN-39
    goToStop({.event = static_cast<std::uint16_t>(Event::StopProgramSequence),
              .text = "start refused: OB 1 is not loaded"},
             true);
    return false;
  }
  clearStacks();
  const Duration stopped = machine_.clock - stoppedAt_;
  for (S5Timer& timer : machine_.timers)  // S7-TMR-22: timers stand still in STOP
    if (timer.started) timer.end = timer.end + stopped;
  clearSystemMemory(cold);
  if (cold)
    machine_.dataBlocks.load(*program_);  // S7-STATE-06, S7-MEM-04
  else
    machine_.dataBlocks.loadNonRetentive(*program_);
  prepareInterrupts();

  const auto last = stopEvent_.event;
  const Event request = cold                            ? Event::ColdRestartManual
                        : how == Restart::AutomaticWarm ? Event::WarmRestartAutomatic
                                                        : Event::WarmRestartManual;
  report(static_cast<std::uint16_t>(request), std::string(text(request)));
  report(static_cast<std::uint16_t>(Event::StopToStartup), std::string(text(Event::StopToStartup)));
  mode_ = Mode::Startup;
  stoppedByFault_ = false;
  scan_ = cold ? 4 : 1;
  cycleTimes_ = {};
  watchdog_ = Instant::never();  // S7-STATE-11: no cycle monitoring

  // OB 102 for a cold restart, else OB 100 (S7-STATE-04, -06; S7-OBI-12)
  const std::uint8_t ob = cold ? 102 : 100;
  if (hasOb(ob)) {
    const std::uint8_t kind = cold ? 0x85 : how == Restart::AutomaticWarm ? 0x82 : 0x81;
    StartInformation start = startInformation(0x13, kind, priorityOf(ob), ob, dateAndTime());
    setWord(start, 6, last);
    startLevel(ob, priorityOf(ob), start, false);
  }
  return true;
}

void Cpu::goToStop(DiagnosticEvent event, bool fault) {
  event.time = machine_.clock;
  stopEvent_ = event;
  record(std::move(event));
  for (RuntimeMeter& meter : runtimeMeters_) meter.stop(machine_.clock);
  if (mode_ != Mode::Stop) stoppedAt_ = machine_.clock;
  mode_ = Mode::Stop;
  stoppedByFault_ = fault;
  watchdog_ = Instant::never();
  std::fill(machine_.areas.outputs.begin(), machine_.areas.outputs.end(),
            std::uint8_t{0});  // S7-STATE-02
  machine_.interrupt();
  reached(CyclePoint::Stop);
}

void Cpu::stop(Event why) {
  if (mode_ == Mode::Stop) return;
  goToStop({.event = static_cast<std::uint16_t>(why), .text = std::string(text(why)), .place = {}},
           false);
}

// S7-STATE-10: the diagnostic buffer and the clock stay.
void Cpu::memoryReset() {
  stop(Event::StopByProgrammer);
  report(static_cast<std::uint16_t>(Event::MemoryReset), std::string(text(Event::MemoryReset)));
  clearStacks();
  clearSystemMemory(true);
  if (program_) machine_.dataBlocks.load(*program_);
  stoppedByFault_ = false;
  report(static_cast<std::uint16_t>(Event::MemoryResetDone),
         std::string(text(Event::MemoryResetDone)));
}

void Cpu::powerOff() {
  if (!powered_) return;
  runningAtPowerOff_ = mode_ != Mode::Stop;
  if (runningAtPowerOff_) stoppedAt_ = machine_.clock;
  for (RuntimeMeter& meter : runtimeMeters_) meter.stop(machine_.clock);
  mode_ = Mode::Stop;
  powered_ = false;
  watchdog_ = Instant::never();
  std::fill(machine_.areas.outputs.begin(), machine_.areas.outputs.end(), std::uint8_t{0});
}

void Cpu::powerOn() {
  if (powered_) return;
  powered_ = true;
  report(static_cast<std::uint16_t>(Event::PowerOn), std::string(text(Event::PowerOn)));
  clearStacks();
  clearSystemMemory(false);
  if (program_) machine_.dataBlocks.loadNonRetentive(*program_);
  if (runningAtPowerOff_) restart(Restart::AutomaticWarm);
}

}  // namespace merker::cpu
