// Plants with other parameters and disturbances: what moves beside cycles that are passed over
// comes to the same places, levels and amounts as beside cycles that are computed.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>

#include "comparison.h"
#include "compilation/build.h"

namespace merker::differential {
namespace {

#ifdef NDEBUG
constexpr std::uint32_t kBelts = 40, kOthers = 8;
#else
constexpr std::uint32_t kBelts = 3, kOthers = 1;
#endif

constexpr const char* kSortingPlant = "sorting-plant";

// Parameters of the belt: speed, interval, automatic, seed.
void change(plant::PlantSettings& belt, std::mt19937& random) {
  belt.parameters[0] = 0.02 + static_cast<double>(random() % 300) / 1000;
  belt.parameters[1] = 2 + static_cast<double>(random() % 90) / 10;
  belt.parameters[2] = 1;
  belt.parameters[3] = static_cast<double>(random() % 1000);
}

std::string comparePlants(const station::Station& a, const station::Station& b) {
  Comparison c;
  const auto& plants = a.plants()->configuration().plants;
  for (std::uint32_t plant = 0; plant < plants.size(); ++plant)
    for (std::uint32_t i = 0; i < plants[plant].kind->signals.size(); ++i)
      c.value(plants[plant].kind->signals[i].name, plant, a.plants()->value({plant, i}),
              b.plants()->value({plant, i}));
  return c.text();
}

// Where the last call of a cycle that has ended was: only messages of the instruction that runs
// read it, and compiled calls write it down less often.
void forgetPosition(cpu::Cpu& cpu) {
  if (cpu.machine().levels.empty()) cpu.machine().position = 0;
}

// From outside: a signal is set, sticks, or is released.
void disturb(station::Station& station, std::uint32_t what) {
  plant::Plants& plants = *station.plants();
  io::Rack& rack = *station.rack();
  const auto& all = plants.configuration().plants;
  const std::uint32_t plant = what % 7 % static_cast<std::uint32_t>(all.size());
  const auto& signals = all[plant].kind->signals;
  const plant::SignalPlace place{plant, what / 7 % static_cast<std::uint32_t>(signals.size())};
  const plant::Signal& signal = signals[place.signal];
  const double value = signal.binary ? what / 64 % 2 : signal.low + (signal.high - signal.low) / 3;
  if (what % 3 == 0) return plants.stick(rack, place, value, station.now());
  if (what % 3 == 1 && signal.side == plant::Signal::Side::Input)
    return plants.set(rack, place, value, station.now());
  plants.release(rack, place, station.now());
}

// From outside: what a pulse generator is given, its power and its enable, and what it never gets
// from the program, its period. Elsewhere flags and an input that change.
void feed(station::Station& station, std::uint32_t what) {
  const auto write = [&](Area area, Width width, std::uint32_t byte, std::uint32_t value) {
    (void)station.write({.operand = address::memory(area, width, bitAddress(byte))}, value);
  };
  write(Area::Flag, Width::Word, 10, what % 1100);
  write(Area::Input, Width::Bit, 125, what / 2048 % 4 != 0);
}

struct Totals {
  std::uint64_t passed = 0, cycles = 0;
};

void move(compilation::Build& build, std::uint32_t seed, std::mt19937& random, Totals& totals) {
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
      if (what % 5 < 2) disturb(*one, what / 5);
      if (what % 5 > 2) feed(*one, what / 5);
    }
    ASSERT_EQ(comparePlants(passing, computing), "") << "seed " << seed << ", stop " << stop;
    for (station::Station* one : {&passing, &computing}) forgetPosition(one->cpu());
    ASSERT_EQ(compare(passing.cpu(), computing.cpu()), "") << "seed " << seed << ", stop " << stop;
  }
  totals.passed += passing.cyclesPassedOver();
  totals.cycles += computing.cycles();
}

class QuietPlants : public testing::TestWithParam<const char*> {};

TEST_P(QuietPlants, MoveAsBesideComputedCycles) {
  const std::string name = GetParam();
  const std::string folder = std::string(MERKER_SOURCE_DIR "/examples/") + name;
  compilation::Build build = compilation::build(project::load(folder, ""), false);
  ASSERT_TRUE(build.ok());
  Totals totals;
  const bool belts = name == kSortingPlant;
  for (std::uint32_t seed = 1; seed <= (belts ? kBelts : kOthers); ++seed) {
    std::mt19937 random(seed);
    if (belts) change(build.project.plants.plants[0], random);
    ASSERT_NO_FATAL_FAILURE(move(build, seed, random, totals)) << name;
  }
  EXPECT_GT(totals.passed, totals.cycles / 3);
  std::cout << totals.passed << " of " << totals.cycles << " cycles passed over\n";
}

INSTANTIATE_TEST_SUITE_P(Examples, QuietPlants,
                         testing::Values(kSortingPlant, "lift", "garage-door", "traffic-light",
                                         "vessel-emptying", "technology/cascade-control",
                                         "technology/valve-control", "technology/pwm-heater",
                                         "technology/blending-control"));

// The example with a call in front of its own that takes the enable away: each cycle has the memory
// of the one before, and begins the pulse anew.
TEST(QuietPulses, BegunAnewInEachCycleAreNotPassedOver) {
  namespace fs = std::filesystem;
  const fs::path folder = fs::path(testing::TempDir()) / "merker-pulses-begun-anew";
  fs::remove_all(folder);
  fs::copy(MERKER_SOURCE_DIR "/examples/technology/pwm-heater", folder);
  std::stringstream text;
  text << std::ifstream(folder / "heater.awl").rdbuf();
  std::string source = text.str();
  source.insert(source.find("      CALL"),
                "      CALL SFB 49, DB 32 (LADDR := W#16#300, CHANNEL := 2, SW_EN := M 5.0);\n");
  std::ofstream(folder / "heater.awl") << source;
  compilation::Build build = compilation::build(project::load(folder.string(), ""), false);
  ASSERT_TRUE(build.ok());
  Totals totals;
  std::mt19937 random(1);
  ASSERT_NO_FATAL_FAILURE(move(build, 1, random, totals));
  fs::remove_all(folder);
}

}  // namespace
}  // namespace merker::differential
