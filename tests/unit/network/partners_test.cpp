// S7-SFC-23, S7-LIM-02: basic communication of two CPUs on one MPI subnet (SFC 65 to 69), what the
// functions return, and what becomes of connections.
#include "stations.h"

namespace merker::network::test {
namespace {

const std::string kData =
    "DATA_BLOCK DB 1\nSTRUCT\n d : ARRAY [0..99] OF BYTE;\nEND_STRUCT\nBEGIN\nEND_DATA_BLOCK\n"
    "DATA_BLOCK DB 3\nREAD_ONLY\nSTRUCT\n d : ARRAY [0..9] OF "
    "BYTE;\nEND_STRUCT\nBEGIN\nEND_DATA_BLOCK\n";

// MW `at` counts the ends of a job, MW `at`+2 is what the last one returned. RET_VAL is in MW 100.
std::string note(int at, const std::string& label) {
  const std::string count = std::to_string(at), code = std::to_string(at + 2);
  return "L MW 100; UW W#16#FFF0; L W#16#7000; ==I; SPB " + label + "; L MW 100; T MW " + code +
         "; L MW " + count + "; + 1; T MW " + count + "; " + label + ": NOP 0;\n";
}

// M 0.0 sends `bytes` of DB 1, M 0.1 reads `variable`, M 0.2 writes it, M 0.3 ends the connection,
// M 0.4 keeps it; M 0.6 asks SFC 66, M 0.7 fetches.
std::string program(const std::string& variable = "P#M200.0 BYTE 4", int bytes = 10) {
  const std::string size = std::to_string(bytes), to = "DEST_ID := MW 2, ";
  return "CALL SFC 65 (REQ := M 0.0, CONT := M 0.4, " + to +
         "REQ_ID := DW#16#1234, SD := P#DB1.DBX0.0 BYTE " + size +
         ", RET_VAL := MW 100, BUSY := M 1.0);\n" + note(10, "a") +
         "CALL SFC 67 (REQ := M 0.1, CONT := M 0.4, " + to + "VAR_ADDR := " + variable +
         ", RET_VAL := MW 100, BUSY := M 1.1, RD := P#M 210.0 BYTE 4);\n" + note(14, "b") +
         "CALL SFC 68 (REQ := M 0.2, CONT := M 0.4, " + to + "VAR_ADDR := " + variable +
         ", SD := P#M 214.0 BYTE 4, RET_VAL := MW 100, BUSY := M 1.2);\n" + note(18, "c") +
         "CALL SFC 69 (REQ := M 0.3, " + to + "RET_VAL := MW 100, BUSY := M 1.3);\n" +
         note(22, "d") +
         "U M 0.6; SPBN e; CALL SFC 66 (EN_DT := M 0.7, RET_VAL := MW 100, REQ_ID := MD 40, NDA := "
         "M 1.4, RD := "
         "P#DB1.DBX20.0 BYTE 76);\nU M 1.4; SPBN e; L MW 100; T MW 28; L MW 26; + 1; T MW 26; e: "
         "NOP 0;\n"
         "SET; R M 0.0; R M 0.1; R M 0.2; R M 0.3;";
}

class Partners : public testing::Test {
 protected:
  void make(const std::string& own, const std::string& other = program()) {
    std::vector<Station> list;
    list.push_back({"A", station(own, kData)});
    list.push_back({"B", station(other, kData)});
    network = std::make_unique<Network>(std::move(list));
    Subnet& subnet = network->addSubnet(187'500);
    network->join(0, subnet, 2);
    network->join(1, subnet, 3);
    start(*network);
    wait(10);
    set(0, 2, 3);  // DEST_ID
  }
  void wait(int ms) { network->advanceTo(network->now() + Duration::milliseconds(ms)); }
  void set(std::size_t i, unsigned byte, std::uint32_t value) {
    ASSERT_TRUE(network->itself(i).write(flagWord(byte), value));
  }
  // Bits of MB 0, the high byte of MW 0; waits until the job is over.
  void begin(std::uint32_t bits, int ms = 100) {
    set(0, 0, bits << 8);
    wait(ms);
  }
  std::uint32_t a(unsigned byte) { return word(*network, 0, byte); }
  std::uint32_t b(unsigned byte) { return word(*network, 1, byte); }

  std::unique_ptr<Network> network;
};

constexpr std::uint32_t kSend = 1, kGet = 2, kPut = 4, kAbort = 8, kKeep = 16;
constexpr std::uint32_t kAsk = 64 << 8, kFetch = 192 << 8;  // at the receiver

TEST_F(Partners, SendsWhatThePartnerFetches) {
  make(program("P#M200.0 BYTE 4", 76));
  set(1, 0, kAsk);
  begin(kSend);
  EXPECT_EQ(a(10), 0u);  // nobody has taken the data: the job goes on
  EXPECT_GT(b(26), 1u);
  EXPECT_EQ(b(28), 76u);
  EXPECT_EQ(b(42), 0x1234u);
  set(1, 0, kFetch);
  wait(20);
  EXPECT_EQ(a(10), 1u);
  EXPECT_EQ(a(12), 0u);
  const std::uint32_t told = b(26);
  wait(20);
  EXPECT_EQ(b(26), told);  // once
}

TEST_F(Partners, ReadsAndWritesVariables) {
  make(program());
  set(1, 200, 0x1122);
  set(1, 202, 0x3344);
  begin(kGet);
  EXPECT_EQ(a(14), 1u);
  EXPECT_EQ(a(16), 0u);
  EXPECT_EQ(a(210), 0x1122u);
  EXPECT_EQ(a(212), 0x3344u);
  set(0, 214, 0x5566);
  begin(kPut);
  EXPECT_EQ(a(18), 1u);
  EXPECT_EQ(a(20), 0u);
  EXPECT_EQ(b(200), 0x5566u);
}

TEST_F(Partners, TellsWhatIsWrongWithTheVariable) {
  const std::pair<const char*, std::uint32_t> rows[] = {{"P#DB9.DBX0.0 BYTE 4", 0x80B0},
                                                        {"P#DB1.DBX98.0 BYTE 4", 0x80B1},
                                                        {"P#DB1.DBX0.0 BYTE 77", 0x80BA}};
  for (const auto& [variable, code] : rows) {
    make(program(variable));
    begin(kGet);
    EXPECT_EQ(a(14), 1u) << variable;
    EXPECT_EQ(a(16), code) << variable;
  }
  make(program("P#DB3.DBX0.0 BYTE 4"));
  begin(kPut);
  EXPECT_EQ(a(20), 0x80B3u);
  make(program("P#M200.0 BYTE 2"));
  begin(kPut);
  EXPECT_EQ(a(20), 0x80B1u);
  begin(kGet);
  EXPECT_EQ(a(16), 0x8092u);
}

TEST_F(Partners, NobodyThere) {
  make(program());
  set(0, 2, 9);
  begin(kSend);
  EXPECT_EQ(a(10), 1u);
  EXPECT_EQ(a(12), 0x80C3u);
  set(0, 2, 2);  // its own address
  begin(kGet);
  EXPECT_EQ(a(16), 0x80C3u);
  set(0, 2, 3);
  network->itself(1).powerOff();
  begin(kGet, 1900);
  EXPECT_EQ(a(14), 1u);
  wait(200);
  EXPECT_EQ(a(14), 2u);
  EXPECT_EQ(a(16), 0x80C3u);
}

TEST_F(Partners, InStopItsVariablesCanBeReached) {
  make(program());
  set(1, 200, 0x1122);
  network->itself(1).stop();
  begin(kGet);
  EXPECT_EQ(a(16), 0u);
  EXPECT_EQ(a(210), 0x1122u);
  begin(kSend);
  EXPECT_EQ(a(12), 0x80B5u);
}

TEST_F(Partners, WhatWaitsIsRefusedAtStop) {
  make(program());
  begin(kSend);
  EXPECT_EQ(a(10), 0u);
  network->itself(1).stop();
  wait(20);
  EXPECT_EQ(a(12), 0x80B5u);
  ASSERT_TRUE(network->itself(1).start());
  wait(20);
  set(1, 0, kAsk);
  begin(kSend);
  network->itself(1).stop();
  wait(20);
  EXPECT_EQ(a(12), 0x80B9u);
}

TEST_F(Partners, OneJobForAConnection) {
  make(program());
  begin(kSend);  // waits for SFC 66
  begin(kGet);
  EXPECT_EQ(a(16), 0x80C0u);
  begin(kAbort);
  EXPECT_EQ(a(22), 1u);
  EXPECT_EQ(a(24), 0u);
  begin(kGet);
  EXPECT_EQ(a(16), 0u);
  set(1, 0, kAsk);
  wait(20);
  EXPECT_EQ(b(26), 0u);  // what the aborted job had sent is discarded
}

// A kept connection is used again: a second job needs two telegrams less and is faster.
TEST_F(Partners, AKeptConnectionIsUsedAgain) {
  make(program());
  const auto lasts = [&](std::uint32_t bits) {
    const std::uint32_t before = a(14);
    set(0, 0, bits << 8);
    int ms = 0;
    for (; a(14) == before && ms < 100; ++ms) wait(1);
    return ms;
  };
  const int first = lasts(kGet | kKeep), second = lasts(kGet | kKeep);
  EXPECT_EQ(a(16), 0u);
  EXPECT_GT(first, second + 1);
  network->itself(1).powerOff();
  begin(kGet | kKeep, 2100);
  EXPECT_EQ(a(16), 0x80A1u);
}

// Eight connections of basic communication a CPU has (S7-LIM-05): the ninth partner is refused.
TEST(ManyPartners, ConnectionsAreCounted) {
  std::vector<Station> list;
  list.push_back({"B", station(program(), kData)});
  for (int i = 0; i < 9; ++i) list.push_back({"A", station(program(), kData)});
  Network network(std::move(list), 2);
  Subnet& subnet = network.addSubnet(187'500);
  for (std::size_t i = 0; i < network.size(); ++i)
    network.join(i, subnet, static_cast<std::uint8_t>(3 + i));
  start(network);
  network.advanceTo(Instant{10'000'000});
  for (std::size_t i = 1; i < network.size(); ++i) {
    network.itself(i).write(flagWord(2), 3);
    network.itself(i).write(flagWord(0), (kGet | kKeep) << 8);
  }
  network.advanceTo(Instant{300'000'000});
  int good = 0, refused = 0;
  for (std::size_t i = 1; i < network.size(); ++i) {
    EXPECT_EQ(word(network, i, 14), 1u);
    good += word(network, i, 16) == 0 ? 1 : 0;
    refused += word(network, i, 16) == 0x80C2 ? 1 : 0;
  }
  EXPECT_EQ(good, 8);
  EXPECT_EQ(refused, 1);
}

}  // namespace
}  // namespace merker::network::test
