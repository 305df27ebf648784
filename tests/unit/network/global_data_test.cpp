// Global data (S7-NET-27): packets at the end of every so manieth cycle, status words, exact times.
#include <algorithm>
#include <utility>

#include "stations.h"

namespace merker::network::test {
namespace {

address::Reference flagLong(unsigned byte) {
  return {.text = "MD", .operand = address::memory(Area::Flag, Width::DWord, 8 * byte)};
}

const std::string kCount = "L MW 0; + 1; T MW 0; T MW 20;";

// One sends MB 20:length, two takes it to MB 40.
struct Pair {
  Pair(GlobalPacket sent, GlobalPacket taken, const std::string& taker = "NOP 0;")
      : network(stations(taker)) {
    Subnet& subnet = network.addSubnet(187'500);
    line = &subnet;
    sent.sends = true;
    network.join(0, subnet, 2, {{sent}, GlobalArea{Area::Flag, 0, 80, 4}});
    network.join(1, subnet, 3, {{taken}, GlobalArea{Area::Flag, 0, 80, 4}});
    start(network);
  }
  static std::vector<Station> stations(const std::string& taker) {
    std::vector<Station> list;
    list.push_back({"A", station(kCount)});
    list.push_back({"B", station(taker)});
    return list;
  }
  void run(int ms) { network.advanceTo(network.now() + Duration::milliseconds(ms)); }
  std::uint32_t status(std::size_t i, unsigned byte) {
    return network.itself(i).read(flagLong(byte)).value_or(0);
  }

  Network network;
  Subnet* line = nullptr;
};

GlobalPacket packet(unsigned byte, std::uint32_t length, std::uint32_t rate = 1) {
  return {1, 1, false, {Area::Flag, 0, byte, length}, rate, GlobalArea{Area::Flag, 0, 84, 4}};
}

constexpr std::uint32_t kNew = 0x80000000, kRestart = 0x800, kLost = 8;

// A cycle of the sender, then 33 + 11 * (11 + 4 + 2) bits of 187.5 kbit/s: 1.173334 ms.
TEST(GlobalData, ArrivesAfterExactlyItsTelegram) {
  Pair pair(packet(20, 2, 7), packet(40, 2));
  std::vector<std::int64_t> sent, taken;
  controller::Controller& a = pair.network.itself(0);
  controller::Controller& b = pair.network.itself(1);
  a.onCycle([&](controller::Controller& plc) {
    if (plc.cycles() % 7 == 0 && plc.cycles() > 0) sent.push_back(plc.now().ns);
  });
  std::uint32_t last = 0;
  std::int64_t before = 0;
  b.onCycle([&](controller::Controller& plc) {
    const std::uint32_t now = plc.read(flagWord(40)).value_or(0);
    if (std::exchange(last, now) != now) {
      EXPECT_EQ(now % 7, 0u);
      const std::int64_t arrived = sent.at(taken.size()) + 1'173'334;
      EXPECT_LT(before, arrived);  // at the first checkpoint after it
      EXPECT_GE(plc.now().ns, arrived);
      taken.push_back(plc.now().ns);
    }
    before = plc.now().ns;
  });
  pair.run(40);
  EXPECT_GT(taken.size(), 3u);
}

TEST(GlobalData, StatusWords) {
  Pair pair(packet(20, 2, 20), packet(40, 2));
  pair.run(100);
  EXPECT_EQ(pair.status(1, 84), kNew | kRestart);
  EXPECT_EQ(pair.status(1, 80), kNew | kRestart);
  pair.network.itself(1).write(flagLong(84), 0);
  pair.run(100);
  EXPECT_EQ(pair.status(1, 84), kNew);
  EXPECT_EQ(pair.status(0, 84), 0u);
}

TEST(GlobalData, WhatIsNotTakenInTimeIsLost) {
  // The taker waits 20 ms in each cycle.
  Pair pair(packet(20, 2, 1), packet(40, 2), "CALL SFC 47 (WT := 20000);");
  pair.run(100);
  EXPECT_EQ(pair.status(1, 84), kNew | kRestart | kLost);
}

TEST(GlobalData, AnotherLengthIsNotTaken) {
  Pair pair(packet(20, 2, 1), packet(40, 4));
  pair.run(50);
  EXPECT_EQ(pair.status(1, 84) & ~kLost, kRestart | 0x40u);
  EXPECT_EQ(word(pair.network, 1, 40), 0u);
}

TEST(GlobalData, AMissingDataBlock) {
  GlobalPacket sent = packet(20, 2), taken = packet(40, 2);
  sent.data = {Area::DataBlock, 9, 0, 2};
  Pair sender(sent, taken);
  sender.run(50);
  EXPECT_EQ(sender.status(0, 84), 2u);
  taken.data = {Area::DataBlock, 9, 0, 2};
  Pair taker(packet(20, 2), taken);
  taker.run(50);
  EXPECT_EQ(taker.status(1, 84) & ~kLost, 0x100u | kRestart);
}

TEST(GlobalData, NothingInStop) {
  Pair pair(packet(20, 2, 20), packet(40, 2));
  pair.run(50);
  pair.network.itself(1).stop();
  const std::uint32_t before = word(pair.network, 1, 40);
  pair.run(50);
  EXPECT_EQ(word(pair.network, 1, 40), before);
  pair.network.itself(0).stop();
  pair.network.itself(1).start();
  pair.run(50);
  pair.network.itself(1).write(flagLong(84), 0);
  pair.run(50);
  EXPECT_EQ(pair.status(1, 84), 0u);
}

// What was lost on the line is seen at the first packet that comes again.
TEST(GlobalData, ALineThatWasBroken) {
  Pair pair(packet(20, 2, 20), packet(40, 2));
  pair.run(50);
  const auto reset = [&] { pair.network.itself(1).write(flagLong(84), 0); };
  reset();
  pair.run(50);
  EXPECT_EQ(pair.status(1, 84), kNew);
  pair.line->interrupt();
  pair.run(50);
  reset();
  const std::uint32_t before = word(pair.network, 1, 40);
  pair.run(50);
  EXPECT_EQ(word(pair.network, 1, 40), before);
  EXPECT_EQ(pair.status(1, 84), 0u);
  pair.line->mend();
  pair.run(50);
  EXPECT_EQ(pair.status(1, 84), kNew | kLost);
}

// Each CPU adds one to what it takes and sends it in every 14th cycle. All begin together, so their
// cycles end at the same instants, and the telegrams follow each other in the order of addresses:
// what the CPU before `i` sends in round i arrives i telegrams of 1.173334 ms later, and is there
// at the first end of a cycle after that.
TEST(GlobalData, ATokenGoesThroughAHundredCpusInExactlyItsTime) {
  constexpr std::size_t kCpus = 100, kRate = 14;
  constexpr std::int64_t kTelegram = 1'173'334;
  std::vector<Station> list;
  for (std::size_t i = 0; i < kCpus; ++i)
    list.push_back(
        {"S" + std::to_string(i), station("L MW 40; + 1; T MW 20; CALL SFC 47 (WT := 10000);")});
  Network network(std::move(list), 2);
  Subnet& subnet = network.addSubnet(187'500);
  std::vector<std::int64_t> ends, came(kCpus);  // of cycles; when the right value came
  for (std::size_t i = 0; i < kCpus; ++i) {
    GlobalPacket sends = packet(20, 2, kRate), takes = packet(40, 2);
    sends.packet = static_cast<std::uint8_t>(i);
    sends.sends = true;
    takes.packet = static_cast<std::uint8_t>((i + kCpus - 1) % kCpus);
    GlobalData data{{sends}, {}};
    if (i > 0) data.packets.insert(data.packets.begin(), takes);
    network.join(i, subnet, static_cast<std::uint8_t>(2 + i), data);
    network.itself(i).onCycle([&, i](controller::Controller& plc) {
      if (i == 0 && plc.cycles() > 0) ends.push_back(plc.now().ns);
      if (came[i] == 0 && i > 0 && plc.read(flagWord(40)) == i) came[i] = plc.now().ns;
    });
  }
  start(network);
  network.advanceTo(Instant{15'000'000'000});
  for (std::size_t i = 1; i < kCpus; ++i) {
    const std::int64_t sent = ends.at(i * kRate - 1);
    const std::int64_t arrived = sent + static_cast<std::int64_t>(i) * kTelegram;
    ASSERT_EQ(came[i], *std::ranges::lower_bound(ends, arrived)) << i;
  }
}

}  // namespace
}  // namespace merker::network::test
