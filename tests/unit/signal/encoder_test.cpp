// The tracks of an encoder (CNT-ENC-01, CNT-SIM-06) as functions of time.
#include "signal/encoder.h"

#include <gtest/gtest.h>

#include <vector>

namespace merker::signal {
namespace {

constexpr std::int64_t kQuarter = 250'000'000;  // ns, at one period a second
constexpr Instant kBegin{1'000'000'000};

Instant quarter(std::int64_t n, std::int64_t more = 0) {
  return Instant{kBegin.ns + n * kQuarter + more};
}
Motion motion(std::int64_t frequency, std::int64_t position = 0, std::int64_t quarters = 0) {
  return {.start = kBegin, .position = position, .frequency = frequency, .quarters = quarters};
}

TEST(Encoder, PositionFollowsTheMotion) {
  EXPECT_EQ(motion(1'000, 7).positionAt(quarter(-4)), 7);
  EXPECT_EQ(motion(1'000, 7).positionAt(quarter(1, -1)), 7);
  EXPECT_EQ(motion(1'000, 7).positionAt(quarter(1)), 8);
  EXPECT_EQ(motion(-1'000, 7).positionAt(quarter(9)), -2);
  EXPECT_EQ(motion(0, 7).positionAt(quarter(9)), 7);
  EXPECT_EQ(motion(1'000, 7, 3).positionAt(quarter(9)), 10);
  EXPECT_EQ(motion(-2'000, 0, 3).positionAt(quarter(1)), -2);
  EXPECT_EQ(motion(1'000'000).positionAt(Instant{kBegin.ns + 1'000'000'000}), 4'000);
}

// Forward A comes first, backward B.
TEST(Encoder, TracksAreAQuarterApart) {
  const bool forwardA[] = {false, true, true, false}, forwardB[] = {false, false, true, true};
  for (std::int64_t i = 0; i < 8; ++i) {
    const auto place = static_cast<std::size_t>(i & 3), back = static_cast<std::size_t>(-i & 3);
    EXPECT_EQ(EncoderTrack(motion(1'000), Track::A).level(quarter(i)), forwardA[place]) << i;
    EXPECT_EQ(EncoderTrack(motion(1'000), Track::B).level(quarter(i)), forwardB[place]) << i;
    EXPECT_EQ(EncoderTrack(motion(-1'000), Track::A).level(quarter(i)), forwardA[back]) << i;
    EXPECT_EQ(EncoderTrack(motion(-1'000), Track::B).level(quarter(i)), forwardB[back]) << i;
  }
}

TEST(Encoder, ChangesLieAtEverySecondQuarter) {
  const EncoderTrack a(motion(1'000), Track::A), b(motion(1'000), Track::B);
  EXPECT_EQ(a.next(kBegin), quarter(1));
  EXPECT_EQ(a.next(quarter(1, -1)), quarter(1));
  EXPECT_EQ(a.next(quarter(1)), quarter(3));
  EXPECT_EQ(b.next(quarter(1)), quarter(2));
  EXPECT_EQ(b.next(quarter(3)), quarter(4));
  EXPECT_EQ(a.last(quarter(1, -1)), kLongAgo);
  EXPECT_EQ(a.last(quarter(2)), quarter(1));
  EXPECT_EQ(a.last(quarter(3)), quarter(3));
  EXPECT_EQ(b.last(quarter(3, 5)), quarter(2));
}

TEST(Encoder, StandsAndEnds) {
  const EncoderTrack standing(motion(0), Track::A);
  EXPECT_EQ(standing.next(kBegin), Instant::never());
  EXPECT_FALSE(standing.rhythm(kBegin));
  const EncoderTrack ending(motion(1'000, 0, 3), Track::A);
  EXPECT_EQ(ending.next(quarter(2)), quarter(3));
  EXPECT_EQ(ending.next(quarter(3)), Instant::never());
  EXPECT_EQ(EncoderTrack(motion(1'000, 0, 3), Track::B).next(quarter(2)), Instant::never());
  EXPECT_EQ(ending.last(quarter(90)), quarter(3));
}

TEST(Encoder, RepeatsItselfUntilItsEnd) {
  const EncoderTrack endless(motion(-1'000), Track::A), ending(motion(1'000, 0, 6), Track::A);
  EXPECT_FALSE(endless.rhythm(quarter(0, -1)));
  EXPECT_EQ(endless.rhythm(kBegin).period, (Period{1'000'000'000'000, 1'000}));
  EXPECT_EQ(endless.rhythm(kBegin).until, Instant::never());
  EXPECT_EQ(ending.rhythm(kBegin).until, quarter(6));
  EXPECT_TRUE(ending.rhythm(quarter(6, -1)));
  EXPECT_FALSE(ending.rhythm(quarter(6)));
  EXPECT_EQ(endless.later(quarter(1), 2), quarter(9));
}

}  // namespace
}  // namespace merker::signal
