#include "workbench/station_rows.h"

#include "compilation/network_plan.h"

namespace merker::workbench {
namespace {

using compilation::NetworkPlan;

Json stations(const NetworkPlan& plan) {
  Json rows = Json::array();
  for (const compilation::PlannedStation& one : plan.stations)
    rows.push_back({{"name", one.name}, {"folder", one.folder}, {"model", one.model}});
  return rows;
}

Json nodeRow(const NetworkPlan& plan, const compilation::PlannedNode& node) {
  Json row = {{"station", plan.stations[node.station].name}, {"address", node.address}};
  if (!node.ip.empty()) row["ip"] = node.ip;
  return row;
}

Json subnets(const NetworkPlan& plan) {
  Json rows = Json::array();
  for (const compilation::PlannedSubnet& one : plan.subnets) {
    Json nodes = Json::array(), slaves = Json::array();
    for (const compilation::PlannedNode& node : one.nodes) nodes.push_back(nodeRow(plan, node));
    for (const compilation::PlannedSlave& slave : one.slaves)
      slaves.push_back({{"address", slave.address}, {"name", slave.name}, {"model", slave.model}});
    rows.push_back({{"name", one.name},
                    {"kind", one.kind},
                    {"rate", one.rate},
                    {"highest", one.highest},
                    {"nodes", std::move(nodes)},
                    {"slaves", std::move(slaves)}});
  }
  return rows;
}

Json texts(const std::vector<project::GlobalDataRow::Place>& places) {
  Json list = Json::array();
  for (const auto& place : places) list.push_back(place.text);
  return list;
}

Json circles(const NetworkPlan& plan) {
  Json rows = Json::array();
  for (const project::GlobalDataRow& row : plan.circles)
    rows.push_back({{"circle", row.circle},
                    {"rate", row.rate},
                    {"from", row.from.text},
                    {"to", texts(row.to)},
                    {"status", texts(row.status)}});
  return rows;
}

Json connections(const NetworkPlan& plan) {
  Json rows = Json::array();
  for (const compilation::PlannedConnection& one : plan.connections)
    rows.push_back({{"station", plan.stations[one.station].name},
                    {"kind", compilation::kindName(one.kind)},
                    {"id", one.id},
                    {"active", one.active},
                    {"partner", one.partner}});
  return rows;
}

// Problems of the project's own merker.toml; those of a station are shown in it.
Json problemsOf(const Laboratory& lab) {
  Json rows = Json::array();
  for (const Problem& problem : lab.build.problems.list())
    if (rows.size() < kMostProblems) rows.push_back(toJson(problem));
  return rows;
}

Json lineNow(const Laboratory& lab, const project::Subnet& row) {
  network::Subnet* const subnet = lab.network->subnet(row.name);
  if (subnet == nullptr)
    return {{"busy", 0}, {"interrupted", false}, {"pulled", Json::array()}, {"delay", 0}};
  Json pulled = Json::array();
  for (const project::SubnetNode& node : row.nodes)
    if (subnet->interrupted(static_cast<std::uint8_t>(node.address)))
      pulled.push_back(lab.build.stations[node.station].name);
  return {{"busy", subnet->busy().ns},
          {"interrupted", subnet->interrupted()},
          {"pulled", std::move(pulled)},
          {"delay", subnet->delayed().ns}};
}

Json statusWords(const Laboratory& lab) {
  Json rows = Json::array();
  for (const auto& circle : lab.gdsOf) {
    Json words = Json::array();
    for (const address::Reference& one : circle)
      words.push_back(lab.network->itself(one.station - 1u).read(one).value_or(0));
    rows.push_back(std::move(words));
  }
  return rows;
}

}  // namespace

Json stationRows(const Laboratory& lab, const std::string& shown) {
  NetworkPlan plan = planOf(lab.build);
  addProfibus(lab.build, plan);
  return {{"name", plan.name},          {"shown", shown},
          {"stations", stations(plan)}, {"subnets", subnets(plan)},
          {"circles", circles(plan)},   {"connections", connections(plan)},
          {"problems", problemsOf(lab)}};
}

Json stationsNow(const Laboratory& lab) {
  Json rows = Json::array();
  for (const auto& plc : lab.plcs)
    rows.push_back({{"mode", modeOf(*plc)},
                    {"powered", plc->controller().powered()},
                    {"leds", lampsOf(*plc)},
                    {"reason", plc->controller().stopReason()}});
  Json lines = Json::array();
  for (const project::Subnet& row : lab.build.project.network->subnets)
    lines.push_back(lineNow(lab, row));
  return {{"event", "stations"},
          {"time", lab.network->now().ns},
          {"stations", std::move(rows)},
          {"subnets", std::move(lines)},
          {"circles", statusWords(lab)}};
}

}  // namespace merker::workbench
