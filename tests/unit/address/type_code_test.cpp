#include "address/type_code.h"

#include <gtest/gtest.h>

#include "address/constant.h"

namespace merker {
namespace {

// S7-IND-13: the codes of ANY pointers.
TEST(TypeCode, codesOfAnyPointers) {
  constexpr std::pair<std::string_view, int> kCodes[] = {
      {"BOOL", 0x01},     {"BYTE", 0x02},      {"CHAR", 0x03},     {"WORD", 0x04},
      {"INT", 0x05},      {"DWORD", 0x06},     {"DINT", 0x07},     {"REAL", 0x08},
      {"DATE", 0x09},     {"TOD", 0x0A},       {"TIME", 0x0B},     {"S5TIME", 0x0C},
      {"DT", 0x0E},       {"STRING", 0x13},    {"BLOCK_FB", 0x17}, {"BLOCK_FC", 0x18},
      {"BLOCK_DB", 0x19}, {"BLOCK_SDB", 0x1A}, {"COUNTER", 0x1C},  {"TIMER", 0x1D}};
  for (const auto& [keyword, code] : kCodes) {
    ASSERT_TRUE(typeFromName(keyword)) << keyword;
    EXPECT_EQ(static_cast<int>(*typeFromName(keyword)), code) << keyword;
  }
}

TEST(TypeCode, namesAreLongAndReadInAnyCase) {
  EXPECT_EQ(name(TypeCode::TimeOfDay), "TIME_OF_DAY");
  EXPECT_EQ(name(TypeCode::DateAndTime), "DATE_AND_TIME");
  EXPECT_EQ(name(TypeCode::Struct), "");
  EXPECT_EQ(typeFromName("s5Time"), TypeCode::S5Time);
  EXPECT_EQ(typeFromName("ARRAY"), std::nullopt);
  EXPECT_EQ(typeFromName(""), std::nullopt);
}

// S7-TYPES-04 to -18
TEST(TypeCode, widths) {
  EXPECT_EQ(bitWidth(TypeCode::Bool), 1u);
  EXPECT_EQ(bitWidth(TypeCode::Char), 8u);
  EXPECT_EQ(bitWidth(TypeCode::Date), 16u);
  EXPECT_EQ(bitWidth(TypeCode::Time), 32u);
  EXPECT_EQ(bitWidth(TypeCode::DateAndTime), 64u);
  EXPECT_EQ(bitWidth(TypeCode::String), 0u);
}

TEST(NaturalType, ofConstants) {
  const auto type = [](std::string_view text) { return naturalType(*parseConstant(text, {})); };
  EXPECT_EQ(type("'a'"), TypeCode::Char);
  EXPECT_EQ(type("'ab'"), TypeCode::Word);
  EXPECT_EQ(type("12"), TypeCode::Int);
  EXPECT_EQ(type("1.0"), TypeCode::Real);
  EXPECT_EQ(type("TRUE"), TypeCode::Bool);
  EXPECT_EQ(type("C#5"), TypeCode::Word);
  EXPECT_EQ(type("P#M 1.0"), TypeCode::Pointer);
  EXPECT_EQ(type("DW#16#1"), TypeCode::DWord);
  EXPECT_EQ(bitWidth(ConstantFormat::Byte), 8u);
  EXPECT_EQ(bitWidth(ConstantFormat::Characters), 16u);
  EXPECT_EQ(bitWidth(ConstantFormat::LongBytes), 32u);
}

}  // namespace
}  // namespace merker
