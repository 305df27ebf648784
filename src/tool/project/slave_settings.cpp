// [[slave]]: what is connected to a DP master, from its GSD file or as ET 200M with modules of the
// catalogue, and the rules of its maker (S7-NET-04 to -06).
#include <fmt/format.h>

#include <algorithm>

#include "base/text.h"
#include "project/readers.h"
#include "project/slave_modules.h"

namespace merker::project {
namespace {

constexpr std::string_view kEt200M = "ET 200M";
constexpr std::uint16_t kEt200MIdent = 0x801D;  // IM 153-1
constexpr std::string_view kDrive = "PROFIdrive";
constexpr std::uint16_t kDriveIdent = 0x7F02;  // belongs to no maker
constexpr std::uint32_t kFirstEt200MSlot = 4, kEt200MModules = 8;
constexpr SlaveLimits kEt200MLimits{kEt200MModules, 128, 128, 256};

// Slots follow each other where none is named.
void readSlaveSlot(const Table& table, std::uint32_t first, std::uint32_t count, io::Module& module,
                   std::uint32_t& next) {
  module.slot = table.number("slot", first, first + count - 1).value_or(next);
  next = module.slot + 1;
}

bool isTaken(const io::Slave& slave, const io::Module& module) {
  return std::ranges::any_of(slave.modules,
                             [&](const io::Module& one) { return one.slot == module.slot; });
}

class SlaveReader {
 public:
  SlaveReader(const Table& table, io::Slave& slave) : table_(table), slave_(slave) {}

  void fromGsd(const gsd::Device& device, std::int64_t rate) {
    slave_.model = device.model;
    slave_.ident = static_cast<std::uint16_t>(device.ident);
    slave_.sync = device.sync;
    slave_.freeze = device.freeze;
    limits_ = {device.modular ? std::max<std::int64_t>(device.maxModules, 1) : 1,
               device.modular && device.maxInput > 0 ? device.maxInput : kLongestData,
               device.modular && device.maxOutput > 0 ? device.maxOutput : kLongestData,
               device.modular && device.maxData > 0 ? device.maxData : 2 * kLongestData};
    checkRate(device, rate);
    // A compact slave has one module, which need not be named.
    if (!device.modular && !table_.has("modules") && !device.modules.empty())
      add(moduleOf(device.modules.front()), 1, table_);
    std::uint32_t next = 1;
    for (const Table& table : table_.tables("modules"))
      if (auto module = readGsdModule(table, device)) {
        readSlaveSlot(table, 1, static_cast<std::uint32_t>(kLongestData), *module, next);
        add(std::move(*module), module->slot, table);
      }
    checkLengths(table_, slave_, limits_);
  }

  void et200M() {
    slave_.model = kEt200M;
    slave_.head = io::kHeadSlot;
    slave_.ident = kEt200MIdent;
    slave_.sync = slave_.freeze = true;
    std::uint32_t next = kFirstEt200MSlot;
    for (const Table& table : table_.tables("modules"))
      if (auto module = readModule(table, *findCpuModel("generic"))) {
        readSlaveSlot(table, kFirstEt200MSlot, kEt200MModules, *module, next);
        if (!module->type->signalModule())
          table.mustBe("type", "a signal module; ET 200M has its interface module itself");
        else
          add(std::move(*module), module->slot, table);
      }
    checkLengths(table_, slave_, limits_);
  }

  // `known`: it has no other keys; else it may have modules under another name.
  void drive(bool known) {
    slave_.model = kDrive;
    slave_.ident = kDriveIdent;
    slave_.sync = slave_.freeze = true;
    limits_.modules = 1;
    std::uint32_t slot = 1;
    for (const Table& table : table_.tables("modules"))
      if (auto module = readTelegram(table)) add(std::move(*module), slot++, table);
    if (known && table_.tables("modules").empty())
      table_.problems().add(ProblemCode::P0744, table_.place(), table_.title(),
                            "modules = [ {type = \"Standard telegram 9\"} ]");
    checkLengths(table_, slave_, limits_);
  }

 private:
  void add(io::Module module, std::uint32_t slot, const Table& table) {
    module.rack = io::kSlaveRack + slave_.address;
    module.slot = slot;
    if (module.position.line == 0) module.position = table.place();
    if (isTaken(slave_, module)) return table.mustBe("slot", "unique in the slave");
    slave_.modules.push_back(std::move(module));
  }

  void checkRate(const gsd::Device& device, std::int64_t rate) const {
    const auto known = std::ranges::find(device.rates, rate, &gsd::BaudRate::rate);
    if (known != device.rates.end() && !known->supported)
      table_.mustBe("subnet", fmt::format("a subnet with a baud rate that {} knows; {} is none",
                                          device.model, known->name));
  }

  const Table& table_;
  io::Slave& slave_;
  SlaveLimits limits_ = kEt200MLimits;
};

// Which subnet a slave is on, where several are; a second subnet is one mistake, however many
// slaves leave their own out.
class SubnetChoice {
 public:
  // `silent`: a subnet is missing because of a mistake in it, which is named there.
  SubnetChoice(std::vector<DpSubnet>& subnets, bool silent) : subnets_(subnets), silent_(silent) {}

  // Null, and a problem: it is on none.
  DpSubnet* of(const Table& table) {
    constexpr std::string_view kWhat = "the name of a [[subnet]] with kind = \"profibus\"";
    if (!table.has("subnet")) return onlyOne(table);
    const auto name = table.text("subnet", kWhat);
    if (!name) return nullptr;
    const auto found = std::ranges::find_if(
        subnets_, [&](const DpSubnet& one) { return equalsIgnoreCase(one.name, *name); });
    if (found != subnets_.end()) return &*found;
    if (!silent_) table.mustBe("subnet", kWhat);
    return nullptr;
  }

 private:
  DpSubnet* onlyOne(const Table& table) {
    if (subnets_.size() == 1) return &subnets_.front();
    if (!silent_)
      table.problems().add(
          ProblemCode::P0744, table.place(), table.title(),
          fmt::format("subnet = \"{}\": there are several PROFIBUS subnets", subnets_[0].name));
    silent_ = true;
    return nullptr;
  }

  std::vector<DpSubnet>& subnets_;
  bool silent_;
};

// 1 to the highest, and no other one's.
bool readAddressOnBus(const Table& table, const DpSubnet& subnet, io::Slave& slave) {
  if (!table.has("address"))
    table.problems().add(ProblemCode::P0744, table.place(), table.title(), "address = 4");
  const toml::node* const given = table.node("address");
  const std::int64_t value = given != nullptr ? given->value_or(std::int64_t{1}) : 1;
  if (value == 0 || value == 126) {
    table.mustBe("address", value == 0 ? "1 to 125: 0 is the programming device's"
                                       : "1 to 125: 126 is for slaves that have no address yet");
    return false;
  }
  const auto address = table.number("address", 1, 125);
  if (!address) return false;
  slave.address = static_cast<std::uint8_t>(*address);
  const bool taken = slave.address == subnet.master.address ||
                     std::ranges::any_of(subnet.master.slaves, [&](const io::Slave& one) {
                       return one.address == slave.address;
                     });
  if (taken)
    table.mustBe("address", fmt::format("unique on the subnet; {} is another node's", *address));
  else if (*address > subnet.highest)
    table.mustBe("address",
                 fmt::format("at most the highest address of the subnet, {}", subnet.highest));
  return true;
}

void readGroups(const Table& table, io::Slave& slave) {
  constexpr std::uint32_t kGroups = 8;
  for (const Table::Number& group : table.numbers("groups", "groups from 1 to 8: [1, 2]")) {
    if (group.value < 1 || group.value > kGroups)
      table.mustBe("groups", "groups from 1 to 8: [1, 2]");
    else
      slave.groups = static_cast<std::uint8_t>(slave.groups | 1u << (group.value - 1));
  }
}

// A GSD file, a type or a station; SYNC and FREEZE are for the first two.
bool namesOneKind(const Table& table) {
  const char* first = nullptr;
  for (const char* key : {"station", "type", "gsd"}) {
    if (!table.has(key)) continue;
    if (first != nullptr) {
      table.mustBe(key, fmt::format("omitted; the slave has {}", first));
      return false;
    }
    first = key;
  }
  if (table.has("station") && table.has("groups"))
    table.mustBe("groups", "omitted; an intelligent slave has neither SYNC nor FREEZE");
  return true;
}

// Behind the others of its subnet, unless it is too wrong.
void readSlave(const Table& table, const Network* network, std::vector<DpSubnet>& subnets,
               DpSubnet& subnet, io::Slave slave, bool known) {
  slave.name = table.text("name", "a text").value_or(fmt::format("DP{}", slave.address));
  if (trim(slave.name).empty()) table.mustBe("name", "a name, or left out");
  if (!namesOneKind(table)) return;
  readGroups(table, slave);
  SlaveReader reader(table, slave);
  if (table.has("station")) {
    if (!readIntelligentSlave(table, network, subnets, subnet, slave)) return;
  } else if (table.has("type")) {
    const auto type = table.choice("type", {kEt200M, kDrive});
    if (type == std::size_t{0}) reader.et200M();
    if (type == std::size_t{1}) reader.drive(known);
  } else if (!table.has("gsd")) {
    table.problems().add(ProblemCode::P0744, table.place(), table.title(),
                         "gsd = \"valves.gsd\", type = \"ET 200M\" or type = \"PROFIdrive\"");
  } else if (const auto device = readGsd(table)) {
    reader.fromGsd(*device, subnet.master.rate);
  }
  subnet.master.slaves.push_back(std::move(slave));
}

}  // namespace

bool readSlaves(const Table& root, const Network* network, std::vector<DpSubnet>& subnets,
                bool allSubnets) {
  constexpr std::size_t kMost = 125;
  bool complete = true;
  SubnetChoice choice(subnets, !allSubnets);
  for (const Table& table : root.tables("slave", kMost)) {
    const bool known =
        table.allow({"name", "subnet", "address", "gsd", "type", "station", "groups", "modules"});
    DpSubnet* const subnet = choice.of(table);
    io::Slave slave;
    slave.position = table.place();
    const std::size_t before = subnet == nullptr ? 0 : subnet->master.slaves.size();
    if (subnet != nullptr && readAddressOnBus(table, *subnet, slave))
      readSlave(table, network, subnets, *subnet, std::move(slave), known);
    complete &= subnet != nullptr && subnet->master.slaves.size() > before;
  }
  return complete;
}

}  // namespace merker::project
