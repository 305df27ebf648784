// The operating system of the PLC: operating states, call raster, levels, monitoring, alarms
// (S5-OB, S5-SCHED, S5-ERR). Moves the machine through virtual time, one instruction or one event
// a step; deterministic.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "softplc/alarm_input.h"
#include "softplc/alarm_list.h"
#include "softplc/engine.h"
#include "softplc/forces.h"
#include "softplc/interrupt_stack.h"
#include "softplc/options.h"
#include "softplc/probes.h"
#include "softplc/recorder.h"
#include "softplc/run_times.h"
#include "softplc/schedule.h"
#include "softplc/start_checks.h"
#include "softplc/transfer_flags.h"

namespace merker::sinumerik {

enum class Mode : std::uint8_t { Off, Stop, Startup, Run, Halt };
enum class Start : std::uint8_t { Cold, Warm };  // Neustart, Wiederanlauf

// Whether instructions are executed.
constexpr bool executes(Mode mode) { return mode == Mode::Startup || mode == Mode::Run; }

// Pseudo addresses F000 … F005 (S5-ERR-11).
struct FineCode {
  std::uint16_t code = 0;    // 00xx: FEHLCODE, 0 without STOP
  std::uint16_t number = 0;  // 61yy in BCD
  std::array<std::uint16_t, 3> words{};
  std::uint16_t delays = 0;  // zob2
};

class OperatingSystem {
 public:
  explicit OperatingSystem(const Options& options);
  OperatingSystem(const OperatingSystem&) = delete;
  OperatingSystem& operator=(const OperatingSystem&) = delete;

  // operating states
  Mode mode() const { return mode_; }
  bool start(Start kind);  // false: refused, or an error stopped it
  void stopByProgrammer();
  void powerOff();
  void powerOn(bool buffered);
  // Stops for an event that has no number of its own.
  void stopWithout(std::string text);
  // HALT (halt.cpp) in front of the next instruction or event; not within a step. False: no program
  // runs. A start, a STOP and power off leave it, too.
  bool hold();
  bool resume();
  void holdNext() { holdNext_ = executes(mode_); }   // the same, before the next step
  Instant heldSince() const { return held_.since; }  // in HALT
  // From now on each instruction of this block goes past the probe; null: none. Not within a step.
  // False: there is no such code block; it is looked at when it comes.
  bool probe(mc5::BlockId block, Probe* probe);
  const PlacedProbes& probes() const { return probes_.placed(); }

  // One instruction or one event, or to `limit` if nothing is to do.
  void step(Instant limit);
  bool betweenCycles() const { return machine_.levels.empty() && !cycleActive_; }
  std::uint64_t cycles() const { return cycles_; }
  std::uint64_t checkpoints() const { return checkpoints_; }
  std::uint64_t instructions() const { return processor_.instructions(); }
  void onCheckpoint(std::function<void()> observer) { observer_ = std::move(observer); }
  // For measurements: OB 1 once, back to back, without images, sampling and monitoring of times.
  // False if it did not end within `most`; the next call goes on with it then.
  bool runOb1(Duration most);
  // Machine code of this computer now, not only when it is needed.
  void translate();
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
  AlarmList& alarms() { return alarms_; }
  const AlarmList& alarms() const { return alarms_; }
  const FineCode& fineCode() const { return fineCode_; }
  const StopPicture& picture() const { return picture_; }
  ControlBits controlBits() const;
  void setControlBit(ControlBit bit, bool on) { controlBits_.set(bit, on); }
  const std::string& stopReason() const { return stopReason_; }
  bool stoppedByFault() const { return stoppedByFault_; }
  const Schedule& schedule() const { return schedule_; }
  const Recorder& recorder() const { return recorder_; }
  const RunTimes& runTimes() const { return times_; }
  const TimeBases& timeBases() const { return environment_.timeBases; }
  std::uint8_t segmentSwitch = 5;  // S5-MEM-03

  Forces<kImageBytes> forcedInputs, forcedOutputs;
  Forces<kFlagBytes> forcedFlags;

 private:
  // start_up.cpp
  void prepareStart(Start kind);
  void clearAreas(bool all);
  void takeMachineData();
  void lookAround();
  void beginRun();
  // cycle.cpp
  void beginCycle();
  void endCycle();
  bool runAlone(Instant latest);
  void readInputs();
  void writeOutputs();
  void showDiagnosis(Duration cycleTime);
  // alarm_level.cpp
  void sample();
  void ipoClock();
  void requestAlarmLevel(Edges edges);
  void beginAlarmLevel(Edges edges);
  void endAlarmLevel();
  // halt.cpp
  void delayProgram(Duration by);
  // operating_system.cpp
  bool macrosAreDue() const;
  void serveMacros();
  void runStep(Instant limit);
  void execute(Instant limit);
  void judgeRunTime(std::uint8_t ob);
  void levelEnded(std::uint8_t ob);
  bool executable() const;
  Duration shareOfThird() const;
  Duration alarmLimit() const;
  // compiled.cpp
  Instant horizon(Instant limit) const;
  bool runCompiled(Instant horizon);
  bool alarmLevelRuns() const;
  bool stops(Reaction reaction) const;
  void noteStop(const Trap& trap);
  void halt();
  void enterStop(const Trap& trap, ControlBit also);
  void show(const Trap& trap);
  void runChanges();
  std::string place() const;
  void passCheckpoint();

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
  AlarmInput alarmInput_;
  AlarmList alarms_;
  Checksums sums_;
  Schedule schedule_;
  RunTimes times_;

  Mode mode_ = Mode::Stop;
  struct {
    Mode mode = Mode::Stop;  // to go back to
    Instant since;
  } held_;
  bool holdNext_ = false;
  Start startKind_ = Start::Cold;
  bool warmInterrupted_ = false;  // power failed in OB 20 of a warm restart (S5-OB-03)
  bool memoryLost_ = false, runBeforePowerOff_ = false;
  bool cycleActive_ = false, requested_ = false;
  bool alarmTimeReported_ = false;
  Edges waitingEdges_;
  std::vector<bool> conditions_;  // of the surroundings, as last seen
  Instant cycleStart_, watchdog_ = Instant::never();
  std::uint64_t cycles_ = 0, checkpoints_ = 0;
  std::uint64_t compiledVersion_ = ~std::uint64_t{0};  // of the code that the engine has

  FineCode fineCode_;
  StopPicture picture_;
  std::optional<StopPicture> stpPicture_;
  ControlBits controlBits_;
  std::string stopReason_;
  bool stoppedByFault_ = false;
  std::vector<std::function<void()>> changes_;
  std::function<void()> observer_;
};

}  // namespace merker::sinumerik
