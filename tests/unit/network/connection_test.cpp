// Configured connections between two stations, over MPI and over Ethernet:
// BSEND, BRCV, GET, PUT in virtual time, and what becomes of them when a partner is not there.
#include "stations.h"

namespace merker::network::test {
namespace {

std::string data() {
  return "DATA_BLOCK DB 1\nSTRUCT\n d : ARRAY [0..999] OF BYTE;\nEND_STRUCT\nBEGIN\n"
         "d[0] := B#16#11;\nd[599] := B#16#99;\nEND_DATA_BLOCK\n"
         "DATA_BLOCK DB 2\nSTRUCT\n d : ARRAY [0..999] OF "
         "BYTE;\nEND_STRUCT\nBEGIN\nEND_DATA_BLOCK\n"
         "DATA_BLOCK DB 3\nREAD_ONLY\nSTRUCT\n d : ARRAY [0..9] OF BYTE;\nEND_STRUCT\nBEGIN\n"
         "END_DATA_BLOCK\n";
}

std::string instances() {
  std::string text = data();
  for (int number = 12; number <= 15; ++number) {
    const std::string name = std::to_string(number);
    text += "DATA_BLOCK DB " + name + "\nSFB " + name + "\nBEGIN\nEND_DATA_BLOCK\n";
  }
  return text;
}

// MW `at` counts `done`, MW `at`+2 `failed`; then MW `at`+4 is STATUS, which is in MW 110.
std::string count(int at, const std::string& done, const std::string& failed,
                  const std::string& label) {
  const std::string good = std::to_string(at), bad = std::to_string(at + 2);
  return "U " + done + "; SPBN " + label + "g; L MW " + good + "; + 1; T MW " + good + "; " +
         label + "g: U " + failed + "; SPBN " + label + "b; L MW " + bad + "; + 1; T MW " + bad +
         "; L MW 110; T MW " + std::to_string(at + 4) + "; " + label + "b: NOP 0;\n";
}

// M 0.0 sends 600 bytes of DB 1, M 0.1 reads `there`, M 0.2 writes it, M 0.3 receives into DB 2.
std::string connectedProgram(const std::string& there = "P#M200.0 BYTE 4",
                             const std::string& received = "P#DB2.DBX 0.0 BYTE 1000") {
  return "L 600; T MW 100;\n"
         "CALL SFB 12, DB 12 (REQ := M 0.0, R := M 0.4, ID := W#16#1, R_ID := DW#16#5,\n"
         " DONE := M 1.0, ERROR := M 1.1, STATUS := MW 110, SD_1 := P#DB1.DBX 0.0 BYTE 1000,\n"
         " LEN := MW 100);\n" +
         count(10, "M 1.0", "M 1.1", "s") +
         "CALL SFB 13, DB 13 (EN_R := M 0.3, ID := W#16#1, R_ID := DW#16#5,\n"
         " NDR := M 1.0, ERROR := M 1.1, STATUS := MW 110, RD_1 := " +
         received +
         ",\n"
         " LEN := MW 102);\n" +
         count(20, "M 1.0", "M 1.1", "r") +
         "CALL SFB 14, DB 14 (REQ := M 0.1, ID := W#16#1, NDR := M 1.0, ERROR := M 1.1,\n"
         " STATUS := MW 110, ADDR_1 := " +
         there + ", RD_1 := P#M 210.0 BYTE 4);\n" + count(30, "M 1.0", "M 1.1", "g") +
         "CALL SFB 15, DB 15 (REQ := M 0.2, ID := W#16#1, DONE := M 1.0, ERROR := M 1.1,\n"
         " STATUS := MW 110, ADDR_1 := " +
         there + ", SD_1 := P#M 214.0 BYTE 4);\n" + count(40, "M 1.0", "M 1.1", "p") +
         "SET; R M 0.0; R M 0.1; R M 0.2;";
}

constexpr std::uint32_t kCycle = 10;

class Connected : public testing::TestWithParam<bool> {
 protected:
  void make(const std::string& own = connectedProgram(), bool oneSided = false,
            unsigned threads = 1, const std::string& partner = connectedProgram()) {
    std::vector<Station> list;
    list.push_back({"A", station(own, instances(), "generic", kCycle)});
    if (oneSided)
      list.push_back({"B", station("L MW 200; T MW 202;", data(), {}, kCycle)});  // a 314C-2
    else
      list.push_back({"B", station(partner, instances(), "generic", kCycle)});
    network = std::make_unique<Network>(std::move(list), threads);
    line = &network->addSubnet(GetParam() ? ethernet(100'000'000) : mpi(187'500));
    for (std::size_t i = 0; i < 2; ++i) {
      const auto address = static_cast<std::uint8_t>(i + 2);
      GetParam() ? network->attach(i, *line, address) : network->join(i, *line, address);
    }
    const std::optional<std::uint16_t> id =
        oneSided ? std::nullopt : std::optional<std::uint16_t>(std::uint16_t{1});
    network->connect(*line, {0, std::uint16_t{1}}, {1, id});
    start(*network);
    wait(100);
  }
  void wait(int ms) { network->advanceTo(network->now() + Duration::milliseconds(ms)); }
  void set(std::size_t i, unsigned byte, std::uint32_t value) {
    ASSERT_TRUE(network->itself(i).write(flagWord(byte), value));
  }
  void begin(std::uint32_t bits, int ms = 300) {
    set(0, 0, bits << 8);
    wait(ms);
  }
  std::uint32_t a(unsigned byte) { return word(*network, 0, byte); }
  std::uint32_t b(unsigned byte) { return word(*network, 1, byte); }
  std::uint32_t byteOfDb2(std::size_t i, unsigned byte) {
    address::Reference reference;
    reference.operand = address::memory(Area::DataBlock, Width::Byte, 8 * byte);
    reference.db = 2;
    return network->itself(i).read(reference).value_or(0xFFFF);
  }

  std::unique_ptr<Network> network;
  Subnet* line = nullptr;
};

constexpr std::uint32_t kStartSend = 1, kStartGet = 2, kStartPut = 4, kStartReceive = 8;
constexpr unsigned kSent = 10, kReceived = 20, kGot = 30, kWritten = 40, kFailed = 2, kStatus = 4;

// S7-NETPRO-08, S7-SFB-10
TEST_P(Connected, ReadsAndWritesTheVariablesOfAPartnerThatOnlyServes) {
  make(connectedProgram(), true);
  set(1, 200, 0x1122);
  begin(kStartGet);
  EXPECT_EQ(a(kGot), 1u);
  EXPECT_EQ(a(kGot + kFailed), 0u);
  EXPECT_EQ(a(210), 0x1122u);
  EXPECT_EQ(a(212), 0x1122u);  // its program has copied it
  set(0, 214, 0x5566);
  begin(kStartPut);
  EXPECT_EQ(a(kWritten), 1u);
  EXPECT_EQ(b(200), 0x5566u);
  begin(kStartSend);  // no block of it receives
  EXPECT_EQ(a(kSent + kFailed), 1u);
  EXPECT_EQ(a(kSent + kStatus), 3u);
}

// S7-NETPRO-08, S7-SFB-10
TEST_P(Connected, SendsDataOfSeveralTelegrams) {
  make();
  set(1, 0, kStartReceive << 8);
  wait(50);
  begin(kStartSend, 1000);
  EXPECT_EQ(a(kSent), 1u);
  EXPECT_EQ(b(kReceived), 1u);
  EXPECT_EQ(b(102), 600u);
  EXPECT_EQ(byteOfDb2(1, 0), 0x11u);
  EXPECT_EQ(byteOfDb2(1, 599), 0x99u);
}

// Nobody may take for received what was lost: RD_1 is in a block that is READ_ONLY, or missing.
TEST_P(Connected, RefusesWhatCannotBeStored) {
  for (const char* place : {"P#DB3.DBX 0.0 BYTE 10", "P#DB77.DBX 0.0 BYTE 1000"}) {
    make(connectedProgram(), false, 1, connectedProgram("P#M200.0 BYTE 4", place));
    set(1, 0, kStartReceive << 8);
    wait(50);
    begin(kStartSend, 1000);
    EXPECT_EQ(a(kSent), 0u) << place;
    EXPECT_EQ(a(kSent + kStatus), 2u) << place;
    EXPECT_EQ(b(kReceived), 0u) << place;
    EXPECT_EQ(b(kReceived + kStatus), 10u) << place;
  }
}

TEST_P(Connected, TellsWhatThePartnerHasNot) {
  for (const char* there : {"P#DB9.DBX0.0 BYTE 4", "P#DB1.DBX998.0 BYTE 4"}) {
    make(connectedProgram(there), true);
    begin(kStartGet);
    EXPECT_EQ(a(kGot + kStatus), 8u) << there;
  }
  make(connectedProgram("P#DB3.DBX0.0 BYTE 4"), true);
  begin(kStartPut);
  EXPECT_EQ(a(kWritten + kStatus), 8u);
}

TEST_P(Connected, AServerInStopAnswers) {
  make(connectedProgram(), true);
  set(1, 200, 0x1122);
  network->itself(1).stop();
  begin(kStartGet);
  EXPECT_EQ(a(kGot), 1u);
  EXPECT_EQ(a(210), 0x1122u);
}

TEST_P(Connected, IsBuiltUpAgainWhenThePartnerHasPower) {
  make();
  network->itself(1).powerOff();
  begin(kStartGet, 1900);
  EXPECT_EQ(a(kGot), 0u);
  EXPECT_EQ(a(kGot + kFailed), 0u);  // it waits
  wait(300);
  EXPECT_EQ(a(kGot + kStatus), 1u);  // for 2 s
  network->itself(1).powerOn(true);
  wait(4000);
  begin(kStartGet);
  EXPECT_EQ(a(kGot), 1u);
  network->itself(0).powerOff();  // the one that calls
  wait(500);
  network->itself(0).powerOn(true);
  wait(4000);
  const std::uint32_t before = a(kGot);  // flags may be retentive
  begin(kStartGet);
  EXPECT_EQ(a(kGot), before + 1);
}

TEST_P(Connected, ABrokenLineEndsItUntilItIsMended) {
  make();
  line->interrupt();
  begin(kStartGet, 2500);
  EXPECT_EQ(a(kGot + kFailed), 1u);
  EXPECT_EQ(a(kGot + kStatus), 1u);
  begin(kStartGet, 50);
  EXPECT_EQ(a(kGot + kFailed), 2u);  // at once: there is no connection
  line->mend();
  wait(4000);
  begin(kStartGet);
  EXPECT_EQ(a(kGot), 1u);
}

// At any instant: in a telegram, between two of them, while it is built up.
TEST_P(Connected, APlugThatIsPulledAtAnyInstantHangsNothing) {
  make();
  std::uint32_t seed = 1;
  for (int i = 0; i < 8; ++i) {
    seed = seed * 1'103'515'245 + 12'345;
    set(1, 0, kStartReceive << 8);
    set(0, 0, (kStartSend | kStartGet) << 8);
    network->advanceTo(network->now() +
                       Duration::microseconds(seed % (GetParam() ? 10'000 : 100'000)));
    line->interrupt(3);
    wait(static_cast<int>(seed >> 8 & 0xFF));
    line->mend(3);
    wait(4000);
    const std::uint32_t sent = a(kSent), got = a(kGot);
    begin(kStartSend | kStartGet, 1000);
    EXPECT_EQ(a(kSent), sent + 1) << i;
    EXPECT_EQ(a(kGot), got + 1) << i;
  }
}

TEST_P(Connected, TheSameOnAnyNumberOfThreads) {
  std::vector<std::uint64_t> seen;
  for (const unsigned threads : {1u, 2u}) {
    make(connectedProgram(), false, threads);
    set(1, 0, kStartReceive << 8);
    begin(kStartSend | kStartGet, 500);
    EXPECT_EQ(a(kSent), 1u);
    for (std::size_t i = 0; i < 2; ++i) {
      seen.push_back(network->itself(i).instructions());
      seen.push_back(network->itself(i).cycles());
    }
    seen.push_back(static_cast<std::uint64_t>(line->busy().ns));
  }
  EXPECT_EQ(std::vector(seen.begin(), seen.begin() + 5), std::vector(seen.begin() + 5, seen.end()));
}

INSTANTIATE_TEST_SUITE_P(Both, Connected, testing::Bool(),
                         [](const auto& of) { return of.param ? "Ethernet" : "Mpi"; });

}  // namespace
}  // namespace merker::network::test
