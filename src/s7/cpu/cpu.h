// The operating system of an S7-300: operating states, scan cycle, priority classes, faults. It
// knows no module, no machine code and no socket; an Engine executes, SystemServices answer system
// calls. Its parts own their data and know only the parts above them in the list of members; the
// Cpu moves time and connects them.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "catalogue/cpu_parameters.h"
#include "catalogue/module_event.h"
#include "cpu/clock_memory.h"
#include "cpu/engine.h"
#include "cpu/error.h"
#include "cpu/event_log.h"
#include "cpu/forces.h"
#include "cpu/image_faults.h"
#include "cpu/leds.h"
#include "cpu/load_memory.h"
#include "cpu/machine.h"
#include "cpu/mode_switch.h"
#include "cpu/module_events.h"
#include "cpu/modules.h"
#include "cpu/present_faults.h"
#include "cpu/quiet_cycles.h"
#include "cpu/requests.h"
#include "cpu/retention.h"
#include "cpu/scan_cycle.h"
#include "cpu/snapshot.h"
#include "cpu/startup.h"
#include "cpu/state_control.h"
#include "cpu/time_interrupts.h"
#include "plc/cycle_points.h"

namespace merker::cpu {

// What the running block does after a synchronous error.
enum class AfterError : std::uint8_t { GoOn, ErrorOb, Stopped };

using controller::CyclePoint;
using controller::CyclePoints;

class Cpu {
 public:
  Cpu(const CpuModel& model, Engine& engine, SystemServices& services, std::int64_t startOfClock);
  Cpu(const CpuModel& model, Engine& engine, SystemServices& services, std::int64_t startOfClock,
      CpuParameters parameters);
  // Fills load and work memory; the CPU is then as after memory reset.
  void load(std::shared_ptr<const block::Program> program);
  // The same program with blocks changed, added or deleted: in RUN at the next cycle checkpoint,
  // all of them at once (S7-CYCLE-05, S7-LIM-04). Unchanged blocks keep their values.
  void download(std::shared_ptr<const block::Program> program);

  // the parts
  Machine& machine() { return machine_; }
  const Machine& machine() const { return machine_; }
  const CpuParameters& parameters() const { return parameters_; }
  const LoadMemory& loadMemory() const { return loadMemory_; }
  const std::shared_ptr<const block::Program>& program() const { return loadMemory_.program(); }
  Modules& modules() { return modules_; }
  const Modules& modules() const { return modules_; }
  Forces& forces() { return forces_; }
  const Forces& forces() const { return forces_; }
  const ScanCycle& cycle() const { return cycle_; }
  Interrupts& interrupts() { return interrupts_.list(); }
  Requests& requests() { return requests_; }
  ModuleEvents& moduleEvents() { return moduleEvents_; }
  EventLog& log() { return log_; }
  const EventLog& log() const { return log_; }
  const Diagnostics& diagnostics() const { return log_.buffer(); }
  const RealTimeClock& clock() const { return clock_; }
  std::vector<RuntimeMeter>& runtimeMeters() { return runtimeMeters_; }
  const ModeSwitch& modeSwitch() const { return switch_; }
  const Startup& startup() const { return startup_; }

  const StateControl& state() const { return state_; }
  Mode mode() const { return state_.mode(); }
  bool powered() const { return powered_; }
  // Time that has passed in STARTUP and RUN since the last warm or cold restart (SFC 64).
  Duration systemTime() const { return state_.programTime() - systemStart_; }
  Leds leds() const;

  // operating states (S7-STATE)
  bool restart(Restart how);  // false: refused
  void stop(Event why) { state_.stop(why); }
  void stopByFault(Event why, std::string detail = {}) {
    state_.stopByFault(why, std::move(detail));
  }
  void memoryReset(Event how = Event::MemoryReset);
  void powerOff();
  // Not buffered: everything that was in RAM is lost (battery empty, card taken out).
  void powerOn(bool buffered = true);
  void turnSwitch(SwitchPosition to);
  void releaseSwitch();  // from STOP or MRES to RUN-P, without a start
  // STOP LED blinks; no start until memory reset.
  void requestMemoryReset();
  // Test operation (S7-STATE-07): HALT stops before the next instruction. False: not possible now.
  bool halt();
  // A step that comes back to HALT is no event; one that never does is told when it is given up.
  bool resume(bool step = false);
  void stepGivenUp() { state_.tellHaltLeft(); }
  // In HALT: one instruction, and HALT again.
  bool singleStep();
  // retentive memory (S7-MEM-02): as it is now, into `data`, whose events stay if none was added
  void retentive(block::RetentiveData& data) const;
  // For a CPU that was just loaded: it is then switched off and has this in its memory.
  void restore(const block::RetentiveData& data);
  // The full state, in STOP or in RUN between two cycles. take() restores it immediately, in any
  // operating state of a CPU of the same model and configuration.
  Snapshot snapshot() const;
  void take(const Snapshot& from, std::shared_ptr<const block::Program> program);

  // Timers by hand, of a simulator (S7-SIM-13): S5 timers keep the time that they show.
  void holdTimers(bool held) { timersHeld_ = held; }
  bool timersHeld() const { return timersHeld_; }

  // time
  bool betweenCycles() const { return machine_.levels.empty(); }
  void step(
      Instant limit);  // the next piece of work, not beyond limit unless an instruction crosses it
  // Once, without the rest of the cycle; false if it did not end within `most`: the next call goes
  // on with it.
  bool runOb1(Duration most);
  // Directly behind the end of a cycle: passes over further ones that are proven to be the same as
  // the last one. How many it were.
  std::uint64_t passQuiet(const QuietSpan& span);
  QuietCycles& quiet() { return quiet_; }
  const QuietCycles& quiet() const { return quiet_; }
  void setClock(std::int64_t milliseconds);  // time-of-day interrupts that are jumped over: OB 80
  void retrigger();                          // SFC 43
  // Somebody outside exchanges data: the cycle gets longer by the communication load.
  void communicate(bool active) { cycle_.communicate(active); }
  void onCheckpoint(std::function<void()> observer) { observer_ = std::move(observer); }
  void onCyclePoint(CyclePoints::Monitor monitor) { cyclePoints_.observe(std::move(monitor)); }

  // for engines; machine.position tells where
  AfterError synchronousError(const SyncError& error);
  bool callSystem(BlockId block, std::span<const std::uint32_t> parameters);
  // A system function met a programming error: its call ends with it (OB 121).
  void failSystemCall(const SyncError& error) { systemError_ = error; }
  SyncError takeSystemError() { return std::exchange(systemError_, SyncError{}); }
  // The next instruction of a running block, in bytes of its code.
  std::uint32_t offset(const Frame& frame) const { return engine_.offset(frame); }

 private:
  // cycle.cpp
  void move(Instant limit);
  void rest(Instant limit);
  void idle(Instant limit);
  void runTop(Instant limit);
  void runInstructions(Instant until);
  void enterRun();
  void startCycle();
  void endCycle();
  void endTopLevel();
  // quiet_pass.cpp
  bool atCheckpoint() const;
  bool predictable() const;
  CycleNumber cycleNumber() const;
  Checkpoint checkpoint() const;
  void passOver(const ProvenCycle& cycle, std::uint64_t cycles);
  DateAndTime dateAt(Instant when) const;
  void showDate(const DateAndTime& date);
  // image_update.cpp
  void updateImages();
  void imageFault(const ImageFault& fault);
  // events.cpp
  Instant nextEvent() const;
  void takeEvents();
  void takePeriphery();
  void skipTimesOfDay(std::uint8_t faultId);
  void cycleTimeExceeded();
  // restart.cpp
  bool startRefused(Restart how) const;
  void beginWarm(bool cold);
  void beginHot();
  void beginStartup(Restart how, std::size_t interrupted);
  void clearStacks();
  void clearSystemMemory(Extent extent);
  void prepareInterrupts();
  // halt.cpp
  void shiftTimers(Duration by);
  void shiftProgramTime(Duration by);
  // others
  void noteReplaced(const block::Program& before);
  void activateDownload();
  bool running() const;  // or it was when power went
  void takeTimes(const Snapshot& from, Duration shift);
  Light stopLight() const;

  Machine machine_;
  Engine& engine_;
  SystemServices& services_;
  CpuParameters parameters_;
  SyncError systemError_;
  RealTimeClock clock_;
  std::vector<RuntimeMeter> runtimeMeters_;
  PresentFaults faults_;
  CyclePoints cyclePoints_;
  EventLog log_;
  Modules modules_;
  LoadMemory loadMemory_;
  Retention retention_;
  ScanCycle cycle_;
  StateControl state_;
  TimeInterrupts interrupts_;
  Requests requests_;
  ModuleEvents moduleEvents_;
  Startup startup_;
  Forces forces_;
  ImageFaults imageFaults_;
  ClockMemory clockMemory_;
  ModeSwitch switch_;
  std::function<void()> observer_;
  QuietCycles quiet_;
  Outlook lastOutlook_;  // of the cycle that has ended last
  Instant cycleEnded_{INT64_MIN};

  bool powered_ = true, buffered_ = true, runningAtPowerOff_ = false;
  bool resetRequested_ = false, timersHeld_ = false;
  Instant systemStart_;
};

}  // namespace merker::cpu
