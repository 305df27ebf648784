#include <algorithm>

#include "base/text.h"
#include "io/addresses.h"
#include "io/slave.h"

namespace merker::io {
namespace {

// The names and the row that refers to them.
struct OwnType {
  std::string name;
  ModuleType row;
};

std::shared_ptr<const ModuleType> owned(const std::string& name, ModuleType row) {
  auto own = std::make_shared<OwnType>(OwnType{name, row});
  own->row.name = own->name;
  return {own, &own->row};
}

ModuleType dataRow(std::uint32_t inputs, std::uint32_t outputs) {
  return {.orderNumber = "DP",
          .name = {},
          .text = {},
          .kind = ModuleKind::Communication,
          .inputBytes = static_cast<std::uint8_t>(inputs),
          .outputBytes = static_cast<std::uint8_t>(outputs)};
}

std::shared_ptr<const ModuleType> headType(const std::string& model) {
  return owned(model, {.orderNumber = {}, .name = {}, .text = {}, .kind = ModuleKind::Interface});
}

class FreeBytes {
 public:
  explicit FreeBytes(const Configuration& configuration)
      : inputs_(configuration.model->peripheralBytes),
        outputs_(configuration.model->peripheralBytes) {
    for (const Module& module : configuration.modules) take(module);
  }

  void take(const Module& module) {
    mark(inputs_, module.inputStart, module.type->inputBytes);
    mark(outputs_, module.outputStart, module.type->outputBytes);
  }
  void markInput(std::uint32_t byte) { mark(inputs_, byte, 1); }

  std::uint32_t input(std::uint32_t count) const { return lowest(inputs_, count); }
  std::uint32_t output(std::uint32_t count) const { return lowest(outputs_, count); }
  // HW Konfig gives diagnostic addresses from the highest byte down.
  std::uint32_t highestInput() const {
    std::uint32_t byte = static_cast<std::uint32_t>(inputs_.size());
    while (byte-- > 1)
      if (!inputs_[byte]) break;
    return byte;
  }

 private:
  static void mark(std::vector<bool>& taken, std::optional<std::uint32_t> start,
                   std::uint32_t count) {
    if (!start) return;
    for (std::uint32_t i = *start; i < *start + count && i < taken.size(); ++i) taken[i] = true;
  }
  static std::uint32_t lowest(const std::vector<bool>& taken, std::uint32_t count) {
    for (std::uint32_t start = 0; start + count <= taken.size(); ++start) {
      const auto from = taken.begin() + start;
      if (std::find(from, from + count, true) == from + count) return start;
    }
    return static_cast<std::uint32_t>(taken.size());  // beyond the area, which is a problem
  }

  std::vector<bool> inputs_, outputs_;
};

Module headOf(const Slave& slave, const DpMaster& master) {
  Module head;
  head.own = headType(slave.model);
  head.type = head.own.get();
  head.rack = kSlaveRack + slave.address;
  head.slot = slave.head;
  head.name = slave.name;
  head.position = slave.position;
  head.parameters = Parameters::of(*head.type);
  // RACKS_FLTD of OB 86 (S7-OBI-11): station, DP master system 1, diagnostic address.
  head.station = std::uint32_t{slave.diagnosis} << 16 | 1u << 8 | slave.address;
  head.master = master.diagnosis;
  return head;
}

void checkSlaveNames(const std::vector<Module>& modules, Problems& problems) {
  for (auto one = modules.begin(); one != modules.end(); ++one)
    for (auto other = modules.begin(); other != one; ++other)
      if (!one->name.empty() && equalsIgnoreCase(one->name, other->name))
        problems.add(ProblemCode::P0742, one->position, one->name, "slot " + other->slotText());
}

}  // namespace

std::shared_ptr<const ModuleType> slaveModule(const std::string& name, std::uint32_t inputs,
                                              std::uint32_t outputs) {
  constexpr std::uint32_t kTerminals = 4;  // bytes
  ModuleType row = dataRow(inputs, outputs);
  if (inputs <= kTerminals && outputs <= kTerminals) {
    row.kind = ModuleKind::Digital;
    row.digitalInputs = static_cast<std::uint8_t>(8 * inputs);
    row.digitalOutputs = static_cast<std::uint8_t>(8 * outputs);
  }
  return owned(name, row);
}

std::shared_ptr<const ModuleType> dataModule(const std::string& name, std::uint32_t inputs,
                                             std::uint32_t outputs) {
  return owned(name, dataRow(inputs, outputs));
}

// Addresses that are free for the areas, then all are checked together.
void addOwnSlave(Configuration& configuration, OwnSlave own, Problems& problems) {
  FreeBytes bytes(configuration);
  for (const Module& area : own.self.modules) bytes.take(area);
  own.self.diagnosis = static_cast<std::uint16_t>(bytes.highestInput());
  DpMaster itself;
  itself.diagnosis = own.self.diagnosis;
  configuration.modules.push_back(headOf(own.self, itself));
  for (const Module& area : own.self.modules) configuration.modules.push_back(area);
  checkSlaveNames(configuration.modules, problems);
  checkAddresses(configuration, problems);
  configuration.ownSlave = std::make_shared<const OwnSlave>(std::move(own));
}

void addSlaves(Configuration& configuration, DpMaster master, Problems& problems) {
  FreeBytes bytes(configuration);
  for (const Slave& slave : master.slaves)
    for (const Module& module : slave.modules) bytes.take(module);
  const auto diagnostic = [&] {
    const std::uint32_t byte = bytes.highestInput();
    bytes.markInput(byte);
    return static_cast<std::uint16_t>(byte);
  };
  master.diagnosis = diagnostic();
  for (Slave& slave : master.slaves) {
    slave.diagnosis = diagnostic();
    for (Module& module : slave.modules) {
      if (module.type->hasInputs() && !module.inputStart)
        module.inputStart = bytes.input(module.type->inputBytes);
      if (module.type->hasOutputs() && !module.outputStart)
        module.outputStart = bytes.output(module.type->outputBytes);
      bytes.take(module);
      slave.inputs += module.type->inputBytes;
      slave.outputs += module.type->outputBytes;
    }
    configuration.modules.push_back(headOf(slave, master));
    for (const Module& module : slave.modules) configuration.modules.push_back(module);
  }
  checkSlaveNames(configuration.modules, problems);
  checkAddresses(configuration, problems);
  configuration.dp = std::make_shared<const DpMaster>(std::move(master));
}

}  // namespace merker::io
