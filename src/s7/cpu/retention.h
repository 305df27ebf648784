// What outlives a power failure (S7-MEM-02, S7-CPU-28), handed out and taken back; and all memory,
// for a snapshot (S7-SIM-13).
#pragma once

#include <vector>

#include "catalogue/cpu_parameters.h"
#include "cpu/event_log.h"
#include "cpu/runtime_meter.h"
#include "plc/retentive.h"

namespace merker::cpu {

// An entry of the diagnostic buffer, outside and back.
block::RetentiveEvent toRetentive(const DiagnosticEvent& event);
DiagnosticEvent toEvent(const block::RetentiveEvent& event, Duration shift);

enum class Extent : std::uint8_t { Retentive, All };

class Retention {
 public:
  struct Parts {
    RealTimeClock& clock;
    EventLog& log;
    std::vector<RuntimeMeter>& meters;
  };
  Retention(Machine& machine, const CpuParameters& parameters, const Parts& parts)
      : machine_(machine), parameters_(parameters), parts_(parts) {}

  // Memory as it is now; events stay if none was added. `standing`: since when the timers have
  // stood still.
  void keep(block::RetentiveData& data, Extent extent, Duration standing) const;
  // Meters are off then (S7-SFC-03).
  void takeBack(const block::RetentiveData& data, Extent extent);
  // As before a power failure that was none: meters go on.
  void takeMeters(const block::RetentiveData& data);
  // Flags, timers, counters: all of them, or those beyond the retentive ranges (S7-STATE-09).
  void clear(Extent extent);

 private:
  // How much of M, T and Z, from number 0.
  struct Ranges {
    std::uint32_t flags;  // bytes
    std::size_t timers, counters;
  };
  Ranges ranges(Extent extent) const;

  Machine& machine_;
  const CpuParameters& parameters_;
  Parts parts_;
};

}  // namespace merker::cpu
