#include "served/exchange.h"

#include "served_plc.h"

namespace merker::served {
namespace {

INSTANTIATE_TEST_SUITE_P(Families, EachFamily, ::testing::Values(Family::Station, Family::Control));

TEST_P(EachFamily, readsTheEndOfTheLastCycle) {
  plc.exchange.opened();
  plc.cycles(3);
  const Bytes three = {3, 3};
  EXPECT_EQ(plc.read(flags(10, 2))->octets, three);
  // In the middle of a cycle, too: what lies between two ends nobody sees.
  for (int i = 0; i < 200; ++i) {
    plc.plc().advanceTo(plc.plc().now() + Duration::microseconds(7));
    const auto value = plc.read(flags(10, 2));
    ASSERT_TRUE(value);
    EXPECT_EQ(value->octets[0], value->octets[1]);
  }
}

// No cost without clients; the first read waits for the end of a cycle.
TEST_P(EachFamily, nothingIsCopiedWhileNobodyIsConnected) {
  plc.cycles(2);
  EXPECT_FALSE(plc.read(flags(10, 2)));
  plc.cycles(1);
  EXPECT_FALSE(*plc.waiting);
  plc.exchange.opened();
  EXPECT_FALSE(*plc.waiting);
  plc.cycles(1);
  ASSERT_TRUE(*plc.waiting);
  EXPECT_EQ((*plc.waiting)->octets, (Bytes{4, 4}));
  EXPECT_TRUE(plc.read(flags(10, 2)));
  plc.exchange.closed();
  EXPECT_FALSE(plc.read(flags(10, 2)));
}

TEST_P(EachFamily, writesBetweenTwoCyclesAndAnswersThen) {
  plc.exchange.opened();
  plc.cycles(1);
  EXPECT_FALSE(plc.write(flags(10, 1), {70}));
  EXPECT_EQ(plc.read(flags(10, 1))->octets, Bytes{1});
  plc.cycles(1);
  EXPECT_EQ(*plc.written, ItemCode::Done);
  EXPECT_EQ(plc.read(flags(10, 2))->octets, (Bytes{70, 2}));  // behind the program
  plc.cycles(1);
  EXPECT_EQ(plc.read(flags(10, 2))->octets, (Bytes{71, 71}));
}

TEST_P(EachFamily, inStopItIsDoneAtOnce) {
  plc.exchange.opened();
  plc.cycles(1);
  plc.plc().stop();
  plc.write(flags(120, 1), {7});
  plc.look();
  EXPECT_EQ(*plc.written, ItemCode::Done);
  EXPECT_EQ(plc.read(flags(120, 1))->octets, Bytes{7});
}

TEST_P(EachFamily, withoutPowerNothingIsAnswered) {
  plc.exchange.opened();
  plc.cycles(1);
  EXPECT_TRUE(plc.read(flags(10, 1)));
  plc.plc().powerOff();
  plc.look();
  EXPECT_FALSE(plc.exchange.reachable());
  plc.read(flags(10, 1));
  plc.write(flags(120, 1), {7});
  EXPECT_TRUE(plc.exchange.waits());
  plc.look();
  EXPECT_FALSE(plc.exchange.waits());
  EXPECT_EQ((*plc.waiting)->code, ItemCode::HardwareFault);
  EXPECT_EQ(*plc.written, ItemCode::HardwareFault);
  plc.plc().powerOn();
  plc.cycles(1);
  plc.look();
  EXPECT_TRUE(plc.exchange.reachable());
  plc.cycles(1);
  EXPECT_TRUE(plc.read(flags(10, 1)));
}

TEST_P(EachFamily, whileTimeIsHeldItIsDoneAtOnce) {
  plc.exchange.opened();
  plc.cycles(1);
  plc.look();
  plc.write(flags(120, 1), {7});
  plc.look();
  EXPECT_EQ(*plc.written, ItemCode::Done);
}

TEST_P(EachFamily, whileTimePassesItWaitsForTheCycle) {
  plc.exchange.opened();
  plc.cycles(1);
  plc.look();
  plc.write(flags(120, 1), {7});
  plc.plc().advanceTo(plc.plc().now() + Duration::microseconds(1));
  plc.look();
  EXPECT_FALSE(*plc.written);
}

TEST_P(EachFamily, withoutAPlcThereIsAHardwareFault) {
  plc.exchange.opened();
  plc.read(flags(0, 1));
  plc.write(flags(120, 1), {7});
  plc.exchange.look(nullptr);
  EXPECT_EQ((*plc.waiting)->code, ItemCode::HardwareFault);
  EXPECT_EQ(*plc.written, ItemCode::HardwareFault);
}

TEST_P(EachFamily, anotherPlcHasNoOldValues) {
  plc.exchange.opened();
  plc.cycles(1);
  EXPECT_TRUE(plc.read(flags(10, 2)));
  plc.exchange.forget();
  EXPECT_FALSE(plc.read(flags(10, 2)));
}

// A startup that does not end refuses what waits for its end.
TEST(Exchange, whatNeverEndsRefuses) {
  ServedPlc plc(
      "a.awl",
      std::string(kStation) +
          "ORGANIZATION_BLOCK OB 100\nBEGIN\nNETWORK\nM: SPA M;\nEND_ORGANIZATION_BLOCK\n");
  plc.exchange.opened();
  plc.write(flags(120, 1), {7});
  plc.look();
  for (int i = 1; i <= 51; ++i) {
    EXPECT_FALSE(*plc.written);
    plc.plc().advanceTo(plc.plc().now() + Duration::milliseconds(100));
    plc.look();
  }
  EXPECT_EQ(*plc.written, ItemCode::HardwareFault);
}

TEST(Exchange, thePlcIsWokenForOrders) {
  ServedPlc plc = ServedPlc::station();
  unsigned wakes = 0, posts = 0;
  plc.exchange.connectBy(
      [&](const Exchange::Call& call) {
        ++posts;
        call();
      },
      [&] { ++wakes; });
  plc.exchange.opened();
  plc.cycles(1);
  plc.read(flags(10, 2));
  EXPECT_EQ(wakes, 1u);
  EXPECT_EQ(posts, 0u);
  plc.write(flags(120, 1), {7});
  EXPECT_EQ(wakes, 2u);
  plc.cycles(1);
  EXPECT_EQ(posts, 1u);
}

}  // namespace
}  // namespace merker::served
