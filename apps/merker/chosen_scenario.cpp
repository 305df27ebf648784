#include "chosen_scenario.h"

#include <algorithm>
#include <iostream>

#include "base/text.h"
#include "command.h"

namespace merker::app {
namespace {

std::vector<std::string> subnetsOf(std::size_t station, const project::Network& network) {
  std::vector<std::string> names;
  for (const project::Subnet& subnet : network.subnets)
    if (std::ranges::count(subnet.nodes, station, &project::SubnetNode::station) > 0)
      names.push_back(subnet.name);
  return names;
}

}  // namespace

std::vector<simulator::Scenario> boundScenarios(const source::SourceFile& file, const Build& built,
                                                Problems& problems) {
  std::vector<simulator::Scenario> list = simulator::parseScenarios(file, problems);
  if (!built.ok()) return list;
  const auto resolver = built.resolver();
  const auto& hardware = built.project.hardware;
  for (simulator::Scenario& one : list)
    simulator::resolve(one, resolver, problems, hardware ? &*hardware : nullptr,
                       &built.project.plants);
  return list;
}

std::vector<simulator::Scenario> boundScenarios(const source::SourceFile& file,
                                                const compilation::NetworkBuild& built,
                                                Problems& problems) {
  std::vector<simulator::Scenario> list = simulator::parseScenarios(file, problems);
  if (!built.ok()) return list;
  const compilation::NetworkOperands operands(built);
  std::vector<simulator::StationBinding> stations;
  for (std::size_t i = 0; i < built.stations.size(); ++i) {
    const project::Project& own = built.stations[i].build->project;
    stations.push_back({built.stations[i].name, operands.resolver(i),
                        own.hardware ? &*own.hardware : nullptr, &own.plants,
                        subnetsOf(i, *built.project.network)});
  }
  for (simulator::Scenario& one : list) simulator::resolve(one, stations, problems);
  return list;
}

std::unique_ptr<const ChosenScenario> chooseScenario(const std::string& command,
                                                     const std::string& path,
                                                     const std::string& name, const Build& built,
                                                     int& code) {
  auto file = source::readSource(path);
  Problems problems;
  if (!file) {
    problems.add(file.error());
    printProblems(problems, [](const std::string&) { return nullptr; });
    code = kUnreadable;
    return nullptr;
  }
  auto chosen = std::make_unique<ChosenScenario>(ChosenScenario{std::move(file.value()), {}});
  const auto list = boundScenarios(chosen->file, built, problems);
  printProblems(problems, [&](const std::string&) { return &chosen->file; });
  code = kProblems;
  if (problems.hasErrors()) return nullptr;
  const auto found = std::ranges::find_if(list, [&](const simulator::Scenario& one) {
    return upper(one.name).find(upper(name)) != std::string::npos;
  });
  code = kUsage;
  if (found == list.end()) {
    std::cerr << command << ": --name: no scenario of " << path << " has '" << name
              << "' in its name\n";
    return nullptr;
  }
  code = kGood;
  chosen->scenario = *found;
  return chosen;
}

}  // namespace merker::app
