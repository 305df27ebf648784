// Gates: which edge opens, what is loaded then (technology manual 5.5.9), and the start of the CPU.
#include <gtest/gtest.h>

#include "machine.h"

namespace merker::technology {
namespace {

using io::CountChannel;
using io::CountDirection;
using io::CountMode;

// CNT-GATE-12: a pulse each ms from 0.5 ms on; opened at 0, closed at 4 ms, opened at 8 ms.
TEST(Gates, CurveOfCancelAndInterrupt) {
  for (const bool interrupt : {false, true}) {
    CountChannel p = mode(CountMode::Endless);
    p.interruptGate = interrupt;
    Machine m(p);
    m.gate(true);
    EXPECT_EQ(m.pulses("UUUU").back(), 4);
    m.gate(false);
    EXPECT_EQ(m.pulses("UUUU").back(), 4);
    m.gate(true);
    EXPECT_EQ(m.counter.count(), interrupt ? 4 : 0);
    EXPECT_EQ(m.pulses("UUUU").back(), interrupt ? 8 : 4);
  }
}

// CNT-GATE-03: a pulse in each of the four states.
TEST(Gates, OnlyBothTogetherAreOpen) {
  for (const bool software : {false, true})
    for (const bool hardware : {false, true})
      for (const bool used : {false, true}) {
        CountChannel p = mode(CountMode::Endless);
        p.hardwareGate = used;
        Machine m(p);
        m.gate(software);
        m.counter.gateEdge(hardware, m.now);
        const bool open = software && (hardware || !used);
        EXPECT_EQ(m.counter.gateOpen(), open);
        EXPECT_EQ(m.pulses("U").back(), open ? 1 : 0);
      }
}

// CNT-GATE-06, CNT-GATE-07: who opens last decides whether the load value counts.
TEST(Gates, TheLastOfTwoEdges) {
  for (const bool interrupt : {false, true}) {
    CountChannel p = mode(CountMode::Endless);
    p.interruptGate = interrupt;
    p.hardwareGate = true;
    Machine m(p);
    m.counter.job(2, 50);
    m.gate(true);
    m.counter.gateEdge(true, m.now);
    EXPECT_EQ(m.pulses("UUUUUUU").back(), 57);
    m.gate(false);
    m.gate(true);
    EXPECT_EQ(m.counter.count(), 57);
    m.counter.gateEdge(false, m.now);
    m.counter.gateEdge(true, m.now);
    EXPECT_EQ(m.counter.count(), interrupt ? 57 : 50);
  }
}

// CNT-PRAL-07: both interrupts of the gate, only while the software gate is open.
TEST(Gates, Interrupts) {
  CountChannel p = mode(CountMode::Endless);
  p.hardwareGate = p.onGateOpened = p.onGateClosed = true;
  Machine m(p);
  m.counter.gateEdge(true, m.now);
  m.counter.gateEdge(false, m.now);
  EXPECT_EQ(m.counter.takeCauses(), 0);
  m.gate(true);
  EXPECT_EQ(m.counter.takeCauses(), 0);
  m.counter.gateEdge(true, m.now);
  EXPECT_EQ(m.counter.takeCauses(), io::kGateOpened);
  m.counter.gateEdge(false, m.now);
  EXPECT_EQ(m.counter.takeCauses(), io::kGateClosed);
}

// CNT-GATE-10, CNT-OP-06: an input that is 1 already is an open gate.
TEST(Gates, StartWithAnInputThatIsOne) {
  CountChannel p = mode(CountMode::Periodic, CountDirection::Backward, 9);
  p.hardwareGate = true;
  Counter counter(p);
  counter.start(true, {});
  counter.control(true, false, false, {});
  EXPECT_TRUE(counter.gateOpen());
  EXPECT_EQ(counter.count(), 9);
}

// CNT-ONCE-09: the edge may come first, then the software gate; its own edge is not enough.
TEST(Once, TheHardwareEdgeMayComeFirst) {
  CountChannel p = mode(CountMode::Once, CountDirection::Forward, 3);
  p.hardwareGate = true;
  Machine m(p);
  m.gate(true);
  m.counter.gateEdge(true, m.now);
  m.pulses("UUU");
  m.gate(false);
  m.counter.gateEdge(false, m.now);
  m.counter.gateEdge(true, m.now);
  EXPECT_FALSE(m.counter.gateOpen());
  m.gate(true);
  EXPECT_TRUE(m.counter.gateOpen());
  EXPECT_EQ(m.pulses("U").back(), 1);
}

// CNT-OP-09: the direction is seen with the gate closed as well.
TEST(Gates, DirectionOfPulsesThatDoNotCount) {
  Machine m(mode(CountMode::Endless));
  EXPECT_FALSE(m.counter.down());  // CNT-IF47-06
  EXPECT_EQ(m.pulses("D").back(), 0);
  EXPECT_TRUE(m.counter.down());
}

// CNT-LATCH-04: with the gate closed as well.
TEST(Latch, NeedsNoGate) {
  Machine m(mode(CountMode::Endless));
  m.gate(true);
  m.pulses("UUU");
  m.gate(false);
  m.counter.latchEdge();
  EXPECT_EQ(m.counter.latched(), 3);
}

// CNT-END-04: zero by a job, and nothing with a main direction.
TEST(Endless, ZeroByAJob) {
  Machine m(mode(CountMode::Endless));
  m.counter.job(1, 5);
  m.counter.resetStatus();
  m.counter.job(1, 0);
  EXPECT_TRUE(m.counter.zero());
  Machine forward(mode(CountMode::Once, CountDirection::Forward, 10));
  forward.gate(true);
  forward.counter.job(1, 0);
  forward.pulses("UDDU");
  EXPECT_FALSE(forward.counter.zero());
}

// CNT-JOB-09, CNT-JOB-15: at once and with the gate closed; after an error the old value holds.
TEST(Endless, JobsWithTheGateClosed) {
  Machine m(mode(CountMode::Endless));
  m.counter.job(1, 77);
  EXPECT_EQ(m.counter.count(), 77);
  m.counter.job(2, 12);
  EXPECT_EQ(m.counter.count(), 77);
  EXPECT_EQ(m.counter.job(2, 2'147'483'647).error, 0x0152);
  EXPECT_EQ(m.counter.job(0x82, 0).value, 12);
  EXPECT_EQ(m.counter.job(8, 256).error, 0x0132);
  EXPECT_EQ(m.counter.job(0x88, 0).value, 0);
}

// CNT-PERIOD-02, CNT-PARAM-17: in microseconds; CNT-PERIOD-04: the longest one.
TEST(PeriodDuration, InMicroseconds) {
  CountChannel p = mode(CountMode::Endless);
  p.maxFrequency = 1;
  p.microseconds = true;
  Machine m(p);
  m.pulses("U");
  m.counter.pulse(1, m.now + Duration::milliseconds(10));
  EXPECT_EQ(m.counter.period(), 10'000u);
  const Instant then = m.now + Duration::milliseconds(10);
  m.counter.pulse(1, then + Duration::microseconds(4'294'967'295));
  EXPECT_EQ(m.counter.period(), 4'294'967'295u);
  m.counter.pulse(1, then + Duration::microseconds(2 * 4'294'967'295 + 2));
  EXPECT_EQ(m.counter.period(), 1u);
}

}  // namespace
}  // namespace merker::technology
