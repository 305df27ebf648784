#include <fmt/format.h>

#include <random>

#include "base/bytes.h"
#include "case.h"
#include "comparison.h"
#include "cpu/trigger.h"
#include "edges.h"
#include "source.h"
#include "stand.h"

namespace merker::differential {
namespace {

using Random = std::mt19937;

std::uint32_t below(Random& random, std::uint32_t n) {
  return static_cast<std::uint32_t>(random() % n);
}

block::Block dataBlock(std::uint16_t number, std::size_t bytes, Random& random) {
  block::Block block;
  block.id = {BlockKind::DB, number};
  block.initialData.resize(bytes);
  // Double words that are pointers into the first bytes, and anything.
  for (std::size_t i = 0; i + 4 <= bytes; i += 4)
    storeDWord(&block.initialData[i],
               below(random, 2) != 0 ? below(random, 200) : static_cast<std::uint32_t>(random()));
  block.actualData = block.initialData;
  block.attributes.readOnly = number == 3;
  return block;
}

std::shared_ptr<const block::Program> program(const Case& c) {
  Random random(c.seed);
  auto result = std::make_shared<block::Program>();
  const auto add = [&](block::Block block) { result->emplace(block.id, std::move(block)); };
  add(dataBlock(1, 40, random));
  add(dataBlock(2, 64, random));
  add(dataBlock(3, 40, random));
  for (const auto& [id, code] : c.blocks) {
    block::Block block;
    block.id = id;
    block.code = code;
    block.localBytes = 40;
    add(std::move(block));
  }
  if (c.withSystemCalls()) result->insert(systemCalls().begin(), systemCalls().end());
  return result;
}

// Within the next instructions the time ends, or one of its units: exactly when one begins, for all
// of them take a multiple of a step.
Instant end(Random& random, const cpu::S5Timer& timer, Instant now) {
  constexpr std::int64_t kStep = 100, kSteps = 600, kUnits[] = {10, 100, 1'000, 10'000};  // ns; ms
  return now + Duration::milliseconds(kUnits[timer.base] * below(random, 3)) +
         Duration{kStep * below(random, kSteps)};
}

// Registers and memory; the same for both.
void fill(cpu::Machine& m, Random random) {
  const auto number = [&] {
    return below(random, 3) == 0 ? static_cast<std::uint32_t>(random())
                                 : kEdges[below(random, std::size(kEdges))];
  };
  for (std::uint32_t& accu : m.registers.accu) accu = number();
  constexpr Area kAreas[] = {Area::Flag, Area::DataBlock, Area::Input, Area::None, Area::Local};
  m.registers.ar1 =
      pointer(kAreas[below(random, 5)], 8 * (below(random, 12)) + (below(random, 4) == 0));
  m.registers.ar2 = pointer(kAreas[below(random, 5)], 8 * (below(random, 12)));
  m.registers.status = cpu::StatusWord::fromWord(static_cast<std::uint32_t>(random()));
  for (std::size_t i = 0; i + 4 <= 256; i += 4)
    storeDWord(m.image + i, below(random, 2) != 0 ? below(random, 160) : number());
  for (std::size_t i = 0; i < 8; ++i) {
    m.counters[i].count = static_cast<std::uint16_t>(below(random, 3));
    cpu::S5Timer& timer = m.timers[i];
    timer.kind = static_cast<cpu::S5Timer::Kind>(below(random, 5));
    timer.started = below(random, 2) != 0;
    timer.held = below(random, 4) == 0;
    timer.base = static_cast<std::uint8_t>(below(random, 4));
    timer.end = end(random, timer, m.clock);
  }
}

void advance(cpu::Cpu& cpu, Instant until) {
  while (cpu.machine().clock < until && executes(cpu.mode())) cpu.step(until);
}

// In OB 1 of the first cycle.
cpu::Cpu& started(Stand& stand, const Case& c, const std::shared_ptr<const block::Program>& p) {
  CpuParameters parameters = CpuParameters::of(*findModel(c.model));
  parameters.cyclic.push_back({.ob = 35, .interval = 1});
  cpu::Cpu& cpu = stand.load(p, parameters);
  cpu.restart(cpu::Restart::ManualWarm);
  while (executes(cpu.mode()) && cpu.machine().levels.empty()) cpu.step(Instant::never());
  fill(cpu.machine(), Random(c.seed ^ 0x5EED));
  return cpu;
}

Duration pause(Random& random) {
  const bool far = below(random, 4) == 0;
  return Duration{static_cast<std::int64_t>(below(random, far ? 1'000'000 : 4'000))};
}

}  // namespace

std::string difference(const Case& c, std::optional<icode::Opcode> broken, std::uint32_t slots) {
  constexpr int kStops = 12;
  constexpr std::uint32_t kSwitches = 40;  // one at so many stops
  const auto blocks = program(c);
  cpu::Cpu& interpreted = started(stand({.model = c.model, .compiled = false}), c, blocks);
  Stand& second = stand({.model = c.model, .broken = broken, .slots = slots});
  cpu::Cpu& compiled = started(second, c, blocks);
  Random random(c.seed);
  std::uint64_t seen = 0;
  for (int i = 0; i < kStops && executes(interpreted.mode()); ++i) {
    const Instant until = interpreted.machine().clock + pause(random);
    advance(interpreted, until);
    advance(compiled, until);
    const std::string found = compare(interpreted, compiled, seen);
    if (!found.empty()) return fmt::format("stop {}:\n{}", i, found);
    seen = interpreted.diagnostics().added();
    if (below(random, kSwitches) == 0) second.switchEngine();
    if (below(random, 3) != 0 || !executes(interpreted.mode())) continue;
    for (cpu::Cpu* cpu : {&interpreted, &compiled}) cpu::trigger(*cpu, {.ob = 40});
  }
  return {};
}

}  // namespace merker::differential
