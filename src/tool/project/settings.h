// What merker.toml says. All keys are optional; a key that is not known is a problem, so that no
// typing error passes.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "catalogue/block_library.h"
#include "catalogue/communication.h"
#include "catalogue/cpu_parameters.h"
#include "control/cnc.h"
#include "io/configuration.h"
#include "plant/configuration.h"
#include "project/address_check.h"
#include "project/network.h"
#include "project/other_station.h"
#include "serial/connection.h"
#include "source/source_file.h"

namespace merker::project {

// A pattern with its place in the file, for the problem that it matches nothing.
struct Pattern {
  std::string text;
  Position position;
};

// A PLC of either family; exactly one is not null.
struct Model {
  const CpuModel* simatic = nullptr;
  const SinumerikModel* sinumerik = nullptr;
};
std::optional<Model> findModel(std::string_view name);

// S7-NET-03: what a new CPU has; 0 is the programming device, 1 an operator panel.
constexpr std::uint32_t kCpuMpiAddress = 2, kHighestMpiAddress = 126;

struct Settings {
  std::string name;
  const CpuModel* model = &defaultCpuModel();
  std::optional<cnc::Options> control;  // the PLC is that of a SINUMERIK; `model` means nothing
  std::int64_t startOfClock = 0;        // milliseconds since 1990-01-01
  std::optional<std::vector<Pattern>> sources, symbols;
  std::optional<Mnemonics> mnemonics;  // of the sources; each shows its own without it
  CpuParameters parameters;
  CommunicationParameters communication{};
  Libraries libraries = standardLibraries();
  // Without [hardware], [[module]] and [[plant]] there is none: docs/compatibility.md, "Without a
  // hardware configuration".
  std::optional<io::Configuration> hardware;
  plant::Configuration plants;
  std::optional<serial::Connection> serial;  // of X27; none: the partner of scenarios
  std::vector<OtherStation> stations;
  std::optional<Network> network;  // a project of several stations: only the name counts then
  AddressCheck addressCheck = AddressCheck::Standard;
  bool vertical = false;  // mounting (S7-HW-19)
  std::uint32_t mpiAddress = kCpuMpiAddress;
};

// `model` replaces the CPU that the file names.
Settings readSettings(const source::SourceFile& file, Problems& problems,
                      std::optional<Model> model = std::nullopt);

// "314C-2 PtP, generic, …", for problems.
std::string modelNames();

// What the CPU's clock shows when a station is switched on, unless the project says otherwise:
// always the same, so that two runs are the same. 1994-01-01-00:00:00.000, the clock of a CPU whose
// battery was flat.
std::int64_t defaultStartOfClock();

}  // namespace merker::project
