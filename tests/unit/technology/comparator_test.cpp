// Comparator and hysteresis (technology manual 5.5.10, 5.5.11).
#include <gtest/gtest.h>

#include "machine.h"

namespace merker::technology {
namespace {

using io::CountChannel;
using io::CountDirection;
using io::CountMode;

// CNT-HYST-07
TEST(Hysteresis, AlsoActsOnZero) {
  Machine m(mode(CountMode::Endless));
  m.gate(true);
  m.counter.job(8, 3);
  m.counter.job(1, -5);
  m.pulses("UUU");
  std::string events;
  for (const char c : std::string_view("UUUDDUUUUDDD")) {  // -1 0 1 0 -1 0 1 2 3 2 1 0
    m.counter.resetStatus();
    m.pulses(std::string_view(&c, 1));
    events += m.counter.zero() ? '1' : '0';
  }
  EXPECT_EQ(events, "010000000001");
}

// CNT-HYST-07: across the limit as well.
TEST(Hysteresis, AlsoActsOnTheLimits) {
  CountChannel p = mode(CountMode::Endless);
  p.hysteresis = 3;
  p.onOverflow = p.onUnderflow = true;
  Machine m(p);
  m.gate(true);
  m.counter.job(1, 2'147'483'646);
  std::string events;
  for (const char c : std::string_view("UUDUUUUDDDDDDUUUUUU")) {
    m.counter.resetStatus();
    m.pulses(std::string_view(&c, 1));
    events += m.counter.overflow() ? 'o' : m.counter.underflow() ? 'u' : '.';
    EXPECT_EQ(m.counter.takeCauses() != 0, events.back() != '.');
  }
  EXPECT_EQ(events, ".ou.......u....o...");
}

// CNT-CMP-17, CNT-OP-10: what is compared when; a written value starts no pulse.
TEST(Comparison, AtTheStartAndAfterJobs) {
  CountChannel p = mode(CountMode::Endless);
  p.output = io::CountOutput::AtLeast;
  Machine m(p);
  EXPECT_TRUE(m.counter.comparator().reached());
  m.counter.control(true, true, false, m.now);
  EXPECT_TRUE(m.counter.output());
  m.counter.job(4, 5);
  EXPECT_FALSE(m.counter.output());
  m.counter.job(1, 6);
  EXPECT_TRUE(m.counter.output());
  p.output = io::CountOutput::Pulse;
  p.comparison = 7;
  p.pulseDuration = 10;
  Machine pulse(p);
  pulse.counter.control(true, true, false, pulse.now);
  pulse.counter.job(1, 7);
  EXPECT_FALSE(pulse.counter.output());
  pulse.pulses("UD");
  EXPECT_TRUE(pulse.counter.output());
}

// CNT-PRAL-08, 5.5.12: the interrupt without an output, with the hysteresis; nothing is switched.
TEST(Comparison, InterruptWithoutOutput) {
  CountChannel p = mode(CountMode::Endless);
  p.comparison = 3;
  p.hysteresis = 2;
  p.onComparator = true;
  Machine m(p);
  m.gate(true);
  std::string events;
  for (const char c : std::string_view("UUUUDUUDD")) {  // 1 2 3 4 3 4 5 4 3
    m.pulses(std::string_view(&c, 1));
    events += m.counter.takeCauses() == io::kComparator ? '1' : '0';
  }
  EXPECT_EQ(events, "001000001");
  EXPECT_FALSE(m.counter.comparator().reached());
  EXPECT_FALSE(m.counter.output());
  m.counter.job(1, 3);  // written, not counted
  EXPECT_EQ(m.counter.takeCauses(), 0);
  EXPECT_EQ(m.counter.absorbs(1), 0u);
}

// CNT-HYST-09, CNT-HYST-10
TEST(Hysteresis, ChangedWhileActive) {
  CountChannel p = mode(CountMode::Endless);
  p.output = io::CountOutput::AtLeast;
  p.comparison = 5;
  p.hysteresis = 3;
  Machine m(p);
  m.gate(true);
  m.counter.control(true, true, false, m.now);
  m.pulses("UUUUUD");
  EXPECT_TRUE(m.counter.output());
  m.counter.job(8, 5);
  m.pulses("D");
  EXPECT_TRUE(m.counter.output());
  m.pulses("D");
  EXPECT_FALSE(m.counter.output());
  m.pulses("UUUDDDD");
  EXPECT_TRUE(m.counter.output());
  m.pulses("D");
  EXPECT_FALSE(m.counter.output());
  m.pulses("UUUUUD");
  m.counter.job(4, 10);
  EXPECT_FALSE(m.counter.output());
}

// CNT-CMP-02, CNT-CMP-03, CNT-CMP-04, CNT-CMP-05, CNT-CMP-06
TEST(Comparison, OutputAndStatusBit) {
  CountChannel p = mode(CountMode::Endless);
  p.output = io::CountOutput::AtLeast;
  p.comparison = 5;
  Machine m(p);
  m.counter.control(true, true, false, m.now);
  m.pulses("UUUU");
  EXPECT_FALSE(m.counter.output());
  m.pulses("UU");
  EXPECT_TRUE(m.counter.output());
  m.counter.resetStatus();
  EXPECT_TRUE(m.counter.comparator().reached());
  m.pulses("DD");
  EXPECT_TRUE(m.counter.comparator().reached());
  m.counter.resetStatus();
  EXPECT_FALSE(m.counter.comparator().reached());
  m.counter.control(true, false, true, m.now);
  EXPECT_TRUE(m.counter.comparator().reached());
  EXPECT_FALSE(m.counter.output());
  m.counter.control(true, false, false, m.now);
  m.pulses("UUU");  // 7: CTRL_DO is missing
  EXPECT_FALSE(m.counter.output());
  EXPECT_TRUE(m.counter.comparator().reached());
  Machine none(mode(CountMode::Endless));
  none.counter.control(true, true, true, none.now);
  EXPECT_FALSE(none.counter.output() || none.counter.ownsOutput());
}

// CNT-CMP-07, CNT-CMP-08
TEST(Comparison, SetByTheProgram) {
  CountChannel p = mode(CountMode::Endless);
  p.output = io::CountOutput::AtLeast;
  p.comparison = 5;
  Machine m(p);
  m.counter.control(true, true, false, m.now);
  m.pulses("UUUUUU");
  m.counter.control(true, true, true, m.now);
  m.counter.control(true, true, false, m.now);
  EXPECT_FALSE(m.counter.output());
  m.pulses("U");
  EXPECT_TRUE(m.counter.output());
  Machine set(p);
  set.counter.control(true, true, true, set.now);
  set.pulses("UUUUUUDDD");
  EXPECT_TRUE(set.counter.output());
  set.counter.control(true, true, false, set.now);
  EXPECT_FALSE(set.counter.output());
}

// CNT-CMP-09, CNT-CMP-10, CNT-CMP-12, CNT-CMP-13, CNT-CMP-15
TEST(Comparison, PulseOfALength) {
  CountChannel p = mode(CountMode::Periodic, CountDirection::Forward, 10);
  p.output = io::CountOutput::Pulse;
  p.comparison = 5;
  p.pulseDuration = 100;
  Machine m(p);
  m.counter.control(true, true, false, m.now);
  m.pulses("UUUUU");
  EXPECT_TRUE(m.counter.output());
  EXPECT_EQ(m.counter.due(), m.now + Duration::milliseconds(100));
  const Instant end = m.counter.due();
  m.counter.job(0x10, 20);
  m.pulses("DUUD");
  EXPECT_EQ(m.counter.due(), end);
  m.counter.resetStatus();
  EXPECT_TRUE(m.counter.comparator().reached());
  m.counter.expire(end);
  EXPECT_FALSE(m.counter.output());
  m.counter.resetStatus();
  EXPECT_FALSE(m.counter.comparator().reached());
  m.pulses("UD");  // 6, then 5 from above: not in the main direction
  EXPECT_FALSE(m.counter.output());
  m.pulses("DU");
  EXPECT_EQ(m.counter.due(), m.now + Duration::milliseconds(20));
}

// CNT-CMP-11, CNT-CMP-14
TEST(Comparison, PulseWithoutALengthAndBySetting) {
  CountChannel p = mode(CountMode::Endless);
  p.output = io::CountOutput::Pulse;
  p.comparison = 5;
  Machine m(p);
  m.counter.control(true, true, true, m.now);
  EXPECT_FALSE(m.counter.output());
  m.counter.control(true, true, false, m.now);
  m.pulses("UUUUU");
  EXPECT_TRUE(m.counter.output());
  m.pulses("U");
  EXPECT_FALSE(m.counter.output());
  m.counter.job(0x10, 50);
  m.counter.control(true, true, true, m.now);
  EXPECT_TRUE(m.counter.output());
  EXPECT_EQ(m.counter.due(), m.now + Duration::milliseconds(50));
}

// CNT-HYST-01: a condition that begins outside of the range, at the distance H itself, does not
// make the hysteresis active; one inside does.
TEST(Hysteresis, BeginsInsideItsRange) {
  for (const std::int32_t first : {8, 7}) {
    CountChannel p = mode(CountMode::Endless);
    p.output = io::CountOutput::AtLeast;
    p.comparison = 5;
    p.hysteresis = 3;
    Machine m(p);
    m.counter.control(true, true, false, m.now);
    m.counter.job(1, first);
    EXPECT_TRUE(m.counter.output());
    m.counter.job(1, 4);
    EXPECT_EQ(m.counter.output(), first == 7) << first;
  }
}

// CNT-HYST-08: job 08h takes 0 to 255 and 88h reads it back; 0 and 1 switch the hysteresis off.
TEST(Hysteresis, ByAJob) {
  Machine m(mode(CountMode::Endless));
  for (const std::int32_t value : {255, 7, 0}) {
    EXPECT_EQ(m.counter.job(8, value).error, 0);
    EXPECT_EQ(m.counter.job(0x88, 0).value, value);
  }
  EXPECT_EQ(m.counter.job(8, 256).error, 0x0132);
  EXPECT_EQ(m.counter.job(0x88, 0).value, 0);
}

// CNT-JOB-05: each job does what it says, and nothing else.
TEST(CounterJobs, WhatEachDoes) {
  struct State {
    std::int32_t count, load, comparison, hysteresis, duration;
    bool operator==(const State&) const = default;
  };
  Machine m(mode(CountMode::Endless));
  m.gate(true);
  const auto state = [&] {
    return State{m.counter.count(), m.counter.job(0x82, 0).value, m.counter.job(0x84, 0).value,
                 m.counter.job(0x88, 0).value, m.counter.job(0x90, 0).value};
  };
  EXPECT_EQ(state(), (State{0, 0, 0, 0, 0}));
  m.counter.job(1, 11);
  EXPECT_EQ(state(), (State{11, 0, 0, 0, 0}));
  m.counter.job(2, -12);
  EXPECT_EQ(state(), (State{11, -12, 0, 0, 0}));
  m.counter.job(4, 13);
  EXPECT_EQ(state(), (State{11, -12, 13, 0, 0}));
  m.counter.job(8, 14);
  EXPECT_EQ(state(), (State{11, -12, 13, 14, 0}));
  m.counter.job(0x10, 16);
  EXPECT_EQ(state(), (State{11, -12, 13, 14, 16}));
  EXPECT_EQ(m.counter.job(0, 99).error, 0);
  EXPECT_EQ(state(), (State{11, -12, 13, 14, 16}));
}

}  // namespace
}  // namespace merker::technology
