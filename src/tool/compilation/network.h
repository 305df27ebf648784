// A project of several stations: each loaded and compiled, and their operands by name.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "compilation/build.h"
#include "network/network.h"

namespace merker::compilation {

struct NamedBuild {
  std::string name;
  std::shared_ptr<const Build> build;  // stations of one folder share it
};

struct NetworkBuild {
  project::Project project;  // its merker.toml
  std::vector<NamedBuild> stations;
  std::vector<network::GlobalData> globalData;  // of each station
  Problems problems;                            // of all
  bool unreadable = false;

  bool ok() const { return !problems.hasErrors(); }
  std::size_t blocks() const;
  FileLookup files() const;
  std::unique_ptr<network::Network> network(unsigned threads, bool coverage = false) const;
};

// `toRun`: what cannot run is a problem (requireOb1, requireWorkMemory), else only noted.
NetworkBuild buildNetwork(project::Project project, bool toRun);
// What a command that knows one station only says of such a project.
Problem needsOneStation(const project::Project& project);

// Operands as Press/E 0.0. The NetworkBuild must outlive it.
class NetworkOperands {
 public:
  explicit NetworkOperands(const NetworkBuild& build);

  // The station in front of `text`, which is taken off; nothing if none is named.
  std::optional<std::size_t> takeStation(std::string_view& text) const;
  std::optional<std::size_t> find(std::string_view name) const;
  // "Foo" of Foo/E 0.0 must be the name of a station, or one must be named at all.
  Problem unknown(std::string_view text, const Position& at) const;
  // With `station` as the one of operands without a name; without it each must have one.
  simulator::Resolver resolver(std::optional<std::size_t> station) const;

 private:
  Result<address::Reference> resolve(std::string_view text, const Position& at,
                                     std::optional<std::size_t> station) const;

  const NetworkBuild& build_;
  std::map<std::string, std::size_t> numbers_;
  std::vector<std::shared_ptr<const simulator::Resolver>> resolvers_;
};

// What each station of a good project sends and takes; what is wrong is added to its problems.
std::vector<network::GlobalData> globalDataOf(NetworkBuild& build);

}  // namespace merker::compilation
