// What stands where: the racks as HW Konfig draws them, with addresses and parameters. Made from
// merker.toml by `project`, completed and checked here, put into operation by `Rack`.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/problem.h"
#include "catalogue/cpu_model.h"
#include "catalogue/measuring_range.h"
#include "catalogue/module_type.h"
#include "clock/instant.h"
#include "io/axis_channel.h"
#include "io/count_channel.h"

namespace merker {
struct CpWebParameters;  // catalogue/communication.h
}
namespace merker::serial {
struct Parameters;
}

namespace merker::io {

struct DpMaster;  // io/slave.h
struct OwnSlave;  // the same
struct AsiSlave;  // io/asi.h

// What outputs do while the CPU is not in RUN (S7-STATE-02, S7-HWCFG-09).
enum class OnStop : std::uint8_t { Zero, Keep, Substitute };

struct AnalogInput {
  const MeasuringRange* range = nullptr;  // null: channel deactivated, shows 32767
  bool wireBreakCheck = false;
  std::optional<double> upperLimit, lowerLimit;  // hardware interrupt beyond, in the range's unit
};

struct AnalogOutput {
  const MeasuringRange* range = nullptr;  // null: deactivated, puts out nothing
  double substitute = 0;                  // in the range's unit
};

struct Parameters {
  Duration inputDelay;
  std::uint32_t risingEdges = 0, fallingEdges = 0;  // hardware interrupt, a bit for each channel
  bool diagnosticInterrupt = false;
  OnStop onStop = OnStop::Zero;
  std::uint32_t substituteBits = 0;  // digital outputs
  std::array<AnalogInput, 8> analogInputs;
  std::array<AnalogOutput, 8> analogOutputs;
  bool hardwareInterrupt = false;  // sub-module 2.4: interrupt selection "process" (CNT-PARAM-02)
  std::array<CountChannel, 4> counters;
  std::optional<AxisChannel> axis;                   // sub-module 2.5, if it is in use
  std::shared_ptr<const serial::Parameters> serial;  // sub-module 2.1; null: another one

  static Parameters of(const ModuleType& type);  // as HW Konfig places the module
};

struct Module {
  const ModuleType* type = nullptr;
  std::uint32_t rack = 0, slot = 0;
  std::uint32_t subslot = 0;  // 1 to 5 on board of the CPU in slot 2, else 0
  std::string name;           // what scenarios call it; empty: its slot
  std::optional<std::uint32_t> inputStart,
      outputStart;              // logical addresses; none if it has no such
  std::optional<double> cable;  // m, interface modules
  Parameters parameters;
  // Where it stands in merker.toml: the table and, if they are there, its keys. Line 0 of
  // `position`: the module is on board and not mentioned.
  Position position, slotPosition, rackPosition, inputPosition, outputPosition, cablePosition;
  // Of a DP slave: `type` if it is in no catalogue; of its head what OB 86 says of it, the
  // diagnostic address of the master and RACKS_FLTD.
  std::shared_ptr<const ModuleType> own{};
  std::uint16_t master = 0;
  std::uint32_t station = 0;
  bool consistent = false;  // an area of an intelligent slave: all its bytes belong together
  // Of a CP 343-2: what is on its AS-Interface. Of such a slave: the number of the CP in the
  // configuration, and which of its data bits are what.
  std::shared_ptr<const std::vector<AsiSlave>> asi{};
  std::optional<std::uint32_t> asiCp{};
  std::uint8_t asiInputs = 0, asiOutputs = 0;
  std::shared_ptr<const CpWebParameters> web{};  // of a CP 343-1 IT

  std::string slotText() const;  // "4", "1/4", "2.2", "DP3/4" of the slave with address 3,
                                 // "AS4/7" of the AS-i slave 7 at the CP in slot 4
  std::string title() const;     // "SM 321 DI16xDC24V", "DI24/DO16 on board"
  std::uint32_t inputEnd() const { return *inputStart + type->inputBytes - 1; }
  std::uint32_t outputEnd() const { return *outputStart + type->outputBytes - 1; }
  bool onBoard() const { return subslot != 0; }
};

// Sorted by rack, slot, sub-slot.
struct Configuration {
  std::vector<Module> modules;
  const CpuModel* model = nullptr;
  std::shared_ptr<const DpMaster> dp{};        // null: no DP slaves
  std::shared_ptr<const OwnSlave> ownSlave{};  // null: it is no DP slave

  // By name or slot ("Conveyor", "4", "1/4", "2.2"), ignoring case; null if there is none.
  const Module* find(std::string_view name) const;
  // Whether any module answers there.
  bool hasInput(std::uint32_t byte) const;
  bool hasOutput(std::uint32_t byte) const;
  // Of the sub-module 2.5; null if there is none.
  const AxisChannel* axis() const;
};
// Whether the axis has this analog output: AO 0 on board (POS-OVW-07).
bool isOfAxis(const Configuration& configuration, const Module& module, std::uint32_t output);

// Adds the on-board sub-modules that are not mentioned, sorts, gives each module without an address
// its slot's default (S7-HW-20 to -25) and checks all mounting rules (S7-HW-12 to -17, -28, -33,
// -34) and limits (S7-CPU-11 to -14).
Configuration configure(std::vector<Module> modules, const CpuModel& model, Problems& problems);

// Default start addresses of a slot (S7-HW-20, -21).
constexpr std::uint32_t digitalStart(std::uint32_t rack, std::uint32_t slot) {
  return 32 * rack + 4 * (slot - 4);
}
constexpr std::uint32_t analogStart(std::uint32_t rack, std::uint32_t slot) {
  return 256 + 128 * rack + 16 * (slot - 4);
}

// mA that the modules of a rack take from its backplane bus, and what it supplies (S7-HW-14).
struct Current {
  std::uint32_t taken = 0, possible = 0;
};
Current current(const Configuration& configuration, std::uint32_t rack);

struct Channels {
  std::uint32_t digitalInputs = 0, digitalOutputs = 0, analogInputs = 0, analogOutputs = 0;
  std::uint32_t digital() const { return digitalInputs + digitalOutputs; }
  std::uint32_t analog() const { return analogInputs + analogOutputs; }
};
Channels channels(const Configuration& configuration);

}  // namespace merker::io
