// Messages: who listens, acknowledgement, lock, query; and what indications look like.
#include "s7comm/messages.h"

#include <gtest/gtest.h>

#include "line.h"

namespace merker::s7comm {
namespace {

constexpr std::string_view kAnswered = "32 07 00 00 05 00 00 0C 00 ";

const AlarmState kAlarm{.number = 0x01020304,
                        .waits = true,
                        .signal = true,
                        .acknowledged = false,
                        .coming = {0x24, 0x12, 0x31, 0x23, 0x59, 0x59, 0x12, 0x33},
                        .going = {},
                        .comingValue = {0xAB, 0xCD, 0xEF},
                        .goingValue = {}};

std::string answered(std::string_view length, std::string_view subfunction, std::string_view rest) {
  return std::string(kAnswered) + std::string(length) + " 00 01 12 08 12 84 " +
         std::string(subfunction) + " " + std::string(rest);
}

TEST(Messages, whoListensSaysToWhat) {
  Line line;
  EXPECT_EQ(line.say("32 07 00 00 05 00 00 08 00 0E 00 01 12 04 11 44 02 00 FF 09 00 0A "
                     "07 00 4D 65 72 6B 65 72 20 20"),
            answered("06", "02", "01 00 00 00 00 FF 09 00 02 00 00"));
  EXPECT_EQ(line.plc.listened, kModes | kSystemEvents | kUserEvents);
  const std::string_view alarms =
      "32 07 00 00 05 00 00 08 00 10 00 01 12 04 11 44 02 00 FF 09 00 0C "
      "82 00 4D 65 72 6B 65 72 20 20 09 00";
  EXPECT_EQ(line.say(alarms), answered("09", "02", "02 00 00 00 00 FF 09 00 05 00 00 09 00 00"));
  EXPECT_EQ(line.plc.listened, kSystemEvents | kAlarms);
  line.say(std::string(alarms).replace(32 * 3, 2, "08"));
  EXPECT_EQ(line.plc.listened, kSystemEvents);
  EXPECT_EQ(line.say("32 07 00 00 05 00 00 08 00 06 00 01 12 04 11 44 02 00 FF 09 00 02 07 00"),
            answered("04", "02", "00 00 00 D4 05 0A 00 00 00"));
}

TEST(Messages, acknowledged) {
  Line line;
  line.plc.alarmList = {kAlarm};
  EXPECT_EQ(line.say("32 07 00 00 05 00 00 08 00 1A 00 01 12 04 11 44 0B 00 FF 09 00 16 09 02 "
                     "12 08 19 00 01 02 03 04 00 01 12 08 19 00 00 00 00 07 00 01"),
            answered("08", "0B", "01 00 00 00 00 FF 09 00 04 09 02 FF 0A"));
  const auto refused = answered("04", "0B", "00 00 00 D4 05 0A 00 00 00");
  const std::string head = "32 07 00 00 05 00 00 08 00 10 00 01 12 04 11 44 0B 00 FF 09 00 0C 09 ";
  EXPECT_EQ(line.say(head + "02 12 08 19 00 01 02 03 04 00 01"), refused);  // one is missing
  EXPECT_EQ(line.say(head + "01 12 08 16 00 01 02 03 04 00 01"), refused);  // other syntax
  EXPECT_EQ(line.say(head + "01 12 04 19 00 01 02 03 04 00 01"), refused);  // no number
  EXPECT_EQ(line.say(head + "00 12 08 19 00 01 02 03 04 00 01"), refused);
}

TEST(Messages, lockedAndUnlocked) {
  Line line;
  std::string lock =
      "32 07 00 00 05 00 00 08 00 0E 00 01 12 04 11 44 07 00 FF 09 00 0A 08 01 "
      "12 06 15 00 00 00 00 07";
  EXPECT_EQ(line.say(lock), answered("07", "07", "01 00 00 00 00 FF 09 00 03 08 01 FF"));
  EXPECT_TRUE(line.plc.locked_.at(7));
  line.say(lock.replace(16 * 3, 2, "08"));
  EXPECT_FALSE(line.plc.locked_.at(7));
}

// ALARM_S, then by number; one message a PDU and an end.
TEST(Messages, query) {
  Line line;
  const std::string query =
      "32 07 00 00 05 00 00 08 00 10 00 01 12 04 11 44 13 00 FF 09 00 0C 00 01 "
      "12 08 1A 00 01 34 00 00 00 04";
  EXPECT_EQ(line.say(query), answered("0A", "13", "01 00 00 00 00 FF 09 00 06 00 01 0A 00 00 00"));
  line.plc.alarmList = {kAlarm, kAlarm};
  line.plc.alarmList[1].number = 9;
  const std::string record =
      "26 00 00 04 01 02 03 04 00 01 01 00 24 12 31 23 59 59 12 33 FF 09 00 03 "
      "AB CD EF 00 00 00 00 00 00 00 00 0A 00 00 00";
  EXPECT_EQ(line.say(query),
            answered("31", "13", "02 02 01 00 00 FF 09 00 2D 00 01 FF 09 FF FF " + record));
  const auto more = [&](std::string_view sequence) {
    return line.say("32 07 00 00 05 00 00 0C 00 04 00 01 12 08 12 44 13 " + std::string(sequence) +
                    " 00 00 00 00 0A 00 00 00");
  };
  EXPECT_TRUE(more("02").starts_with(
      answered("2B", "13", "02 02 01 00 00 FF 09 00 27 26 00 00 04 00 00 00 09")));
  EXPECT_EQ(more("02"), answered("06", "13", "02 02 00 00 00 FF 09 00 02 00 00"));
  std::string one = query;
  one.replace(28 * 3, 2, "03").replace(33 * 3, 2, "09");
  EXPECT_TRUE(line.say(one).ends_with("AB CD EF 00 00 00 00 00 00 00 00 0A 00 00 00"));
  EXPECT_EQ(more("03"), answered("06", "13", "03 03 00 00 00 FF 09 00 02 00 00"));
}

std::string written(const Indication& one) {
  return std::to_string(one.group) + "/" + std::to_string(one.subfunction) + ": " +
         toHex(one.octets);
}

TEST(Messages, indications) {
  EXPECT_EQ(written(alarmIndication(kAlarm)),
            "4/17: 24 12 31 23 59 59 12 33 00 01 12 0A 16 01 01 02 03 04 01 00 01 00 "
            "FF 09 00 03 AB CD EF");
  AlarmState gone = kAlarm;
  gone.waits = gone.signal = false, gone.acknowledged = true;
  gone.going = {0x25};
  EXPECT_EQ(written(alarmIndication(gone)),
            "4/18: 25 00 00 00 00 00 00 00 00 01 12 0A 16 00 01 02 03 04 00 00 01 01");
  EXPECT_EQ(written(acknowledgementIndication(gone, {0x26})),
            "4/12: 26 00 00 00 00 00 00 00 00 01 12 08 19 00 01 02 03 04 01 01");
  EXPECT_EQ(written(diagnosticIndication(Bytes{1, 2})), "4/3: 01 02");
  EXPECT_EQ(written(modeIndication(ModeCode::Hold)), "0/4: ");
}

}  // namespace
}  // namespace merker::s7comm
