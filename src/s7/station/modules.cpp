#include "station/modules.h"

#include "catalogue/ethernet.h"
#include "io/slave.h"
#include "profibus/slave_diagnosis.h"

namespace merker::station {
namespace {

using system::ModuleInfo;
using system::ModulePlace;
using system::RecordResult;

// Places of slaves differ from those of racks by a sub-slot that no CPU has.
constexpr std::uint8_t kSlaveSubslot = 0xFF;

ModulePlace placeOf(const io::Module& module) {
  const bool slave = module.rack >= io::kSlaveRack;
  if (slave)
    return {static_cast<std::uint8_t>(module.rack - io::kSlaveRack),
            static_cast<std::uint8_t>(module.slot), kSlaveSubslot};
  return {static_cast<std::uint8_t>(module.rack), static_cast<std::uint8_t>(module.slot),
          static_cast<std::uint8_t>(module.subslot)};
}

system::AddressRange range(std::optional<std::uint32_t> start, unsigned bytes) {
  if (!start) return {};
  return {static_cast<std::uint16_t>(*start), static_cast<std::uint16_t>(bytes)};
}

// Type of the module as SZL 0D91 shows it: first digit 1 inputs, 2 outputs, 3 both for analog, 9,
// A, B for digital modules; second digit the class of data record 0 (docs/compatibility.md,
// "Modules").
std::uint16_t typeCode(const ModuleType& type) {
  const unsigned direction = (type.hasInputs() ? 1u : 0u) + (type.hasOutputs() ? 2u : 0u);
  const bool digital = type.kind == ModuleKind::Digital;
  const bool analog = type.kind == ModuleKind::Analog || type.kind == ModuleKind::Position;
  const unsigned first = digital ? 8 + direction : direction;
  const unsigned second = digital                                  ? 0xF
                          : analog                                 ? 0x5
                          : type.kind == ModuleKind::Communication ? 0xC
                                                                   : 0x8;
  const unsigned channels =
      type.digitalInputs + type.digitalOutputs + type.analogInputs + type.analogOutputs;
  return static_cast<std::uint16_t>(first << 12 | second << 8 | 0xC0 | (channels & 0x3F));
}

}  // namespace

std::vector<ModuleInfo> Modules::all() const {
  std::vector<ModuleInfo> list;
  for (const io::Module& module : rack_.configuration().modules) {
    if (!module.inputStart && !module.outputStart) continue;
    ModuleInfo info;
    info.place = placeOf(module);
    info.inputs = range(module.inputStart, module.type->inputBytes);
    info.outputs = range(module.outputStart, module.type->outputBytes);
    info.type = typeCode(*module.type);
    info.plugged = answers(module);
    info.diagnostics = module.type->diagnosticInterrupt;
    info.distributed = module.rack >= io::kSlaveRack;
    info.ethernet = hasEthernet(*module.type);
    list.push_back(info);
  }
  return list;
}

const io::Module* Modules::find(const ModulePlace& place) const {
  for (const io::Module& module : rack_.configuration().modules)
    if (placeOf(module) == place) return &module;
  return nullptr;
}

bool Modules::answers(const io::Module& module) const {
  return rack_.present(static_cast<std::uint32_t>(&module - rack_.configuration().modules.data()));
}

// Records 0 and 1: diagnostic data of modules that have them.
RecordResult Modules::readRecord(const ModulePlace& place, std::uint8_t number,
                                 std::vector<std::uint8_t>& data) {
  const io::Module* module = find(place);
  if (module == nullptr || !answers(*module)) return RecordResult::NotAcknowledged;
  if (number > 1 || !module->type->diagnosticInterrupt) return RecordResult::UnknownRecord;
  data = number == 0 ? rack_.record0(*module) : rack_.record1(*module);
  return RecordResult::Good;
}

// Parameters are those of the hardware configuration (docs/compatibility.md, "Modules").
RecordResult Modules::writeRecord(const ModulePlace& place, std::uint8_t,
                                  std::span<const std::uint8_t>) {
  const io::Module* module = find(place);
  if (module == nullptr || !answers(*module)) return RecordResult::NotAcknowledged;
  return RecordResult::UnknownRecord;
}

std::vector<std::uint8_t> Modules::configuredRecords(const ModulePlace&) const { return {}; }

std::optional<std::vector<std::uint8_t>> Modules::slaveDiagnosis(std::uint32_t address) const {
  if (!rack_.configuration().dp) return std::nullopt;
  for (const io::Slave& slave : rack_.configuration().dp->slaves)
    if (slave.diagnosis == address) return profibus::slaveDiagnosis(rack_, slave);
  return std::nullopt;
}

// The telegram goes out with the next turns of the slaves.
std::uint32_t Modules::command(const SlaveCommand& command, Instant now) {
  constexpr std::uint32_t kNoMaster = 0x8090, kNoGroup = 0x80B0, kNoSync = 0x80B2,
                          kNoFreeze = 0x80B3;
  if (!exchange_.any() || command.master != exchange_.master().diagnosis) return kNoMaster;
  const auto wants = [&](profibus::Control one) {
    return (command.commands & static_cast<std::uint8_t>(one)) != 0;
  };
  unsigned groups = 0;
  bool sync = true, freeze = true;
  for (const io::Slave& slave : exchange_.master().slaves) {
    groups |= slave.groups;
    if ((slave.groups & command.groups) == 0) continue;
    sync &= slave.sync;
    freeze &= slave.freeze;
  }
  if ((command.groups & ~groups) != 0) return kNoGroup;
  if (wants(profibus::Control::Sync) && !sync) return kNoSync;
  if (wants(profibus::Control::Freeze) && !freeze) return kNoFreeze;
  exchange_.control(command.groups, command.commands, now);
  return 0;
}

std::optional<std::vector<std::uint8_t>> Modules::configuredRecord(const ModulePlace&,
                                                                   std::uint8_t) const {
  return std::nullopt;
}

}  // namespace merker::station
