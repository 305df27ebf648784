// Racks and the modules in them as SZL shows them (S7-DIAG-05). Records: reference manual "System
// Software for S7-300/400", 33.25 to 33.27; values of the CPU's own one: a CPU 315-2 PN/DP.
#include <algorithm>

#include "system/module_access.h"
#include "system/szl.h"

namespace merker::system {
namespace {

constexpr std::uint32_t kCpuSlot = 2, kCpuAddress = 0x7FFF, kCpuType = 0x00C0;
constexpr std::uint32_t kOutputAddress = 0x8000;
// Status: the module is there, or is not; first byte: its address is one of inputs, or of outputs.
constexpr std::uint32_t kPresent = 0x02, kAbsent = 0x04, kIsInput = 0xB400, kIsOutput = 0xB500;
constexpr std::uint32_t kS7300OneSlot = 0x0011;  // area and width of the module

std::vector<ModuleInfo> modulesOf(const SzlSource& source) {
  return source.modules == nullptr ? std::vector<ModuleInfo>{} : source.modules->all();
}

void moduleRecord(SzlList& list, std::uint32_t rack, std::uint32_t slot, std::uint32_t address,
                  std::uint32_t type, bool present, bool outputs) {
  list.word(rack);
  list.word(slot);
  list.word(address);
  list.word(type);
  list.word(present ? type : 0);
  list.word(0);
  list.word((outputs ? kIsOutput : kIsInput) | (present ? kPresent : kAbsent));
  list.word(kS7300OneSlot);
}

void cpuRecord(SzlList& list) {
  moduleRecord(list, 0, kCpuSlot << 8, kCpuAddress, kCpuType, true, false);
}

void moduleRecord(SzlList& list, const ModuleInfo& module) {
  const ModuleBase base = baseOf(module);
  moduleRecord(list, module.place.rack, module.place.slot << 8u | module.place.subslot,
               base.address, module.type, module.plugged, base.area == kOutputArea);
}

// One bit a rack, the first one in bit 0 of the first byte.
std::uint32_t racks(const SzlSource& source, bool (*counts)(const ModuleInfo&)) {
  std::uint32_t bits = 0;
  for (const ModuleInfo& module : modulesOf(source))
    if (counts(module)) bits |= 1u << module.place.rack;
  return bits;
}

std::uint32_t present(const SzlSource& source) {
  return 1 | racks(source, [](const ModuleInfo&) { return true; });
}

std::uint32_t faulty(const SzlSource& source) {
  return racks(source, [](const ModuleInfo& module) { return !module.plugged; });
}

// INDEX 0: the racks; another one: a DP master system, and there is none.
void rackBits(std::uint32_t index, std::uint32_t bits, SzlList& list) {
  if (index != 0) return;
  list.byte(bits);
  list.data.resize(list.recordLength);
}

// The same for many stations: INDEX, then bit 0 of all together, then one for each rack.
void stationBits(std::uint32_t index, std::uint32_t bits, SzlList& list) {
  if (index != 0) return;
  list.word(index);
  list.word(bits << 1 | (bits != 0));
  std::swap(list.data[2], list.data[3]);
  list.data.resize(list.recordLength);
}

}  // namespace

// Number of a rack, and of the modules that it holds.
void szlExpansion(const SzlSource& source, std::uint32_t, SzlList& list) {
  constexpr std::uint32_t kSlots = 8;
  for (std::uint32_t rack = 0; rack < source.cpu.machine().model->racks; ++rack) {
    list.word(rack);
    list.word(kSlots);
  }
}

void szlOneExpansion(const SzlSource& source, std::uint32_t rack, SzlList& list) {
  SzlList all;
  szlExpansion(source, 0, all);
  const std::size_t at = rack * std::size_t{4};
  if (at + 4 <= all.data.size()) list.data.assign(&all.data[at], &all.data[at] + 4);
}

void szlSubmodules(const SzlSource& source, std::uint32_t, SzlList& list) {
  for (const ModuleInfo& module : modulesOf(source))
    if (module.place.subslot != 0) moduleRecord(list, module);
}

void szlMasterSystems(const SzlSource&, std::uint32_t, SzlList&) {}  // there are none

// INDEX: an address of the module, bit 15 for outputs.
void szlModuleByAddress(const SzlSource& source, std::uint32_t index, SzlList& list) {
  if (index == kCpuAddress) return cpuRecord(list);
  const std::uint32_t area = (index & kOutputAddress) != 0 ? kOutputArea : kInputArea;
  const auto module = moduleAt(source.modules, area, index & ~kOutputAddress, AddressRule::Any);
  if (module) moduleRecord(list, *module);
}

// INDEX: the rack in its high byte; in the low one a DP station, and there is none.
void szlModulesOfRack(const SzlSource& source, std::uint32_t index, SzlList& list) {
  if ((index & 0xFF) != 0) return;
  if (index == 0) cpuRecord(list);
  for (const ModuleInfo& module : modulesOf(source))
    if (module.place.rack == index >> 8) moduleRecord(list, module);
}

void szlRacks(const SzlSource& source, std::uint32_t index, SzlList& list) {
  rackBits(index, present(source), list);
}

void szlFaultyRacks(const SzlSource& source, std::uint32_t index, SzlList& list) {
  rackBits(index, faulty(source), list);
}

void szlStations(const SzlSource& source, std::uint32_t index, SzlList& list) {
  stationBits(index, present(source), list);
}

void szlFaultyStations(const SzlSource& source, std::uint32_t index, SzlList& list) {
  stationBits(index, faulty(source), list);
}

}  // namespace merker::system
