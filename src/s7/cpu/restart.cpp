// Restarts and STOP: what each change of state keeps and clears (S7-STATE-04 … -09, -11; S7-MEM-02,
// -04).
#include <algorithm>
#include <cassert>

#include "cpu/cpu.h"

namespace merker::cpu {
namespace {

// S7-OBI-12, S7-DIAG-02
struct Row {
  Restart how;
  std::uint8_t ob, kind;  // kind: OB10x_STRTUP
  Event event;
  std::uint8_t info, unbuffered;  // bits 23..16 of STRT_INFO; after power on without buffer
};
constexpr Row kRows[] = {
    {Restart::ManualWarm, 100, 0x81, Event::WarmRestartManual, 0x03, 0x03},
    {Restart::AutomaticWarm, 100, 0x82, Event::WarmRestartAutomatic, 0x10, 0x20},
    {Restart::ManualHot, 101, 0x83, Event::HotRestartManual, 0x0B, 0x0B},
    {Restart::AutomaticHot, 101, 0x84, Event::HotRestartAutomatic, 0xA0, 0xA0},
    {Restart::ManualCold, 102, 0x85, Event::ColdRestartManual, 0x07, 0x07},
    {Restart::AutomaticCold, 102, 0x86, Event::ColdRestartAutomatic, 0x11, 0x21}};

const Row& rowOf(Restart how) { return kRows[static_cast<unsigned>(how)]; }

}  // namespace

void Cpu::clearStacks() {
  machine_.levels.clear();
  machine_.frames.resize(1);
  machine_.top = &machine_.frames.back();
  machine_.updateCallLimit();
  machine_.brackets.clear();
  machine_.mcrStack.clear();
  machine_.mcrActive = machine_.mcrOff = machine_.levelEnded = false;
  machine_.registers = {};
  resumable_ = false;
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
  std::fill(areas.outputs.begin(), areas.outputs.end(), std::uint8_t{0});
  modules_.written(0, static_cast<std::uint32_t>(areas.outputs.size()));
}

// A start that does not exist on this model, or that nothing allows now, leaves no trace.
bool Cpu::startRefused(Restart how) const {
  const CpuModel& model = *machine_.model;
  return !powered_ || resetRequested_ || !switch_.allowsRun() ||
         (isCold(how) && !model.coldRestart) ||
         (isHot(how) && (!model.hotRestart || (mode_ == Mode::Stop && !resumable_)));
}

bool Cpu::restart(Restart how) {
  if (startRefused(how)) return false;
  if (mode_ != Mode::Stop) stop(Event::StopByProgrammer);
  activateDownload();
  if (!hasOb(1)) {  // S7-OPEN-39
    goToStop(Event::StopProgramSequence, "start refused: OB 1 is not loaded", {}, true);
    return false;
  }
  if (isHot(how) && !resumable_) return false;
  if (isHot(how))
    beginHot();
  else
    beginWarm(isCold(how));
  beginStartup(how);
  return true;
}

void Cpu::beginWarm(bool cold) {
  clearStacks();
  shiftTimers(machine_.clock - frozenAt_);  // S7-TMR-22: they stood still in STOP
  clearSystemMemory(cold);
  if (cold)
    machine_.dataBlocks.load(*program());  // S7-STATE-06, S7-MEM-04
  else
    machine_.dataBlocks.loadNonRetentive(*program());
  prepareInterrupts();
  services_.restart();
  restOfCycle_ = 0;
  scan_ = cold ? 4 : 1;
  cycleTimes_ = {};
  systemStart_ = machine_.clock;
}

// S7-STATE-05: nothing is cleared; behind OB 101 the program goes on where it was interrupted.
void Cpu::beginHot() {
  shiftProgramTime(machine_.clock - frozenAt_);
  std::erase_if(interrupts_.waiting, [](const Request& request) { return request.ob >= 80; });
  restOfCycle_ = machine_.levels.size();
  scan_ = 2;
}

void Cpu::beginStartup(Restart how) {
  const Row& row = rowOf(how);
  lastStart_ = startupInformation(how);
  report(row.event);
  report(Event::StopToStartup);
  change(Mode::Startup);
  lastRestart_ = how;
  stoppedByFault_ = faults_.program = false;
  monitoring_.off();  // S7-STATE-11: no cycle monitoring
  if (hasOb(row.ob)) startLevel(row.ob, priorityOf(row.ob), lastStart_, false);
}

// Byte 6 the event of the last STOP; bytes 8..11 as the manual's table "STRT_INFO" has them (System
// Software for S7-300/400, startup OBs): which start, by whom, and which starts are possible.
StartInformation Cpu::startupInformation(Restart how) const {
  constexpr unsigned kWarmPossible = 0x77, kHotPossible = 0xFF;
  const Row& row = rowOf(how);
  const unsigned who = buffered_ ? row.info : row.unbuffered;
  StartInformation start = startInformation(0x13, row.kind, 27, row.ob, dateAndTime());
  setWord(start, 6, stopEvent_.event);
  setByte(start, 9, who);
  setByte(start, 10, machine_.model->hotRestart ? kHotPossible : kWarmPossible);
  setByte(start, 11, who);
  return start;
}

// S7-STATE-08
void Cpu::change(Mode to) {
  assert(isTransition(mode_, to));
  mode_ = to;
  if (to == Mode::Startup) modules_.wake();
  modules_.modeChanged();
}

void Cpu::standStill() {
  monitoring_.off();
  for (RuntimeMeter& meter : runtimeMeters_) meter.stop(machine_.clock);
  modules_.disableOutputs(true);  // S7-STATE-02
}

void Cpu::goToStop(Event why, std::string reason, Place place, bool fault) {
  stopEvent_ = makeEvent(static_cast<std::uint16_t>(why), std::move(reason), place);
  diagnostics_.add(stopEvent_);
  if (executes(mode_)) frozenAt_ = machine_.clock;
  if (mode_ != Mode::Stop) {
    resumable_ = mode_ == Mode::Run && !fault;
    change(Mode::Stop);
  }
  stoppedByFault_ = fault;
  standStill();
  machine_.interrupt();
  reached(CyclePoint::Stop);
}

void Cpu::stop(Event why) {
  if (mode_ == Mode::Stop) return;
  if (mode_ == Mode::Halt) report(Event::HaltToStop);
  goToStop(why, std::string(text(why)), {}, false);
}

}  // namespace merker::cpu
