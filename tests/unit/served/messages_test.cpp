// Messages of a CPU for those who listen.
#include "served/messages.h"

#include "s7comm/messages.h"
#include "served_plc.h"

namespace merker::served {
namespace {

using s7comm::Error;
using s7comm::Outlet;

// M 0.0 and M 0.1 are the signals of messages 1 (must be acknowledged) and 2, with MW 20 as the
// value of the first one; M 0.2 writes an entry of class A; M 0.3 asks SFC 19.
const char* const kMessenger =
    "ORGANIZATION_BLOCK OB 1\nVAR_TEMP\n info : ARRAY [1..20] OF BYTE;\n r : INT;\n state : BOOL;\n"
    " q : BOOL;\nEND_VAR\nBEGIN\nNETWORK\n"
    " U M 0.0; X M 1.0; SPBN n1; U M 0.0; = M 1.0;\n"
    " CALL SFC 17 (SIG := M 0.0, ID := W#16#EEEE, EV_ID := DW#16#1, SD := P#M 20.0 BYTE 2, RET_VAL "
    ":= MW 30);\n"
    "n1: U M 0.1; X M 1.1; SPBN n2; U M 0.1; = M 1.1;\n"
    " CALL SFC 18 (SIG := M 0.1, ID := W#16#EEEE, EV_ID := DW#16#2, SD := P#M 22.0 BYTE 1, RET_VAL "
    ":= MW 32);\n"
    "n2: U M 0.2; FP M 1.2; SPBN n3;\n"
    " CALL SFC 52 (SEND := TRUE, EVENTN := W#16#A123, INFO1 := MW 20, INFO2 := MD 40, RET_VAL := "
    "MW 34);\n"
    "n3: CALL SFC 19 (EV_ID := DW#16#1, RET_VAL := MW 36, STATE := M 2.0, Q_STATE := M 2.1);\n"
    "n4: U M 0.4; X M 1.4; SPBN n5; U M 0.4; = M 1.4;\n"
    " CALL SFC 107 (SIG := M 0.4, ID := W#16#EEEE, EV_ID := DW#16#4, CMP_ID := DW#16#9, SD := P#M "
    "20.0 BYTE 1, RET_VAL := MW 44);\n"
    "n5: U M 0.5; X M 1.5; SPBN n6; U M 0.5; = M 1.5;\n"
    " CALL SFC 108 (SIG := M 0.5, ID := W#16#EEEE, EV_ID := DW#16#5, CMP_ID := DW#16#9, SD := P#M "
    "20.0 BYTE 1, RET_VAL := MW 46);\n"
    "n6: NOP 0;\nEND_ORGANIZATION_BLOCK\n";

class ListeningTest : public ::testing::Test {
 protected:
  void SetUp() override {
    plc.exchange.opened();
    plc.cycles(1);
  }
  static std::shared_ptr<Outlet> someone() {
    auto one = std::make_shared<Outlet>();
    one->setRoom(200);
    return one;
  }
  Error listen(const std::shared_ptr<Outlet>& who, std::uint8_t kinds) {
    Error how = Error::CannotBeDone;
    plc.exchange.listen(who, kinds, [&](Error error) { how = error; });
    plc.cycles(1);
    return how;
  }
  // Subfunctions of what was sent: "17 18 12"; with 12 octets behind the time.
  static std::string heard(Outlet& who) {
    std::string text;
    while (const auto one = who.take())
      text += (text.empty() ? "" : " ") + std::to_string(one->group) + "/" +
              std::to_string(one->subfunction);
    return text;
  }
  void set(std::uint8_t bits) {
    plc.writeNow(flags(0, 1), {bits});
    plc.cycles(2);
  }
  std::uint32_t word(std::uint32_t at) {
    return plc.read(flags(at, 2))->octets[0] << 8 | plc.read(flags(at, 2))->octets[1];
  }

  ServedPlc plc = ServedPlc::station(kMessenger);
  std::shared_ptr<Outlet> client = someone();
};

TEST_F(ListeningTest, nobodyListens) {
  set(1);
  EXPECT_EQ(word(30), 0x8085u);
  set(4);
  EXPECT_EQ(word(34), 0x8091u);
  EXPECT_EQ(heard(*client), "");
}

TEST_F(ListeningTest, messagesComeAndGo) {
  EXPECT_EQ(listen(client, s7comm::kAlarms), Error::None);
  plc.writeNow(flags(20, 2), {0xAB, 0xCD});
  set(1);
  EXPECT_EQ(word(30), 0u);
  const auto coming = client->take();
  ASSERT_TRUE(coming);
  EXPECT_EQ(coming->subfunction, 0x11);
  EXPECT_EQ(Bytes(coming->octets.begin() + 8, coming->octets.end()),
            (Bytes{0, 1, 0x12, 10, 0x16, 1, 0, 0, 0, 1, 1, 0, 1, 0, 0xFF, 9, 0, 2, 0xAB, 0xCD}));
  set(0);
  EXPECT_EQ(heard(*client), "4/17");
  set(2);
  set(0);
  EXPECT_EQ(heard(*client), "4/18 4/18");
  set(0x30);
  EXPECT_EQ(word(44) | word(46), 0u);
  EXPECT_EQ(heard(*client), "4/17 4/18");
}

// SFC 19 sees what a display device has acknowledged, and all of them hear of it.
TEST_F(ListeningTest, acknowledged) {
  const auto other = someone();
  listen(client, s7comm::kAlarms);
  listen(other, s7comm::kAlarms);
  set(1);
  EXPECT_EQ(plc.read(flags(2, 1))->octets[0], 1);
  std::vector<ItemCode> codes;
  plc.exchange.acknowledge({1, 77}, [&](const std::vector<ItemCode>& all) { codes = all; });
  plc.cycles(2);
  EXPECT_EQ(codes, (std::vector{ItemCode::Done, ItemCode::Missing}));
  EXPECT_EQ(plc.read(flags(2, 1))->octets[0], 3);
  EXPECT_EQ(heard(*client), "4/17 4/12");
  EXPECT_EQ(heard(*other), "4/17 4/12");
}

TEST_F(ListeningTest, whoEndsHearsNoMore) {
  const auto other = someone();
  listen(client, s7comm::kAlarms);
  listen(other, s7comm::kAlarms);
  EXPECT_EQ(listen(client, 0), Error::None);
  other->close();
  plc.cycles(2);
  set(1);
  EXPECT_EQ(word(30), 0x8085u);
  EXPECT_EQ(heard(*client), "");
}

TEST_F(ListeningTest, locked) {
  listen(client, s7comm::kAlarms);
  plc.exchange.lock({1}, true, [](const std::vector<ItemCode>&) {});
  plc.cycles(1);
  set(3);
  EXPECT_EQ(heard(*client), "4/18");
}

TEST_F(ListeningTest, theMessagesThatStand) {
  plc.writeNow(flags(20, 2), {0xAB, 0xCD});
  set(3);
  std::optional<std::vector<s7comm::AlarmState>> all;
  plc.exchange.alarms([&](const auto& list) { all = list; });
  plc.cycles(1);
  ASSERT_EQ(all->size(), 2u);
  EXPECT_EQ(all->at(0).number, 1u);
  EXPECT_TRUE(all->at(0).waits && all->at(0).signal && !all->at(0).acknowledged);
  EXPECT_EQ(all->at(0).comingValue, (Bytes{0xAB, 0xCD}));
  EXPECT_EQ(all->at(0).going, s7comm::ClockTime{});
  EXPECT_TRUE(all->at(1).acknowledged);
}

// SFC 52 with SEND, and a STOP: each client hears what it wants to.
TEST_F(ListeningTest, eventsAndModes) {
  const auto system = someone(), modes = someone();
  listen(client, s7comm::kUserEvents);
  listen(system, s7comm::kSystemEvents);
  listen(modes, s7comm::kModes);
  set(4);
  const auto entry = client->take();
  ASSERT_TRUE(entry);
  EXPECT_EQ(entry->subfunction, 3);
  ASSERT_EQ(entry->octets.size(), 20u);
  EXPECT_EQ(entry->octets[0], 0xA1);
  EXPECT_EQ(entry->octets[1], 0x23);
  EXPECT_EQ(word(34), 0u);
  EXPECT_EQ(heard(*system) + heard(*modes), "");
  plc.monitor().stop();
  plc.look();
  EXPECT_EQ(heard(*client), "");
  EXPECT_EQ(heard(*system), "4/3");
  EXPECT_EQ(heard(*modes), "0/0");
}

TEST_F(ListeningTest, aSlowClientKeepsTheOldestAndThePlcRuns) {
  listen(client, s7comm::kAlarms);
  for (int i = 0; i < 50; ++i) set(2), set(0);
  EXPECT_GT(client->lost(), 30u);
  EXPECT_EQ(word(32), 0u);
}

TEST(Messages, aSinumerikHasNone) {
  ServedPlc plc = ServedPlc::control();
  MessageLog log;
  Tasks tasks;
  EXPECT_EQ(listen(tasks, log, plc.monitor(), std::make_shared<Outlet>(), 7),
            Error::FunctionNotAvailable);
  EXPECT_FALSE(alarmsOf(plc.plc()));
}

}  // namespace
}  // namespace merker::served
