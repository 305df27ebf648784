#include "compilation/network.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>

#include "catalogue/ethernet.h"
#include "project/files.h"
#include "project/station_plants.h"

namespace merker::compilation {
namespace {

// Loads and compiles the folders, each once.
class NetworkStations {
 public:
  NetworkStations(NetworkBuild& result, bool toRun)
      : result_(result), network_(*result.project.network), toRun_(toRun) {}

  void load() {
    for (std::size_t i = 0; i < network_.stations.size(); ++i)
      if (auto folder = folderOf(i)) folders_.emplace(keyOf(i), std::move(*folder));
    if (network_.plants) addPlants();
  }

  void build() {
    for (std::size_t i = 0; i < network_.stations.size(); ++i) {
      const auto own = folders_.find(keyOf(i));
      if (own == folders_.end()) continue;
      auto& made = builds_[own->first];
      if (!made) made = built(std::move(own->second));
      result_.stations.push_back({network_.stations[i].name, made});
    }
  }

 private:
  const project::DpSubnet* slavesOf(std::size_t station) const {
    for (const project::DpSubnet& subnet : network_.profibus)
      if (subnet.station == station) return &subnet;
    return nullptr;
  }

  const project::IntelligentSlave* slaveOf(std::size_t station) const {
    for (const project::DpSubnet& subnet : network_.profibus)
      for (const project::IntelligentSlave& slave : subnet.intelligent)
        if (slave.station == station) return &slave;
    return nullptr;
  }

  std::string pathOf(std::size_t station) const {
    const auto path =
        std::filesystem::path(result_.project.folder) / network_.stations[station].folder;
    return path.lexically_normal().string();
  }

  // A DP master or slave, and one with plants, is a program of its own, whatever others share its
  // folder.
  std::string keyOf(std::size_t station) const {
    const bool apart =
        network_.plants || slavesOf(station) != nullptr || slaveOf(station) != nullptr;
    return apart ? pathOf(station) + '\n' + network_.stations[station].name : pathOf(station);
  }

  // Nothing: it was loaded before, or cannot be a station.
  std::optional<project::Project> folderOf(std::size_t number) const {
    const std::string key = keyOf(number), folder = pathOf(number);
    if (folders_.contains(key)) return std::nullopt;
    const Position& named = network_.stations[number].named;
    const auto refuse = [&](std::string_view what) {
      result_.problems.add(ProblemCode::P0704, named, "folder", what);
      return std::nullopt;
    };
    if (!project::isFile(project::join(folder, "merker.toml"))) {
      result_.problems.add(ProblemCode::P0701, named, folder);
      return std::nullopt;
    }
    project::Project own = project::load(folder, "", {}, result_.project.problems.stop());
    if (own.network) return refuse("the folder of a project of one station");
    if (!own.stations.empty())
      return refuse(
          "the folder of a project without [[station]]; its X27 needs another connection");
    if (result_.project.mnemonics) own.mnemonics = result_.project.mnemonics;
    // Slaves may be missing.
    if (result_.project.problems.hasErrors()) own.addressCheck = project::AddressCheck::Off;
    if (modulesAreUnknown(own)) return own;
    const project::DpSubnet* const slaves = slavesOf(number);
    const project::IntelligentSlave* const self = slaveOf(number);
    if ((slaves != nullptr || self != nullptr) && own.control)
      return refuse("a SIMATIC S7; a SINUMERIK has no DP interface");
    if (slaves != nullptr) project::plugSlaves(*slaves, *own.model, own.hardware, result_.problems);
    if (self != nullptr) project::plugOwnSlave(*self, *own.model, own.hardware, result_.problems);
    return own;
  }

  // Its merker.toml has mistakes, which are named there.
  static bool modulesAreUnknown(const project::Project& station) {
    const std::string settings = project::join(station.folder, "merker.toml");
    return std::ranges::any_of(station.problems.list(), [&](const Problem& problem) {
      return problem.severity() == Severity::Error && problem.position.file == settings;
    });
  }

  // Where all modules are known. A station without a hardware configuration gets the modules on
  // board if it has a plant or lends a terminal, as one with a [[plant]] of its own.
  void addPlants() {
    std::vector<project::StationField> fields;
    std::map<std::size_t, io::Configuration> onBoard;
    for (std::size_t i = 0; i < network_.stations.size(); ++i) {
      fields.push_back({network_.stations[i].name});
      const auto found = folders_.find(keyOf(i));
      if (found == folders_.end()) return;  // which is a problem already
      project::Project& own = found->second;
      if (modulesAreUnknown(own)) return;
      if (own.control) continue;
      if (!own.hardware) onBoard[i] = io::configure({}, *own.model, result_.problems);
      fields.back().hardware = own.hardware ? &*own.hardware : &onBoard[i];
      fields.back().plants = &own.plants;
    }
    const std::string file = project::join(result_.project.folder, "merker.toml");
    if (const source::SourceFile* const text = result_.project.file(file))
      project::readStationPlants(*text, fields, result_.problems);
    for (auto& [station, modules] : onBoard)
      if (const plant::Configuration& plants = *fields[station].plants;
          !plants.plants.empty() || !plants.lent.empty())
        folders_.at(keyOf(station)).hardware = std::move(modules);
  }

  std::shared_ptr<const Build> built(project::Project own) {
    auto made = std::make_shared<Build>(compilation::build(std::move(own), false));
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
  const project::Network& network_;
  bool toRun_;
  std::map<std::string, project::Project> folders_;
  std::map<std::string, std::shared_ptr<const Build>> builds_;
};

}  // namespace

namespace {

bool isOnEthernet(const project::Project& station) {
  const auto isEthernet = [](const io::Module& module) { return hasEthernet(*module.type); };
  return hasEthernet(*station.model) ||
         (station.hardware && std::ranges::any_of(station.hardware->modules, isEthernet));
}

bool hasCp(const project::Project& station) {
  return station.hardware && std::ranges::any_of(station.hardware->modules, [](const auto& one) {
           return hasEthernet(*one.type);
         });
}

// A SINUMERIK has none. Without problems so far the stations have the numbers of their list.
void requireInterface(const project::Subnet& subnet, const project::SubnetNode& node,
                      NetworkBuild& build) {
  if (!build.ok()) return;
  const Build& station = *build.stations[node.station].build;
  const bool ethernet = subnet.kind == project::SubnetKind::Ethernet;
  if (station.isListing())
    build.problems.add(ProblemCode::P0704, node.named, "station",
                       ethernet ? "a SIMATIC S7; a SINUMERIK has no Ethernet interface"
                                : "a SIMATIC S7; a SINUMERIK has no MPI interface");
  else if (ethernet && !isOnEthernet(station.project))
    build.problems.add(ProblemCode::P0704, node.named, "station",
                       fmt::format("a station with an Ethernet interface; the {} has none: plug a "
                                   "CP 343-1 ([[module]])",
                                   station.project.model->name));
}

// Blocks name a connection only where the CPU has such blocks (S7-SFB-10).
void requireBlocks(NetworkBuild& build, std::size_t station, const Position& at,
                   std::string_view key) {
  constexpr BlockId kGet{BlockKind::SFB, 14}, kGetOfCp{BlockKind::FB, 14};
  const Build& own = *build.stations[station].build;
  if (own.library->contains(kGet) || own.library->contains(kGetOfCp)) return;
  build.problems.add(ProblemCode::P0704, at, key,
                     fmt::format("a station whose CPU has SFB 12 to 15, or with a CP 343-1; the {} "
                                 "only serves others: it can be the partner, without partner_id",
                                 own.project.model->name));
}

// Ids that the station's own merker.toml has, and how many connections there are (S7-LIM-05).
void requireConnection(NetworkBuild& build, std::size_t station, std::optional<std::uint16_t> id,
                       const Position& at, std::vector<std::size_t>& counts) {
  const CommunicationParameters& own = build.stations[station].build->project.communication;
  const std::string& name = build.stations[station].name;
  if (id && std::ranges::count(own.configured, *id, &ConnectionParameters::id) > 0)
    build.problems.add(ProblemCode::P0704, at, "id",
                       fmt::format("another one: {} has a connection W#16#{:X} in its own "
                                   "merker.toml",
                                   name, *id));
  const std::size_t all = ++counts[station] + own.configured.size();
  if (!own.connections || all + own.pg + own.op + own.basic <= *own.connections) return;
  build.problems.add(ProblemCode::P0704, at, "connection",
                     fmt::format("left out: {} has {} connections, of which {} are kept", name,
                                 *own.connections, own.pg + own.op + own.basic));
}

void requireCp(NetworkBuild& build, std::size_t station, std::uint16_t id, const Position& at,
               std::string_view key) {
  const project::Project& own = build.stations[station].build->project;
  if (!hasCp(own))
    build.problems.add(ProblemCode::P0704, at, key, "a station with a CP 343-1 ([[module]])");
  else if (std::ranges::count(own.communication.ofCp, id, &CpConnectionParameters::id) > 0)
    build.problems.add(ProblemCode::P0704, at, "id",
                       fmt::format("another one: {} has a connection {} of its CP in its own "
                                   "merker.toml",
                                   build.stations[station].name, id));
}

void checkConnections(NetworkBuild& build) {
  std::vector<std::size_t> counts(build.stations.size());
  for (const project::StationConnection& one : build.project.network->connections) {
    if (!build.ok()) return;
    if (one.kind != ConnectionKind::S7) {
      requireCp(build, one.local, one.id, one.localAt, "local");
      requireCp(build, one.partner, *one.partnerId, one.partnerAt, "partner");
      continue;
    }
    requireBlocks(build, one.local, one.localAt, "local");
    if (one.partnerId) requireBlocks(build, one.partner, one.partnerAt, "partner");
    requireConnection(build, one.local, one.id, one.position, counts);
    requireConnection(build, one.partner, one.partnerId, one.position, counts);
  }
}

network::Medium mediumOf(const project::Subnet& subnet) {
  return subnet.kind == project::SubnetKind::Ethernet ? network::ethernet(subnet.rate)
                                                      : network::mpi(subnet.rate);
}

// Where stations exchange data with each other; other slaves are part of their master. Without a
// name: its faults are those of the slaves.
void joinDp(const project::DpSubnet& dp, network::Network& network) {
  if (dp.intelligent.empty()) return;
  network::Subnet& subnet = network.addSubnet(network::dp(dp.master.rate));
  network.joinDp(*dp.station, subnet, dp.master.address);
  for (const project::IntelligentSlave& slave : dp.intelligent)
    network.joinDp(slave.station, subnet, slave.own.self.address);
}

// Between each two stations one bundle for the plants of the one and one for those of the other.
void wirePlants(const NetworkBuild& build, network::Network& network) {
  for (std::size_t i = 0; i < build.stations.size(); ++i) {
    std::set<std::size_t> others;
    for (const plant::FarWire& wire : build.stations[i].build->project.plants.far)
      if (others.insert(wire.station).second) network.wire(i, wire.station);
  }
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
  std::vector<network::Subnet*> subnets;
  for (const project::Subnet& one : project.network->subnets) {
    network::Subnet& subnet = result->addSubnet(mediumOf(one), one.name);
    subnets.push_back(&subnet);
    for (const project::SubnetNode& node : one.nodes) {
      const auto address = static_cast<std::uint8_t>(node.address);
      if (one.kind == project::SubnetKind::Mpi)
        result->join(node.station, subnet, address, globalData[node.station]);
      else
        result->attach(node.station, subnet, address);
    }
  }
  for (const project::DpSubnet& one : project.network->profibus) joinDp(one, *result);
  wirePlants(*this, *result);
  for (const project::StationConnection& one : project.network->connections)
    result->connect(*subnets[one.subnet], {one.local, one.id}, {one.partner, one.partnerId},
                    one.kind);
  return result;
}

NetworkBuild buildNetwork(project::Project project, bool toRun) {
  NetworkBuild result;
  result.project = std::move(project);
  result.problems = result.project.problems;
  result.unreadable = result.project.unreadable;
  NetworkStations stations(result, toRun);
  stations.load();
  stations.build();
  for (const project::Subnet& subnet : result.project.network->subnets)
    for (const project::SubnetNode& node : subnet.nodes) requireInterface(subnet, node, result);
  checkConnections(result);
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
