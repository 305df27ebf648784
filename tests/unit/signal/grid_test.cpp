#include "signal/grid.h"

#include <gtest/gtest.h>

namespace merker::signal {
namespace {

// 60 kHz: 16666 2/3 ns; each instant is rounded down by itself (CNT-SIM-01).
constexpr Grid kSixty{Instant{1'000}, {50'000, 3}};

TEST(Grid, RoundsEachInstantDownByItself) {
  EXPECT_EQ(kSixty.at(0).ns, 1'000);
  EXPECT_EQ(kSixty.at(1).ns, 17'666);
  EXPECT_EQ(kSixty.at(2).ns, 34'333);
  EXPECT_EQ(kSixty.at(3).ns, 51'000);
  EXPECT_EQ(kSixty.at(60'000).ns, 1'000'001'000);
  EXPECT_EQ(kSixty.at(-1).ns, 1'000 - 16'667);
  EXPECT_EQ(kSixty.at(1, 25'000).ns, 1'000 + 25'000);
  EXPECT_EQ(kSixty.at(0, -1).ns, 999);
}

TEST(Grid, IndexIsTheLastOneThatHasBeen) {
  for (const std::int64_t i :
       {-60'000ll, -3ll, -1ll, 0ll, 1ll, 2ll, 3ll, 59'999ll, 6'000'000'000'000ll}) {
    const Instant at = kSixty.at(i);
    EXPECT_EQ(kSixty.index(at), i);
    EXPECT_EQ(kSixty.index(Instant{at.ns - 1}), i - 1);
    EXPECT_EQ(kSixty.index(Instant{at.ns + 16'665}), i);
  }
}

}  // namespace
}  // namespace merker::signal
