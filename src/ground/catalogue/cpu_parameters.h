// What HW Konfig lets one set on a CPU (S7-HWCFG-08). Values are checked where they are read
// (project); the CPU takes them as they are.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "catalogue/cpu_model.h"

namespace merker {

// OB 30..38: called every `interval` ms, `phase` ms behind the common beginning (S7-BLK-10).
struct CyclicParameter {
  std::uint8_t ob = 35;
  std::int32_t interval = 100, phase = 0;
};

// OB 10..17, set without a call of SFC 28 (S7-BLK-08).
struct TimeOfDayParameter {
  std::uint8_t ob = 10;
  bool active = false;
  std::uint16_t period = 0;  // as PERIOD of SFC 28: 16#0201 every minute …
  std::int64_t start = 0;    // ms since 1990-01-01
};

// When OB 85 is called for errors while the process image is updated.
enum class ImageErrors : std::uint8_t { None, EachCycle, ComingAndGoing };

// What a CPU that was running does when power returns; Hot and Cold where the model has them.
enum class PowerOnStart : std::uint8_t { Warm, Hot, Cold };

struct CpuParameters {
  std::uint32_t cycleMonitoring = 150;       // ms, 1..6000 (S7-CPU-29)
  std::uint32_t minimumCycle = 0;            // ms; 0 = off
  std::uint32_t communicationLoad = 20;      // %, 10..50
  std::optional<std::uint32_t> clockMemory;  // number of the flag byte (S7-MEM-01)
  std::uint32_t retentiveFlags = 16, retentiveTimers = 0, retentiveCounters = 8;  // from number 0
  std::vector<CyclicParameter> cyclic;  // only those that differ from the default
  std::vector<TimeOfDayParameter> timeOfDay;
  ImageErrors imageErrors = ImageErrors::None;
  PowerOnStart afterPowerOn = PowerOnStart::Warm;
  bool startOnMismatch = true;  // start although the modules differ from the configuration
  std::uint8_t protection = 1;  // level 1..3 (S7-MEM-05)
  std::string password;

  static CpuParameters of(const CpuModel& model) {
    CpuParameters parameters;
    parameters.cycleMonitoring = model.cycleMonitoring;
    parameters.retentiveFlags = model.retentiveFlags;
    parameters.retentiveTimers = model.retentiveTimers;
    parameters.retentiveCounters = model.retentiveCounters;
    return parameters;
  }
};

}  // namespace merker
