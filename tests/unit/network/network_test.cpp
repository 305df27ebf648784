// S7-MGR-13, S7-NET-01: stations in one virtual time, the same whatever the threads and the
// portions, of both families.
#include "network/network.h"

#include <random>

#include "stations.h"

namespace merker::network::test {
namespace {

constexpr std::size_t kStations = 5;

const std::string kRingData =
    "DATA_BLOCK DB 1\nSTRUCT\n d : ARRAY [0..75] OF BYTE;\nEND_STRUCT\nBEGIN\nEND_DATA_BLOCK\n";

// Each sends its counter to the next one, and reads what the one before has sent.
std::string ringProgram(std::size_t i) {
  const std::size_t next = 2 + (i + 1) % kStations;
  return "L MW 0; + 1; T MW 0; T DB1.DBW 0;\n"
         "CALL SFC 65 (REQ := TRUE, CONT := TRUE, DEST_ID := W#16#" +
         std::to_string(next) + ", REQ_ID := DW#16#1, SD := P#DB1.DBX0.0 BYTE " +
         std::to_string(10 + 7 * i) +
         ", RET_VAL := MW 2, BUSY := M 4.0);\n"
         "CALL SFC 66 (EN_DT := TRUE, RET_VAL := MW 6, REQ_ID := MD 8, NDA := M 4.1, RD := "
         "P#DB1.DBX0.0 BYTE 76);\n"
         "U M 4.1; SPBN m1; L DB1.DBW 0; T MW 12; L MW 14; + 1; T MW 14; m1: NOP 0;";
}

struct Ring {
  explicit Ring(unsigned threads) : network(stations(), threads), seen(kStations) {
    Subnet& subnet = network.addSubnet(187'500);
    for (std::size_t i = 0; i < kStations; ++i) {
      network.join(i, subnet, static_cast<std::uint8_t>(2 + i));
      network.itself(i).onCycle([this, i](controller::Controller& plc) {
        seen[i] += std::to_string(plc.now().ns) + ' ' +
                   std::to_string(plc.read(flagWord(2)).value_or(0)) + ' ' +
                   std::to_string(plc.read(flagWord(12)).value_or(0)) + '\n';
      });
    }
    start(network);
  }
  static std::vector<Station> stations() {
    std::vector<Station> list;
    for (std::size_t i = 0; i < kStations; ++i)
      list.push_back({"S" + std::to_string(i), station(ringProgram(i), kRingData)});
    return list;
  }
  std::string text() const {
    std::string all;
    for (const std::string& one : seen) all += one + "--\n";
    return all;
  }

  Network network;
  std::vector<std::string> seen;  // of each station at the end of each cycle
};

const std::string& reference() {
  static const std::string kText = [] {
    Ring ring(1);
    ring.network.advanceTo(Instant{30'000'000});
    for (std::size_t i = 0; i < kStations; ++i) EXPECT_GT(word(ring.network, i, 14), 0u) << i;
    return ring.text();
  }();
  return kText;
}

TEST(Network, TheSameOnAnyNumberOfThreads) {
  for (int run = 0; run < 25; ++run)
    for (const unsigned threads : {1u, 2u, 4u, 8u}) {
      Ring ring(threads);
      ring.network.advanceTo(Instant{30'000'000});
      ASSERT_EQ(ring.text(), reference()) << threads << " threads, run " << run;
    }
}

TEST(Network, TheSameInAnyPortions) {
  std::mt19937 random(4711);
  for (int run = 0; run < 10; ++run) {
    Ring ring(2);
    const Instant end{30'000'000};
    while (ring.network.now() < end) {
      const std::size_t one = random() % kStations;
      const Instant to = std::min(
          end, ring.network.now() + Duration{static_cast<std::int64_t>(1 + random() % 3000000)});
      if (random() % 2 == 0)
        ring.network.advanceTo(to);
      else
        ring.network.station(one).advanceToCheckpoint(to);
    }
    ASSERT_EQ(ring.text(), reference()) << run;
  }
}

TEST(Network, AMemberTakesTheOthersAlong) {
  std::vector<Station> list;
  list.push_back({"A", station("L MW 0; + 1; T MW 0;")});
  list.push_back({"B", station("L MW 0; + 1; T MW 0;",
                               "ORGANIZATION_BLOCK OB 35\nBEGIN\nNETWORK\nL MW 2; + 1; T MW "
                               "2;\nEND_ORGANIZATION_BLOCK\n")});
  list.push_back({"C", control()});
  Network network(std::move(list));
  start(network);
  controller::Controller& a = network.station(0);
  a.advanceTo(Instant{1'000'000'000});
  EXPECT_GE(network.itself(1).now().ns, 1'000'000'000);
  EXPECT_EQ(word(network, 1, 2), 9u);  // OB 35, every 100 ms
  EXPECT_GT(word(network, 2, 10), 5u);
  const std::uint64_t cycles = a.cycles();
  a.advanceCycles(3);
  EXPECT_EQ(a.cycles(), cycles + 3);
  EXPECT_LT(network.itself(1).now() - a.now(), Duration::milliseconds(1));
  EXPECT_LT(a.now() - network.itself(1).now(), Duration::milliseconds(1));
  EXPECT_TRUE(network.settle(Duration::seconds(1)));
}

// A reference names its station from 1 on; without a name it is that of the PLC that is asked.
TEST(Network, OperandsOfOthers) {
  std::vector<Station> list;
  list.push_back({"A", station("NOP 0;")});
  list.push_back({"B", station("NOP 0;")});
  Network network(std::move(list));
  start(network);
  address::Reference other = flagWord(10);
  other.station = 2;
  EXPECT_TRUE(network.station(0).write(other, 7));
  EXPECT_EQ(word(network, 1, 10), 7u);
  EXPECT_EQ(network.station(1).read(flagWord(10)), 7u);
  EXPECT_EQ(network.station(0).read(flagWord(10)), 0u);
  EXPECT_EQ(network.station(0).read(other), 7u);
}

TEST(Network, OnlyAnS7HasAnMpiInterface) {
  EXPECT_NE(controller::capability<Connectable>(*station("NOP 0;")), nullptr);
  EXPECT_EQ(controller::capability<Connectable>(*control()), nullptr);
}

}  // namespace
}  // namespace merker::network::test
