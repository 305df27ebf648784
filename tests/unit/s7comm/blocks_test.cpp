// Directory, information and upload of blocks.
#include <gtest/gtest.h>

#include "line.h"

namespace merker::s7comm {
namespace {

constexpr std::string_view kListDb =
    "32 07 00 00 05 00 00 08 00 06 00 01 12 04 11 43 02 00 FF 09 00 02 30 41";

TEST(Blocks, countsOfEachType) {
  EXPECT_EQ(Line().say("32 07 00 00 05 00 00 08 00 04 00 01 12 04 11 43 01 00 0A 00 00 00"),
            "32 07 00 00 05 00 00 0C 00 20 00 01 12 08 12 83 01 01 00 00 00 00 FF 09 00 1C "
            "30 38 00 01 30 45 00 00 30 43 00 00 30 41 00 02 30 42 00 00 30 44 00 00 30 46 00 00");
}

TEST(Blocks, aListOfOneType) {
  EXPECT_EQ(Line().say(kListDb),
            "32 07 00 00 05 00 00 0C 00 0C 00 01 12 08 12 83 02 01 00 00 00 00 FF 09 00 08 "
            "00 01 22 05 00 02 22 05");
  EXPECT_EQ(Line().say("32 07 00 00 05 00 00 08 00 06 00 01 12 04 11 43 02 00 FF 09 00 02 30 45"),
            "32 07 00 00 05 00 00 0C 00 04 00 01 12 08 12 83 02 00 00 00 D2 0E 0A 00 00 00");
}

// 60 entries of 4 octets: 53 and 7, none of them cut.
TEST(Blocks, aLongListIsCutBetweenEntries) {
  Line line;
  line.plc.dataBlocks = 60;
  EXPECT_TRUE(line.say(kListDb).starts_with(
      "32 07 00 00 05 00 00 0C 00 D8 00 01 12 08 12 83 02 01 01 01 00 00 FF 09 00 D4 00 01"));
  EXPECT_TRUE(
      line.say("32 07 00 00 05 00 00 0C 00 04 00 01 12 08 12 43 02 01 00 00 00 00 0A 00 00 00")
          .starts_with("32 07 00 00 05 00 00 0C 00 20 00 01 12 08 12 83 02 01 01 00 00 00 "
                       "FF 09 00 1C 00 36 22 05"));
}

TEST(Blocks, informationIsHeadAndEndOfTheContainer) {
  const std::string answer = Line().say(
      "32 07 00 00 05 00 00 08 00 0C 00 01 12 04 11 43 03 00 FF 09 00 08 30 38 30 30 30 30 31 41");
  EXPECT_TRUE(
      answer.starts_with("32 07 00 00 05 00 00 0C 00 52 00 01 12 08 12 83 03 01 00 00 00 00 "
                         "FF 09 00 4E 01 00 00 4A 22 00 AA AA"));
  EXPECT_TRUE(
      answer.ends_with("AA EE EE EE EE EE EE EE EE EE EE EE EE EE EE EE EE EE EE EE EE EE EE EE EE "
                       "EE EE EE EE EE EE EE EE EE EE EE EE"));
  EXPECT_EQ(Line().say("32 07 00 00 05 00 00 08 00 0C 00 01 12 04 11 43 03 00 "
                       "FF 09 00 08 30 38 30 30 30 30 32 41"),
            "32 07 00 00 05 00 00 0C 00 04 00 01 12 08 12 83 03 00 00 00 D2 09 0A 00 00 00");
}

constexpr std::string_view kStart =
    "32 01 00 00 00 02 00 12 00 00 1D 00 00 00 00 00 00 00 09 5F 30 38 30 30 30 30 31 41";
constexpr std::string_view kNext = "32 01 00 00 00 03 00 08 00 00 1E 00 00 00 00 00 00 01";
constexpr std::string_view kEndUpload = "32 01 00 00 00 04 00 08 00 00 1F 00 00 00 00 00 00 01";
constexpr std::string_view kUploadRefused = "32 02 00 00 00 03 00 00 00 00 84 04";

// 372 octets: 222 and 150.
TEST(Upload, aBlockComesInPieces) {
  Line line;
  EXPECT_EQ(line.say(kStart),
            "32 03 00 00 00 02 00 10 00 00 00 00 1D 00 01 00 00 00 00 01 07 30 30 30 30 33 37 32");
  EXPECT_TRUE(
      line.say(kNext).starts_with("32 03 00 00 00 03 00 02 00 E2 00 00 1E 01 00 DE 00 FB AA"));
  const std::string last = line.say(kNext);
  EXPECT_TRUE(last.starts_with("32 03 00 00 00 03 00 02 00 9A 00 00 1E 00 00 96 00 FB CC"));
  EXPECT_TRUE(
      last.ends_with("CC EE EE EE EE EE EE EE EE EE EE EE EE EE EE EE EE EE EE EE EE EE EE EE EE "
                     "EE EE EE EE EE EE EE EE EE EE EE EE"));
  EXPECT_EQ(line.say(kNext), "32 03 00 00 00 03 00 02 00 04 00 00 1E 00 00 00 00 FB");
  EXPECT_EQ(line.say(kEndUpload), "32 03 00 00 00 04 00 01 00 00 00 00 1F");
  EXPECT_EQ(line.say(kNext), kUploadRefused);
}

// A connection has one upload; a recorded conversation has the number that another CPU gave.
TEST(Upload, itsNumberIsToldAndNotLookedAt) {
  Line line;
  line.say(kStart);
  EXPECT_TRUE(line.say("32 01 00 00 00 03 00 08 00 00 1E 00 00 00 00 00 00 09")
                  .starts_with("32 03 00 00 00 03 00 02 00 E2 00 00 1E 01 00 DE 00 FB AA"));
  EXPECT_EQ(line.say("32 01 00 00 00 04 00 08 00 00 1F 00 00 00 00 00 00 09"),
            "32 03 00 00 00 04 00 01 00 00 00 00 1F");
}

// "$" in place of "_".
TEST(Upload, aHeadAlone) {
  Line line;
  EXPECT_EQ(
      line.say(
          "32 01 00 00 00 02 00 12 00 00 1D 00 00 00 00 00 00 00 09 24 30 38 30 30 30 30 31 41"),
      "32 03 00 00 00 02 00 10 00 00 00 00 1D 00 01 00 00 00 00 01 07 30 30 30 30 30 33 36");
  const std::string only = line.say(kNext);
  EXPECT_TRUE(only.starts_with("32 03 00 00 00 03 00 02 00 28 00 00 1E 00 00 24 00 FB AA"));
  EXPECT_TRUE(only.ends_with("AA AA AA"));
  EXPECT_EQ(
      line.say(
          "32 01 00 00 00 02 00 12 00 00 1D 00 00 00 00 00 00 00 09 24 30 41 30 30 30 30 31 41"),
      "32 02 00 00 00 02 00 00 00 00 D2 09");
}

TEST(Upload, whatIsNotThereOrNotAllowedIsRefused) {
  Line line;
  EXPECT_EQ(line.say(kNext), kUploadRefused);
  EXPECT_EQ(
      line.say(
          "32 01 00 00 00 02 00 12 00 00 1D 00 00 00 00 00 00 00 09 5F 30 41 30 30 30 30 31 41"),
      "32 02 00 00 00 02 00 00 00 00 D2 09");
  EXPECT_EQ(line.say(kNext), kUploadRefused);
  EXPECT_EQ(
      line.say(
          "32 01 00 00 00 02 00 12 00 00 1D 00 00 00 00 00 00 00 09 5F 30 38 30 30 2F 30 31 41"),
      "32 02 00 00 00 02 00 00 00 00 D2 01");
  line.plc.locked = true;
  EXPECT_EQ(line.say(kStart), "32 02 00 00 00 02 00 00 00 00 D2 41");
  EXPECT_EQ(line.say(kNext), kUploadRefused);
}

}  // namespace
}  // namespace merker::s7comm
