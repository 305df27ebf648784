#include "clock/instant.h"

#include <gtest/gtest.h>

namespace merker {
namespace {

TEST(Instant, CountsNanoseconds) {
  EXPECT_EQ((Instant{} + Duration::seconds(2) + Duration::milliseconds(3)).ns, 2'003'000'000);
  EXPECT_EQ((Instant{500} - Duration::microseconds(1)).ns, -500);
  EXPECT_EQ(Instant{700} - Instant{200}, Duration{500});
  EXPECT_EQ(Duration{200} * 5, Duration::microseconds(1));
}

TEST(Instant, NeverIsBehindEverything) {
  EXPECT_LT(Instant{} + Duration::seconds(1'000'000'000), Instant::never());
}

}  // namespace
}  // namespace merker
