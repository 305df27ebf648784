// What lies around the PLC and its operating system looks at: modules on the periphery, the
// distributed unit, memory and EPROM, battery, the NC. Set from outside, at any time.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace merker::sinumerik {

// Bytes from here on are no periphery but the interface to the NC inside the control.
constexpr unsigned kPeripheryBytes = 64;

struct Module {
  bool output = false;
  unsigned first = 0, bytes = 1;
  bool distributed = false;  // in the expansion unit (EG)
  bool fitted = true;        // false: configured, but not there (6100)
  std::string name{};        // for whoever pulls it out
};

// The whole periphery: inputs and outputs 0..63.
std::vector<Module> standardModules();

// The expansion unit, looked at if MD 2002 bit 4 says that there is one (S5-MD-05).
struct DistributedUnit {
  bool answers = true, transmission = true, mains = true;
  bool overTemperature = false, changed = false;
};

enum class EpromFault : std::uint8_t { None, Synchronisation, Block, Checksum };

struct NcSide {
  bool alarm = false, machiningStop = false;                     // M 24.0, M 24.3
  bool probe1 = false, probe2 = false;                           // M 24.6, M 24.7
  std::uint8_t reloading = 0;                                    // MB 17
  std::uint16_t blocks1 = 0, blocks2 = 0;                        // MB 19-20, MB 21-22
  bool ringFull = false, ringEmpty = false, serialRuns = false;  // MB 23
  bool operator==(const NcSide&) const = default;
};

struct Surroundings {
  std::vector<Module> modules = standardModules();
  DistributedUnit unit;
  NcSide nc;
  bool batteryGood = true;
  bool jumpersRight = true;
  bool programMemoryFitted = true, dataMemoryFitted = true, memoryGap = false;
  EpromFault basicProgram = EpromFault::None;
  bool masterPlcRuns = true;
};

}  // namespace merker::sinumerik
