// The operating state and its changes (S7-STATE): what is reported, when the program stood still,
// why the CPU is in STOP and whether the interrupted program can go on.
#pragma once

#include <string>
#include <vector>

#include "cpu/event_log.h"
#include "cpu/modules.h"
#include "cpu/operating_state.h"
#include "cpu/runtime_meter.h"
#include "cpu/scan_cycle.h"
#include "plc/cycle_points.h"

namespace merker::cpu {

class StateControl {
 public:
  // What goes to STOP with the CPU.
  struct Parts {
    EventLog& log;
    Modules& modules;
    ScanCycle& cycle;
    std::vector<RuntimeMeter>& meters;
    const controller::CyclePoints& points;
  };
  StateControl(Machine& machine, const Parts& parts);

  Mode mode() const { return mode_; }
  bool executing() const { return executes(mode_); }
  bool stoppedByFault() const { return stoppedByFault_; }
  const DiagnosticEvent& stopEvent() const { return stopEvent_; }
  void replaced(const std::set<BlockId>& blocks) {
    stopEvent_.place.replaced |= blocks.contains(stopEvent_.place.block);
  }
  // The instant that timers see: they stand still in STOP and HALT (S7-TMR-22).
  Instant programTime() const { return executing() ? machine_.clock : frozenAt_; }
  // How long the program has been standing still.
  Duration standing() const { return machine_.clock - programTime(); }
  // The stacks are those of an interrupted program, which a hot restart may go on with.
  bool resumable() const { return resumable_; }
  void forgetProgram() { resumable_ = false; }

  void startup();
  void run() { change(Mode::Run); }
  void stop(Event why);  // a wish: switch, programming device, SFC 46
  void stopByFault(Event why, std::string detail = {});
  // A start that cannot be: still in STOP, with a fault.
  void refuseStart(std::string why);
  // HALT, in front of the instruction at `next`; then back to the state before, true if it is RUN.
  void halt(Place next);
  // `step`: it is about to come back, and neither is told.
  void endHalt(bool step);
  void tellHaltLeft();
  // A single step leaves HALT and comes back to it; modules do not notice.
  void beginStep() { mode_ = beforeHalt_; }
  void endStep();
  // The clock went back to the instruction that HALT stands before.
  void stillHalted() { frozenAt_ = machine_.clock; }

  // STOP without an event, except that HALT has ended. True: the program was running.
  bool losePower();
  void startOff();  // loaded and switched off, in STOP since now
  // STOP or RUN as it was saved; nothing is reported.
  void stopQuietly();
  void runQuietly();
  void takeStop(const DiagnosticEvent& why, bool byFault);
  void forgiveFault() { stoppedByFault_ = false; }  // memory reset

 private:
  void change(Mode to);
  void goToStop(Event why, std::string reason, Place place, bool fault);
  void standStill();

  Machine& machine_;
  Parts parts_;
  Mode mode_ = Mode::Stop, beforeHalt_ = Mode::Run;
  Instant frozenAt_;
  DiagnosticEvent stopEvent_;
  bool stoppedByFault_ = false, resumable_ = false, stepping_ = false;
};

}  // namespace merker::cpu
