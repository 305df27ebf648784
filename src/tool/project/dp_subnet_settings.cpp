// [[subnet]] with kind = "profibus": its master (S7-NET-04 to -06, -10, -25).
#include <fmt/format.h>

#include <algorithm>

#include "base/text.h"
#include "project/readers.h"

namespace merker::project {
namespace {

struct DpRate {
  std::string_view name;
  std::int64_t rate;
};
constexpr DpRate kDpRates[] = {{"9.6k", 9'600},     {"19.2k", 19'200},   {"45.45k", 45'450},
                               {"93.75k", 93'750},  {"187.5k", 187'500}, {"500k", 500'000},
                               {"1.5M", 1'500'000}, {"3M", 3'000'000},   {"6M", 6'000'000},
                               {"12M", 12'000'000}};

std::int64_t readDpRate(const Table& table) {
  constexpr std::int64_t kUsual = 1'500'000;
  const auto name = table.text("baud", "a baud rate: 9.6k to 12M");
  if (!name) return kUsual;
  for (const DpRate& row : kDpRates)
    if (equalsIgnoreCase(row.name, *name)) return row.rate;
  std::string names;
  for (const DpRate& row : kDpRates)
    names += fmt::format("{}{}", names.empty() ? "" : ", ", row.name);
  table.mustBe("baud", "one of " + names);
  return kUsual;
}

// {address = 2, master = true}; in a project of several stations with the name of the station.
void readMaster(const Table& table, const Network* network, DpSubnet& subnet) {
  table.allow({"station", "address", "master"});
  if (!table.flag("master").value_or(true)) return table.mustBe("master", "true: the DP master");
  const auto name = table.text("station", "the name of a [[station]]");
  const auto station = network != nullptr && name ? findStation(*network, *name) : std::nullopt;
  if (network != nullptr && !station)
    return table.mustBe("station", "the name of a [[station]]: " + stationNames(*network));
  subnet.station = station.value_or(0);
  subnet.named = network != nullptr ? table.at("station") : table.place();
  if (const auto address = table.number("address", 1, 125))
    subnet.master.address = static_cast<std::uint8_t>(*address);
  if (subnet.master.address > subnet.highest)
    table.mustBe("address",
                 fmt::format("at most the highest address of the subnet, {}", subnet.highest));
}

bool hasDpInterface(const CpuModel& model, const Position& at, Problems& problems) {
  constexpr std::uint8_t kRackFailure = 86;  // CPUs with a DP interface have this OB
  if (model.hasOrganizationBlock(kRackFailure)) return true;
  problems.add(ProblemCode::P0735, at, model.name, "DP interface");
  return false;
}

// An area whose bytes belong together is updated with the process image, or read by SFC 14: not
// one part of it so and another so.
void checkConsistency(const std::vector<io::Module>& modules, const CpuModel& model, bool own,
                      Problems& problems) {
  for (const io::Module& area : modules) {
    if (!area.consistent) continue;
    const std::uint32_t first = area.inputStart.value_or(area.outputStart.value_or(0));
    const std::uint32_t last = area.inputStart ? area.inputEnd() : area.outputEnd();
    if (first >= model.imageBytes || last < model.imageBytes) continue;
    problems.add(ProblemCode::P0704, area.inputStart ? area.inputPosition : area.outputPosition,
                 own               ? "local"
                 : area.inputStart ? "input"
                                   : "output",
                 fmt::format("wholly inside or outside the process image, bytes 0 to {}: the area "
                             "is consistent",
                             model.imageBytes - 1));
  }
}

}  // namespace

// Else the mistake is named there.
static bool kindsAreKnown(const Table& root) {
  const std::vector<Table> tables = root.tables("subnet");
  return std::ranges::all_of(tables, [](const Table& table) {
    const toml::node* const kind = table.node("kind");
    const std::string_view name = kind != nullptr ? kind->value_or(std::string_view{}) : "";
    return equalsIgnoreCase(name, "mpi") || equalsIgnoreCase(name, "ethernet") ||
           equalsIgnoreCase(name, "profibus");
  });
}

bool isDpSubnet(const Table& table) {
  const toml::node* kind = table.node("kind");
  return kind != nullptr && equalsIgnoreCase(kind->value_or(""), "profibus");
}

// Of a project of one station; of several, each kind has its reader.
static void requireProfibus(const Table& subnet) {
  if (!subnet.has("kind"))
    subnet.problems().add(ProblemCode::P0744, subnet.place(), subnet.title(),
                          "kind = \"profibus\"");
  else
    subnet.mustBe("kind", "\"profibus\": a project of one station has no other subnets");
}

std::vector<DpSubnet> readDpSubnets(const Table& root, const Network* network) {
  std::vector<DpSubnet> subnets;
  checkSubnetNames(root);
  bool known = kindsAreKnown(root);
  for (const Table& table : root.tables("subnet")) {
    if (!isDpSubnet(table)) {
      if (network == nullptr) requireProfibus(table), known = false;
      continue;
    }
    table.allow({"name", "kind", "baud", "highest", "nodes"});
    DpSubnet subnet;
    subnet.position = table.place();
    subnet.name = table.text("name", "a text").value_or("PROFIBUS");
    subnet.master.rate = readDpRate(table);
    subnet.highest = table.number("highest", 1, 126).value_or(subnet.highest);
    subnet.master.subnet = subnet.name;
    subnet.master.highest = subnet.highest;
    const auto nodes = table.tables("nodes");
    for (const Table& node : nodes) readMaster(node, network, subnet);
    if (nodes.size() != 1)
      table.mustBe("nodes", "one station, the DP master: [ {address = 2, master = true} ]");
    subnets.push_back(std::move(subnet));
  }
  if (subnets.empty() && root.has("slave") && known)
    root.mustBe("slave", "on a [[subnet]] with kind = \"profibus\"");
  if (!subnets.empty() && !readSlaves(root, network, subnets, known)) return subnets;
  for (const DpSubnet& subnet : subnets)
    if (subnet.master.slaves.empty())  // S7-NET-10
      root.problems().add(ProblemCode::P0744, subnet.position, "[[subnet]]",
                          "a [[slave]]: a PROFIBUS subnet has a master and at least one slave");
  return subnets;
}

void plugSlaves(const DpSubnet& subnet, const CpuModel& model,
                std::optional<io::Configuration>& hardware, Problems& problems) {
  if (!hasDpInterface(model, subnet.named, problems)) return;
  if (!hardware) hardware = io::configure({}, model, problems);
  if (hardware->dp)
    return problems.add(ProblemCode::P0704, subnet.named, "nodes",
                        "a station that is no DP master yet; a CPU has one DP interface");
  for (const io::Slave& slave : subnet.master.slaves)
    checkConsistency(slave.modules, model, false, problems);
  io::addSlaves(*hardware, subnet.master, problems);
}

void plugOwnSlave(const IntelligentSlave& slave, const CpuModel& model,
                  std::optional<io::Configuration>& hardware, Problems& problems) {
  if (!hasDpInterface(model, slave.named, problems)) return;
  if (!hardware) hardware = io::configure({}, model, problems);
  if (hardware->dp)
    return problems.add(ProblemCode::P0704, slave.named, "station",
                        "a station whose DP interface is free; a CPU has one");
  checkConsistency(slave.own.self.modules, model, true, problems);
  io::addOwnSlave(*hardware, slave.own, problems);
}

}  // namespace merker::project
