// The operating system of an S7-300: operating states, scan cycle, priority classes, faults. It
// knows no module, no machine code and no socket; an Engine executes, SystemServices answer system
// calls.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "catalogue/cpu_parameters.h"
#include "catalogue/module_event.h"
#include "cpu/clock_memory.h"
#include "cpu/cycle_monitoring.h"
#include "cpu/diagnostics.h"
#include "cpu/engine.h"
#include "cpu/error.h"
#include "cpu/event.h"
#include "cpu/forces.h"
#include "cpu/image_faults.h"
#include "cpu/interrupts.h"
#include "cpu/leds.h"
#include "cpu/load_memory.h"
#include "cpu/machine.h"
#include "cpu/mode_switch.h"
#include "cpu/modules.h"
#include "cpu/operating_state.h"
#include "cpu/present_faults.h"
#include "cpu/real_time_clock.h"
#include "cpu/runtime_meter.h"
#include "cpu/snapshot.h"
#include "plc/retentive.h"

namespace merker::cpu {

// What the running block does after a synchronous error.
enum class AfterError : std::uint8_t { GoOn, ErrorOb, Stopped };

// An entry of the diagnostic buffer, outside and back.
block::RetentiveEvent toRetentive(const DiagnosticEvent& event);
DiagnosticEvent toEvent(const block::RetentiveEvent& event, Duration shift);

// How much of M, T and Z outlives a restart, from number 0 (S7-CPU-28).
struct RetentiveRanges {
  std::uint32_t flags;  // bytes
  std::size_t timers, counters;
};

// Where a variable table monitors and modifies: before OB 1 with fresh inputs, behind OB 1 before
// the outputs go out, at the transition to STOP.
enum class CyclePoint : std::uint8_t { Begin, End, Stop };

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

  Machine& machine() { return machine_; }
  const Machine& machine() const { return machine_; }
  const CpuParameters& parameters() const { return parameters_; }
  const LoadMemory& loadMemory() const { return loadMemory_; }
  const std::shared_ptr<const block::Program>& program() const { return loadMemory_.program(); }
  Modules& modules() { return modules_; }
  const Modules& modules() const { return modules_; }
  Forces& forces() { return forces_; }
  const Forces& forces() const { return forces_; }
  Mode mode() const { return mode_; }
  bool powered() const { return powered_; }
  bool stoppedByFault() const { return stoppedByFault_; }
  const DiagnosticEvent& stopEvent() const { return stopEvent_; }
  const Diagnostics& diagnostics() const { return diagnostics_; }
  // The instant that timers see: they stand still in STOP and HALT (S7-TMR-22).
  Instant timerTime() const { return executes(mode_) ? machine_.clock : frozenAt_; }
  // Time that has passed in STARTUP and RUN since the last warm or cold restart (SFC 64).
  Duration systemTime() const { return timerTime() - systemStart_; }
  std::uint64_t cycles() const { return cycles_; }
  // Ends of cycles, and changes to RUN.
  std::uint64_t checkpoints() const { return checkpoints_; }
  Leds leds() const;

  // operating states (S7-STATE)
  bool restart(Restart how);  // false: refused
  void stop(Event why);       // a wish: switch, programming device, SFC 46
  void memoryReset(Event how = Event::MemoryReset);
  void powerOff();
  // Not buffered: everything that was in RAM is lost (battery empty, card taken out).
  void powerOn(bool buffered = true);
  void turnSwitch(SwitchPosition to);
  void releaseSwitch();  // from STOP or MRES to RUN-P, without a start
  const ModeSwitch& modeSwitch() const { return switch_; }
  // STOP LED blinks; no start until memory reset.
  void requestMemoryReset();
  // Test operation (S7-STATE-07): HALT stops before the next instruction. False: not possible now.
  bool halt();
  bool resume();
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

  // events from outside the program
  void moduleEvent(const ModuleEvent& event);
  // An asynchronous error (OB 80 to 87): entered, then its OB is asked for or the CPU stops
  // (S7-ERR-01). `start` as its OB will see it.
  void asynchronousError(const StartInformation& start, std::string_view detail = {});
  void setBattery(bool low);  // OB 81
  // Somebody outside exchanges data: the cycle gets longer by the communication load.
  void communicate(bool active) { communicating_ = active; }
  // Entries of the diagnostic buffer.
  void report(Event event);
  void report(std::uint16_t event, std::string text, Place place = {});
  // Of the user program or of a module; info: bytes 4..11 of the entry (S7-SFC-20).
  void note(std::uint16_t event, std::string text, const DiagnosticInformation& info);

  // time
  bool betweenCycles() const { return machine_.levels.empty(); }
  void step(
      Instant limit);  // the next piece of work, not beyond limit unless an instruction crosses it
  // Once, without the rest of the cycle; false if it did not end within `most`: the next call goes
  // on with it.
  bool runOb1(Duration most);
  void onCheckpoint(std::function<void()> observer) { observer_ = std::move(observer); }

  // for engines; machine.position tells where
  AfterError synchronousError(const SyncError& error);
  void stopByFault(Event why, std::string detail = {});
  bool callSystem(BlockId block, std::span<const std::uint32_t> parameters);

  // for test functions
  void onCyclePoint(std::function<void(CyclePoint)> monitor) { monitor_ = std::move(monitor); }
  // The next instruction of a running block, in bytes of its code.
  std::uint32_t offset(const Frame& frame) const { return engine_.offset(frame); }

  // for system functions
  RealTimeClock& clock() { return clock_; }
  void setClock(std::int64_t milliseconds);  // time-of-day interrupts that are jumped over: OB 80
  const RealTimeClock& clock() const { return clock_; }
  Interrupts& interrupts() { return interrupts_; }
  std::vector<RuntimeMeter>& runtimeMeters() { return runtimeMeters_; }
  const CycleTimes& cycleTimes() const { return cycleTimes_; }
  void retrigger();  // SFC 43
  bool hasOb(std::uint32_t number) const {
    return find(machine_.organizationBlocks, number) != nullptr;
  }
  DateAndTime dateAndTime() const;
  const StartInformation& lastStart() const { return lastStart_; }  // SFC 6

 private:
  // cycle.cpp
  void move(Instant limit);
  void idle(Instant limit);
  void rest(Instant limit);
  void runTop(Instant limit);
  void runInstructions(Instant until);
  void startCycle();
  void endCycle();
  void enterRun();
  Instant nextCycle() const;
  Duration cycleMonitoring() const { return Duration::milliseconds(parameters_.cycleMonitoring); }
  // image_update.cpp
  void updateImages();
  void imageFault(const ImageFault& fault);
  void reached(CyclePoint point);
  // levels.cpp
  bool startLevel(std::uint8_t ob, std::uint8_t priority, const StartInformation& start,
                  bool errorOb);
  void endLevel();
  void startWaiting();
  std::uint8_t priority() const;
  // events.cpp
  Instant nextEvent() const;
  void takeEvents();
  void takePeriphery();
  void takeCyclic();
  void takeDelayed();
  void takeTimeOfDay();
  void skipTimeOfDay(std::uint8_t faultId);
  void cycleTimeExceeded();
  void prepareInterrupts();
  void updateInterrupts();  // OBs have come or gone in RUN
  // requests.cpp
  void request(const StartInformation& start);
  void queue(StartInformation start);
  void timeError(std::uint8_t faultId, std::uint32_t info, const StartInformation& cause);
  void obMissing(const StartInformation& start);
  bool runsOrWaits(std::uint8_t ob) const;
  // module_events.cpp
  void hardwareInterrupt(const ModuleEvent& event);
  void hardwareInterruptEnded(const StartInformation& start);
  void storeHardwareInterrupt(const ModuleEvent& event, const StartInformation& start);
  // restart.cpp
  bool startRefused(Restart how) const;
  void beginWarm(bool cold);
  void beginHot();
  void beginStartup(Restart how);
  StartInformation startupInformation(Restart how) const;
  // retentive.cpp
  RetentiveRanges retentiveRanges() const;
  void keep(block::RetentiveData& data, const RetentiveRanges& ranges, bool allBlocks) const;
  void takeBack(const block::RetentiveData& data, const RetentiveRanges& ranges, bool allBlocks);
  // snapshot.cpp
  RetentiveRanges wholeMemory() const;
  void takeMeters(const block::RetentiveData& data, Duration shift);
  void takeTimes(const Snapshot& from, Duration shift);
  void clearStacks();
  void clearSystemMemory(bool all);
  void standStill();
  void goToStop(Event why, std::string reason, Place place, bool fault);
  void change(Mode to);
  // halt.cpp
  void shiftTimers(Duration by);
  void shiftProgramTime(Duration by);
  void activateDownload();
  // leds.cpp
  Light stopLight() const;
  // faults.cpp
  Place here() const;
  Place next() const;
  void report(const StartInformation& start, std::string text);
  DiagnosticEvent makeEvent(std::uint16_t event, std::string text, Place place) const;

  Machine machine_;
  Engine& engine_;
  SystemServices& services_;
  CpuParameters parameters_;
  Modules modules_;
  LoadMemory loadMemory_;
  RealTimeClock clock_;
  Diagnostics diagnostics_;
  Interrupts interrupts_;
  PresentFaults faults_;
  std::vector<RuntimeMeter> runtimeMeters_;
  Forces forces_;
  ImageFaults imageFaults_;
  ClockMemory clockMemory_;
  std::function<void()> observer_;
  std::function<void(CyclePoint)> monitor_;

  Mode mode_ = Mode::Stop, beforeHalt_ = Mode::Run;
  ModeSwitch switch_;
  bool stoppedByFault_ = false, resetRequested_ = false, timersHeld_ = false;
  bool powered_ = true, buffered_ = true, runningAtPowerOff_ = false;
  bool communicating_ = false;
  // The stacks are those of an interrupted program, which a hot restart may go on with.
  bool resumable_ = false;
  Restart lastRestart_ = Restart::ManualWarm;
  StartInformation lastStart_{};  // of the last startup, with or without its OB
  std::size_t restOfCycle_ = 0;   // levels below the startup OB: what a hot restart goes on with
  DiagnosticEvent stopEvent_;
  Instant frozenAt_;  // in STOP and HALT: when the program stood still
  Instant systemStart_;

  std::uint64_t cycles_ = 0, checkpoints_ = 0;
  std::uint8_t scan_ = 1;  // OB1_SCAN_1 of the next cycle
  Instant cycleStart_, nextCycle_;
  CycleMonitoring monitoring_;
  CycleTimes cycleTimes_;
};

}  // namespace merker::cpu
