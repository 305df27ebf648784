#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "address/constant.h"

namespace merker {
namespace {

std::string again(std::string_view text, Mnemonics mnemonics = Mnemonics::German) {
  return formatConstant(*parseConstant(text, {}), mnemonics);
}

TEST(FormatConstant, asSourcesShowIt) {
  EXPECT_EQ(again("12.456"), "1.245600e+001");  // S7-LOAD-12
  EXPECT_EQ(again("-0.5"), "-5.000000e-001");
  EXPECT_EQ(again("s5t#4220s"), "S5T#1H10M20S");
  EXPECT_EQ(again("S5T#0MS"), "S5T#0MS");
  EXPECT_EQ(again("T#-1500MS"), "T#-1S500MS");
  EXPECT_EQ(again("T#-24D20H31M23S648MS"), "T#-24D20H31M23S648MS");
  EXPECT_EQ(again("D#1998-4-14"), "D#1998-04-14");
  EXPECT_EQ(again("TOD#1:2:3.04"), "TOD#01:02:03.040");
  EXPECT_EQ(again("B#(81, 54)"), "B#(81,54)");
  EXPECT_EQ(again("2#1"), "2#00000000_00000001");
  EXPECT_EQ(again("C#010"), "C#10");
  EXPECT_EQ(again("'ab'"), "'ab'");
  EXPECT_EQ(again("b#16#a"), "B#16#0A");
  EXPECT_EQ(again("L#-5"), "L#-5");
}

// S7-MNE-14: only pointers differ between the mnemonics.
TEST(FormatConstant, pointersInBothMnemonics) {
  EXPECT_EQ(again("P#E 1.0"), "P#E1.0");
  EXPECT_EQ(again("P#E 1.0", Mnemonics::International), "P#I1.0");
  EXPECT_EQ(again("P#A 1.0", Mnemonics::International), "P#Q1.0");
  EXPECT_EQ(again("P#1.0", Mnemonics::International), "P#1.0");
}

TEST(FormatConstant, bitsThatTheNotationCannotExpress) {
  EXPECT_EQ(formatConstant({ConstantFormat::Counter, 0x0A00}), "W#16#0A00");
  EXPECT_EQ(formatConstant({ConstantFormat::S5Time, 0x0ABC}), "W#16#0ABC");
  EXPECT_EQ(formatConstant({ConstantFormat::S5Time, 0x1005}),
            "W#16#1005");  // not the smallest base
  EXPECT_EQ(formatConstant({ConstantFormat::Date, 0xFFFF}), "W#16#FFFF");
  EXPECT_EQ(formatConstant({ConstantFormat::Real, 0x7FC00000}), "DW#16#7FC00000");
  EXPECT_EQ(formatConstant({ConstantFormat::Real, 0x00000001}), "DW#16#00000001");
  EXPECT_EQ(formatConstant({ConstantFormat::TimeOfDay, 86'400'000}), "DW#16#05265C00");
  EXPECT_EQ(formatConstant({ConstantFormat::Pointer, 0x88000000}), "DW#16#88000000");
}

TEST(FormatValue, inTheNotationOfTheType) {
  EXPECT_EQ(formatValue(TypeCode::Bool, 1), "TRUE");
  EXPECT_EQ(formatValue(TypeCode::Byte, 5), "B#16#05");
  EXPECT_EQ(formatValue(TypeCode::Char, 'T'), "'T'");
  EXPECT_EQ(formatValue(TypeCode::Word, 5), "W#16#0005");
  EXPECT_EQ(formatValue(TypeCode::Int, 5), "5");
  EXPECT_EQ(formatValue(TypeCode::Int, 0xFFFFD0A5), "-12123");
  EXPECT_EQ(formatValue(TypeCode::DWord, 5), "DW#16#00000005");
  EXPECT_EQ(formatValue(TypeCode::DInt, 0xFFFFFFFF), "L#-1");
  EXPECT_EQ(formatValue(TypeCode::Real, 0x3DCCCCCE), "1.000000e-001");
  EXPECT_EQ(formatValue(TypeCode::Real, 0x00000001), "1.401298e-045");
  EXPECT_EQ(formatValue(TypeCode::Real, 0x7F800000), "DW#16#7F800000");
  EXPECT_EQ(formatValue(TypeCode::Time, 5000), "T#5S");
  EXPECT_EQ(formatValue(TypeCode::S5Time, 0x1005), "S5T#500MS");
  EXPECT_EQ(formatValue(TypeCode::Timer, 0x2200), "S5T#3M20S");
  EXPECT_EQ(formatValue(TypeCode::Counter, 0x0999), "C#999");
  EXPECT_EQ(formatValue(TypeCode::Date, 3025), "D#1998-04-14");
  EXPECT_EQ(formatValue(TypeCode::TimeOfDay, 64397333), "TOD#17:53:17.333");
  EXPECT_EQ(formatValue(TypeCode::Pointer, 0x81000008, Mnemonics::International), "P#I1.0");
}

// Whatever the bits are, reading the text gives them back; and the text of a text is the same text.
RC_GTEST_PROP(FormatConstant, readingGivesTheSameBits, ()) {
  const auto number = *rc::gen::inRange(0, static_cast<int>(ConstantFormat::TimeOfDay) + 1);
  const auto format = static_cast<ConstantFormat>(number);
  auto bits = *rc::gen::arbitrary<std::uint32_t>();
  if (*rc::gen::arbitrary<bool>()) bits = *rc::gen::inRange<std::uint32_t>(0, 90'000'000);
  const unsigned width = bitWidth(format);
  if (width < 32) bits &= (1u << width) - 1;
  const auto mnemonics = *rc::gen::element(Mnemonics::German, Mnemonics::International);

  const std::string text = formatConstant({format, bits}, mnemonics);
  const auto constant = parseConstant(text, {});
  RC_ASSERT(constant.has_value());
  RC_ASSERT(constant->bits == bits);
  RC_ASSERT(bitWidth(constant->format) == width);
  RC_ASSERT(formatConstant(*constant, mnemonics) == text);
}

RC_GTEST_PROP(FormatCharacters, readingGivesTheSameBytes, (const std::string& bytes)) {
  const auto constant = parseCharacters(formatCharacters(bytes), {});
  RC_ASSERT(constant.has_value());
  RC_ASSERT(*constant == bytes);
}

RC_GTEST_PROP(ParseConstant, anyTextIsReadOrRefused, (const std::string& text)) {
  const auto constant = parseConstant(text, {});
  if (constant) RC_ASSERT(parseConstant(formatConstant(*constant), {})->bits == constant->bits);
}

}  // namespace
}  // namespace merker
