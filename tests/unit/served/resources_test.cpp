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

CommunicationParameters with(std::optional<std::uint32_t> connections, std::uint32_t pg,
                             std::uint32_t op, std::uint32_t basic) {
  CommunicationParameters parameters;
  parameters.connections = connections;
  parameters.pg = pg, parameters.op = op, parameters.basic = basic;
  return parameters;
}

TEST(Resources, aProjectSaysHowManyAreKept) {
  Resources resources;
  resources.limit(with(6, 2, 0, 3));
  EXPECT_TRUE(resources.take(Resource::Op));
  EXPECT_FALSE(resources.take(Resource::Op));
  for (int i = 0; i < 3; ++i) EXPECT_TRUE(resources.take(Resource::Basic)) << i;
  EXPECT_FALSE(resources.take(Resource::Basic));
  EXPECT_TRUE(resources.take(Resource::Pg));
  EXPECT_TRUE(resources.take(Resource::Pg));
  EXPECT_FALSE(resources.take(Resource::Pg));
  EXPECT_EQ(resources.counts(), (Resources::Counts{2, 1, 3}));
}

TEST(Resources, thoseInUseStayWithOtherLimits) {
  Resources resources;
  for (int i = 0; i < 8; ++i) EXPECT_TRUE(resources.take(Resource::Basic)) << i;
  resources.limit(with(4, 1, 1, 0));
  EXPECT_FALSE(resources.take(Resource::Pg));
  EXPECT_EQ(resources.inUse(), 8u);
  resources.limit(with(std::nullopt, 1, 1, 0));
  for (int i = 0; i < 100; ++i) EXPECT_TRUE(resources.take(Resource::Basic)) << i;
}

TEST(Resources, rackAndSlotAreInTheSecondByte) {
  const auto named = [](std::vector<std::uint8_t> tsap) { return namesTheCpu(tsap); };
  EXPECT_TRUE(named({1, 2}));
  EXPECT_TRUE(named({3, 2}));
  EXPECT_FALSE(named({1, 3}));
  EXPECT_FALSE(named({1, 0x22}));
  EXPECT_FALSE(named({2}));
  EXPECT_FALSE(named({}));
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
