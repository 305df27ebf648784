// What a source holds for one program, from whatever format it came.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "s7p/folder.h"
#include "s7p/symbols.h"
#include "source/source_file.h"

namespace merker::importing {

struct TextFile {
  std::string name;  // as the manager or the disk calls it
  std::string text;  // UTF-8
  bool awl = true;
  bool step5 = false;
};

struct HardwareModule {
  std::uint32_t rack = 0, slot = 0, subslot = 0;
  std::string orderNumber, name;
  std::optional<std::uint32_t> input, output;
};

struct Material {
  std::string name;  // of the program
  std::string station, cpu, cpuOrderNumber;
  std::string model;  // of the project that it goes into; empty: it brings its own CPU
  std::vector<s7p::StoredBlock> blocks;
  std::vector<s7p::SymbolRow> symbols;
  // Sources that belong to stored blocks, drafts, other languages.
  std::vector<TextFile> sources;
  // Files that are parts of the project as they are: sources without blocks beside, symbol tables.
  std::vector<TextFile> files;
  std::vector<TextFile> foreign;  // in other languages, without blocks beside
  std::vector<s7p::VariableTable> tables;
  std::vector<HardwareModule> modules;
  std::size_t modulesLeftOut = 0;  // a station has less
  bool fromProject = false;        // an S7P
  bool step5 = false;              // `files` are listings and their symbols; nothing of STEP 7
  bool empty() const {
    return blocks.empty() && symbols.empty() && files.empty() && modules.empty() &&
           sources.empty() && foreign.empty();
  }
};

}  // namespace merker::importing
