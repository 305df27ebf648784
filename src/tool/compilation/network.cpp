#include "compilation/network.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "project/files.h"

namespace merker::compilation {
namespace {

// Loads and compiles the folders, each once.
class NetworkStations {
 public:
  NetworkStations(NetworkBuild& result, bool toRun) : result_(result), toRun_(toRun) {}

  void add(const project::OtherStation& station) {
    const auto path = std::filesystem::path(result_.project.folder) / station.folder;
    const std::string folder = path.lexically_normal().string();
    const project::DpSubnet* const slaves = slavesOf(result_.stations.size());
    // A DP master is a program of its own, whatever others share its folder.
    const std::string key = slaves == nullptr ? folder : folder + '\n' + station.name;
    auto known = builds_.find(key);
    if (known == builds_.end()) known = builds_.emplace(key, built(folder, station, slaves)).first;
    if (known->second) result_.stations.push_back({station.name, known->second});
  }

 private:
  const project::DpSubnet* slavesOf(std::size_t station) const {
    for (const project::DpSubnet& subnet : result_.project.network->profibus)
      if (subnet.station == station) return &subnet;
    return nullptr;
  }

  // Null: it cannot be a station.
  std::shared_ptr<const Build> built(const std::string& folder,
                                     const project::OtherStation& station,
                                     const project::DpSubnet* slaves) {
    const auto refuse = [&](std::string_view what) {
      result_.problems.add(ProblemCode::P0704, station.named, "folder", what);
      return nullptr;
    };
    if (!project::isFile(project::join(folder, "merker.toml"))) {
      result_.problems.add(ProblemCode::P0701, station.named, folder);
      return nullptr;
    }
    project::Project own = project::load(folder, "", {}, result_.project.problems.stop());
    if (own.network) return refuse("the folder of a project of one station");
    if (!own.stations.empty())
      return refuse(
          "the folder of a project without [[station]]; its X27 needs another connection");
    if (result_.project.mnemonics) own.mnemonics = result_.project.mnemonics;
    if (slaves != nullptr && own.control)
      return refuse("a SIMATIC S7; a SINUMERIK has no DP interface");
    if (slaves != nullptr) project::plugSlaves(*slaves, *own.model, own.hardware, result_.problems);
    auto made = std::make_shared<Build>(build(std::move(own), false));
    judge(*made);
    result_.problems.append(made->problems);
    result_.unreadable |= made->project.unreadable;
    return made;
  }

  void judge(Build& one) const {
    if (!toRun_) return noteMissingOb1(one);
    requireOb1(one);
    requireWorkMemory(one);
  }

  NetworkBuild& result_;
  bool toRun_;
  std::map<std::string, std::shared_ptr<const Build>> builds_;
};

}  // namespace

namespace {

// A SINUMERIK has none. Without problems so far the stations have the numbers of their list.
void requireInterface(const project::SubnetNode& node, NetworkBuild& build) {
  if (!build.ok() || !build.stations[node.station].build->isListing()) return;
  build.problems.add(ProblemCode::P0704, node.named, "station",
                     "a SIMATIC S7; a SINUMERIK has no MPI interface");
}

}  // namespace

std::size_t NetworkBuild::blocks() const {
  std::size_t sum = 0;
  for (const NamedBuild& station : stations) sum += station.build->blocks();
  return sum;
}

FileLookup NetworkBuild::files() const {
  return [this](const std::string& name) {
    const source::SourceFile* found = project.file(name);
    for (std::size_t i = 0; found == nullptr && i < stations.size(); ++i)
      found = stations[i].build->files()(name);
    return found;
  };
}

std::unique_ptr<network::Network> NetworkBuild::network(unsigned threads, bool coverage) const {
  std::vector<network::Station> list;
  for (const NamedBuild& station : stations)
    list.push_back({station.name, station.build->controller(coverage)});
  auto result = std::make_unique<network::Network>(std::move(list), threads);
  for (const project::MpiSubnet& one : project.network->subnets) {
    network::Subnet& subnet = result->addSubnet(one.rate, one.name);
    for (const project::SubnetNode& node : one.nodes)
      result->join(node.station, subnet, static_cast<std::uint8_t>(node.address),
                   globalData[node.station]);
  }
  return result;
}

NetworkBuild buildNetwork(project::Project project, bool toRun) {
  NetworkBuild result;
  result.project = std::move(project);
  result.problems = result.project.problems;
  result.unreadable = result.project.unreadable;
  NetworkStations stations(result, toRun);
  for (const project::OtherStation& station : result.project.network->stations)
    stations.add(station);
  for (const project::MpiSubnet& subnet : result.project.network->subnets)
    for (const project::SubnetNode& node : subnet.nodes) requireInterface(node, result);
  if (result.ok()) result.globalData = globalDataOf(result);
  result.problems.tellRest(Position{result.project.path});
  return result;
}

Problem needsOneStation(const project::Project& project) {
  return makeProblem(
      ProblemCode::P0744, Position{project.path}, project.path,
      fmt::format("--station NAME, or the folder of a station, here: NAME is one of {}",
                  stationNames(*project.network)));
}

}  // namespace merker::compilation
