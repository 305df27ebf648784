#include "card.h"

namespace merker::store::test {

block::Block functionBlock(std::uint16_t number, std::uint8_t constant) {
  block::Block block;
  block.id = {BlockKind::FC, number};
  block.code = {0x28, constant, 0x65, 0x00};
  block.networks = {{0, {}}};
  return block;
}

block::Block dataBlock(std::uint16_t number, std::size_t bytes, std::uint8_t value) {
  block::Block block;
  block.id = {BlockKind::DB, number};
  block.language = block::Language::Db;
  block.actualData.assign(bytes, value);
  block.initialData = block.actualData;
  return block;
}

LoadMemory loadMemory() {
  LoadMemory load{"314C-2 PtP", "[project]\nname = \"Plant\"\n", {}};
  for (const block::Block& block : {functionBlock(1, 7), dataBlock(1, 600, 1), dataBlock(2, 10, 2)})
    load.program[block.id] = block;
  load.program[{BlockKind::DB, 2}].attributes.readOnly = true;
  return load;
}

block::RetentiveData retentiveData(std::uint8_t seed) {
  block::RetentiveData data;
  data.now = 1'000'000LL * seed;
  data.clock = 126'230'400'000 + seed;
  data.running = seed % 2 == 1;
  data.flags.assign(16, seed);
  data.timers = {{.kind = 2, .startEdge = true, .started = true, .base = 1, .end = -5'000'000},
                 {.kind = 4, .enableEdge = true, .held = true, .base = 3, .frozen = 77}};
  data.counters = {{.count = seed, .upEdge = true}, {.count = 999, .setEdge = true}};
  data.dataBlocks = {{1, false, std::vector<std::uint8_t>(600, seed)},
                     {2, false, std::vector<std::uint8_t>(10, seed)},
                     {9, true, std::vector<std::uint8_t>(256, seed)}};
  data.meters = {{3'600'000'000'000, 5, true}, {seed, 0, false}};
  data.eventsAdded = seed;
  data.events = {{0x4302, 17, "STARTUP to RUN", false, {}, 0, {}, {}},
                 {0x2521, -3, "BCD \xC3\xA4", true, {BlockKind::FC, 1}, seed, {1, 2}, {0x94}}};
  return data;
}

block::RetentiveData withoutCount(block::RetentiveData data) {
  data.eventsAdded = 0;
  return data;
}

}  // namespace merker::store::test
