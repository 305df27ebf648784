#include <fmt/format.h>
#include <fmt/ranges.h>

#include <random>

#include "base/bytes.h"
#include "case.h"
#include "cpu/trigger.h"
#include "station/engines.h"

namespace merker::differential {
namespace {

struct NoServices : cpu::SystemServices {
  bool call(const cpu::SystemCall&) override { return false; }
};

block::Block dataBlock(std::uint16_t number, std::size_t bytes, std::mt19937& random) {
  block::Block block;
  block.id = {BlockKind::DB, number};
  block.initialData.resize(bytes);
  // Double words that are pointers into the first bytes, and anything.
  for (std::size_t i = 0; i + 4 <= bytes; i += 4)
    storeDWord(&block.initialData[i],
               random() % 2 != 0 ? random() % 200 : static_cast<std::uint32_t>(random()));
  block.actualData = block.initialData;
  block.attributes.readOnly = number == 3;
  return block;
}

std::shared_ptr<const block::Program> program(const Case& c) {
  std::mt19937 random(c.seed);
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
  return result;
}

void fill(cpu::Machine& m, std::mt19937& random) {
  const auto number = [&] {
    constexpr std::uint32_t kValues[] = {0, 1, 0xFFFFFFFF, 0x7FFF, 0x8000, 0x80000000, 0x42280000};
    return random() % 3 == 0 ? static_cast<std::uint32_t>(random()) : kValues[random() % 7];
  };
  for (std::uint32_t& accu : m.registers.accu) accu = number();
  constexpr Area kAreas[] = {Area::Flag, Area::DataBlock, Area::Input, Area::None, Area::Local};
  m.registers.ar1 = pointer(kAreas[random() % 5], 8 * (random() % 12) + (random() % 4 == 0));
  m.registers.ar2 = pointer(kAreas[random() % 5], 8 * (random() % 12));
  m.registers.status = cpu::StatusWord::fromWord(static_cast<std::uint32_t>(random()));
  for (std::size_t i = 0; i + 4 <= 256; i += 4)
    storeDWord(m.image + i, random() % 2 != 0 ? random() % 160 : number());
  for (std::size_t i = 0; i < 8; ++i) {
    m.counters[i].count = static_cast<std::uint16_t>(random() % 3);
    cpu::S5Timer& timer = m.timers[i];
    timer.kind = static_cast<cpu::S5Timer::Kind>(random() % 5);
    timer.started = random() % 2 != 0;
    timer.held = random() % 4 == 0;
    timer.end = m.clock + Duration{static_cast<std::int64_t>(random() % 200'000)};
  }
}

std::string registers(const cpu::Registers& r) {
  return fmt::format("accu {:08X} ar1 {:08X} ar2 {:08X} db {}/{}/{} di {}/{}/{} status {:09b}\n",
                     fmt::join(r.accu, " "), r.ar1, r.ar2, r.db.number, r.db.length, r.db.writable,
                     r.di.number, r.di.length, r.di.writable, r.status.word());
}

std::string bytes(std::string_view name, std::span<const std::uint8_t> data) {
  return fmt::format("{} {:02X}\n", name, fmt::join(data, ""));
}

std::string stacks(const cpu::Cpu& cpu) {
  const cpu::Machine& m = cpu.machine();
  std::string text = fmt::format("position {} mcr {} {} {} levelEnded {}\n", m.position,
                                 m.mcrActive, m.mcrOff, m.mcrStack.size(), m.levelEnded);
  for (const cpu::Bracket& b : m.brackets)
    text += fmt::format("bracket {} {} {} {}\n", b.function, b.rlo, b.orBit, b.er);
  for (const cpu::Frame& f : m.frames)
    if (f.code != nullptr)
      text += fmt::format("frame {} resume {} local {} ar2 {:X} db {} di {}\n",
                          toString(f.code->source->id), f.resume, f.localLength, f.ar2, f.db.number,
                          f.di.number);
  for (const cpu::Level& level : m.levels)
    text +=
        fmt::format("level OB {} priority {} frames {} ", level.ob, level.priority, level.frames) +
        registers(level.interrupted);
  for (const auto& local : m.localStacks)
    text += bytes("local", std::span(local).first(std::min<std::size_t>(local.size(), 256)));
  return text;
}

std::string snapshot(const cpu::Cpu& cpu) {
  const cpu::Machine& m = cpu.machine();
  std::string text = fmt::format("clock {} instructions {} mode {} cycles {}\n", m.clock.ns,
                                 m.instructions, static_cast<int>(cpu.mode()), cpu.cycles());
  text += registers(m.registers) + stacks(cpu);
  text += bytes("image",
                std::span(m.areas.image).first(std::min<std::size_t>(m.areas.image.size(), 1024)));
  text += bytes("outputs", std::span(m.areas.outputs).first(128));
  for (std::uint32_t n = 1; n <= 3; ++n)
    if (const auto* db = m.dataBlocks.find(n)) text += bytes(fmt::format("DB {}", n), db->data);
  for (std::size_t i = 0; i < 8; ++i) {
    const cpu::S5Timer& t = m.timers[i];
    const cpu::S5Counter& c = m.counters[i];
    text += fmt::format("T {} {}{}{}{}{} {} {} {}, Z {} {}{}{}{}\n", i, static_cast<int>(t.kind),
                        t.startEdge, t.enableEdge, t.started, t.held, t.base, t.frozen, t.end.ns,
                        c.count, c.setEdge, c.upEdge, c.downEdge, c.enableEdge);
  }
  text += fmt::format("diagnostics {}\n", cpu.diagnostics().added());
  for (const cpu::DiagnosticEvent& e : cpu.diagnostics().events())
    text += fmt::format("  {:04X} {} {} at {} {}\n", e.event, e.time.ns, e.text,
                        e.place.known ? toString(e.place.block) : "", e.place.offset);
  return text;
}

void advance(cpu::Cpu& cpu, Instant until) {
  while (cpu.machine().clock < until && executes(cpu.mode())) cpu.step(until);
}

}  // namespace

std::vector<std::string> run(const Case& c, const Engine& engine) {
  constexpr int kStops = 12;
  const CpuModel& model = *findCpuModel(c.model);
  NoServices services;
  station::Engines engines(model, engine.compiled,
                           {.jit = {.broken = engine.broken}, .shortestEntry = 1});
  CpuParameters parameters = CpuParameters::of(model);
  parameters.cyclic.push_back({.ob = 35, .interval = 1});
  cpu::Cpu cpu(model, engines, services, 0, parameters);
  cpu.load(program(c));
  std::mt19937 random(c.seed ^ 0x5EED);
  std::vector<std::string> states;
  cpu.restart(cpu::Restart::ManualWarm);
  while (executes(cpu.mode()) && cpu.machine().levels.empty()) cpu.step(Instant::never());
  fill(cpu.machine(), random);
  for (int i = 0; i < kStops && executes(cpu.mode()); ++i) {
    const bool far = random() % 4 == 0;
    advance(cpu, cpu.machine().clock +
                     Duration{static_cast<std::int64_t>(random() % (far ? 1'000'000 : 4'000))});
    states.push_back(snapshot(cpu));
    if (random() % 3 == 0 && executes(cpu.mode())) cpu::trigger(cpu, {.ob = 40});
  }
  states.push_back(snapshot(cpu));
  return states;
}

namespace {

// The lines that are not the same.
std::string compare(const std::string& a, const std::string& b) {
  std::string text;
  std::size_t i = 0, k = 0;
  while (i < a.size() || k < b.size()) {
    const std::size_t endA = std::min(a.find('\n', i), a.size()),
                      endB = std::min(b.find('\n', k), b.size());
    const std::string x = i < a.size() ? a.substr(i, endA - i) : "";
    const std::string y = k < b.size() ? b.substr(k, endB - k) : "";
    if (x != y) text += "  interpreter " + x + "\n  compiled    " + y + "\n";
    i = endA + 1, k = endB + 1;
  }
  return text;
}

}  // namespace

std::string difference(const Case& c, std::optional<icode::Opcode> broken) {
  const auto expected = run(c, {.compiled = false});
  const auto found = run(c, {.compiled = true, .broken = broken});
  for (std::size_t i = 0; i < std::min(expected.size(), found.size()); ++i)
    if (expected[i] != found[i])
      return fmt::format("stop {}:\n{}", i, compare(expected[i], found[i]));
  return expected.size() == found.size() ? "" : "one engine stopped earlier";
}

}  // namespace merker::differential
