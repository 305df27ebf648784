// The interrupts of time: which exist, when the next one is due, and what its OB learns (S7-BLK-08
// … -10, S7-CYCLE-04, S7-HWCFG-08).
#pragma once

#include <functional>

#include "catalogue/cpu_parameters.h"
#include "cpu/interrupts.h"
#include "cpu/machine.h"
#include "cpu/start_information.h"

namespace merker::cpu {

class TimeInterrupts {
 public:
  TimeInterrupts(const Machine& machine, const RealTimeClock& clock,
                 const CpuParameters& parameters)
      : machine_(machine), clock_(clock), parameters_(parameters) {}
  // For system functions, which set, cancel and lock them.
  Interrupts& list() { return list_; }
  const Interrupts& list() const { return list_; }

  // Which exist: those whose OB is loaded. All that was set before is forgotten (S7-STATE-09).
  void prepare();
  // OBs have come or gone; in RUN a new cyclic interrupt begins now.
  void update(bool run);
  void beginCyclic();
  void delay(Duration by);  // the program stood still

  // While the CPU is in RUN.
  Instant next() const;
  using Request = std::function<void(const StartInformation&)>;
  // What is due now: delayed, time of day, cyclic.
  void requestDue(const Request& request);
  // Times of day that were jumped over do not start their OB (S7-OBI-07): bit n for OB 10 + n.
  unsigned skipTimesOfDay();

  // As saved, of those that this program has.
  void take(const Interrupts& from, Duration shift);

 private:
  StartInformation startOf(std::uint8_t ob) const;
  void requestDelayed(const Request& request);
  void requestTimesOfDay(const Request& request);
  void requestCyclic(const Request& request);

  const Machine& machine_;
  const RealTimeClock& clock_;
  const CpuParameters& parameters_;
  Interrupts list_;
};

}  // namespace merker::cpu
