// The conformance programs and examples, each on both engines: calls with parameters, system
// functions, error OBs as people write them.
#include <gtest/gtest.h>

#include <filesystem>
#include <random>

#include "case.h"
#include "comparison.h"
#include "jit/native.h"
#include "mc7/encoding.h"
#include "source.h"
#include "stand.h"

namespace merker::differential {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> sources() {
  std::vector<std::string> paths;
  for (const char* folder : {"/tests/conformance", "/examples"})
    for (const auto& entry :
         fs::recursive_directory_iterator(MERKER_SOURCE_DIR + std::string(folder)))
      if (entry.path().extension() == ".awl" &&
          entry.path().string().find("rejected") == std::string::npos)
        paths.push_back(entry.path().string());
  std::sort(paths.begin(), paths.end());
  return paths;
}

std::string modelOf(const std::string& path) {
  return path.find("_generic4") != std::string::npos ? "generic-4" : "314C-2 PtP";
}

void advance(cpu::Cpu& cpu, Instant until, std::uint32_t inputs) {
  for (unsigned byte = 0; byte < 4; ++byte)
    cpu.machine().areas.inputs[byte] = static_cast<std::uint8_t>(inputs >> 8 * byte);
  while (cpu.machine().clock < until && executes(cpu.mode())) cpu.step(until);
}

// Between the stops up to 1 ms at first, later up to 1 s: timers, IEC timers, delays.
std::string difference(const std::shared_ptr<const block::Program>& program,
                       const std::string& model) {
  constexpr int kStops = 60, kFar = 50;
  const CpuParameters parameters = CpuParameters::of(*findModel(model));
  cpu::Cpu& interpreted = stand({.model = model, .compiled = false}).load(program, parameters);
  cpu::Cpu& compiled = stand({.model = model}).load(program, parameters);
  for (cpu::Cpu* cpu : {&interpreted, &compiled}) cpu->restart(cpu::Restart::ManualWarm);
  std::mt19937 random(1);
  for (int i = 0; i < kStops; ++i) {
    const auto most = Duration::milliseconds(i < kFar ? 1 : 1000);
    const Instant until =
        interpreted.machine().clock +
        Duration{static_cast<std::int64_t>(random() % static_cast<std::uint64_t>(most.ns))};
    const auto inputs = static_cast<std::uint32_t>(random());
    advance(interpreted, until, inputs);
    advance(compiled, until, inputs);
    const std::string found = compare(interpreted, compiled);
    if (!found.empty()) return fmt::format("stop {}:\n{}", i, found);
    if (!executes(interpreted.mode())) break;
  }
  return {};
}

// Without a stop in between, where nothing keeps compiled code from running: what the program has
// left, its checks stripped.
std::string differenceAtTheEnd(const std::shared_ptr<const block::Program>& program,
                               const std::string& model) {
  const CpuParameters parameters = CpuParameters::of(*findModel(model));
  cpu::Cpu& interpreted = stand({.model = model, .compiled = false}).load(program, parameters);
  cpu::Cpu& compiled = stand({.model = model}).load(program, parameters);
  for (cpu::Cpu* cpu : {&interpreted, &compiled}) {
    cpu->restart(cpu::Restart::ManualWarm);
    advance(*cpu, cpu->machine().clock + Duration::milliseconds(200), 0x5A0F);
  }
  return compare(interpreted, compiled);
}

TEST(DifferentialPrograms, ConformanceAndExamples) {
  if (!jit::available()) GTEST_SKIP() << "no compiler for this processor";
  int compared = 0;
  for (const std::string& path : sources()) {
    const std::string model = modelOf(path);
    auto program = std::make_shared<block::Program>(compiled(path, *findModel(model)));
    if (!program->contains({BlockKind::OB, 1})) continue;  // needs its project's other files
    EXPECT_EQ(difference(program, model), "") << path;
    EXPECT_EQ(differenceAtTheEnd(program, model), "") << path << " at its end";
    ++compared;
  }
  EXPECT_GT(compared, 100);
  std::cout << compared << " programs\n";
}

// 120 bytes of which each is read, changed and only written at the end.
block::Block manyValues() {
  block::Block block{.id = {BlockKind::OB, 1}};
  for (std::uint32_t byte = 0; byte < 120; ++byte)
    (void)mc7::encode({mc7::Operation::SET_BIT,
                       mc7::memory(Area::Flag, Width::Bit, bitAddress(100 + byte, byte % 8))},
                      block.code);
  block.code.insert(block.code.end(), {0x65, 0x00});  // BE
  return block;
}

std::size_t compiledBytes(std::uint32_t slots) {
  auto program = std::make_shared<block::Program>();
  program->emplace(manyValues().id, manyValues());
  return station::MixedEngine::compiledBytes(
      stand({.model = "314C-2 PtP", .slots = slots}).load(program, {}));
}

// No block goes back to the interpreter because it has too many values at a time; its regions
// become shorter.
TEST(DifferentialPrograms, ManyValuesAtATimeAreCompiled) {
  if (!jit::available()) GTEST_SKIP() << "no compiler for this processor";
  const std::size_t atOnce = compiledBytes(UINT32_MAX);
  EXPECT_GT(atOnce, 0u);
  EXPECT_GT(compiledBytes(4), atOnce / 2);
  Case c;
  c.blocks[{BlockKind::OB, 1}] = manyValues().code;
  for (const std::uint32_t slots : {4u, UINT32_MAX})
    EXPECT_EQ(differential::difference(c, {}, slots), "");
}

// They would not be called if they did not compile.
TEST(DifferentialPrograms, SystemCallsAreThere) {
  EXPECT_TRUE(systemCalls().contains({BlockKind::FC, 2}));
  EXPECT_TRUE(systemCalls().contains({BlockKind::FC, 3}));
}

}  // namespace
}  // namespace merker::differential
