// Cycles that are passed over against cycles that are computed: random programs with everything
// that can make one cycle different from the one before, on both engines. MERKER_QUIET=<first
// seed>:<count> runs others.
#include <gtest/gtest.h>

#include <cstdlib>
#include <iostream>
#include <random>
#include <sstream>

#include "comparison.h"
#include "cpu/trigger.h"
#include "jit/native.h"
#include "quiet_program.h"
#include "source.h"
#include "stand.h"

namespace merker::differential {
namespace {

constexpr std::uint32_t kParts = 8;
#ifdef NDEBUG
constexpr std::uint32_t kPrograms = 60'000;
#else
constexpr std::uint32_t kPrograms = 1'000;
#endif

struct Totals {
  std::uint64_t cycles = 0, passed = 0, programs = 0, broken = 0;
};

class QuietRun {
 public:
  QuietRun(std::uint32_t seed, Totals& totals) : seed_(seed), random_(seed), totals_(totals) {}

  // Empty if there is no difference.
  std::string difference() {
    const auto program =
        std::make_shared<block::Program>(compiledText(quietProgram(seed_), *findModel(kModel)));
    ++totals_.programs;
    if (program->empty()) {
      ++totals_.broken;
      return "the program does not compile";
    }
    CpuParameters parameters = this->parameters();
    if (program->contains({BlockKind::OB, 85})) parameters.imageErrors = ImageErrors::EachCycle;
    const std::uint32_t engines = jit::available() ? below(3) : 0;
    passing_ = &start(true, engines == 1, program, parameters);
    computing_ = &start(false, engines == 1, program, parameters);
    switches_ = engines == 2;
    if (switches_) standOf(true, false).compileAfter(1 + below(below(2) == 0 ? 100 : 5'000));
    const std::string found = run();
    totals_.cycles += computing_->cycle().count();
    totals_.passed += passing_->quiet().cycles();
    return found;
  }

 private:
  static constexpr const char* kModel = "small generic";
  std::uint32_t below(std::uint32_t n) { return static_cast<std::uint32_t>(random_() % n); }

  CpuParameters parameters() {
    CpuParameters parameters = CpuParameters::of(*findModel(kModel));
    if (below(2) == 0) parameters.clockMemory = 100;
    if (below(2) == 0) parameters.cyclic.push_back({.ob = 35, .interval = 3 + int(below(20))});
    if (below(3) == 0) parameters.minimumCycle = 1 + below(3);
    return parameters;
  }

  // Two stands of one engine: their names differ.
  static Stand& standOf(bool passing, bool jit) {
    const std::uint32_t slots = passing ? UINT32_MAX : UINT32_MAX - 1;
    return stand({.model = kModel, .compiled = jit, .slots = slots});
  }

  static cpu::Cpu& start(bool passing, bool jit, const std::shared_ptr<const block::Program>& p,
                         const CpuParameters& parameters) {
    cpu::Cpu& cpu = standOf(passing, jit).load(p, parameters);
    cpu.quiet().enable(passing);
    if (parameters.imageErrors != ImageErrors::None) removeModule(cpu.machine().areas);
    cpu.restart(cpu::Restart::ManualWarm);
    return cpu;
  }

  // Modules with three bytes, the one with the third does not answer: OB 85 runs in each cycle.
  static void removeModule(cpu::Areas& areas) {
    areas.inputConfigured.assign(areas.inputs.size(), 0);
    areas.outputConfigured.assign(areas.outputs.size(), 0);
    std::fill_n(areas.inputConfigured.begin(), 3, 1);
    areas.inputPresent[2] = 0;
  }

  // Compiled code writes down less often where it last was.
  void forgetPositions() {
    for (cpu::Cpu* cpu : {passing_, computing_})
      if (switches_ && cpu->machine().levels.empty()) cpu->machine().position = 0;
  }

  std::string run() {
    const std::uint32_t stops = 3 + below(4);
    for (std::uint32_t i = 0; i < stops; ++i) {
      change();
      const Instant until = computing_->machine().clock + pause();
      advance(*passing_, until);
      advance(*computing_, until);
      forgetPositions();
      const std::string found = compare(*passing_, *computing_);
      if (!found.empty()) return fmt::format("stop {} (first passes over):\n{}", i, found);
      if (!executes(computing_->mode())) break;
    }
    return {};
  }

  static void advance(cpu::Cpu& cpu, Instant until) {
    while (cpu.machine().clock < until && executes(cpu.mode())) {
      cpu.passQuiet({.limit = until});
      if (cpu.machine().clock < until) cpu.step(until);
    }
  }

  Duration pause() {
    return Duration{static_cast<std::int64_t>(below(below(4) == 0 ? 60'000'000 : 6'000'000))};
  }

  // From outside, the same for both.
  void change() {
    const std::uint32_t byte = below(3), value = below(16);
    const bool event = below(8) == 0, input = below(2) == 0, again = below(3) == 0;
    for (cpu::Cpu* cpu : {passing_, computing_}) {
      if (again) continue;  // goes on as it is
      cpu->quiet().forget();
      cpu::Areas& areas = cpu->machine().areas;
      *areas.flag(byte) = static_cast<std::uint8_t>(value);
      if (input) areas.inputs[byte] = static_cast<std::uint8_t>(value);
      if (event) cpu::trigger(*cpu, {.ob = 40});
    }
  }

  const std::uint32_t seed_;
  std::mt19937 random_;
  Totals& totals_;
  cpu::Cpu *passing_ = nullptr, *computing_ = nullptr;
  bool switches_ = false;  // the one that passes over becomes compiled
};

struct Seeds {
  std::uint32_t first = 1, count = kPrograms;
};
Seeds seeds() {
  Seeds s;
  char colon = 0;
  if (const char* text = std::getenv("MERKER_QUIET"))
    std::istringstream(text) >> s.first >> colon >> s.count;
  return s;
}

class QuietCycles : public testing::TestWithParam<std::uint32_t> {};

TEST_P(QuietCycles, PassedOverAsIfComputed) {
  const Seeds s = seeds();
  const auto share = [&](std::uint32_t part) {
    return static_cast<std::uint32_t>(std::uint64_t{s.count} * part / kParts);
  };
  Totals totals;
  int found = 0;
  for (std::uint32_t i = share(GetParam()); i < share(GetParam() + 1); ++i) {
    const std::uint32_t seed = s.first + i;
    const std::string difference = QuietRun(seed, totals).difference();
    if (difference.empty()) continue;
    ADD_FAILURE() << "seed " << seed << '\n' << quietProgram(seed) << difference;
    if (++found == 3) return;
  }
  std::cout << totals.passed << " of " << totals.cycles << " cycles passed over\n";
  if (totals.programs < 100) return;
  EXPECT_GT(totals.passed, totals.cycles / 16) << "nothing is tested";
}

INSTANTIATE_TEST_SUITE_P(Random, QuietCycles, testing::Range(0u, kParts));

// Both sides of the comparison are asked the same: of a quiet program nearly all cycles are passed
// over, and none if it is switched off.
TEST(QuietCyclesOfOne, AreCounted) {
  const auto program = std::make_shared<block::Program>(
      compiledText("ORGANIZATION_BLOCK OB 1\nBEGIN\nU M 0.0\n= A 0.0\nEND_ORGANIZATION_BLOCK\n",
                   *findModel("small generic")));
  cpu::Cpu& cpu = stand({.model = "small generic", .compiled = false})
                      .load(program, CpuParameters::of(*findModel("small generic")));
  cpu.restart(cpu::Restart::ManualWarm);
  const auto second = [&] {
    const Instant until = cpu.machine().clock + Duration::seconds(1);
    const std::uint64_t before = cpu.quiet().cycles();
    while (cpu.machine().clock < until) {
      cpu.passQuiet({.limit = until});
      if (cpu.machine().clock < until) cpu.step(until);
    }
    return cpu.quiet().cycles() - before;
  };
  const std::uint64_t passed = second();
  EXPECT_GT(passed, cpu.cycle().count() - 8);
  cpu.quiet().enable(false);
  EXPECT_EQ(second(), 0u);
}

// So many cycles of a program that changes something in each of them: how often memory was
// compared.
std::uint64_t comparisons(const std::string& model, const CpuParameters& parameters) {
  constexpr std::uint64_t kCycles = 20'000;
  const auto program = std::make_shared<block::Program>(
      compiledText("ORGANIZATION_BLOCK OB 1\nBEGIN\nL MW 10\n+ 1\nT MW 10\n"
                   "END_ORGANIZATION_BLOCK\nORGANIZATION_BLOCK OB 35\nBEGIN\nNOP 0\n"
                   "END_ORGANIZATION_BLOCK\n",
                   *findModel(model)));
  cpu::Cpu& cpu = stand({.model = model, .compiled = false}).load(program, parameters);
  cpu.restart(cpu::Restart::ManualWarm);
  const std::uint64_t before = cpu.quiet().comparisons();
  while (cpu.cycle().count() < kCycles) {
    cpu.passQuiet({});
    cpu.step(Instant::never());
  }
  return cpu.quiet().comparisons() - before;
}

// Where nothing is quiet looking costs next to nothing: the more memory a CPU has the less often it
// is compared, and not at all behind cycles that another OB has interrupted.
TEST(QuietCyclesOfOne, AreSeldomLookedForWhereNoneIs) {
  const auto rest = [](const std::string& model) {
    return comparisons(model, CpuParameters::of(*findModel(model)));
  };
  EXPECT_LT(rest("small generic"), 700u);  // two in 64
  EXPECT_LT(rest("generic-4"), 60u);
  CpuParameters interrupted = CpuParameters::of(*findModel("generic-4"));
  interrupted.cyclic.push_back({.ob = 35, .interval = 1});
  interrupted.minimumCycle = 2;
  EXPECT_LT(comparisons("generic-4", interrupted), 10u);
}

}  // namespace
}  // namespace merker::differential
