// The operating system of the PLC: operating states, call raster, levels, monitoring, alarms
// (S5-OB, S5-SCHED, S5-ERR). Moves the machine through virtual time, one instruction or one event
// a step; deterministic.
#pragma once

#include <functional>
#include <string>

#include "plc/cycle_points.h"
#include "softplc/alarm_level.h"
#include "softplc/alarm_record.h"
#include "softplc/changes.h"
#include "softplc/compiled_code.h"
#include "softplc/conditions.h"
#include "softplc/cycle_watch.h"
#include "softplc/operating_state.h"
#include "softplc/options.h"
#include "softplc/process_images.h"
#include "softplc/quiet_cycles.h"
#include "softplc/run_times.h"
#include "softplc/schedule.h"
#include "softplc/start_checks.h"

namespace merker::sinumerik {

class OperatingSystem {
 public:
  explicit OperatingSystem(const Options& options);
  OperatingSystem(const OperatingSystem&) = delete;
  OperatingSystem& operator=(const OperatingSystem&) = delete;

  // operating states
  Mode mode() const { return state_.mode(); }
  bool start(Start kind);  // false: refused, or an error stopped it
  void stopByProgrammer();
  void powerOff();
  void powerOn(bool buffered);
  // HALT (halt.cpp) in front of the next instruction or event; not within a step. False: no program
  // runs. A start, a STOP and power off leave it, too.
  bool hold() { return state_.hold(machine_.clock); }
  bool resume();
  void holdNext() { state_.holdNext(); }                    // the same, before the next step
  Instant heldSince() const { return state_.heldSince(); }  // in HALT
  // From now on each instruction of this block goes past the probe; null: none. Not within a step.
  // False: there is no such code block; it is looked at when it comes.
  bool probe(mc5::BlockId block, Probe* probe);
  const PlacedProbes& probes() const { return probes_.placed(); }

  // One instruction or one event, or to `limit` if nothing is to do.
  void step(Instant limit);
  // Directly behind the end of a cycle: passes over further ones that are proven to be the same as
  // the last one, not beyond `limit`, at most so many.
  void passQuiet(Instant limit, std::uint64_t most = UINT64_MAX);
  QuietCycles& quiet() { return quiet_; }
  const QuietCycles& quiet() const { return quiet_; }
  bool betweenCycles() const { return machine_.levels.empty() && !cycleActive_; }
  std::uint64_t cycles() const { return cycles_; }
  std::uint64_t checkpoints() const { return checkpoints_; }
  std::uint64_t instructions() const { return processor_.instructions(); }
  void onCheckpoint(std::function<void()> observer) { observer_ = std::move(observer); }
  void onCyclePoint(controller::CyclePoints::Monitor monitor) {
    cyclePoints_.observe(std::move(monitor));
  }
  // For measurements: OB 1 once, back to back, without images, sampling and monitoring of times.
  // False if it did not end within `most`; the next call goes on with it then.
  bool runOb1(Duration most);
  // Machine code of this computer now, not only when it is needed.
  void translate() { compiled_.translate(); }
  // Done now or, while the program runs, between two cycles: blocks move then.
  void betweenCycles(std::function<void()> change);

  // An alarm with its reaction, as conditions and macros raise it.
  void raise(const Trap& trap, ControlBit also = ControlBit::NONE);
  void setTerminal(unsigned inputByte, std::uint8_t value);
  // Code was loaded or deleted: its sums count from now on.
  void blocksChanged();

  Machine& machine() { return machine_; }
  const Machine& machine() const { return machine_; }
  const Options& options() const { return options_; }
  MachineData& machineData() { return data_; }
  Surroundings& surroundings() { return around_; }
  const Surroundings& surroundings() const { return around_; }
  ImageForces& forces() { return images_.forces; }
  const ImageForces& forces() const { return images_.forces; }
  AlarmRecord& record() { return record_; }
  const AlarmRecord& record() const { return record_; }
  ControlBits controlBits() const;  // those of the record, and what the operating state shows
  const Schedule& schedule() const { return schedule_; }
  const Recorder& recorder() const { return recorder_; }
  const RunTimes& runTimes() const { return times_; }
  const TimeBases& timeBases() const { return environment_.timeBases; }
  std::uint8_t segmentSwitch = 5;  // S5-MEM-03

 private:
  // start_up.cpp
  void prepareStart(Start kind);
  void clearAreas(bool all);
  void takeMachineData();
  void lookAround();
  void beginRun();
  // cycle.cpp
  void beginCycle();
  bool readInputs();
  void endCycle();
  bool runAlone(Instant latest);
  void passCheckpoint();
  // quiet_pass.cpp
  bool atCheckpoint() const;
  bool predictable() const;
  Instant nextEvent() const;
  Checkpoint checkpoint() const;
  // sampling.cpp
  void sample();
  void ipoClock();
  void sampleAlarms(Instant at);
  void endAlarmLevel();
  void judgeRunTime(std::uint8_t ob);
  Duration alarmLimit() const { return Duration::microseconds(active_.word(3)); }
  Duration cycleLimit() const { return Duration::milliseconds(active_.word(5)); }
  // operating_system.cpp
  bool macrosAreDue() const;
  void serveMacros();
  void runStep(Instant limit);
  void levelEnded(std::uint8_t ob);
  void raise(const std::optional<Trap>& trap);  // if there is one
  void halt();
  // execution.cpp
  void execute(Instant limit);
  bool executable() const;
  Duration shareOfThird() const;
  Instant horizon(Instant limit) const;
  bool runCompiled(Instant horizon);
  void charge(std::uint8_t ob, Duration time);

  const Options options_;
  MachineData data_;
  MachineData active_;  // as the last start took them over
  Surroundings around_;
  Machine machine_;
  Environment environment_;
  Processor processor_;
  TransferFlags flags_;
  Recorder recorder_;
  Probes probes_;
  CompiledCode compiled_;
  ProcessImages images_;
  Schedule schedule_;
  RunTimes times_;
  CycleWatch watch_;
  AlarmLevel alarmLevel_;
  Conditions conditions_;
  AlarmRecord record_;
  OperatingState state_;
  Changes changes_;
  Checksums sums_;

  bool memoryLost_ = false;
  bool cycleActive_ = false, requested_ = false;
  std::uint64_t cycles_ = 0, checkpoints_ = 0, raised_ = 0;
  QuietCycles quiet_;
  Instant cycleEnded_{INT64_MIN};
  controller::CyclePoints cyclePoints_;
  std::function<void()> observer_;
};

}  // namespace merker::sinumerik
