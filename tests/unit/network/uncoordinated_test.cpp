// USEND and URCV over a configured connection between two stations, in virtual time (S7-SFB-10).
#include "stations.h"

namespace merker::network::test {
namespace {

constexpr std::uint32_t kShortest = 10;

// M 0.0 sends MW 50 and M 60.1; MW 10 counts DONE, MW 12 ERROR, MW 14 is the STATUS of that.
std::string sender(const std::string& first = "P#M 50.0 BYTE 2") {
  return "CALL SFB 8, DB 8 (REQ := M 0.0, ID := W#16#1, R_ID := DW#16#7,\n"
         " DONE := M 1.0, ERROR := M 1.1, STATUS := MW 110, SD_1 := " +
         first +
         ", SD_2 := P#M 60.1 BOOL 1);\n"
         "U M 1.0; SPBN d; L MW 10; + 1; T MW 10; d: NOP 0;\n"
         "U M 1.1; SPBN e; L MW 12; + 1; T MW 12; L MW 110; T MW 14; e: NOP 0;\n"
         "SET; R M 0.0;";
}

// M 0.0 enables, M 0.1 calls URCV. MW 10 counts NDR and MW 14 is its STATUS, MW 12 counts ERROR,
// MW 16 is the STATUS of that.
std::string receiver(const std::string& places) {
  return "UN M 0.1; SPB n;\n"
         "CALL SFB 9, DB 9 (EN_R := M 0.0, ID := W#16#1, R_ID := DW#16#7,\n"
         " NDR := M 1.0, ERROR := M 1.1, STATUS := MW 110, " +
         places +
         ");\n"
         "U M 1.0; SPBN d; L MW 10; + 1; T MW 10; L MW 110; T MW 14; d: NOP 0;\n"
         "U M 1.1; SPBN e; L MW 12; + 1; T MW 12; L MW 110; T MW 16; e: NOP 0;\n"
         "n: NOP 0;";
}

const char* const kBoth = "RD_1 := P#M 70.0 BYTE 4, RD_2 := P#M 80.2 BOOL 1";

class Uncoordinated : public testing::TestWithParam<bool> {
 protected:
  void make(const std::string& places = kBoth, const std::string& sending = sender()) {
    std::vector<Station> list;
    list.push_back({"A", station(sending, "DATA_BLOCK DB 8\nSFB 8\nBEGIN\nEND_DATA_BLOCK\n",
                                 "generic", kShortest)});
    list.push_back(
        {"B", station(receiver(places), "DATA_BLOCK DB 9\nSFB 9\nBEGIN\nEND_DATA_BLOCK\n",
                      "generic", kShortest)});
    network = std::make_unique<Network>(std::move(list), 1);
    line = &network->addSubnet(GetParam() ? ethernet(100'000'000) : mpi(187'500));
    for (std::size_t i = 0; i < 2; ++i) {
      const auto address = static_cast<std::uint8_t>(i + 2);
      GetParam() ? network->attach(i, *line, address) : network->join(i, *line, address);
    }
    network->connect(*line, {0, std::uint16_t{1}}, {1, std::uint16_t{1}});
    start(*network);
    wait(100);
  }
  void wait(int ms) { network->advanceTo(network->now() + Duration::milliseconds(ms)); }
  void set(std::size_t i, unsigned byte, std::uint32_t value) {
    ASSERT_TRUE(network->itself(i).write(flagWord(byte), value));
  }
  void enable(unsigned bits) {
    set(1, 0, bits << 8);
    wait(50);
  }
  void send(std::uint32_t value) {
    set(0, 50, value);
    set(0, 60, 0x0200);
    set(0, 0, 0x0100);
    wait(100);
  }
  std::uint32_t a(unsigned byte) { return word(*network, 0, byte); }
  std::uint32_t b(unsigned byte) { return word(*network, 1, byte); }

  std::unique_ptr<Network> network;
  Subnet* line = nullptr;
};

constexpr unsigned kGood = 10, kBad = 12, kSendStatus = 14, kTakenStatus = 14, kBadStatus = 16;
constexpr unsigned kCalls = 2, kEnabled = 1;

TEST_P(Uncoordinated, BringsItsAreas) {
  make();
  enable(kCalls | kEnabled);
  send(0x1234);
  EXPECT_EQ(a(kGood), 1u);
  EXPECT_EQ(a(kBad), 0u);
  EXPECT_EQ(b(kGood), 1u);
  EXPECT_EQ(b(kTakenStatus), 0u);
  EXPECT_EQ(b(70), 0x1234u);
  EXPECT_EQ(b(72), 0u);  // RD_1 is longer
  EXPECT_EQ(b(80), 0x0400u);
}

// The sender learns nothing of it.
TEST_P(Uncoordinated, IsLostWhereNobodyListens) {
  make();
  send(1);
  enable(kCalls);  // EN_R = 0
  send(2);
  EXPECT_EQ(a(kGood), 2u);
  enable(kCalls | kEnabled);
  EXPECT_EQ(b(kGood), 0u);
  network->itself(1).stop();
  send(3);
  EXPECT_EQ(a(kGood), 3u);
}

// STATUS 9
TEST_P(Uncoordinated, ARestartForgetsWhatCameInStop) {
  make();
  enable(kCalls | kEnabled);
  network->itself(1).stop();
  send(77);
  ASSERT_TRUE(network->itself(1).start());
  wait(100);
  EXPECT_EQ(b(kGood), 0u);
  EXPECT_EQ(b(0) & 0x0300, 0x0300u);  // it has listened from its first cycle on
  send(78);
  EXPECT_EQ(b(kGood), 1u);
}

TEST_P(Uncoordinated, TheNewestCounts) {
  make();
  enable(kCalls | kEnabled);
  enable(0);  // it is not called
  send(1);
  send(2);
  enable(kCalls | kEnabled);
  EXPECT_EQ(b(kGood), 1u);
  EXPECT_EQ(b(kTakenStatus), 9u);
  EXPECT_EQ(b(70), 2u);
  send(3);
  EXPECT_EQ(b(kGood), 2u);
  EXPECT_EQ(b(kTakenStatus), 0u);
}

// STATUS 4: number, type or length; nothing of it is stored. 10: the data block is missing.
TEST_P(Uncoordinated, AreasMustMatch) {
  struct Row {
    const char* places;
    std::uint32_t status;
  };
  for (const Row& row : {Row{"RD_1 := P#M 70.0 BYTE 4", 4},
                         Row{"RD_1 := P#M 70.0 BYTE 1, RD_2 := P#M 80.2 BOOL 1", 4},
                         Row{"RD_1 := P#M 70.0 INT 1, RD_2 := P#M 80.2 BOOL 1", 4},
                         Row{"RD_1 := P#M 70.0 BYTE 4, RD_2 := P#M 80.0 BYTE 1", 4},
                         Row{"RD_1 := P#DB77.DBX 0.0 BYTE 4, RD_2 := P#M 80.2 BOOL 1", 10}}) {
    make(row.places);
    enable(kCalls | kEnabled);
    send(0x1234);
    EXPECT_EQ(a(kGood), 1u) << row.places;
    EXPECT_EQ(b(kGood), 0u) << row.places;
    EXPECT_EQ(b(kBad), 1u) << row.places;
    EXPECT_EQ(b(kBadStatus), row.status) << row.places;
    EXPECT_EQ(b(70), 0u) << row.places;
  }
}

TEST_P(Uncoordinated, TellsWhatCannotBeSent) {
  make(kBoth, sender("P#M 0.0 BYTE 250"));
  send(0);
  EXPECT_EQ(a(kSendStatus), 4u);  // longer than a PDU
  make(kBoth, sender("P#DB77.DBX 0.0 BYTE 2"));
  send(0);
  EXPECT_EQ(a(kSendStatus), 10u);
  make();
  network->itself(1).powerOff();
  send(1);
  wait(3000);
  send(2);
  EXPECT_EQ(a(kGood) + a(kBad), 2u);
}

// STATUS 1, in each call of URCV.
TEST_P(Uncoordinated, NeedsItsConnection) {
  make();
  line->interrupt();
  send(1);
  wait(4000);
  enable(kCalls | kEnabled);
  if (!GetParam()) {  // MPI tells that a telegram could not be delivered
    send(2);
    EXPECT_EQ(a(kSendStatus), 1u);
  }
  EXPECT_EQ(b(kGood), 0u);
}

INSTANTIATE_TEST_SUITE_P(Both, Uncoordinated, testing::Bool(),
                         [](const auto& of) { return of.param ? "Ethernet" : "Mpi"; });

}  // namespace
}  // namespace merker::network::test
