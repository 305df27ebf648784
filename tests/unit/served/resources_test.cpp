#include "served/resources.h"

#include <gtest/gtest.h>

namespace merker::served {
namespace {

// S7-LIM-05
TEST(Resources, theThirteenthIsRefused) {
  Resources resources;
  EXPECT_TRUE(resources.take(Resource::Pg));
  EXPECT_TRUE(resources.take(Resource::Op));
  for (int i = 0; i < 10; ++i) EXPECT_TRUE(resources.take(Resource::Basic)) << i;
  for (const Resource kind : {Resource::Pg, Resource::Op, Resource::Basic})
    EXPECT_FALSE(resources.take(kind));
  resources.release(Resource::Basic);
  EXPECT_TRUE(resources.take(Resource::Op));
  EXPECT_EQ(resources.inUse(), 12u);
}

TEST(Resources, oneIsKeptForAProgrammingDeviceAndOneForAPanel) {
  Resources resources;
  for (int i = 0; i < 10; ++i) EXPECT_TRUE(resources.take(Resource::Basic)) << i;
  EXPECT_FALSE(resources.take(Resource::Basic));
  EXPECT_TRUE(resources.take(Resource::Pg));
  EXPECT_FALSE(resources.take(Resource::Pg));
  EXPECT_TRUE(resources.take(Resource::Op));
  resources.release(Resource::Pg);
  EXPECT_FALSE(resources.take(Resource::Basic));
  EXPECT_TRUE(resources.take(Resource::Pg));
}

TEST(Resources, theTsapSaysWhich) {
  const auto of = [](std::vector<std::uint8_t> tsap) { return resourceOf(tsap); };
  EXPECT_EQ(of({1, 2}), Resource::Pg);
  EXPECT_EQ(of({2, 2}), Resource::Op);
  EXPECT_EQ(of({3, 0}), Resource::Basic);
  EXPECT_EQ(of({0x10, 2}), Resource::Basic);
  EXPECT_EQ(of({}), Resource::Basic);
}

}  // namespace
}  // namespace merker::served
