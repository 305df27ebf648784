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

#include "block/retentive.h"
#include "cpu/diagnostics.h"
#include "cpu/engine.h"
#include "cpu/error.h"
#include "cpu/event.h"
#include "cpu/interrupts.h"
#include "cpu/machine.h"
#include "cpu/real_time_clock.h"
#include "cpu/runtime_meter.h"

namespace merker::cpu {

enum class Mode : std::uint8_t { Stop, Startup, Run };
enum class Restart : std::uint8_t { ManualWarm, AutomaticWarm, ManualCold };
// What the running block does after a synchronous error.
enum class AfterError : std::uint8_t { GoOn, ErrorOb, Stopped };

struct CycleTimes {  // ms, as OB 1 sees them (S7-OBI-02)
  std::int32_t previous = 0, shortest = 0, longest = 0;
  bool any = false;
  void add(Duration cycle) {
    previous = static_cast<std::int32_t>(cycle.ns / 1'000'000);
    shortest = any && shortest < previous ? shortest : previous;
    longest = any && longest > previous ? longest : previous;
    any = true;
  }
};

// How much of M, T and Z outlives a restart, from number 0 (S7-CPU-28).
struct RetentiveRanges {
  std::uint32_t flags;  // bytes
  std::size_t timers, counters;
};

struct Force {
  std::uint32_t byte;  // of areas.image
  std::uint8_t mask, value;
};

// Where a variable table monitors and modifies: before OB 1 with fresh inputs, behind OB 1 before
// the outputs go out, at the transition to STOP.
enum class CyclePoint : std::uint8_t { Begin, End, Stop };

class Cpu {
 public:
  Cpu(const CpuModel& model, Engine& engine, SystemServices& services, std::int64_t startOfClock);
  // Fills load and work memory; the CPU is then as after memory reset.
  void load(std::shared_ptr<const block::Program> program);

  Machine& machine() { return machine_; }
  const Machine& machine() const { return machine_; }
  Mode mode() const { return mode_; }
  bool stoppedByFault() const { return stoppedByFault_; }
  const DiagnosticEvent& stopEvent() const { return stopEvent_; }
  const Diagnostics& diagnostics() const { return diagnostics_; }
  // The instant that timers see: they stand still in STOP (S7-TMR-22).
  Instant timerTime() const { return mode_ == Mode::Stop ? stoppedAt_ : machine_.clock; }
  std::uint64_t cycles() const { return cycles_; }
  // Ends of cycles, and changes to RUN.
  std::uint64_t checkpoints() const { return checkpoints_; }

  // operating states (S7-STATE)
  bool restart(Restart how);  // false: refused
  void stop(Event why);       // a wish: switch, programming device, SFC 46
  void memoryReset();
  void powerOff();
  void powerOn();
  // retentive memory (S7-MEM-02): as it is now, into `data`, whose events stay if none was added
  void retentive(block::RetentiveData& data) const;
  // For a CPU that was just loaded: it is then switched off and has this in its memory.
  void restore(const block::RetentiveData& data);

  // time
  bool betweenCycles() const { return machine_.levels.empty(); }
  void step(
      Instant limit);  // the next piece of work, not beyond limit unless an instruction crosses it
  void runOb1();       // once, without the rest of the cycle
  void onCheckpoint(std::function<void()> observer) { observer_ = std::move(observer); }
  // Bits of E, A, M that keep their value (mask and value over areas.image); applied around each
  // OB 1.
  void force(std::uint32_t imageByte, std::uint8_t mask, std::uint8_t value);
  void unforce() { forces_.clear(); }
  void unforce(std::uint32_t imageByte, std::uint8_t mask);
  const std::vector<Force>& forces() const { return forces_; }

  // for engines; machine.position tells where
  AfterError synchronousError(const SyncError& error);
  void stopByFault(Event why, std::string detail = {});
  bool callSystem(BlockId block, std::span<const std::uint32_t> parameters);

  // for test functions
  bool probe(BlockId block, Probe* probe);  // false: no such code block
  void onCyclePoint(std::function<void(CyclePoint)> monitor) { monitor_ = std::move(monitor); }
  // The next instruction of a running block, in bytes of its code.
  std::uint32_t offset(const Frame& frame) const { return engine_.offset(frame); }

  // for system functions
  RealTimeClock& clock() { return clock_; }
  Interrupts& interrupts() { return interrupts_; }
  std::vector<RuntimeMeter>& runtimeMeters() { return runtimeMeters_; }
  // An entry of the user program or of a module; info: bytes 4..11 of the entry (S7-SFC-20).
  void note(std::uint16_t event, std::string text, const std::array<std::uint8_t, 8>& info);
  const CycleTimes& cycleTimes() const { return cycleTimes_; }
  void retrigger();  // SFC 43
  bool hasOb(std::uint32_t number) const {
    return find(machine_.organizationBlocks, number) != nullptr;
  }

 private:
  // cycle.cpp
  void idle(Instant limit);
  void runTop(Instant limit);
  void startCycle();
  void endCycle();
  void enterRun();
  void applyForces();
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
  void takeCyclic();
  void takeDelayed();
  void takeTimeOfDay();
  void cycleTimeExceeded();
  void request(std::uint8_t ob, const StartInformation& start);
  void timeError(std::uint8_t faultId, std::uint16_t info, std::uint8_t ob);
  bool runsOrWaits(std::uint8_t ob) const;
  void prepareInterrupts();
  // restart.cpp
  RetentiveRanges retentiveRanges() const;  // retentive.cpp
  void clearStacks();
  void clearSystemMemory(bool all);
  void goToStop(DiagnosticEvent event, bool fault);
  // faults.cpp
  Place here() const;
  DateAndTime dateAndTime() const;
  void report(std::uint16_t event, std::string text, Place place = {});
  void record(DiagnosticEvent event);  // stamps and stores it

  Machine machine_;
  Engine& engine_;
  SystemServices& services_;
  std::shared_ptr<const block::Program> program_;
  std::vector<std::unique_ptr<Code>> code_;
  RealTimeClock clock_;
  Diagnostics diagnostics_;
  Interrupts interrupts_;
  std::vector<RuntimeMeter> runtimeMeters_;
  std::vector<Force> forces_;
  std::function<void()> observer_;
  std::function<void(CyclePoint)> monitor_;

  Mode mode_ = Mode::Stop;
  bool stoppedByFault_ = false;
  bool powered_ = true, runningAtPowerOff_ = false;
  DiagnosticEvent stopEvent_;
  Instant stoppedAt_;

  std::uint64_t cycles_ = 0, checkpoints_ = 0;
  std::uint8_t scan_ = 1;  // OB1_SCAN_1 of the next cycle
  Instant cycleStart_, nextCycle_, watchdog_ = Instant::never();
  bool watchdogWarned_ = false;
  CycleTimes cycleTimes_;
};

}  // namespace merker::cpu
