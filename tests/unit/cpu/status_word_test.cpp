#include "cpu/status_word.h"

#include <gtest/gtest.h>

namespace merker::cpu {
namespace {

// S7-STW-01 … -08, -15: the place of each bit.
TEST(StatusWord, EachBitHasItsPlace) {
  EXPECT_EQ((StatusWord{.er = true}).word(), 0x001);
  EXPECT_EQ((StatusWord{.rlo = true}).word(), 0x002);
  EXPECT_EQ((StatusWord{.sta = true}).word(), 0x004);
  EXPECT_EQ((StatusWord{.orBit = true}).word(), 0x008);
  EXPECT_EQ((StatusWord{.os = true}).word(), 0x010);
  EXPECT_EQ((StatusWord{.ov = true}).word(), 0x020);
  EXPECT_EQ((StatusWord{.cc0 = true}).word(), 0x040);
  EXPECT_EQ((StatusWord{.cc1 = true}).word(), 0x080);
  EXPECT_EQ((StatusWord{.br = true}).word(), 0x100);
}

TEST(StatusWord, WordAndBackIsTheSame) {
  for (std::uint32_t word = 0; word < 0x200; ++word)
    EXPECT_EQ(StatusWord::fromWord(word).word(), word);
  EXPECT_EQ(StatusWord::fromWord(0xFE00).word(), 0);
}

// S7-STW-09
TEST(StatusWord, ConditionCodesFollowTheSign) {
  StatusWord s;
  s.setSign(-3);
  EXPECT_EQ(s.word(), 0x040);
  s.setSign(4);
  EXPECT_EQ(s.word(), 0x080);
  s.setSign(0);
  EXPECT_EQ(s.word(), 0x000);
}

}  // namespace
}  // namespace merker::cpu
