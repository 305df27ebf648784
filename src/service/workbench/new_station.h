// New stations, new global data and connections in the merker.toml of several stations
// (S7-NETPRO-02, -05).
#pragma once

#include "workbench/workspace.h"

namespace merker::workbench {

struct NewStation {
  std::string name, model, form, subnet;  // subnet: empty: none
  std::uint32_t address = 2;
  Mnemonics mnemonics = Mnemonics::German;
};

struct NewCircle {
  std::string from;
  std::vector<std::string> to;
  std::uint32_t rate = 8;
};

struct NewLink {
  std::string local, partner, subnet;  // subnet: empty: the first one of both
  bool both = false;                   // the partner's blocks name it, too
};

// `path`: of the project. All give it back; what is wrong leaves the files as they were.
Result<std::string> addStation(const std::string& path, const NewStation& wanted);
Result<std::string> addCircle(const std::string& path, const NewCircle& wanted);
// A configured connection with the lowest free local IDs (S7-NETPRO-08).
Result<std::string> addLink(const std::string& path, const NewLink& wanted);
// A project of several stations, so far with one: a copy of the project in `from`.
Result<std::string> makeNetwork(const Workspace& workspace, const std::string& name,
                                const std::string& station, const std::string& from,
                                std::uint32_t address);

}  // namespace merker::workbench
