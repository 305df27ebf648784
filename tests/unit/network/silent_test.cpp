// Stations that send nothing need no windows: they move alone, and their quiet cycles are passed
// over.
#include "network/network.h"
#include "plc/quiet_cycles.h"
#include "station/block_cpu.h"
#include "stations.h"

namespace merker::network::test {
namespace {

const std::string kNothingSent = "U E 0.0; = A 124.0;";
// Counts what the partner with the address 2 has sent, and shows the last of it.
const std::string kReceives =
    "CALL SFC 66 (EN_DT := TRUE, RET_VAL := MW 6, REQ_ID := MD 8, NDA := M 4.1, RD := MW 12);\n"
    "U M 4.1; SPBN m1; L MW 14; + 1; T MW 14; m1: NOP 0;";
const std::string kSends =
    "L MW 0; + 1; T MW 0;\n"
    "CALL SFC 65 (REQ := TRUE, CONT := TRUE, DEST_ID := W#16#3, REQ_ID := DW#16#1, SD := MW 0, "
    "RET_VAL := MW 2, BUSY := M 4.0);";

std::uint64_t passedOver(Network& network, std::size_t i) {
  return controller::capability<controller::QuietCycles>(network.itself(i))->cyclesPassedOver();
}

void passOver(Network& network, bool on) {
  for (std::size_t i = 0; i < network.size(); ++i)
    controller::capability<controller::QuietCycles>(network.itself(i))->passOverQuietCycles(on);
}

// The stations of `lines` at one subnet, with the addresses from 2 on.
std::unique_ptr<Network> onSubnet(const std::vector<std::string>& lines) {
  std::vector<Station> stations;
  for (std::size_t i = 0; i < lines.size(); ++i)
    stations.push_back({"S" + std::to_string(i), station(lines[i])});
  auto network = std::make_unique<Network>(std::move(stations));
  Subnet& subnet = network->addSubnet(187'500);
  for (std::size_t i = 0; i < lines.size(); ++i)
    network->join(i, subnet, static_cast<std::uint8_t>(2 + i));
  start(*network);
  return network;
}

// All that both networks count is the same.
void expectEqual(Network& a, Network& b) {
  EXPECT_EQ(a.now(), b.now());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a.itself(i).now(), b.itself(i).now()) << i;
    EXPECT_EQ(a.itself(i).cycles(), b.itself(i).cycles()) << i;
    EXPECT_EQ(a.itself(i).instructions(), b.itself(i).instructions()) << i;
    for (unsigned byte = 0; byte < 20; byte += 2) EXPECT_EQ(word(a, i, byte), word(b, i, byte));
  }
}

TEST(Silent, StationsThatSendNothingPassOverQuietCycles) {
  const auto network = onSubnet({kNothingSent, kNothingSent}),
             each = onSubnet({kNothingSent, kNothingSent});
  passOver(*each, false);
  network->advanceTo(Instant{1'000'000'000});
  each->advanceTo(Instant{1'000'000'000});
  for (std::size_t i = 0; i < 2; ++i) EXPECT_GT(passedOver(*network, i), 100u) << i;
  expectEqual(*network, *each);
}

TEST(Silent, ATelegramFindsAQuietStationAtItsInstant) {
  const std::vector<std::string> lines{kSends, kReceives, kNothingSent};
  const auto network = onSubnet(lines), each = onSubnet(lines);
  passOver(*each, false);
  network->advanceTo(Instant{300'000'000});
  each->advanceTo(Instant{300'000'000});
  EXPECT_GT(word(*network, 1, 14), 5u);
  expectEqual(*network, *each);
}

// A partner that only answers does not keep a subnet in use for itself, but it must hear in time.
TEST(Silent, WhoeverOnlyAnswersIsReadByX_GET) {
  const std::string get =
      "CALL SFC 67 (REQ := TRUE, CONT := FALSE, DEST_ID := W#16#3, VAR_ADDR := MW 0, RET_VAL := MW "
      "2, BUSY := M 4.0, RD := MW 12);";
  const std::vector<std::string> lines{get, "L W#16#1234; T MW 0;"};
  const auto network = onSubnet(lines), each = onSubnet(lines);
  passOver(*each, false);
  network->advanceTo(Instant{100'000'000});
  each->advanceTo(Instant{100'000'000});
  EXPECT_EQ(word(*network, 0, 12), 0x1234u);
  expectEqual(*network, *each);
}

TEST(Silent, ADownloadThatSendsBringsTheWindowsBack) {
  const auto network = onSubnet({kNothingSent, kReceives});
  network->advanceTo(Instant{50'000'000});
  const auto sending = compilation::build(
      project::load(
          "a.awl", {},
          {{"a.awl", "ORGANIZATION_BLOCK OB 1\nBEGIN\n" + kSends + "\nEND_ORGANIZATION_BLOCK\n"}}),
      false);
  auto* const cpu = controller::capability<station::BlockCpu>(network->itself(0));
  ASSERT_NE(cpu, nullptr);
  EXPECT_EQ(cpu->download(sending.program, {}), "");
  network->advanceTo(Instant{400'000'000});
  EXPECT_GT(word(*network, 1, 14), 5u);
}

}  // namespace
}  // namespace merker::network::test
