// The PLC of SINUMERIK 810/820 GA3, put together: a value built by arguments, in virtual time; no
// globals, any number of them live in one process. Everything outside works through this.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "softplc/programmer.h"

namespace merker::sinumerik {

// Battery-backed memory: segments 5 and 6 (S5-MEM-09).
struct Retained {
  std::vector<std::uint16_t> program, data;
};

class Plc {
 public:
  // Blocks of the program that the PLC does not take are named by refused().
  explicit Plc(const Options& options);
  ~Plc();
  Plc(Plc&&) noexcept;
  Plc& operator=(Plc&&) noexcept;

  const mc5::Program& program() const;
  const std::vector<std::string>& refused() const;

  // operating states
  Mode mode() const;
  bool stoppedByFault() const;     // STOP for another reason than STP, STS or the programmer
  std::string stopReason() const;  // empty while not in STOP
  bool coldStart();                // Neustart; false: an error stopped it
  bool warmStart();                // Wiederanlauf; false also if only a cold start is possible
  void stop();                     // as the programmer does it: alarm 6149
  void powerOff();
  // HALT: the program stands still in front of its next instruction, as it is; only time moves.
  // resume() continues there. False: no program runs, it is not in HALT.
  bool hold();
  bool resume();
  void holdNext();                     // within a step: before the next one
  void powerOn(bool buffered = true);  // starts; false: battery empty, the user memory is lost
  Retained retained() const;
  // For a new PLC: it is then switched off and has this in its memory; powerOn() goes on.
  void restore(const Retained& memory);

  // time; nothing moves outside these calls
  Instant now() const;
  std::uint64_t cycles() const;
  std::uint64_t instructions() const;
  // Up to t, also into the middle of a cycle; in STOP only time moves.
  void advanceTo(Instant t);
  // The same, at most to HALT or STOP; and at most to the next end of a cycle or of the start-up.
  void runTo(Instant t);
  void runToCheckpoint(Instant t);
  // On to the end of the cycle that runs now: there values are looked at from outside. False: it
  // has not ended within `longest`, or 10 s, or a start-up within its 200 ms. HALT is an end, too.
  bool settle(Duration longest = Duration::seconds(10));
  void advanceCycles(std::uint64_t count);
  // To the next end of a cycle or of the start-up, at most to `limit`; true if it came there.
  bool advanceToCheckpoint(Instant limit);
  // Off at first: an observer wants to see each cycle. When on, whatever moves time passes over
  // cycles that are the same as the one before; passQuietCycles() directly behind a checkpoint,
  // none that ends later than `limit`.
  void passOverQuietCycles(bool on);
  void passQuietCycles(Instant limit);
  void onCycle(std::function<void(Plc&)> observer);
  void onCyclePoint(controller::CyclePoints::Monitor monitor);
  // For measurements: OB 1 alone, and machine code of this computer now (operating_system.h).
  bool runOb1(Duration most);
  void translate();

  // values, see variable.h
  std::optional<std::uint32_t> read(const Reference& variable) const;
  bool write(const Reference& variable, std::uint32_t value);
  bool writeImage(const Reference& variable, std::uint32_t value);
  bool force(const Reference& variable, std::uint32_t value);
  void unforce();

  // Test functions (probe.h), see operating_system.h. The next instruction, also in HALT; nothing
  // between two cycles.
  bool probe(mc5::BlockId block, Probe* probe);
  const PlacedProbes& probes() const;
  std::optional<CodePlace> place() const;
  std::optional<Instant> heldSince() const;  // nothing unless in HALT

  std::vector<CheckResult> checkResults() const;
  // With Options::coverage; instructions that never ran are missing.
  const Executed& executed() const;

  // What happened, newest last, and what the screen shows.
  const std::vector<DiagnosticEntry>& diagnostics() const;
  std::vector<PendingAlarm> alarms() const;
  bool acknowledge(unsigned alarm);
  void raise(const Trap& trap);  // as the NC side finds it

  MachineData& machineData();  // taken over by the next start
  Surroundings& surroundings();
  const Surroundings& surroundings() const;
  Programmer programmer();
  // Share of STEP 5 in the last call raster, in tenths of a percent (S5-SCHED-07, -08).
  unsigned loadPerMille() const;
  // Registers and areas, for monitors.
  Machine& machine();
  const Machine& machine() const;
  const OperatingSystem& operatingSystem() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace merker::sinumerik
