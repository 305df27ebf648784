// The stations of one project (S7-MGR-13), each as a PLC of its own, in one virtual time.
#pragma once

#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "compilation/network.h"
#include "workbench/plc.h"

namespace merker::workbench {

struct Laboratory {
  std::string path;  // the folder with its merker.toml
  compilation::NetworkBuild build;
  std::unique_ptr<network::Network> network;
  std::vector<std::unique_ptr<Plc>> plcs;              // in the order of `build.stations`
  std::vector<std::vector<address::Reference>> gdsOf;  // status double words of each circle
  std::optional<std::size_t> find(std::string_view station) const;  // case does not matter
};

// Loads and compiles all. A project with errors is opened, too: what cannot run is an empty CPU,
// and there are no subnets. Null: there is nothing to open, `problems` say why.
std::shared_ptr<Laboratory> makeLaboratory(project::Project project,
                                           std::optional<station::Engine> engine,
                                           Problems& problems);

}  // namespace merker::workbench
