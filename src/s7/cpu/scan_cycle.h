// The times of the scan cycle: when it began, when the next one begins (S7-HWCFG-08), what OB 1
// learns of the cycles before (S7-OBI-02), and cycle monitoring (S7-CYCLE-06).
#pragma once

#include <cstdint>

#include "catalogue/cpu_parameters.h"
#include "cpu/cycle_monitoring.h"
#include "cpu/cycle_times.h"
#include "cpu/operating_state.h"
#include "cpu/start_information.h"

namespace merker::cpu {

struct Snapshot;

class ScanCycle {
 public:
  // `share`: what the operating system takes of each cycle.
  ScanCycle(const CpuParameters& parameters, Duration share)
      : parameters_(parameters), share_(share) {}
  std::uint64_t count() const { return count_; }
  // Ends of cycles, and changes to RUN.
  std::uint64_t checkpoints() const { return checkpoints_; }
  const CycleTimes& times() const { return times_; }
  Instant began() const { return began_; }
  Instant next() const { return next_; }
  std::uint8_t scan() const { return scan_; }  // OB1_SCAN_1 of the next cycle
  // Somebody outside exchanges data: the cycle gets longer by the communication load.
  void communicate(bool active) { communicating_ = active; }

  void prepare(Restart how);  // a startup begins
  // RUN begins; `resumed`: in the middle of a cycle, after a hot restart.
  void enterRun(Instant now, bool resumed);
  void begin(Instant now);
  void end(Instant now);
  // Of OB 1 in the cycle that has begun.
  StartInformation startOfOb1(const DateAndTime& time);
  // So many cycles have passed, like the last one.
  void pass(std::uint64_t cycles, Duration by);
  // The program stood still.
  void delay(Duration by);

  // Cycle monitoring begins, or begins again.
  void monitor(Instant from);
  void monitorOff() { monitoring_.off(); }
  Instant deadline() const { return monitoring_.deadline(); }
  bool exceeded(Instant now) const { return monitoring_.exceeded(now); }
  // As CycleMonitoring::extend.
  bool extend() { return monitoring_.extend(); }

  void save(Snapshot& to) const;
  // A cycle that has not begun yet, or began long ago, begins now.
  void take(const Snapshot& from, Duration shift, Instant now);

 private:
  Instant afterThis(Instant now) const;

  const CpuParameters& parameters_;
  Duration share_;
  std::uint64_t count_ = 0, checkpoints_ = 0;
  std::uint8_t scan_ = 1;
  bool communicating_ = false;
  Instant began_, next_;
  CycleMonitoring monitoring_;
  CycleTimes times_;
};

}  // namespace merker::cpu
