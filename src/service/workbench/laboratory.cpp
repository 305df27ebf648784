#include "workbench/laboratory.h"

#include <thread>

#include "network/member.h"

namespace merker::workbench {
namespace {

// From so many stations on more than one thread pays, at least.
constexpr std::size_t kManyStations = 16;

// With errors somewhere each station is alone, and those that cannot run are empty.
std::unique_ptr<network::Network> apart(const compilation::NetworkBuild& build) {
  std::vector<network::Station> list;
  for (const compilation::NamedBuild& one : build.stations)
    list.push_back(
        {one.name, one.build->ok() ? one.build->controller() : withoutProgram(*one.build)});
  return std::make_unique<network::Network>(std::move(list));
}

std::unique_ptr<network::Network> networkOf(const compilation::NetworkBuild& build) {
  if (!build.ok()) return apart(build);
  const bool many = build.stations.size() >= kManyStations;
  return build.network(many ? std::max(1u, std::thread::hardware_concurrency()) : 1);
}

void start(Laboratory& lab) {
  for (std::size_t i = 0; i < lab.network->size(); ++i) {
    controller::Controller& plc = lab.network->itself(i);
    if (!lab.build.stations[i].build->ok()) continue;
    plc.memoryReset();
    plc.start();
  }
}

// What the status words of global data are; none of a project with errors.
void findStatusWords(Laboratory& lab) {
  const compilation::NetworkOperands operands(lab.build);
  const simulator::Resolver resolver = operands.resolver(std::nullopt);
  for (const project::GlobalDataRow& row : lab.build.project.network->globalData) {
    auto& list = lab.gdsOf.emplace_back();
    if (!lab.build.ok()) continue;
    for (const auto& place : row.status)
      if (auto reference = resolver(place.text, place.position)) list.push_back(*reference);
  }
}

}  // namespace

std::optional<std::size_t> Laboratory::find(std::string_view station) const {
  return network->find(station);
}

std::shared_ptr<Laboratory> makeLaboratory(project::Project project,
                                           std::optional<station::Engine> engine,
                                           Problems& problems) {
  auto lab = std::make_shared<Laboratory>();
  lab->path = project.path;
  lab->build = compilation::buildNetwork(std::move(project), false);
  problems = lab->build.problems;
  if (lab->build.unreadable || lab->build.stations.empty()) return nullptr;
  lab->network = networkOf(lab->build);
  start(*lab);
  for (std::size_t i = 0; i < lab->network->size(); ++i) {
    lab->plcs.push_back(std::make_unique<Plc>(lab->build.stations[i].build,
                                              std::make_unique<network::Member>(*lab->network, i)));
    lab->plcs.back()->use(engine);
  }
  findStatusWords(*lab);
  return lab;
}

}  // namespace merker::workbench
