#include <gtest/gtest.h>

#include "make.h"

namespace merker::plant {
namespace {

TEST(BouncingSwitch, bouncesAndRests) {
  Bench bench(make("Button", "bouncing switch", {{"bounces", 3}, {"bounce_time", 0.006}}));
  bench.wait(Duration::milliseconds(10));
  EXPECT_EQ(bench.plants().next(), Instant::never());
  bench.set("PRESSED", 1);
  EXPECT_EQ(bench.value("CONTACT"), 1);
  for (int edge = 1; edge <= 6; ++edge) {
    EXPECT_EQ(bench.plants().next(), at(10 + edge));
    bench.wait(Duration::milliseconds(1));
    EXPECT_EQ(bench.value("CONTACT"), edge % 2 == 0 ? 1 : 0) << edge;
  }
  EXPECT_EQ(bench.plants().next(), Instant::never());
  bench.set("PRESSED", 0);
  EXPECT_EQ(bench.value("CONTACT"), 0);
}

TEST(BouncingSwitch, normallyClosed) {  // S7-HW-32
  Bench bench(make("Emergency", "bouncing switch", {{"bounces", 0}, {"normally_closed", 1}}));
  EXPECT_EQ(bench.value("CONTACT"), 1);
  bench.set("PRESSED", 1);
  EXPECT_EQ(bench.value("CONTACT"), 0);
}

// Let go while it still bounces: the bouncing begins anew.
TEST(BouncingSwitch, changesWhileBouncing) {
  Bench bench(make("Button", "bouncing switch", {{"bounces", 1}, {"bounce_time", 0.004}}));
  bench.set("PRESSED", 1);
  bench.wait(Duration::milliseconds(3));
  EXPECT_EQ(bench.value("CONTACT"), 0);
  bench.set("PRESSED", 0);
  bench.wait(Duration::milliseconds(2));
  EXPECT_EQ(bench.value("CONTACT"), 1);
  bench.wait(Duration::milliseconds(2));
  EXPECT_EQ(bench.value("CONTACT"), 0);
}

}  // namespace
}  // namespace merker::plant
