#include <gtest/gtest.h>

#include "line.h"

namespace merker::s7comm {
namespace {

TEST(Variables, aWordOfFlags) {
  Line line;
  line.plc.memory[{Memory::Flag, 0}][10] = 0x12;
  line.plc.memory[{Memory::Flag, 0}][11] = 0x34;
  EXPECT_EQ(line.say("32 01 00 00 00 02 00 0E 00 00 04 01 12 0A 10 04 00 01 00 00 83 00 00 50"),
            "32 03 00 00 00 02 00 02 00 06 00 00 04 01 FF 04 00 10 12 34");
}

// Every item but the last has an even number of octets.
TEST(Variables, valuesOfSeveralItems) {
  Line line;
  line.plc.memory[{Memory::Input, 0}][0] = 0x81;
  line.plc.memory[{Memory::Timer, 0}][2] = 0x21;
  EXPECT_EQ(line.say("32 01 00 00 00 03 00 32 00 00 04 04 "
                     "12 0A 10 01 00 01 00 00 81 00 00 07 "
                     "12 0A 10 02 00 01 00 00 81 00 00 00 "
                     "12 0A 10 1D 00 01 00 00 1D 00 00 01 "
                     "12 0A 10 02 00 01 00 00 80 00 00 00"),
            "32 03 00 00 00 03 00 02 00 17 00 00 04 04 FF 03 00 01 01 00 FF 04 00 08 81 00 "
            "FF 09 00 02 21 00 FF 04 00 08 00");
}

// As an S7-300 answers: return code, no size, no length.
TEST(Variables, whatIsNotThereHasACode) {
  Line line;
  EXPECT_EQ(line.say("32 01 00 00 00 02 00 0E 00 00 04 01 12 0A 10 02 00 01 00 07 84 00 00 00"),
            "32 03 00 00 00 02 00 02 00 04 00 00 04 01 0A 00 00 00");
  EXPECT_EQ(line.say("32 01 00 00 00 02 00 0E 00 00 04 01 12 0A 10 02 00 02 00 01 84 00 00 78"),
            "32 03 00 00 00 02 00 02 00 04 00 00 04 01 05 00 00 00");
}

TEST(Variables, theAnswerMustFitThePdu) {
  Line line;
  // 222 octets fill a PDU of 240 (S7-LIM-01); DB 1 is shorter, but that is another matter.
  EXPECT_EQ(line.say("32 01 00 00 00 02 00 0E 00 00 04 01 12 0A 10 02 00 DE 00 01 84 00 00 00"),
            "32 03 00 00 00 02 00 02 00 04 00 00 04 01 05 00 00 00");
  EXPECT_EQ(line.say("32 01 00 00 00 02 00 0E 00 00 04 01 12 0A 10 02 00 DF 00 01 84 00 00 00"),
            "32 03 00 00 00 02 00 02 00 00 85 00 04 00");
}

TEST(Variables, dbReadGivesOneValueOfAllItsAreas) {
  Line line;
  line.plc.memory[{Memory::DataBlock, 1}] = hex("00 01 02 03 04 05 06 07 08 09 0A 0B 0C 0D 0E 0F");
  EXPECT_EQ(
      line.say("32 01 00 00 00 02 00 10 00 00 04 01 12 0C B0 02 02 00 01 00 01 01 00 01 00 0F"),
      "32 03 00 00 00 02 00 02 00 07 00 00 04 01 FF 04 00 18 01 02 0F");
  EXPECT_EQ(
      line.say("32 01 00 00 00 02 00 10 00 00 04 01 12 0C B0 02 02 00 01 00 01 01 00 02 00 0F"),
      "32 03 00 00 00 02 00 02 00 04 00 00 04 01 0A 00 00 00");
}

TEST(Variables, writtenBitsLeaveTheirNeighbours) {
  Line line;
  line.plc.memory[{Memory::Output, 0}][1] = 0xF0;
  EXPECT_EQ(line.say("32 01 00 00 00 02 00 0E 00 05 05 01 12 0A 10 01 00 01 00 00 82 00 00 09 "
                     "00 03 00 01 01"),
            "32 03 00 00 00 02 00 02 00 01 00 00 05 01 FF");
  EXPECT_EQ(line.plc.memory[(FewBytes::Key{Memory::Output, 0})][1], 0xF2);
}

TEST(Variables, eachWrittenItemHasItsCode) {
  Line line;
  EXPECT_EQ(line.say("32 01 00 00 00 02 00 32 00 17 05 04 "
                     "12 0A 10 02 00 01 00 00 83 00 00 00 "  // MB 0
                     "12 0A 10 04 00 01 00 07 84 00 00 00 "  // DB 7
                     "12 0A 10 04 00 01 00 00 83 00 00 08 "  // MW 1 with one octet
                     "12 0A 10 02 00 01 00 00 83 00 00 18 "  // MB 3
                     "00 04 00 08 AA 00 00 04 00 10 11 22 00 04 00 08 BB 00 00 04 00 08 CC"),
            "32 03 00 00 00 02 00 02 00 04 00 00 05 04 FF 0A 07 FF");
  EXPECT_EQ(toHex(View(line.plc.memory[(FewBytes::Key{Memory::Flag, 0})]).first(4)), "AA 00 00 CC");
}

TEST(Variables, aValueThatIsCutOffWritesNothing) {
  Line line;
  EXPECT_EQ(line.say("32 01 00 00 00 02 00 1A 00 09 05 02 "
                     "12 0A 10 02 00 01 00 00 83 00 00 00 12 0A 10 04 00 01 00 00 83 00 00 08 "
                     "00 04 00 08 AA 00 00 04 00"),
            "32 03 00 00 00 02 00 02 00 00 85 00 05 00");
  EXPECT_EQ(line.plc.memory[(FewBytes::Key{Memory::Flag, 0})][0], 0);
}

}  // namespace
}  // namespace merker::s7comm
