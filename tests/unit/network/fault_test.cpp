// Faults of a subnet's line: who still reaches whom, and what comes late.
#include "stations.h"

namespace merker::network::test {
namespace {

struct Line : testing::Test {
  Subnet subnet{187'500};
  Node& a = subnet.add(2);
  Node& b = subnet.add(3);
  Node& c = subnet.add(4);
  Instant now;

  // From one node to an address; what arrives is there afterwards.
  void send(Node& from, std::uint8_t to) {
    from.send(now, to, {1, 2, 3});
    now = now + Duration::seconds(1);
    subnet.carry(now);
  }
  // Its data; nothing: nobody was there, or nothing came.
  std::size_t received(Node& node) {
    const auto telegram = node.receive(now);
    return telegram ? telegram->data.size() : 99;
  }
};

TEST_F(Line, NobodyReachesAnybodyOverABrokenLine) {
  subnet.interrupt();
  send(a, 3);
  EXPECT_EQ(received(a), 0u);
  EXPECT_EQ(received(b), 99u);
  send(a, kEveryone);
  EXPECT_EQ(received(b), 99u);
  subnet.mend();
  send(a, kEveryone);
  EXPECT_EQ(received(b), 3u);
  EXPECT_EQ(received(c), 3u);
}

TEST_F(Line, APulledPlugIsOneStationLess) {
  subnet.interrupt(3);
  send(a, 3);
  EXPECT_EQ(received(a), 0u);
  send(b, 4);
  EXPECT_EQ(received(b), 0u);
  send(a, kEveryone);
  EXPECT_EQ(received(b), 99u);
  EXPECT_EQ(received(c), 3u);
  subnet.mend(3);
  send(c, 3);
  EXPECT_EQ(received(b), 3u);
}

TEST_F(Line, WhatIsOnTheLineArrives) {
  send(a, 3);
  subnet.interrupt();
  EXPECT_EQ(received(b), 3u);
}

// 33 + 11 * (11 + 3) bits at 187.5 kbit/s: 997.334 us.
TEST_F(Line, ADelayComesOnTopOfTheTelegramAndNoneOvertakes) {
  subnet.delay(Duration::milliseconds(5));
  a.send(now, 3, {1, 2, 3});
  subnet.carry(now + Duration::milliseconds(1));
  EXPECT_EQ(b.next().ns, 5'997'334);
  subnet.mend();
  a.send(now + Duration::milliseconds(1), 3, {4});
  subnet.carry(now + Duration::milliseconds(2));
  ASSERT_TRUE(b.receive(Instant{5'997'334}));
  EXPECT_EQ(b.next().ns, 5'997'334);
}

}  // namespace
}  // namespace merker::network::test
