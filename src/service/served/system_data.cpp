#include "served/system_data.h"

#include "base/bytes.h"

namespace merker::served {
namespace {

using Octets = std::vector<std::uint8_t>;

constexpr std::uint16_t kNone = 0xFFFF;

// Numbers as the document has them; the value follows in a double word.
struct Setting {
  std::uint16_t number;
  std::uint32_t (*value)(const CpuParameters& cpu);
};

constexpr Setting kSettings[] = {
    {1, [](const CpuParameters& cpu) { return cpu.cycleMonitoring; }},
    {2, [](const CpuParameters& cpu) { return cpu.minimumCycle; }},
    {3, [](const CpuParameters& cpu) { return cpu.communicationLoad; }},
    {4, [](const CpuParameters& cpu) { return cpu.clockMemory.value_or(kNone); }},
    {5, [](const CpuParameters& cpu) { return cpu.retentiveFlags; }},
    {6, [](const CpuParameters& cpu) { return cpu.retentiveTimers; }},
    {7, [](const CpuParameters& cpu) { return cpu.retentiveCounters; }},
    {8, [](const CpuParameters& cpu) { return static_cast<std::uint32_t>(cpu.imageErrors); }},
    {9, [](const CpuParameters& cpu) { return static_cast<std::uint32_t>(cpu.afterPowerOn); }},
    {10, [](const CpuParameters& cpu) { return cpu.startOnMismatch ? 1u : 0u; }},
    {11, [](const CpuParameters& cpu) { return std::uint32_t{cpu.protection}; }},
};

// Of an OB: the high byte says what, the low one has its number.
enum ObSetting : std::uint16_t {
  kInterval = 0x100,
  kPhase = 0x200,
  kTimeOfDay = 0x300,
  kFirstTime = 0x400
};

void appendSetting(Octets& octets, std::uint32_t number, std::int64_t value) {
  appendWord(octets, number);
  appendDWord(octets, static_cast<std::uint32_t>(value));
}

Octets settingsOf(const CpuParameters& cpu) {
  Octets octets;
  for (const Setting& setting : kSettings)
    appendSetting(octets, setting.number, setting.value(cpu));
  for (const CyclicParameter& one : cpu.cyclic) {
    appendSetting(octets, kInterval | one.ob, one.interval);
    appendSetting(octets, kPhase | one.ob, one.phase);
  }
  for (const TimeOfDayParameter& one : cpu.timeOfDay) {
    appendSetting(octets, kTimeOfDay | one.ob, (one.active ? 0x1'0000 : 0) | one.period);
    appendSetting(octets, kFirstTime | one.ob, one.start / 1000);
  }
  return octets;
}

void appendAddresses(Octets& octets, std::optional<std::uint32_t> begin, std::uint8_t count) {
  appendWord(octets, begin.value_or(kNone));
  appendWord(octets, begin ? count : 0u);
}

Octets modulesOf(const io::Configuration& hardware) {
  constexpr std::size_t kOrderNumber = 20;
  Octets octets;
  for (const io::Module& module : hardware.modules) {
    for (const std::uint32_t place : {module.rack, module.slot, module.subslot, 0u})
      octets.push_back(static_cast<std::uint8_t>(place));
    const std::string_view order = module.type->orderNumber;
    octets.insert(octets.end(), order.begin(), order.end());
    octets.resize(octets.size() + kOrderNumber - order.size(), ' ');
    appendAddresses(octets, module.inputStart, module.type->inputBytes);
    appendAddresses(octets, module.outputStart, module.type->outputBytes);
  }
  return octets;
}

void add(block::Program& all, std::uint16_t number, Octets content) {
  block::Block block;
  block.id = {BlockKind::SDB, number};
  block.language = block::Language::Sdb;
  block.attributes.author = "MERKER";
  block.actualData = std::move(content);
  all.emplace(block.id, std::move(block));
}

}  // namespace

block::Program systemData(const CpuModel& model, const CpuParameters& parameters,
                          const io::Configuration* hardware) {
  block::Program all;
  add(all, 0, settingsOf(parameters));
  if (hardware != nullptr) add(all, 1, modulesOf(*hardware));
  add(all, 2, settingsOf(CpuParameters::of(model)));
  return all;
}

}  // namespace merker::served
