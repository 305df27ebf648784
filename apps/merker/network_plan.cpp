#include "network_plan.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/text.h"

namespace merker::app {
namespace {

using nlohmann::ordered_json;

std::string places(const std::vector<project::GlobalDataRow::Place>& list) {
  std::string text;
  for (const auto& place : list) text += (text.empty() ? "" : ", ") + place.text;
  return text;
}

ordered_json texts(const std::vector<project::GlobalDataRow::Place>& list) {
  ordered_json array = ordered_json::array();
  for (const auto& place : list) array.push_back(place.text);
  return array;
}

bool isOnSubnet(const NetworkPlan& plan, std::size_t station) {
  return std::ranges::any_of(plan.subnets, [&](const PlannedSubnet& subnet) {
    return std::ranges::count(subnet.nodes, station, &PlannedNode::station) > 0;
  });
}

std::string stationLines(const NetworkPlan& plan) {
  std::size_t width = 0;
  for (const PlannedStation& one : plan.stations) width = std::max(width, characterCount(one.name));
  std::string text;
  for (std::size_t i = 0; i < plan.stations.size(); ++i) {
    const PlannedStation& one = plan.stations[i];
    text += fmt::format("  {:<{}}  {:<18}  {}{}\n", one.name, width,
                        one.model.empty() ? "(not readable)" : one.model, one.folder,
                        isOnSubnet(plan, i) ? "" : "  (on no subnet)");
  }
  return text;
}

std::string segmentLine(const project::Segment& segment, std::size_t number) {
  const std::string length = segment.length == 0 ? "" : fmt::format(", {} m", segment.length);
  return fmt::format("  segment {}{}: {}\n", number, length, fmt::join(segment.places, " - "));
}

std::string addressText(const PlannedNode& node) {
  return node.ip.empty() ? fmt::format("{}", node.address) : node.ip;
}

// On PROFIBUS; scenarios name a slave in their faults.
std::string roleOf(const PlannedSubnet& subnet, const PlannedNode& node) {
  if (subnet.kind != "profibus") return {};
  return node.slave.empty() ? ", DP master" : fmt::format(", intelligent slave \"{}\"", node.slave);
}

std::string subnetLines(const NetworkPlan& plan, const PlannedSubnet& subnet) {
  const bool ethernet = subnet.kind == "ethernet";
  std::string text = fmt::format("{}: {}, {}", subnet.name,
                                 ethernet ? "Ethernet" : upper(subnet.kind), subnet.rate);
  text += ethernet ? "\n" : fmt::format(", highest address {}\n", subnet.highest);
  for (const PlannedNode& node : subnet.nodes)
    text += fmt::format("  {:>3}  {}{}\n", addressText(node), plan.stations[node.station].name,
                        roleOf(subnet, node));
  for (const compilation::PlannedSlave& slave : subnet.slaves)
    text += fmt::format("  {:>3}  {}, {}\n", slave.address, slave.name, slave.model);
  for (std::size_t i = 0; i < subnet.segments.size(); ++i)
    text += segmentLine(subnet.segments[i], i + 1);
  return text;
}

std::string connectionLine(const NetworkPlan& plan, const PlannedConnection& one) {
  return fmt::format("  {} {} {} {}\n", plan.stations[one.station].name, nameOf(one),
                     one.active ? "calls" : "is called by", one.partner);
}

ordered_json subnetJson(const NetworkPlan& plan, const PlannedSubnet& subnet) {
  ordered_json nodes = ordered_json::array(), segments = ordered_json::array(),
               slaves = ordered_json::array();
  for (const PlannedNode& node : subnet.nodes) {
    ordered_json& row = nodes.emplace_back(ordered_json{
        {"station", plan.stations[node.station].name},
        {"address", node.ip.empty() ? ordered_json(node.address) : ordered_json(node.ip)}});
    if (!node.slave.empty()) row["slave"] = node.slave;
  }
  for (const project::Segment& one : subnet.segments)
    segments.push_back({{"length_m", one.length}, {"nodes", one.places}});
  for (const compilation::PlannedSlave& one : subnet.slaves)
    slaves.push_back({{"name", one.name}, {"model", one.model}, {"address", one.address}});
  return {{"name", subnet.name},       {"kind", subnet.kind}, {"baud", subnet.rate},
          {"highest", subnet.highest}, {"nodes", nodes},      {"segments", segments},
          {"slaves", slaves}};
}

ordered_json circleJson(const project::GlobalDataRow& row) {
  return {{"circle", row.circle},        {"from", row.from.text},
          {"to", texts(row.to)},         {"rate", row.rate},
          {"status", texts(row.status)}, {"group_status", texts(row.groupStatus)}};
}

template <typename List, typename Convert>
ordered_json arrayOf(const List& list, const Convert& convert) {
  ordered_json array = ordered_json::array();
  for (const auto& one : list) array.push_back(convert(one));
  return array;
}

}  // namespace

std::string circleText(const project::GlobalDataRow& row) {
  return fmt::format("GD circle {}, every {} cycles: {} → {}", row.circle, row.rate, row.from.text,
                     places(row.to));
}

std::string toText(const NetworkPlan& plan) {
  std::string text = fmt::format("{}: {} station{}\n{}", plan.name, plan.stations.size(),
                                 plan.stations.size() == 1 ? "" : "s", stationLines(plan));
  for (const PlannedSubnet& subnet : plan.subnets) text += "\n" + subnetLines(plan, subnet);
  if (!plan.circles.empty()) text += "\nglobal data\n";
  for (const project::GlobalDataRow& row : plan.circles) text += "  " + circleText(row) + "\n";
  if (!plan.connections.empty()) text += "\nconnections\n";
  for (const PlannedConnection& one : plan.connections) text += connectionLine(plan, one);
  return text;
}

ordered_json toJson(const NetworkPlan& plan) {
  return {{"name", plan.name},
          {"stations",
           arrayOf(plan.stations,
                   [](const PlannedStation& one) -> ordered_json {
                     return {{"name", one.name}, {"folder", one.folder}, {"cpu", one.model}};
                   })},
          {"subnets",
           arrayOf(plan.subnets, [&](const auto& subnet) { return subnetJson(plan, subnet); })},
          {"global_data", arrayOf(plan.circles, circleJson)},
          {"connections", arrayOf(plan.connections, [&](const auto& one) -> ordered_json {
             return {{"station", plan.stations[one.station].name},
                     {"kind", compilation::kindName(one.kind)},
                     {"id", one.id},
                     {"active", one.active},
                     {"partner", one.partner}};
           })}};
}

}  // namespace merker::app
