// Services of programming devices: SZL, clock, restarts and stop.
#include <gtest/gtest.h>

#include "line.h"

namespace merker::s7comm {
namespace {

constexpr std::string_view kSzl =
    "32 07 00 00 05 00 00 08 00 08 00 01 12 04 11 44 01 00 FF 09 00 04 00 11 00 07";
constexpr std::string_view kMore =
    "32 07 00 00 05 00 00 0C 00 04 00 01 12 08 12 44 01 01 00 00 00 00 0A 00 00 00";

constexpr std::string_view kNothingLeft =
    "32 07 00 00 05 00 00 0C 00 04 00 01 12 08 12 84 01 01 00 00 00 00 0A 00 00 00";

TEST(Userdata, aListHasItsHeadAndItsRecords) {
  EXPECT_EQ(Line().say(kSzl),
            "32 07 00 00 05 00 00 0C 00 14 00 01 12 08 12 84 01 01 00 00 00 00 "
            "FF 09 00 10 00 11 00 07 00 04 00 02 07 07 07 07 07 07 07 07");
}

TEST(Userdata, aListThatIsNotThereIsRefused) {
  EXPECT_EQ(
      Line().say("32 07 00 00 05 00 00 08 00 08 00 01 12 04 11 44 01 00 FF 09 00 04 0F 99 00 00"),
      "32 07 00 00 05 00 00 0C 00 04 00 01 12 08 12 84 01 00 00 00 D4 01 0A 00 00 00");
  EXPECT_EQ(Line().say("32 07 00 00 05 00 00 08 00 06 00 01 12 04 11 44 01 00 FF 09 00 02 00 11"),
            "32 07 00 00 05 00 00 0C 00 04 00 01 12 08 12 84 01 00 00 00 85 00 0A 00 00 00");
}

// 8 octets of head and 500 of records, 214 in a PDU.
TEST(Userdata, aLongListComesInParts) {
  Line line;
  line.plc.listOctets = 500;
  const std::string first = line.say(kSzl), second = line.say(kMore), third = line.say(kMore);
  EXPECT_EQ(first.size(), 240u * 3 - 1);
  EXPECT_TRUE(first.starts_with(
      "32 07 00 00 05 00 00 0C 00 DA 00 01 12 08 12 84 01 01 01 01 00 00 FF 09 00 D6 00 11"));
  EXPECT_TRUE(second.starts_with(
      "32 07 00 00 05 00 00 0C 00 DA 00 01 12 08 12 84 01 01 01 01 00 00 FF 09 00 D6 07"));
  EXPECT_TRUE(third.starts_with(
      "32 07 00 00 05 00 00 0C 00 54 00 01 12 08 12 84 01 01 01 00 00 00 FF 09 00 50 07"));
  EXPECT_EQ(line.say(kMore), kNothingLeft);
}

// As many as a client may have jobs.
TEST(Userdata, partsOfSeveralAnswers) {
  Line line;
  line.plc.listOctets = 500;
  for (std::size_t i = 0; i < Rests::kMost; ++i) line.say(kSzl);
  const std::string second = line.say(kMore);
  EXPECT_TRUE(second.starts_with(
      "32 07 00 00 05 00 00 0C 00 DA 00 01 12 08 12 84 01 01 01 01 00 00 FF 09 00 D6 07"));
  line.say(kSzl);
  EXPECT_EQ(line.say(kMore),
            "32 07 00 00 05 00 00 0C 00 04 00 01 12 08 12 84 01 01 00 00 D4 02 0A 00 00 00");
}

// A recorded conversation asks for more of an answer that is shorter here.
TEST(Userdata, nothingIsLeftOfAWholeAnswer) {
  Line line;
  line.say(kSzl);
  EXPECT_EQ(line.say(kMore), kNothingLeft);
  EXPECT_EQ(Line().say(kMore), kNothingLeft);
}

TEST(Userdata, theClockIsReadAndSet) {
  Line line;
  EXPECT_EQ(line.say("32 07 00 00 01 00 00 08 00 04 00 01 12 04 11 47 01 00 0A 00 00 00"),
            "32 07 00 00 01 00 00 0C 00 0E 00 01 12 08 12 87 01 01 00 00 00 00 "
            "FF 09 00 0A 00 19 05 09 01 08 00 00 00 05");
  EXPECT_EQ(line.say("32 07 00 00 02 00 00 08 00 0E 00 01 12 04 11 47 02 00 "
                     "FF 09 00 0A 00 19 24 12 31 23 59 59 99 93"),
            "32 07 00 00 02 00 00 0C 00 04 00 01 12 08 12 87 02 00 00 00 00 00 0A 00 00 00");
  EXPECT_EQ(line.plc.time, (ClockTime{0x24, 0x12, 0x31, 0x23, 0x59, 0x59, 0x99, 0x93}));
  EXPECT_EQ(line.say("32 07 00 00 02 00 00 08 00 0E 00 01 12 04 11 47 02 00 "
                     "FF 09 00 0A 00 19 24 13 31 23 59 59 99 93"),
            "32 07 00 00 02 00 00 0C 00 04 00 01 12 08 12 87 02 00 00 00 DC 01 0A 00 00 00");
  line.plc.time.reset();
  EXPECT_EQ(line.say("32 07 00 00 01 00 00 08 00 04 00 01 12 04 11 47 01 00 0A 00 00 00"),
            "32 07 00 00 01 00 00 0C 00 04 00 01 12 08 12 87 01 00 00 00 81 04 0A 00 00 00");
}

TEST(Userdata, anAnswerThatComesLater) {
  Line line;
  line.plc.later = true;
  EXPECT_EQ(line.say(kSzl), "");
  line.plc.carryOutAll();
  EXPECT_TRUE(line.heard().starts_with("32 07 00 00 05 00"));
}

constexpr std::string_view kStop =
    "32 01 00 00 00 02 00 10 00 00 29 00 00 00 00 00 09 50 5F 50 52 4F 47 52 41 4D";
constexpr std::string_view kWarm =
    "32 01 00 00 00 02 00 14 00 00 28 00 00 00 00 00 00 FD 00 00 09 50 5F 50 52 4F 47 52 41 4D";

TEST(Control, stopAndRestart) {
  Line line;
  EXPECT_EQ(line.say(kStop), "32 03 00 00 00 02 00 01 00 00 00 00 29");
  EXPECT_FALSE(line.plc.runs);
  EXPECT_EQ(line.say(kStop), "32 03 00 00 00 02 00 02 00 00 84 02 29 07");
  EXPECT_EQ(line.say(kWarm), "32 03 00 00 00 02 00 01 00 00 00 00 28");
  EXPECT_EQ(line.say(kWarm), "32 03 00 00 00 02 00 02 00 00 84 02 28 03");
  EXPECT_EQ(line.say("32 01 00 00 00 02 00 16 00 00 28 00 00 00 00 00 00 FD 00 02 43 20 "
                     "09 50 5F 50 52 4F 47 52 41 4D"),
            "32 03 00 00 00 02 00 02 00 00 84 04 28 02");
}

TEST(Control, otherNamesAndLengthsAreRefused) {
  EXPECT_EQ(
      Line().say("32 01 00 00 00 02 00 10 00 00 28 00 00 00 00 00 00 FD 00 00 05 5F 47 41 52 43"),
      "32 02 00 00 00 02 00 00 00 00 81 04");  // _GARC
  EXPECT_EQ(Line().say("32 01 00 00 00 02 00 0A 00 00 28 00 00 00 00 00 00 FD 00 09"),
            "32 02 00 00 00 02 00 00 00 00 85 00");
  EXPECT_EQ(Line().say("32 01 00 00 00 02 00 06 00 00 29 00 00 00 00 00"),
            "32 02 00 00 00 02 00 00 00 00 85 00");
  EXPECT_EQ(Line().say("32 01 00 00 00 02 00 08 00 00 29 00 00 00 00 00 09 50"),
            "32 02 00 00 00 02 00 00 00 00 81 04");
}

}  // namespace
}  // namespace merker::s7comm
