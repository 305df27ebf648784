// Constants in the manual's notations (9.2.1, 9.3.3).
#include "mc5/constant.h"

#include <gtest/gtest.h>

namespace merker::mc5 {
namespace {

std::optional<std::uint32_t> bits(std::string_view word, std::string_view text) {
  return constantBits(findConstantFormat(word)->format, text);
}

// S5-NUM-02, S5-NUM-05, S5-NUM-07, S5-NUM-08, S5-NUM-10, S5-NUM-11, S5-LOAD-02
TEST(Constant, NotationsOfTheManual) {
  EXPECT_EQ(bits("KF", "-1"), 0xFFFFu);
  EXPECT_EQ(bits("KF", "+32767"), 0x7FFFu);
  EXPECT_EQ(bits("KH", "7F0A"), 0x7F0Au);
  EXPECT_EQ(bits("KH", "ffff"), 0xFFFFu);
  EXPECT_EQ(bits("KZ", "100"), 0x0100u);
  EXPECT_EQ(bits("KT", "10.2"), 0x2010u);
  EXPECT_EQ(bits("KT", "010.2"), 0x2010u);
  EXPECT_EQ(bits("KC", "F1"), 0x4631u);
  EXPECT_EQ(bits("KC", "S"), 0x5320u);
  EXPECT_EQ(bits("KC", ""), 0x2020u);
  EXPECT_EQ(bits("KY", "1,2"), 0x0102u);
  EXPECT_EQ(bits("KM", "0011111001011011"), 0x3E5Bu);
  EXPECT_EQ(bits("KB", "255"), 255u);
  EXPECT_EQ(bits("KG", "+1000000+01"), 0x01400000u);
  EXPECT_EQ(bits("KG", "+1250000+02"), 0x04640000u);
  EXPECT_EQ(bits("KG", "-1000000+01"), 0x01C00000u);  // OP-49
  EXPECT_EQ(bits("KG", "+0000000+00"), 0x80000000u);
}

TEST(Constant, OutsideTheirRanges) {
  const std::pair<const char*, const char*> wrong[] = {
      {"KF", "32768"},       {"KF", "-32769"},      {"KF", ""},
      {"KF", "+-5"},         {"KH", "10000"},       {"KH", "G"},
      {"KZ", "1000"},        {"KZ", "-1"},          {"KT", "10"},
      {"KT", "10.4"},        {"KT", "1000.1"},      {"KC", "ABC"},
      {"KY", "1"},           {"KY", "256,0"},       {"KM", "101"},
      {"KM", "2"},           {"KB", "256"},         {"KG", "12345"},
      {"KG", "+1000000+40"}, {"KG", "+12345678+01"}};
  for (const auto& [word, text] : wrong) EXPECT_FALSE(bits(word, text)) << word << ' ' << text;
}

// Whatever bits a constant has, its text reads back as them, or names them in hexadecimal.
TEST(Constant, TextLosesNothing) {
  for (const Format format : {Format::Hex, Format::Counter, Format::Time, Format::Fixed,
                              Format::Characters, Format::Bytes, Format::Binary})
    for (std::uint32_t value = 0; value <= 0xFFFF; value += 7) {
      const std::string text =
          constantText({.kind = OperandKind::Constant, .format = format, .value = value});
      const std::string word = text.substr(0, 2);
      const auto* row = findConstantFormat(word);
      if (row == nullptr) {
        EXPECT_EQ(std::stoul(text.substr(5), nullptr, 16), value) << text;
        EXPECT_EQ(std::stoul(text.substr(2, 2), nullptr, 16), info(format).formatByte) << text;
      } else {
        EXPECT_EQ(constantBits(format, text.substr(text.size() > 3 ? 3 : 2)), value) << text;
      }
    }
}

}  // namespace
}  // namespace merker::mc5
