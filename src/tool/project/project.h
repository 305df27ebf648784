// A program as it is loaded from disk: sources, symbols, CPU. A project folder with merker.toml, or
// a single source.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <stop_token>
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
#include "source/symbol_table.h"

namespace merker::project {

// A block of a container file (*.mc7): its machine code runs, whatever a source of the same block
// declares for its interface (docs/formats/project.md).
struct MachineCode {
  std::string file;
  block::Block block;
};

struct Project {
  std::string path;    // as the user gave it
  std::string folder;  // where its files are
  std::string name;
  const CpuModel* model = &defaultCpuModel();
  bool modelKnown = true;  // false: merker.toml cannot be read, or names one that there is not
  // The PLC is that of a SINUMERIK: what follows up to `vertical` means nothing then.
  std::optional<cnc::Options> control;
  std::optional<Mnemonics> mnemonics;  // of AWL sources; each shows its own without it
  std::int64_t startOfClock = 0;       // milliseconds since 1990-01-01
  CpuParameters parameters = CpuParameters::of(defaultCpuModel());
  CommunicationParameters communication = CommunicationParameters::of(defaultCpuModel());
  Libraries libraries = standardLibraries();  // whose blocks it may call
  std::optional<io::Configuration> hardware;  // none: every address of the image answers
  plant::Configuration plants;
  std::optional<serial::Connection> serial;  // of X27; none: the partner of scenarios
  std::vector<OtherStation> stations;        // that it is connected to
  std::optional<Network> network;            // it has several stations and no program itself
  AddressCheck addressCheck = AddressCheck::Standard;
  bool vertical = false;         // mounting of the racks (S7-HW-19)
  std::uint32_t mpiAddress = 2;  // as settings.h has it
  std::vector<source::SourceFile> sources;
  std::vector<MachineCode> machineCode;
  std::vector<source::SourceFile> otherFiles;  // merker.toml and symbol files: for showing problems
  source::SymbolTable symbols;
  Problems problems;
  std::map<std::string, std::string> unsaved;  // what an editor has in place of files
  bool unreadable = false;                     // a file or the project itself could not be read

  // The file of this name, for the line under a problem; null if it was not read.
  const source::SourceFile* file(const std::string& name) const;
};

// Texts of files by their paths, in place of what stands on the disk.
using Unsaved = std::map<std::string, std::string>;

// `cpu`, unless empty, replaces the model. Never throws; everything that is wrong is in `problems`.
// `stop` ends the loading and what is done with the project afterwards: its compilation (P0713).
Project load(const std::string& path, const std::string& cpu, const Unsaved& unsaved = {},
             std::stop_token stop = {});

// A configuration without sources, as a memory card holds it: `text` is that of a merker.toml.
Project loadConfiguration(const std::string& path, const std::string& text, const std::string& cpu);
// The text of the project's merker.toml; empty without one.
std::string configurationText(const Project& project);

// Some sources as one program, with the symbol files of the same stems beside them.
Project loadSources(const std::string& path, const std::vector<std::string>& sources,
                    const std::string& cpu);

}  // namespace merker::project
