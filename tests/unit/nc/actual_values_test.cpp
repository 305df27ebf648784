// FB 56 VORSCHUB, FB 57 SCHLEPPA, FB 58 SPINDIST, FB 65 M STACK, FB 66 STACK M.
#include "rig.h"

namespace merker::nc {
namespace {

std::string call(unsigned order, unsigned macro) {
  char text[80];
  std::snprintf(text, sizeof text, "OB 1\n:L KH %04X\n:T MB 224\n:SPA FB %u\n:BE\n", order, macro);
  return text;
}
// What MW 225 and MW 227 hold, or why the PLC stopped.
std::string answer(unsigned order, unsigned macro, const Control& control) {
  Rig rig;
  rig.macros.control() = control;
  EXPECT_TRUE(rig.start(call(order, macro)));
  rig.cycles(1);
  if (rig.stopped()) return rig.stop();
  char text[20];
  std::snprintf(text, sizeof text, "%04X %04X", rig.flagWord(225), rig.flagWord(227));
  return text;
}

// S5-FM-12, S5-FM-16: the manual's example, feed 1425.67 of the first axis.
TEST(ActualValues, FeedOfTheManual) {
  Control control;
  control.axes[0].feed[0] = {142567, 2};
  EXPECT_EQ(answer(0x10, 56, control), "675E 4201");
  control.axes[0].feed[0] = {1500, 0};
  EXPECT_EQ(answer(0x10, 56, control), "0E50 0100");
  control.axes[0].feed[0] = {12345678, 4};  // seven digits find room
  EXPECT_EQ(answer(0x10, 56, control), "67E5 3412");
}

// S5-FM-13, S5-FM-14, S5-FM-15: every value of MB 224.
TEST(ActualValues, FeedOrders) {
  Control control;
  for (std::uint8_t i = 0; i < kAxes; ++i)
    for (std::uint8_t type = 0; type < kFeedTypes; ++type)
      control.axes[i].feed[type] = {10 * (i + 1) + type, 0};
  control.axes[4].channel = 2;
  for (std::uint8_t type = 0; type < kFeedTypes; ++type)
    for (std::uint8_t i = 0; i < kChannels; ++i)
      control.channels[i].pathFeed[type] = {100 * (i + 1) + type, 0};
  Rig rig;
  rig.macros.control() = control;
  for (unsigned order = 0; order < 256; ++order) {
    const unsigned axis = order >> 4, type = order >> 2 & 3, channel = order & 3;
    ASSERT_TRUE(rig.start(call(order, 56)));
    rig.cycles(1);
    const bool wrong = type == 3 || channel == 3 || (axis == 0 && channel == 0);
    ASSERT_EQ(rig.stop(), axis > 5 ? "56/2" : wrong ? "56/1" : "") << order;
    if (rig.stopped()) continue;
    const bool elsewhere = axis > 0 && channel > 0 && channel != (axis == 5 ? 2u : 1u);
    const unsigned feed = axis == 0 ? 100 * channel + type : elsewhere ? 0 : 10 * axis + type;
    const auto nibbles =
        static_cast<unsigned>(feed / 100 << 12 | feed / 10 % 10 << 8 | feed % 10 << 4 | 0xE);
    EXPECT_EQ(rig.flagWord(225), (nibbles & 0xFF) << 8 | nibbles >> 8) << order;
  }
}

// S5-FM-17: 32 bits, the low word first.
TEST(ActualValues, FollowingError) {
  Control control;
  control.axes[0].followingError = 100'000;
  control.axes[4].followingError = -2;
  EXPECT_EQ(answer(1, 57, control), "86A0 0001");
  EXPECT_EQ(answer(5, 57, control), "FFFE FFFF");
  for (const unsigned order : {0u, 6u, 7u, 255u}) EXPECT_EQ(answer(order, 57, control), "57/1");
}

// S5-FM-18
TEST(ActualValues, SpindleSpeed) {
  Control control;
  control.spindleSpeed = {100'000, 1500};
  EXPECT_EQ(answer(1, 58, control), "86A0 0001");
  EXPECT_EQ(answer(2, 58, control), "05DC 0000");
  for (const unsigned order : {0u, 3u, 255u}) EXPECT_EQ(answer(order, 58, control), "58/1");
}

// S5-FM-02: other controls do not have FB 56 … 58; options that nobody described are no macros.
TEST(ActualValues, OnlyOnSomeControls) {
  MacroOptions without;
  without.actualValueMacros = false;
  Rig rig(without);
  ASSERT_TRUE(rig.start(call(1, 57)));
  rig.cycles(1);
  EXPECT_EQ(rig.stop(), "6105");
  std::vector<std::uint16_t> there;
  const FunctionMacros all;
  for (std::uint16_t number = 0; number < 256; ++number)
    if (all.has(number)) there.push_back(number);
  EXPECT_EQ(there, (std::vector<std::uint16_t>{11, 56, 57, 58, 60, 61, 62, 65, 66, 190}));
  Rig option;
  ASSERT_TRUE(option.start("OB 1\n:SPA PB 5\n:BE\nPB 5\n:BE\n"));
  mc5::Block calls;  // which the compiler refuses to write
  calls.id = {mc5::BlockType::Pb, 5};
  calls.words = {0x3D50, 0x6500};  // SPA FB 80, BE
  EXPECT_EQ(option.plc->programmer().load(calls), "");
  option.cycles(1);
  EXPECT_EQ(option.stop(), "6105");
}

std::string stackTest(unsigned saves, unsigned restores) {
  std::string text = "OB 1\n";
  for (unsigned i = 0; i < saves; ++i)
    text += ":L KB " + std::to_string(i + 1) + "\n:T MW 254\n:T MW 224\n:SPA FB 65\n";
  text += ":L KH FFFF\n:T MW 254\n:T MW 224\n:T MW 222\n";
  for (unsigned i = 0; i < restores; ++i) text += ":SPA FB 66\n";
  return text + ":BE\n";
}

// S5-FM-48: last in, first out; MB 224 … 255 and no more.
TEST(FlagStack, SavesTransferFlags) {
  Rig rig;
  ASSERT_TRUE(rig.start(stackTest(4, 4)));
  rig.cycles(1);
  EXPECT_EQ(rig.stop(), "");
  EXPECT_EQ(rig.flagWord(224), 1u);
  EXPECT_EQ(rig.flagWord(254), 1u);
  EXPECT_EQ(rig.flagWord(222), 0xFFFFu);
  ASSERT_TRUE(rig.start(stackTest(3, 1)));
  rig.cycles(1);
  EXPECT_EQ(rig.flagWord(254), 3u);
}

// S5-FM-49, S5-FM-05; a start empties the stack.
TEST(FlagStack, Errors) {
  Rig rig;
  ASSERT_TRUE(rig.start(stackTest(0, 1)));
  rig.cycles(1);
  EXPECT_EQ(rig.stop(), "66/1");
  ASSERT_TRUE(rig.start(stackTest(5, 0)));
  rig.cycles(1);
  EXPECT_EQ(rig.stop(), "65/1");
  ASSERT_TRUE(rig.start(stackTest(4, 0)));
  rig.cycles(1);
  EXPECT_EQ(rig.stop(), "");
  ASSERT_TRUE(rig.start(stackTest(0, 1)));
  rig.cycles(1);
  EXPECT_EQ(rig.stop(), "66/1");
}

}  // namespace
}  // namespace merker::nc
