// The sorting plant with other boxes and speeds: a belt that moves beside cycles that are passed
// over comes to the same places and levels as beside cycles that are computed.
#include <gtest/gtest.h>

#include <random>

#include "comparison.h"
#include "compilation/build.h"

namespace merker::differential {
namespace {

constexpr const char* kFolder = MERKER_SOURCE_DIR "/examples/sorting-plant";
#ifdef NDEBUG
constexpr std::uint32_t kPlants = 40;
#else
constexpr std::uint32_t kPlants = 3;
#endif

// Parameters of the belt: speed, interval, automatic, seed.
void change(plant::PlantSettings& belt, std::mt19937& random) {
  belt.parameters[0] = 0.02 + static_cast<double>(random() % 300) / 1000;
  belt.parameters[1] = 2 + static_cast<double>(random() % 90) / 10;
  belt.parameters[2] = 1;
  belt.parameters[3] = static_cast<double>(random() % 1000);
}

std::string compareBelts(const station::Station& a, const station::Station& b) {
  Comparison c;
  const auto signals = a.plants()->configuration().plants[0].kind->signals.size();
  for (std::uint32_t i = 0; i < signals; ++i)
    c.value("signal", i, a.plants()->value({0, i}), b.plants()->value({0, i}));
  return c.text();
}

// Where the last call of a cycle that has ended was: only messages of the instruction that runs
// read it, and compiled calls write it down less often.
void forgetPosition(cpu::Cpu& cpu) {
  if (cpu.machine().levels.empty()) cpu.machine().position = 0;
}

// From outside: a slider comes out by itself, or the belt stands.
void disturb(station::Station& station, std::uint32_t what) {
  plant::Plants& plants = *station.plants();
  io::Rack& rack = *station.rack();
  const plant::SignalPlace place{0, what % 4};
  if (what % 3 == 0)
    plants.stick(rack, place, what / 3 % 2, station.now());
  else
    plants.release(rack, place, station.now());
}

TEST(QuietPlants, MoveAsBesideComputedCycles) {
  compilation::Build build = compilation::build(project::load(kFolder, ""), false);
  ASSERT_TRUE(build.ok());
  std::uint64_t passed = 0, cycles = 0;
  for (std::uint32_t seed = 1; seed <= kPlants; ++seed) {
    std::mt19937 random(seed);
    change(build.project.plants.plants[0], random);
    station::Station passing = build.station(), computing = build.station();
    computing.passOverQuietCycles(false);
    for (station::Station* one : {&passing, &computing}) {
      (void)one->setCompiled(seed % 2 == 0);
      ASSERT_TRUE(one->warmRestart());
    }
    for (int stop = 0; stop < 12; ++stop) {
      const Duration pause{static_cast<std::int64_t>(random() % 5'000'000'000)};
      const auto what = static_cast<std::uint32_t>(random());
      for (station::Station* one : {&passing, &computing}) {
        one->advanceTo(one->now() + pause);
        if (what % 5 == 0) disturb(*one, what / 5);
      }
      ASSERT_EQ(compareBelts(passing, computing), "") << "seed " << seed << ", stop " << stop;
      for (station::Station* one : {&passing, &computing}) forgetPosition(one->cpu());
      ASSERT_EQ(compare(passing.cpu(), computing.cpu()), "")
          << "seed " << seed << ", stop " << stop;
    }
    passed += passing.cyclesPassedOver();
    cycles += computing.cycles();
  }
  EXPECT_GT(passed, cycles / 2);
  std::cout << passed << " of " << cycles << " cycles passed over\n";
}

}  // namespace
}  // namespace merker::differential
