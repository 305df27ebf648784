// Cyclic reads: subscribe, on change, modify, unsubscribe.
#include <gtest/gtest.h>

#include "line.h"

namespace merker::s7comm {
namespace {

// MW 2 and DB 1 byte 0, each 200 ms.
constexpr std::string_view kTwoItems =
    "32 07 00 00 05 00 00 08 00 20 00 01 12 04 11 42 01 00 FF 09 00 1C 00 02 00 02 "
    "12 0A 10 04 00 01 00 00 83 00 00 10 12 0A 10 02 00 01 00 01 84 00 00 00";
constexpr std::string_view kHead = "32 07 00 00 05 00 00 0C 00 ";

std::string withByte(std::string_view pdu, std::size_t at, std::string_view byte) {
  std::string text(pdu);
  return text.replace(at * 3, 2, byte);
}

std::string refusedWith(std::string_view error, std::string_view subfunction = "01") {
  return std::string(kHead) + "04 00 01 12 08 12 82 " + std::string(subfunction) + " 00 00 00 " +
         std::string(error) + " 0A 00 00 00";
}

TEST(Cyclic, theAnswerHasTheJobAndTheFirstValues) {
  Line line;
  line.plc.memory[{Memory::Flag, 0}][2] = 0xAB;
  EXPECT_EQ(line.say(kTwoItems), std::string(kHead) +
                                     "11 00 01 12 08 12 82 01 01 00 00 00 00 FF 09 00 0D 00 02 "
                                     "FF 04 00 10 AB 00 FF 04 00 08 00");
  EXPECT_EQ(line.plc.cyclic[1].milliseconds, 200u);
  EXPECT_FALSE(line.plc.cyclic[1].onChange);
  EXPECT_EQ(line.plc.cyclic[1].subfunction, 1);
}

TEST(Cyclic, anIndicationHasTheSameData) {
  Line line;
  line.say(kTwoItems);
  const CyclicRead& job = line.plc.cyclic[1];
  const auto data = job.data({{ItemCode::Done, {1, 2}}, {ItemCode::Missing, {}}});
  EXPECT_EQ(toHex(data), "00 02 FF 04 00 10 01 02 0A 00 00 00");
}

TEST(Cyclic, onChangeAndModified) {
  Line line;
  EXPECT_TRUE(line.say(withByte(kTwoItems, 16, "05"))
                  .starts_with(std::string(kHead) + "11 00 01 12 08 12 82 05 01"));
  EXPECT_TRUE(line.plc.cyclic[1].onChange);
  const std::string other = withByte(withByte(kTwoItems, 16, "07"), 24, "01");  // seconds
  EXPECT_EQ(line.say(withByte(other, 17, "09")),
            std::string(kHead) + "04 00 01 12 08 12 82 07 09 00 00 D8 02 0A 00 00 00");
  EXPECT_TRUE(line.say(withByte(other, 17, "01"))
                  .starts_with(std::string(kHead) + "11 00 01 12 08 12 82 07 01"));
  EXPECT_EQ(line.plc.cyclic[1].milliseconds, 2000u);
}

TEST(Cyclic, unsubscribe) {
  Line line;
  constexpr std::string_view kEnd =
      "32 07 00 00 05 00 00 08 00 06 00 01 12 04 11 42 04 00 FF 09 00 02 05 01";
  EXPECT_EQ(line.say(kEnd), refusedWith("D8 02", "04"));
  line.say(kTwoItems);
  EXPECT_EQ(line.say(kEnd),
            std::string(kHead) + "04 00 01 12 08 12 82 04 00 00 00 00 00 0A 00 00 00");
  EXPECT_TRUE(line.plc.cyclic.empty());
}

TEST(Cyclic, whatIsWrongIsRefused) {
  Line line;
  EXPECT_EQ(line.say(withByte(kTwoItems, 24, "03")), refusedWith("D8 04"));  // base
  EXPECT_EQ(line.say(withByte(kTwoItems, 25, "00")), refusedWith("D8 04"));  // factor
  EXPECT_EQ(line.say(withByte(kTwoItems, 29, "0D")), refusedWith("D8 01"));  // type
  EXPECT_EQ(line.say(withByte(kTwoItems, 23, "00")), refusedWith("85 00"));  // no item
  EXPECT_EQ(line.say(withByte(kTwoItems, 23, "03")), refusedWith("85 00"));  // one too many
  EXPECT_EQ(line.say(withByte(kTwoItems, 22, "FF")), refusedWith("85 00"));
  EXPECT_EQ(line.say(withByte(kTwoItems, 30, "FF")), refusedWith("D8 01"));  // 65281 words
  EXPECT_EQ(line.say(withByte(kTwoItems, 31, "80")), refusedWith("85 00"));  // 128 words
  EXPECT_TRUE(line.plc.cyclic.empty());
}

// On change the areas of a DBREAD item have their own codes.
TEST(Cyclic, areasOnChange) {
  Line line;
  line.plc.memory[{Memory::DataBlock, 1}][3] = 0x77;
  EXPECT_TRUE(
      line.say("32 07 00 00 05 00 00 08 00 16 00 01 12 04 11 42 05 00 FF 09 00 12 00 01 00 02 "
               "12 0C B0 02 01 00 01 00 03 02 00 01 00 04")
          .ends_with("FF 09 00 0B 00 01 FF 09 00 05 FF 77 FF 00 00"));
  EXPECT_EQ(toHex(line.plc.cyclic[1].data({{ItemCode::Missing, {}}, {ItemCode::Done, {1, 2}}})),
            "00 01 FF 09 00 04 0A FF 01 02");
}

// An item of odd length, DBREAD of one area, has an octet behind it.
TEST(Cyclic, itemsOfOddLength) {
  Line line;
  line.plc.memory[{Memory::DataBlock, 1}][3] = 0x77;
  EXPECT_TRUE(
      line.say("32 07 00 00 05 00 00 08 00 1E 00 01 12 04 11 42 01 00 FF 09 00 1A 00 02 00 02 "
               "12 07 B0 01 01 00 01 00 03 00 12 0A 10 02 00 01 00 01 84 00 00 18")
          .ends_with("FF 04 00 08 77 00 FF 04 00 08 77"));
}

}  // namespace
}  // namespace merker::s7comm
