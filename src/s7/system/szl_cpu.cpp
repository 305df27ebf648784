// What a CPU is: identification, characteristics, memory, areas, block types (S7-DIAG-05).
#include <algorithm>
#include <vector>

#include "system/memory_use.h"
#include "system/szl.h"

namespace merker::system {
namespace {

bool asked(std::uint32_t index, std::uint32_t record) { return index == 0 || index == record; }

std::uint32_t wordOf(std::uint64_t value) {
  return static_cast<std::uint32_t>(std::min<std::uint64_t>(value, 0xFFFF));
}

// Order number, filled up with blanks to 20 characters.
void identify(SzlList& list, std::uint32_t index, std::string_view orderNumber,
              std::uint32_t version, std::uint32_t rest) {
  list.word(index);
  for (std::size_t i = 0; i < 20; ++i)
    list.byte(i < orderNumber.size() ? static_cast<std::uint8_t>(orderNumber[i]) : ' ');
  list.word(0);
  list.word(version);
  list.word(rest);
}

struct Memory {
  std::uint32_t index, kind, mode, size, used;
};

void memory(SzlList& list, const Memory& m) {
  list.word(m.index);
  list.word(m.kind);
  list.dword(m.size);
  list.word(m.mode);
  list.word(0);
  list.dword(m.size);
  list.dword(m.used);
  list.dword(m.size - std::min(m.size, m.used));  // largest free block: there are no gaps
  for (int i = 0; i < 3; ++i) list.dword(0);      // second area
}

// 16#0300 group: what the machine code can do; 16#0302 … 16#0309 in the order of the manual.
std::vector<std::uint16_t> characteristics(const CpuModel& model) {
  std::vector<std::uint16_t> all{0x0002,                  // executes MC7
                                 0x0101, 0x0104, 0x0105,  // clock: 1 ms, BCD, set and read
                                 0x0202};                 // warm restart
  if (model.hotRestart) all.push_back(0x0203);
  for (std::uint16_t id = 0x0302; id <= 0x0316; ++id)
    if (id != 0x0305 || model.accumulators == 4) all.push_back(id);
  return all;
}

}  // namespace

void szlIdentification(const SzlSource& source, std::uint32_t index, SzlList& list) {
  const CpuModel& model = *source.cpu.machine().model;
  constexpr std::uint32_t kModule = 1, kHardware = 6, kFirmware = 7, kV = 'V' << 8;
  const std::uint32_t rest = static_cast<std::uint32_t>(model.firmware[1]) << 8 | model.firmware[2];
  if (asked(index, kModule)) identify(list, kModule, model.orderNumber, 1, 0);
  if (asked(index, kHardware)) identify(list, kHardware, model.orderNumber, 1, 0);
  if (asked(index, kFirmware))
    identify(list, kFirmware, {}, kV | static_cast<std::uint32_t>(model.firmware[0]), rest);
}

// Clients find a name by its place among the records: this order is that of the CPU.
void szlNames(const SzlSource& source, std::uint32_t index, SzlList& list) {
  constexpr std::size_t kCharacters = 32;
  const std::string_view model = source.cpu.machine().model->name;
  struct Name {
    std::uint32_t number;
    std::string_view text;
  };
  // station, module, plant identification, copyright, serial number, type of the module, memory
  // card, manufacturer (no registered one, generic device, CPU), OEM, location
  constexpr std::string_view kManufacturer("\0\0\xF6\0\0\1", 6);
  for (const Name& name : {Name{1, "Merker"}, Name{2, model}, Name{3, ""}, Name{4, "Merker"},
                           Name{5, "SIMULATED"}, Name{7, model}, Name{8, "MMC SIMULATED"},
                           Name{9, kManufacturer}, Name{10, ""}, Name{11, ""}}) {
    if (!asked(index, name.number)) continue;
    list.word(name.number);
    for (std::size_t i = 0; i < kCharacters; ++i)
      list.byte(i < name.text.size() ? static_cast<std::uint8_t>(name.text[i]) : 0);
  }
}

// INDEX: the group, 16#0000, 0100, 0200, 0300. The whole list is asked for with group 0 as well, so
// that the group of the processing unit cannot be told from it; it has one member.
void szlCharacteristics(const SzlSource& source, std::uint32_t index, SzlList& list) {
  for (const std::uint16_t id : characteristics(*source.cpu.machine().model))
    if (index == 0 || (id & 0xFF00) == index) list.word(id);
}

void szlMemory(const SzlSource& source, std::uint32_t index, SzlList& list) {
  constexpr std::uint32_t kWork = 1, kCard = 3, kVolatile = 1, kMixed = 3;
  constexpr std::uint32_t kRamTogether = 0x0011, kRamAndEprom = 0x0004;
  const cpu::Machine& m = source.cpu.machine();
  const MemoryUse use = memoryUse(m);
  if (asked(index, kWork))
    memory(list, {kWork, kVolatile, kRamTogether, m.model->workMemory, use.work});
  if (asked(index, kCard))
    memory(list, {kCard, kMixed, kRamAndEprom, m.model->loadMemory, use.load});
}

void szlAreas(const SzlSource& source, std::uint32_t index, SzlList& list) {
  const CpuModel& m = *source.cpu.machine().model;
  const CpuParameters& p = source.cpu.parameters();
  struct Area {
    std::uint64_t count, retentive;
  };
  // process images, flags in bits, timers, counters, periphery, local data, flags in bytes
  const Area areas[] = {{m.imageBytes, 0},
                        {m.imageBytes, 0},
                        {8ull * m.flagBytes, 8ull * p.retentiveFlags},
                        {m.timers, p.retentiveTimers},
                        {m.counters, p.retentiveCounters},
                        {m.peripheralBytes, 0},
                        {m.localBytes, 0},
                        {m.flagBytes, p.retentiveFlags}};
  constexpr std::uint32_t kRam = 1;
  std::uint32_t number = 0;
  for (const Area& area : areas) {
    if (!asked(index, ++number)) continue;
    list.word(number);
    list.word(kRam);
    list.word(wordOf(area.count));
    list.word(wordOf(area.retentive));
  }
}

void szlBlockTypes(const SzlSource& source, std::uint32_t index, SzlList& list) {
  const CpuModel& m = *source.cpu.machine().model;
  struct Kind {
    std::uint32_t number;
    std::int64_t count;
    std::uint32_t bytes;
  };
  const Kind kinds[] = {
      {0x0800, static_cast<std::int64_t>(m.organizationBlocks.size()), m.blockSize},
      {0x0A00, m.highestDb, m.dataBlockSize},
      {0x0B00, 0xFFFF, 0xFFFE},
      {0x0C00, m.highestFc + 1, m.blockSize},
      {0x0E00, m.highestFb + 1, m.blockSize}};
  for (const Kind& kind : kinds) {
    if (!asked(index, kind.number)) continue;
    list.word(kind.number);
    list.word(wordOf(static_cast<std::uint64_t>(kind.count)));
    list.word(kind.bytes / 1024);
    list.dword(kind.bytes);
  }
}

}  // namespace merker::system
