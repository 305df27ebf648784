// The instruction table as a whole: every code belongs to one row, and what is decoded encodes to
// the same words.
#include "mc5/encoding.h"

#include <gtest/gtest.h>

#include <set>

#include "mc5/range.h"

namespace merker::mc5 {
namespace {

constexpr std::uint64_t kFirstWord = 0xFFFF00000000;
constexpr std::uint16_t kSecondWords[] = {0x0000, 0x0107, 0x41FF, 0x8F05, 0xC0A0, 0x6ABC, 0xFFFF};

unsigned rowsFitting(std::uint64_t code) {
  unsigned count = 0;
  for (const Encoding& row : encodings()) count += decodeOperand(row, code) ? 1 : 0;
  return count;
}

// S5-OPC-01, S5-OPC-03
TEST(Encoding, EachFirstWordBeginsOneRowOrIsIllegal) {
  unsigned legal = 0;
  for (std::uint32_t word = 0; word <= 0xFFFF; ++word) {
    // The rows of 783F and of the bit tests differ in their second words only.
    std::set<unsigned> widths;
    std::set<std::uint64_t> masks;
    for (const Encoding& row : encodings()) {
      if (((std::uint64_t{word} << 32 ^ row.bits) & row.mask & kFirstWord) != 0) continue;
      if (row.operand.format == Format::Other && (word & 0xFF) == 0x40) continue;
      widths.insert(row.length);
    }
    EXPECT_LE(widths.size(), 1u) << std::hex << word;
    EXPECT_EQ(!widths.empty(), beginsInstruction(static_cast<std::uint16_t>(word)));
    legal += widths.empty() ? 0 : 1;
    for (const std::uint64_t second : {0x0000u, 0x0107u, 0x41FFu, 0x8F05u, 0xC0A0u, 0xFFFFu})
      EXPECT_LE(rowsFitting(std::uint64_t{word} << 32 | second << 16), 1u) << std::hex << word;
  }
  EXPECT_GT(legal, 30'000u);
  EXPECT_LT(legal, 65'000u);
}

// S5-OPC-02
TEST(Encoding, WhatIsDecodedEncodesToTheSameWords) {
  for (std::uint32_t word = 0; word <= 0xFFFF; ++word)
    for (const std::uint16_t second : kSecondWords) {
      const std::uint16_t code[] = {static_cast<std::uint16_t>(word), second, 0x1234};
      const auto decoded = decode(code);
      if (!decoded) continue;
      std::vector<std::uint16_t> again;
      ASSERT_TRUE(encode(decoded->instruction, again)) << std::hex << word;
      ASSERT_EQ(again, std::vector<std::uint16_t>(code, code + decoded->words)) << std::hex << word;
    }
}

TEST(Encoding, WordsOutsideTheTableAreIllegal) {
  // S5-SHIFT-05, S5-ARITH-09 (OP-37), S5-BLK-05 (OP-45)
  constexpr std::uint16_t kIllegal[] = {0x0800, 0x6401, 0x7401, 0x600D, 0x6009,
                                        0x6D14, 0x4D14, 0x6502, 0xBB01, 0x7001};
  for (const std::uint16_t word : kIllegal) {
    const std::uint16_t code[] = {word, 0, 0};
    EXPECT_FALSE(decode(code).has_value()) << std::hex << word;
  }
}

TEST(Encoding, ACutOffInstructionIsNone) {
  const std::uint16_t code[] = {0x3040};
  EXPECT_TRUE(beginsInstruction(0x3040));
  EXPECT_FALSE(decode(code).has_value());
}

// S5-OPC-04, S5-OPC-06: columns of the printed table.
TEST(Encoding, TimesAreThePrintedOnes) {
  const auto timesOf = [](std::uint16_t word, Variant variant) {
    const std::uint16_t code[] = {word, 0, 0};
    return times(*decode(code)->encoding, variant);
  };
  EXPECT_EQ(timesOf(0x2801, Variant::Cop).longest, Duration{4'400});   // L KB
  EXPECT_EQ(timesOf(0x2801, Variant::Acop).longest, Duration{250});    //
  EXPECT_EQ(timesOf(0x5D05, Variant::Cop).shortest, Duration{300});    // SPB SB
  EXPECT_EQ(timesOf(0x5D05, Variant::Cop).longest, Duration{30'000});  //
  EXPECT_EQ(timesOf(0x3F01, Variant::Acop).longest, Duration{500});    // LW =
  EXPECT_EQ(timesOf(0x7000, Variant::Cop).longest, Duration{0});       // STS
}

// S5-LOAD-01, S5-DB-05, S5-BLK-03, S5-FB-05, S5-SHIFT-01
TEST(Range, LimitsOfOperands) {
  const auto reach = [](std::uint16_t word) {
    const std::uint16_t code[] = {word, 0, 0};
    const auto decoded = decode(code);
    return decoded && inRange(decoded->instruction);
  };
  EXPECT_TRUE(reach(0x527E));   // L EW 126
  EXPECT_FALSE(reach(0x527F));  // L EW 127
  EXPECT_TRUE(reach(0x5AFC));   // L AD 124
  EXPECT_FALSE(reach(0x5AFD));  // L AD 125
  EXPECT_TRUE(reach(0x12FE));   // L MW 254
  EXPECT_FALSE(reach(0x12FF));  // L MW 255
  EXPECT_TRUE(reach(0x3AFE));   // L DD 254
  EXPECT_FALSE(reach(0x3AFF));  // L DD 255
  EXPECT_TRUE(reach(0xF81F));   // U T 31
  EXPECT_FALSE(reach(0xF820));  // U T 32
  EXPECT_TRUE(reach(0x2001));   // A DB 1
  EXPECT_FALSE(reach(0x2000));  // A DB 0
  EXPECT_TRUE(reach(0x7500));   // SPA PB 0
  EXPECT_TRUE(reach(0x0728));   // U =40
  EXPECT_FALSE(reach(0x0729));  // U =41
  EXPECT_TRUE(reach(0x610F));   // SLW 15
  EXPECT_FALSE(reach(0x6110));  // SLW 16
  EXPECT_FALSE(reach(0x4EFF));  // B MW 255
}

}  // namespace
}  // namespace merker::mc5
