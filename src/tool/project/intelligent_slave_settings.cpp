// [[slave]] with `station`: another station of the project as an intelligent slave, and the areas
// that its master and it exchange.
#include <fmt/format.h>

#include <algorithm>

#include "base/text.h"
#include "project/readers.h"
#include "project/slave_modules.h"

namespace merker::project {
namespace {

// CPU 31xC and CPU 31x: Installation (A5E00105492-03), 9.7: 32 areas of at most 32 bytes each.
constexpr std::uint32_t kLongestArea = 32;
constexpr SlaveLimits kLimits{io::kMostAreas, kLongestData, kLongestData, 2 * kLongestData};
constexpr std::uint16_t kIdent = 0x7F03;  // belongs to no maker

bool hasDp(const DpSubnet& subnet, std::size_t station) {
  return subnet.station == station ||
         std::ranges::count(subnet.intelligent, station, &IntelligentSlave::station) > 0;
}

std::optional<std::size_t> stationOf(const Table& table, const Network* network,
                                     const std::vector<DpSubnet>& subnets) {
  const auto name = table.text("station", "the name of a [[station]]");
  const auto station = network != nullptr && name ? findStation(*network, *name) : std::nullopt;
  if (network == nullptr)
    table.mustBe("station", "omitted; only a project of several stations has others");
  else if (!station)
    table.mustBe("station", "the name of a [[station]]: " + stationNames(*network));
  else if (std::ranges::any_of(subnets, [&](const DpSubnet& one) { return hasDp(one, *station); }))
    table.mustBe("station", "a station whose DP interface is free; a CPU has one");
  else
    return station;
  return std::nullopt;
}

// One side of an area: inputs or outputs at an address.
io::Module sideOf(const Table& table, bool input, std::uint32_t length, std::string_view key) {
  io::Module side;
  side.own = io::dataModule(fmt::format("{} B", length), input ? length : 0, input ? 0 : length);
  side.type = side.own.get();
  side.parameters = io::Parameters::of(*side.type);
  side.position = table.place();
  auto& start = input ? side.inputStart : side.outputStart;
  (input ? side.inputPosition : side.outputPosition) =
      table.has(key) ? table.at(key) : table.place();
  start = table.number(key, 0, 65'535);
  return side;
}

// What is the master's input is an output of the slave, and the other way round.
void readArea(const Table& table, io::Slave& slave, io::OwnSlave& own) {
  table.allow({"input", "output", "local", "length", "unit", "consistency", "name"});
  const bool input = table.has("input");
  if (input == table.has("output") || !table.has("local"))
    return table.problems().add(ProblemCode::P0744, table.place(), table.title(),
                                "input or output of the master and local of the slave: {input = "
                                "20, local = 30, length = 8}");
  const bool words = table.choice("unit", {"byte", "word"}) == std::size_t{1};
  const std::uint32_t most = words ? kLongestArea / 2 : kLongestArea;
  const std::uint32_t length = table.number("length", 1, most).value_or(1) * (words ? 2 : 1);
  const bool consistent = table.choice("consistency", {"unit", "all"}) == std::size_t{1};
  io::Module there = sideOf(table, input, length, input ? "input" : "output");
  there.name = table.text("name", "a text").value_or("");
  io::Module here = sideOf(table, !input, length, "local");
  const auto slot = static_cast<std::uint32_t>(io::kFirstArea + slave.modules.size());
  there.consistent = here.consistent = consistent;
  there.slot = here.slot = slot;
  there.rack = here.rack = io::kSlaveRack + slave.address;
  slave.modules.push_back(std::move(there));
  own.self.modules.push_back(std::move(here));
}

}  // namespace

bool readIntelligentSlave(const Table& table, const Network* network,
                          const std::vector<DpSubnet>& subnets, DpSubnet& subnet,
                          io::Slave& slave) {
  const auto station = stationOf(table, network, subnets);
  if (!station) return false;
  IntelligentSlave result{*station, table.at("station"), {}};
  slave.intelligent = true;
  slave.model = "intelligent slave";
  slave.ident = kIdent;
  result.own.master = subnet.master.address;
  result.own.self.address = slave.address;
  result.own.self.name = "X2";
  result.own.self.model = slave.model;
  slave.head = result.own.self.head = io::kHeadSlot;
  result.own.self.position = slave.position;
  for (const Table& area : table.tables("modules")) readArea(area, slave, result.own);
  if (slave.modules.empty())
    table.problems().add(ProblemCode::P0744, table.place(), table.title(),
                         "modules = [ {input = 20, local = 30, length = 8} ]");
  checkLengths(table, slave, kLimits, "areas");
  subnet.intelligent.push_back(std::move(result));
  return true;
}

}  // namespace merker::project
