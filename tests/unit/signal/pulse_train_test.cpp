// Pulse trains (CNT-SIM-04) as functions of time.
#include "signal/pulse_train.h"

#include <gtest/gtest.h>

#include <vector>

namespace merker::signal {
namespace {

constexpr Instant kStart{5'000'000};
constexpr std::int64_t kKilohertz = 1'000'000;  // mHz
constexpr std::int64_t kMillisecond = 1'000'000;

std::int64_t after(std::int64_t ns) { return kStart.ns + ns; }
Pulses kilohertz(std::uint32_t duty, std::int64_t count = 0) {
  Pulses pulses = pulsesOf(kKilohertz, duty, kStart);
  pulses.count = count;
  return pulses;
}

// The instants of the first edges, rising first.
std::vector<std::int64_t> edges(const PulseTrain& train, int count) {
  std::vector<std::int64_t> found;
  Instant at{kStart.ns - 1};
  for (int i = 0; i < count; ++i) found.push_back((at = train.next(at)).ns - kStart.ns);
  return found;
}

TEST(PulseTrain, FrequencyAndDuty) {
  const PulseTrain train(kilohertz(250));
  EXPECT_EQ(edges(train, 5),
            (std::vector<std::int64_t>{0, 250'000, 1'000'000, 1'250'000, 2'000'000}));
  EXPECT_FALSE(train.level(Instant{after(-1)}));
  EXPECT_TRUE(train.level(kStart));
  EXPECT_TRUE(train.level(Instant{after(249'999)}));
  EXPECT_FALSE(train.level(Instant{after(250'000)}));
  EXPECT_TRUE(train.level(Instant{after(1'000'000'000)}));
  EXPECT_EQ(pulsesOf(60'000'000, 500, kStart).period, (Period{1'000'000'000'000, 60'000'000}));
}

TEST(PulseTrain, LooksBack) {
  const PulseTrain train(kilohertz(250));
  EXPECT_EQ(train.last(Instant{after(-1)}), kLongAgo);
  EXPECT_EQ(train.last(kStart), kStart);
  EXPECT_EQ(train.last(Instant{after(249'999)}), kStart);
  EXPECT_EQ(train.last(Instant{after(250'000)}).ns, after(250'000));
  EXPECT_EQ(train.last(Instant{after(999'999)}).ns, after(250'000));
}

TEST(PulseTrain, SoManyPulsesAndNoMore) {
  const PulseTrain train(kilohertz(500, 3));
  const Instant last{after(2'500'000)};
  EXPECT_EQ(train.next(Instant{last.ns - 1}), last);
  EXPECT_EQ(train.next(last), Instant::never());
  EXPECT_EQ(train.last(Instant{after(kMillisecond * 1'000)}), last);
  EXPECT_FALSE(train.level(Instant{after(kMillisecond * 3)}));
}

TEST(PulseTrain, RepeatsItselfUntilItsEnd) {
  const PulseTrain train(kilohertz(500, 3));
  EXPECT_FALSE(train.rhythm(Instant{after(-1)}));
  const Rhythm rhythm = train.rhythm(kStart);
  ASSERT_TRUE(rhythm);
  EXPECT_EQ(rhythm.period.numerator / rhythm.period.denominator, kMillisecond);
  EXPECT_EQ(rhythm.until.ns, after(2'500'000));
  EXPECT_TRUE(train.rhythm(Instant{after(2'499'999)}));
  EXPECT_FALSE(train.rhythm(Instant{after(2'500'000)}));
  EXPECT_EQ(PulseTrain(kilohertz(500)).rhythm(kStart).until, Instant::never());
  EXPECT_EQ(train.later(kStart, 2).ns, after(2'000'000));
  EXPECT_EQ(train.later(Instant{after(500'000)}, 2).ns, after(2'500'000));
}

// CNT-SIM-04: the published first numbers of splitmix64 with seed 0, the same edges everywhere.
TEST(PulseTrain, JitterIsThatOfItsGenerator) {
  constexpr std::uint64_t kNumbers[] = {0xE220A8397B1DCDAF, 0x6E789E6AA1B965F4, 0x06C45D188009454F};
  constexpr std::int64_t kMost = 100'000;
  Pulses pulses = kilohertz(500);
  pulses.jitter = 100;
  pulses.seed = 0;
  std::vector<std::int64_t> expected;
  for (std::int64_t i = 0; i < 3; ++i)
    expected.push_back(std::max<std::int64_t>(
        i * 500'000 + static_cast<std::int64_t>(kNumbers[i] % (2 * kMost + 1)) - kMost, 0));
  EXPECT_EQ(edges(PulseTrain(pulses), 3), expected);
  EXPECT_FALSE(PulseTrain(pulses).rhythm(kStart));
}

// The first edge never comes before the start, and no edge overtakes another.
TEST(PulseTrain, JitterKeepsTheOrder) {
  Pulses pulses = kilohertz(100);
  pulses.jitter = mostJitter(pulses);
  EXPECT_GT(pulses.jitter, 40u);
  for (pulses.seed = 1; pulses.seed < 200; ++pulses.seed) {
    const auto found = edges(PulseTrain(pulses), 40);
    EXPECT_GE(found[0], 0);
    for (std::size_t i = 1; i < found.size(); ++i) EXPECT_LT(found[i - 1], found[i]) << pulses.seed;
  }
}

// Half of the shorter part, less a thousandth.
TEST(PulseTrain, JitterIsLimitedByTheShorterPart) {
  EXPECT_EQ(mostJitter(kilohertz(500)), 249u);
  EXPECT_EQ(mostJitter(kilohertz(100)), 49u);
  EXPECT_EQ(mostJitter(kilohertz(900)), 49u);
  EXPECT_EQ(mostJitter(kilohertz(3)), 1u);
  EXPECT_EQ(mostJitter(kilohertz(2)), 0u);
  EXPECT_EQ(mostJitter(kilohertz(1)), 0u);
}

}  // namespace
}  // namespace merker::signal
