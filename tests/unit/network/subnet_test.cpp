// An MPI subnet: how long telegrams take, in which order they go, who gets them.
#include "network/subnet.h"

#include <gtest/gtest.h>

namespace merker::network {
namespace {

using Bytes = std::vector<std::uint8_t>;

Instant at(std::int64_t ns) { return {ns}; }

// 33 bits of pause, 11 bytes around the data, 11 bits a byte: 12 bytes are 33 + 23 * 11 = 286 bits.
TEST(Subnet, ATelegramTakesItsBits) {
  EXPECT_EQ(telegramBits(mpi(187'500), 12), 286);
  Subnet fast(187'500), slow(19'200);
  EXPECT_EQ(fast.duration(286).ns, 1'525'334);  // 286 / 187500 s, rounded up
  EXPECT_EQ(slow.duration(286).ns, 14'895'834);
  EXPECT_EQ(fast.lookahead().ns, fast.duration(165).ns);
}

TEST(Subnet, OneAfterTheOther) {
  Subnet subnet(187'500);
  Node &a = subnet.add(4), &b = subnet.add(2), &c = subnet.add(3);
  a.send(at(100), 3, Bytes(12, 1));
  b.send(at(100), 3, Bytes(12, 2));  // the lower address is first
  c.send(at(50), 4, Bytes(12, 3));
  subnet.carry(at(101));
  const std::int64_t length = 1'525'334;
  EXPECT_FALSE(c.receive(at(50 + 2 * length - 1)));
  const auto first = c.receive(at(50 + 2 * length));
  ASSERT_TRUE(first);
  EXPECT_EQ(first->from, 2);
  EXPECT_EQ(first->data, Bytes(12, 2));
  EXPECT_EQ(c.next(), at(50 + 3 * length));
  EXPECT_EQ(a.next(), at(50 + length));
  EXPECT_EQ(subnet.busy().ns, 3 * length);
}

// What is sent at the end of a window or later waits: an earlier telegram may still come.
TEST(Subnet, OnlyWhatIsKnownGoesOnTheLine) {
  Subnet subnet(187'500);
  Node &a = subnet.add(2), &b = subnet.add(3), &c = subnet.add(4);
  a.send(at(1000), 4, Bytes(12, 1));
  subnet.carry(at(1000));
  EXPECT_EQ(c.next(), Instant::never());
  b.send(at(999), 4, Bytes(12, 2));
  subnet.carry(at(2000));
  EXPECT_EQ(c.receive(Instant::never())->from, 3);
  EXPECT_EQ(c.receive(Instant::never())->from, 2);
}

TEST(Subnet, EveryoneButTheSender) {
  Subnet subnet(187'500);
  Node &a = subnet.add(2), &b = subnet.add(3), &c = subnet.add(4);
  b.send(at(0), kEveryone, Bytes(12, 1));
  subnet.carry(at(1));
  EXPECT_EQ(a.next(), at(1'525'334));
  EXPECT_EQ(c.next(), at(1'525'334));
  EXPECT_EQ(b.next(), Instant::never());
}

// Two tries, each with the slot time of 415 bits: 2 * (286 + 415) bits.
TEST(Subnet, NobodyAtTheAddress) {
  Subnet subnet(187'500);
  Node& a = subnet.add(2);
  a.send(at(0), 9, Bytes(12, 1));
  subnet.carry(at(1));
  const auto answer = a.receive(at(7'477'334));
  ASSERT_TRUE(answer);
  EXPECT_EQ(answer->at, at(7'477'334));
  EXPECT_EQ(answer->from, 9);
  EXPECT_TRUE(answer->data.empty());
}

// A turn of 317 bits and 11 for each byte of data: 10 bytes of a telegram are 9 of data, 416 bits.
TEST(Subnet, TurnsOnDpDoNotWaitForEachOther) {
  Subnet subnet(dp(1'500'000));
  Node& master = subnet.add(2);
  Node& slave = subnet.add(5);
  master.send(at(1000), 5, Bytes(10, 1));
  slave.send(at(1000), 2, Bytes(10, 2));
  slave.send(at(2000), 7, Bytes(10, 3));  // nobody: nobody hears of it
  subnet.carry(at(3000));
  EXPECT_EQ(slave.next(), at(278'334));
  EXPECT_EQ(master.next(), at(278'334));
  EXPECT_EQ(master.receive(at(278'334))->data[0], 2);
  EXPECT_EQ(master.next(), Instant::never());
  EXPECT_EQ(subnet.lookahead().ns, 211'334);
}

}  // namespace
}  // namespace merker::network
