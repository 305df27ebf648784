// Counting: the worked sequences of the technology manual 5.5, pulse by pulse.
#include <gtest/gtest.h>

#include "machine.h"

namespace merker::technology {
namespace {

using io::CountChannel;
using io::CountDirection;
using io::CountMode;

using Counts = std::vector<std::int32_t>;

// CNT-END-01, CNT-END-02, CNT-END-05
TEST(Endless, OverUpperLimit) {
  Machine m(mode(CountMode::Endless));
  EXPECT_EQ(m.counter.count(), 0);
  m.gate(true);
  m.counter.job(1, 2'147'483'645);
  EXPECT_EQ(m.pulses("UU"), (Counts{2'147'483'646, kHighest}));
  EXPECT_FALSE(m.counter.overflow());
  EXPECT_EQ(m.pulses("UUDD"), (Counts{kLowest, kLowest + 1, kLowest, kHighest}));
  EXPECT_TRUE(m.counter.overflow());
  EXPECT_TRUE(m.counter.gateOpen());
}

// CNT-END-03
TEST(Endless, UnderLowerLimit) {
  Machine m(mode(CountMode::Endless));
  m.gate(true);
  m.counter.job(1, -2'147'483'647);
  EXPECT_EQ(m.pulses("DDD"), (Counts{kLowest, kHighest, kHighest - 1}));
  EXPECT_TRUE(m.counter.underflow());
}

// CNT-END-04
TEST(Endless, ZeroFromEitherSideAndByLoading) {
  Machine m(mode(CountMode::Endless));
  m.counter.resetStatus();
  m.gate(true);
  EXPECT_TRUE(m.counter.zero());
  m.counter.job(1, -2);
  m.counter.resetStatus();
  m.pulses("U");
  EXPECT_FALSE(m.counter.zero());
  m.pulses("U");
  EXPECT_TRUE(m.counter.zero());
}

// CNT-END-06, CNT-GATE-04, CNT-GATE-05
TEST(Endless, GateCancelsOrInterrupts) {
  for (const bool interrupt : {false, true}) {
    CountChannel p = mode(CountMode::Endless);
    p.interruptGate = interrupt;
    Machine m(p);
    m.counter.job(2, 100);
    m.gate(true);
    EXPECT_EQ(m.counter.count(), 100);
    EXPECT_EQ(m.pulses("UUUDDDDD").back(), 98);
    m.gate(false);
    EXPECT_EQ(m.pulses("UUU").back(), 98);
    m.gate(true);
    EXPECT_EQ(m.counter.count(), interrupt ? 98 : 100);
    EXPECT_EQ(m.pulses("U").back(), interrupt ? 99 : 101);
  }
}

// CNT-END-07
TEST(Endless, TheFirstOpeningLoadsInBothGateFunctions) {
  CountChannel p = mode(CountMode::Endless);
  p.interruptGate = true;
  Machine m(p);
  m.counter.job(2, 50);
  EXPECT_EQ(m.counter.count(), 0);
  m.gate(true);
  EXPECT_EQ(m.counter.count(), 50);
}

// CNT-ONCE-01, CNT-ONCE-02, CNT-ONCE-03, CNT-GATE-08
TEST(Once, ClosesAtTheLimit) {
  for (const bool interrupt : {false, true}) {
    CountChannel p = mode(CountMode::Once);
    p.interruptGate = interrupt;
    Machine m(p);
    m.gate(true);
    EXPECT_EQ(m.pulses("UU"), (Counts{1, 2}));
    m.counter.job(1, 2'147'483'646);
    EXPECT_EQ(m.pulses("UUU"), (Counts{kHighest, kLowest, kLowest}));
    EXPECT_TRUE(m.counter.overflow());
    EXPECT_FALSE(m.counter.gateOpen());
    m.gate(false);
    m.gate(true);
    EXPECT_EQ(m.pulses("U").back(), interrupt ? kLowest + 1 : 1);
  }
}

// CNT-ONCE-04
TEST(Once, Forward) {
  Machine m(mode(CountMode::Once, CountDirection::Forward, 10));
  m.counter.job(2, 4);
  m.gate(true);
  EXPECT_EQ(m.pulses("UUUUUUU"), (Counts{5, 6, 7, 8, 9, 4, 4}));
  EXPECT_TRUE(m.counter.overflow());
  EXPECT_FALSE(m.counter.gateOpen());
  m.gate(false);
  m.gate(true);
  EXPECT_EQ(m.pulses("U"), Counts{5});
}

// CNT-ONCE-05, CNT-PERI-03, CNT-ONCE-07, CNT-PERI-05
TEST(Once, AgainstTheMainDirection) {
  Machine forward(mode(CountMode::Once, CountDirection::Forward, 10));
  forward.gate(true);
  EXPECT_EQ(forward.pulses("DDD"), (Counts{-1, -2, -3}));
  EXPECT_FALSE(forward.counter.zero());
  forward.counter.job(1, kLowest);
  EXPECT_EQ(forward.pulses("D"), Counts{kHighest});
  EXPECT_TRUE(forward.counter.underflow());
  EXPECT_TRUE(forward.counter.gateOpen());
  Machine backward(mode(CountMode::Periodic, CountDirection::Backward, 5));
  backward.gate(true);
  EXPECT_EQ(backward.pulses("UU"), (Counts{6, 7}));
  backward.counter.job(1, kHighest);
  EXPECT_EQ(backward.pulses("U"), Counts{kLowest});
  EXPECT_TRUE(backward.counter.overflow());
}

// CNT-ONCE-06, CNT-ONCE-08
TEST(Once, Backward) {
  Machine m(mode(CountMode::Once, CountDirection::Backward, 5));
  m.gate(true);
  EXPECT_EQ(m.counter.count(), 5);
  EXPECT_EQ(m.pulses("DDDDDD"), (Counts{4, 3, 2, 1, 5, 5}));
  EXPECT_TRUE(m.counter.underflow());
  EXPECT_FALSE(m.counter.gateOpen());
  m.gate(false);
  m.gate(true);
  EXPECT_EQ(m.pulses("D"), Counts{4});
  m.counter.job(2, 8);
  EXPECT_EQ(m.pulses("DDDD").back(), 8);
}

// CNT-ONCE-09
TEST(Once, TheHardwareGateMustOpenAgain) {
  CountChannel p = mode(CountMode::Once, CountDirection::Forward, 3);
  p.hardwareGate = true;
  Machine m(p);
  m.gate(true);
  m.counter.gateEdge(true, m.now);
  m.pulses("UUU");
  EXPECT_FALSE(m.counter.gateOpen());
  m.gate(false);
  m.gate(true);
  EXPECT_FALSE(m.counter.gateOpen());
  m.counter.gateEdge(false, m.now);
  m.counter.gateEdge(true, m.now);
  EXPECT_TRUE(m.counter.gateOpen());
}

// CNT-PERI-01
TEST(Periodic, WithoutMainDirection) {
  Machine m(mode(CountMode::Periodic));
  m.counter.job(2, 100);
  m.gate(true);
  m.counter.job(1, 2'147'483'646);
  EXPECT_EQ(m.pulses("UUU"), (Counts{kHighest, 100, 101}));
  m.counter.job(1, -2'147'483'647);
  EXPECT_EQ(m.pulses("DDD"), (Counts{kLowest, 100, 99}));
  EXPECT_TRUE(m.counter.overflow() && m.counter.underflow());
}

// CNT-PERI-02, CNT-PERI-06, CNT-PERI-08
TEST(Periodic, Forward) {
  Machine m(mode(CountMode::Periodic, CountDirection::Forward, 5));
  m.counter.job(2, 2);
  m.gate(true);
  EXPECT_EQ(m.pulses("UUUUUU"), (Counts{3, 4, 2, 3, 4, 2}));
  EXPECT_EQ(m.pulses("UUDUU"), (Counts{3, 4, 3, 4, 2}));
  m.pulses("U");
  m.counter.job(2, 0);
  EXPECT_EQ(m.counter.count(), 3);
  EXPECT_EQ(m.pulses("UU"), (Counts{4, 0}));
  EXPECT_TRUE(m.counter.gateOpen());
}

// CNT-PERI-04, CNT-PRAL-09
TEST(Periodic, BackwardInterruptsAtEachJump) {
  CountChannel p = mode(CountMode::Periodic, CountDirection::Backward, 4);
  p.onUnderflow = true;
  Machine m(p);
  m.gate(true);
  EXPECT_EQ(m.pulses("DDDDDD"), (Counts{3, 2, 1, 4, 3, 2}));
  EXPECT_EQ(m.counter.takeCauses(), io::kCountLimit);
  m.pulses("D");
  EXPECT_EQ(m.counter.takeCauses(), 0);
  m.pulses("D");
  EXPECT_EQ(m.counter.takeCauses(), io::kCountLimit);
}

// CNT-GATE-02, CNT-GATE-06, CNT-GATE-07, CNT-PRAL-07
TEST(Gates, SoftwareAndHardware) {
  for (const bool interrupt : {false, true}) {
    CountChannel p = mode(CountMode::Endless);
    p.interruptGate = interrupt;
    p.hardwareGate = p.onGateOpened = true;
    Machine m(p);
    m.counter.gateEdge(true, m.now);
    EXPECT_EQ(m.counter.takeCauses(), 0);  // the software gate is closed
    EXPECT_EQ(m.pulses("U").back(), 0);
    m.gate(true);
    EXPECT_EQ(m.pulses("UUUUUUU").back(), 7);
    m.gate(false);
    m.gate(true);
    EXPECT_EQ(m.counter.count(), 7);
    m.counter.gateEdge(false, m.now);
    EXPECT_EQ(m.pulses("U").back(), 7);
    m.counter.gateEdge(true, m.now);
    EXPECT_EQ(m.counter.takeCauses(), io::kGateOpened);
    EXPECT_EQ(m.counter.count(), interrupt ? 7 : 0);
  }
}

// CNT-LATCH-01, CNT-LATCH-03, CNT-LATCH-04
TEST(Latch, KeepsTheLastEdge) {
  Machine m(mode(CountMode::Periodic, CountDirection::Backward, 500));
  EXPECT_EQ(m.counter.latched(), 500);
  m.gate(true);
  m.pulses("DDD");
  m.counter.latchEdge();
  m.pulses("DDD");
  m.counter.latchEdge();
  m.pulses("D");
  EXPECT_EQ(m.counter.latched(), 494);
  EXPECT_EQ(m.counter.count(), 493);
}

// CNT-PERIOD-01, CNT-PERIOD-02, CNT-PERIOD-03, CNT-PERIOD-04, CNT-PERIOD-07
TEST(PeriodDuration, BetweenTwoPulses) {
  CountChannel p = mode(CountMode::Endless);
  p.maxFrequency = 1;
  p.showPeriod = true;
  Machine m(p);
  m.pulses("U");
  EXPECT_EQ(m.counter.inputData(), 0u);
  m.counter.pulse(1, m.now + Duration::milliseconds(10));
  EXPECT_EQ(m.counter.inputData(), 80'000u);
  m.counter.pulse(1, m.now + Duration::milliseconds(10) + Duration::seconds(600));
  EXPECT_EQ(m.counter.period(), 505'032'704u);
  p.maxFrequency = 2;
  Machine fast(p);
  fast.pulses("UUU");
  EXPECT_EQ(fast.counter.period(), 0u);
}

// CNT-ONCE-03, CNT-ONCE-04: with a main direction single counting begins anew at the load value,
// also where the gate only interrupts; without one it goes on.
TEST(Once, BeginsAnewThoughTheGateInterrupts) {
  for (const CountDirection direction : {CountDirection::Forward, CountDirection::None}) {
    const bool forward = direction == CountDirection::Forward;
    CountChannel p = mode(CountMode::Once, direction, forward ? 10 : kHighest);
    p.interruptGate = true;
    Machine m(p);
    m.counter.job(2, 4);
    m.gate(true);
    m.counter.job(1, forward ? 8 : kHighest - 1);
    m.pulses("UU");
    EXPECT_FALSE(m.counter.gateOpen());
    m.counter.job(2, 6);
    m.gate(false);
    m.gate(true);
    EXPECT_EQ(m.pulses("U").back(), forward ? 7 : kLowest + 1);
    m.gate(false);  // by the program, not by the limit: it only interrupts
    m.gate(true);
    EXPECT_EQ(m.pulses("U").back(), forward ? 8 : kLowest + 2);
  }
}

// CNT-PRAL-09: the interrupts of overflow and underflow are enabled separately; the status bits
// come in any case.
TEST(Interrupts, OverflowAndUnderflowSeparately) {
  for (const bool overflow : {false, true})
    for (const bool underflow : {false, true}) {
      CountChannel p = mode(CountMode::Endless);
      p.onOverflow = overflow;
      p.onUnderflow = underflow;
      Machine m(p);
      m.gate(true);
      m.counter.job(1, kHighest - 1);
      m.pulses("UU");
      EXPECT_TRUE(m.counter.overflow());
      EXPECT_EQ(m.counter.takeCauses() != 0, overflow);
      m.pulses("D");
      EXPECT_TRUE(m.counter.underflow());
      EXPECT_EQ(m.counter.takeCauses() != 0, underflow);
    }
}

// CNT-PRAL-09, CNT-PERI-02: jumps of the main direction are overflows, too.
TEST(Interrupts, OfJumpsToTheLoadValue) {
  CountChannel p = mode(CountMode::Periodic, CountDirection::Forward, 3);
  p.onUnderflow = true;
  Machine without(p);
  without.gate(true);
  without.pulses("UUU");
  EXPECT_TRUE(without.counter.overflow());
  EXPECT_EQ(without.counter.takeCauses(), 0u);
  p.onOverflow = true;
  Machine with(p);
  with.gate(true);
  with.pulses("UU");
  EXPECT_EQ(with.counter.takeCauses(), 0u);
  with.pulses("U");
  EXPECT_NE(with.counter.takeCauses(), 0u);
}

}  // namespace
}  // namespace merker::technology
