// Jobs that the PLC carries out later.
#include <gtest/gtest.h>

#include "line.h"

namespace merker::s7comm {
namespace {

constexpr std::string_view kRead =
    "32 01 00 00 00 02 00 0E 00 00 04 01 12 0A 10 02 00 01 00 00 83 00 00 00";
constexpr std::string_view kValue = "32 03 00 00 00 02 00 02 00 05 00 00 04 01 FF 04 00 08 ";

Bytes write(std::uint8_t reference, std::uint8_t value) {
  Bytes pdu =
      hex("32 01 00 00 00 00 00 0E 00 05 05 01 12 0A 10 02 00 01 00 00 83 00 00 00 00 04 00 08 00");
  pdu[5] = reference;
  pdu.back() = value;
  return pdu;
}

TEST(Order, aReadSeesTheWritesBeforeIt) {
  Line line;
  line.plc.later = true;
  EXPECT_EQ(line.say(write(1, 0x55)), "");
  EXPECT_FALSE(line.session->busy());
  EXPECT_EQ(line.say(kRead), "");
  EXPECT_TRUE(line.session->busy());
  line.plc.carryOutAll();  // the write; now the read begins
  EXPECT_EQ(line.heard(), "32 03 00 00 00 01 00 02 00 01 00 00 05 01 FF");
  line.plc.carryOutAll();
  EXPECT_EQ(line.heard(), std::string(kValue) + "55");
  EXPECT_FALSE(line.session->busy());
}

TEST(Order, aRefusalWaitsForItsTurn) {
  Line line;
  line.plc.later = true;
  EXPECT_EQ(line.say(write(1, 0x55)), "");
  EXPECT_EQ(line.say("32 01 00 00 00 02 00 01 00 00 99"), "");
  line.plc.carryOutAll();
  EXPECT_EQ(line.heard(),
            "32 03 00 00 00 01 00 02 00 01 00 00 05 01 FF | 32 02 00 00 00 02 00 00 00 00 81 04");
}

TEST(Order, writesGoTogether) {
  Line line;
  line.plc.later = true;
  line.say(write(1, 1));
  line.say(write(2, 2));
  EXPECT_EQ(line.plc.waiting.size(), 2u);
  line.plc.carryOutAll();
  EXPECT_EQ(line.heard(),
            "32 03 00 00 00 01 00 02 00 01 00 00 05 01 FF | 32 03 00 00 00 02 00 02 00 01 00 00 05 "
            "01 FF");
}

TEST(Order, noMoreJobsThanAgreed) {
  Line line;  // 8
  line.plc.later = true;
  bool ready = false;
  line.session->whenReady([&] { ready = true; });
  for (std::uint8_t i = 0; i < 8; ++i) {
    EXPECT_FALSE(line.session->busy());
    line.say(write(i, i));
  }
  EXPECT_TRUE(line.session->busy());
  EXPECT_FALSE(ready);
  line.plc.carryOutAll();
  EXPECT_FALSE(line.session->busy());
  EXPECT_TRUE(ready);
}

TEST(Order, anAnswerMayComeWhenNobodyIsThere) {
  FewBytes plc;
  plc.later = true;
  int answers = 0;
  auto session = std::make_shared<Session>(plc, [&](const Bytes&) { ++answers; });
  session->receive(hex("32 01 00 00 00 01 00 08 00 00 F0 00 00 08 00 08 01 E0"));
  session->receive(write(1, 1));
  session.reset();
  plc.carryOutAll();
  EXPECT_EQ(answers, 2);
}

}  // namespace
}  // namespace merker::s7comm
