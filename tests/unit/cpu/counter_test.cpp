#include <gtest/gtest.h>

#include "cpu/s5_counter.h"

namespace merker::cpu {
namespace {

void pulses(S5Counter& counter, int n, void (S5Counter::*step)(bool)) {
  for (int i = 0; i < n; ++i) (counter.*step)(true), (counter.*step)(false);
}

// S7-CNT-01
TEST(S5Counter, CountsOnlyTheRisingEdge) {
  S5Counter counter;
  for (int i = 0; i < 5; ++i) counter.up(true);
  EXPECT_EQ(counter.count, 1);
}

// S7-CNT-08, S7-CNT-09, S7-INSTR-35, S7-INSTR-36
TEST(S5Counter, StaysInsideItsRange) {
  S5Counter counter;
  pulses(counter, 1001, &S5Counter::up);
  EXPECT_EQ(counter.count, 999);
  counter.count = 1;
  pulses(counter, 2, &S5Counter::down);
  EXPECT_EQ(counter.count, 0);
}

// S7-CNT-02, S7-INSTR-33
TEST(S5Counter, IsSetOnAnEdge) {
  S5Counter counter;
  EXPECT_TRUE(counter.set(true, 0x0010));
  EXPECT_EQ(counter.count, 10);
  EXPECT_TRUE(counter.set(true, 0x0250));
  EXPECT_EQ(counter.count, 10);
  counter.set(false, 0);
  EXPECT_TRUE(counter.set(true, 0x0250));
  EXPECT_EQ(counter.count, 250);
}

// S7-CNT-03: only with an edge; bits 12..15 do not count.
TEST(S5Counter, RefusesWhatIsNoBcd) {
  S5Counter counter;
  EXPECT_TRUE(counter.set(false, 0x00AB));
  EXPECT_FALSE(counter.set(true, 0x00AB));
  EXPECT_EQ(counter.count, 0);
  counter.set(false, 0);
  EXPECT_TRUE(counter.set(true, 0xF123));
  EXPECT_EQ(counter.count, 123);
}

// S7-CNT-04, S7-INSTR-34
TEST(S5Counter, ResetNeedsNoEdge) {
  S5Counter counter{.count = 5};
  counter.reset(false);
  EXPECT_EQ(counter.count, 5);
  counter.reset(true);
  EXPECT_EQ(counter.count, 0);
  counter.up(true);
  counter.reset(true);
  EXPECT_EQ(counter.count, 0);
}

// S7-CNT-12: separate edge memories, in program order.
TEST(S5Counter, BothEdgesCancel) {
  S5Counter counter{.count = 7};
  counter.up(true);
  counter.down(true);
  EXPECT_EQ(counter.count, 7);
  S5Counter highest{.count = 999};
  highest.up(true);
  highest.down(true);
  EXPECT_EQ(highest.count, 998);
}

// S7-CNT-13, S7-INSTR-37
TEST(S5Counter, EnableLetsAConstantOneCountAgain) {
  S5Counter counter;
  counter.up(true);
  counter.enable(true);
  counter.up(true);
  EXPECT_EQ(counter.count, 2);
  counter.enable(true);  // no edge
  counter.up(true);
  EXPECT_EQ(counter.count, 2);
}

// S7-CNT-05
TEST(S5Counter, ShowsBcd) { EXPECT_EQ((S5Counter{.count = 25}).bcd(), 0x0025); }

}  // namespace
}  // namespace merker::cpu
