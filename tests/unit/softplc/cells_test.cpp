// Timer and counter cells (9.3.4, S5-TIMER-T1).
#include <gtest/gtest.h>

#include <string>

#include "softplc/counter.h"
#include "softplc/timer.h"

namespace merker::sinumerik {
namespace {

const TimeBases kBases{Duration::milliseconds(10), Duration::milliseconds(100),
                       Duration::seconds(1), Duration::seconds(10)};

// Drives a timer of 5 s with one character per second of input; the outputs come back.
std::string outputs(TimerKind kind, const std::string& inputs, std::uint16_t value = 0x2005) {
  Timer timer;
  std::string result;
  for (std::size_t second = 0; second < inputs.size(); ++second) {
    const Instant now = Instant{} + Duration::seconds(static_cast<std::int64_t>(second));
    timer.count(now, kBases);
    timer.start(kind, inputs[second] == '1', value, now, kBases);
    result += timer.output() ? '1' : '0';
  }
  return result;
}

// S5-TIMER-04 … -08
TEST(Timer, FiveKinds) {
  EXPECT_EQ(outputs(TimerKind::SI, "0111000000"), "0111000000");
  EXPECT_EQ(outputs(TimerKind::SI, "0111111111"), "0111110000");
  EXPECT_EQ(outputs(TimerKind::SV, "0100000000"), "0111110000");
  EXPECT_EQ(outputs(TimerKind::SV, "0101000000"), "0111111100");
  EXPECT_EQ(outputs(TimerKind::SE, "0111111110"), "0000001110");
  EXPECT_EQ(outputs(TimerKind::SE, "0111001110"), "0000000000");
  EXPECT_EQ(outputs(TimerKind::SS, "0100000000"), "0000001111");
  // 1 until R, whatever the start does (S5-TIMER-07, 9.3.4)
  EXPECT_EQ(outputs(TimerKind::SS, "01000000100011"), "00000011111111");
  EXPECT_EQ(outputs(TimerKind::SA, "0110000000"), "0111111100" + std::string());
  EXPECT_EQ(outputs(TimerKind::SA, "0110011000000"), "0111111111110");
}

// S5-TIMER-03, S5-TIMER-10, S5-NUM-09, S5-CODE-03
TEST(Timer, ValueAndBase) {
  Timer timer;
  timer.start(TimerKind::SE, true, 0x1025, {}, kBases);
  EXPECT_EQ(timer.value(), 25u);
  EXPECT_EQ(timer.coded(), 0x1025u);
  timer.count(Instant{} + Duration::milliseconds(2400), kBases);
  EXPECT_EQ(timer.value(), 1u);
  EXPECT_FALSE(timer.output());
  timer.count(Instant{} + Duration::milliseconds(2500), kBases);
  EXPECT_TRUE(timer.output());
}

// S5-TIMER-09, S5-TIMER-12
TEST(Timer, ResetAndEnable) {
  Timer timer;
  timer.start(TimerKind::SI, true, 0x2005, {}, kBases);
  EXPECT_FALSE(timer.reset(false));
  EXPECT_TRUE(timer.output());
  const Instant later = Instant{} + Duration::seconds(3);
  timer.count(later, kBases);
  EXPECT_EQ(timer.value(), 2u);
  EXPECT_FALSE(timer.start(TimerKind::SI, true, 0x2005, later, kBases));
  EXPECT_TRUE(timer.enable(true));
  EXPECT_TRUE(timer.start(TimerKind::SI, true, 0x2005, later, kBases));
  EXPECT_EQ(timer.value(), 5u);
  timer.reset(true);
  EXPECT_EQ(timer.word() & Timer::kValue, 0u);
  EXPECT_FALSE(timer.output());
}

// S5-COUNTER-02 … -07
TEST(Counter, EdgesAndLimits) {
  Counter counter;
  EXPECT_TRUE(counter.set(true, 0x0998));
  EXPECT_FALSE(counter.set(true, 0x0005));
  EXPECT_TRUE(counter.up(true));
  EXPECT_FALSE(counter.up(true));
  counter.up(false);
  counter.up(true);
  EXPECT_EQ(counter.value(), 999u);  // no further
  EXPECT_TRUE(counter.enable(true));
  EXPECT_TRUE(counter.down(true));
  EXPECT_EQ(counter.coded(), 0x0998u);
  EXPECT_TRUE(counter.reset(true));
  counter.down(false);
  counter.down(true);
  EXPECT_EQ(counter.value(), 0u);
  EXPECT_FALSE(counter.output());
}

}  // namespace
}  // namespace merker::sinumerik
