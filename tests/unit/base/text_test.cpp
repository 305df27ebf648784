#include "base/text.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "base/utf8.h"

namespace merker {
namespace {

TEST(DetectEncoding, byteOrderMarks) {
  EXPECT_EQ(detectEncoding("\xEF\xBB\xBFL 5"), Encoding::Utf8);
  EXPECT_EQ(detectEncoding(std::string_view("\xFF\xFEL\0", 4)), Encoding::Utf16Le);
  EXPECT_EQ(detectEncoding(std::string_view("\xFE\xFF\0L", 4)), Encoding::Utf16Be);
}

TEST(DetectEncoding, plainAsciiAndUtf8) {
  EXPECT_EQ(detectEncoding(""), Encoding::Utf8);
  EXPECT_EQ(detectEncoding("U E 0.0\r\n\t= A 1.0\r\n\x1A"), Encoding::Utf8);
  EXPECT_EQ(detectEncoding("// Förderband"), Encoding::Utf8);
}

TEST(DetectEncoding, germanWindowsText) {
  EXPECT_EQ(detectEncoding("// F\xF6rderband l\xE4uft, \xDC"
                           "berlauf"),
            Encoding::Cp1252);
  EXPECT_EQ(detectEncoding("// \xC4ndern"), Encoding::Cp1252);
  EXPECT_EQ(detectEncoding("// \x84zu\x93 Stra\xDF"
                           "e"),
            Encoding::Cp1252);
  EXPECT_EQ(detectEncoding("// \x84zu\x93"), Encoding::Cp1252);
  EXPECT_EQ(detectEncoding("// 20 \xB0"
                           "C"),
            Encoding::Cp1252);
}

TEST(DetectEncoding, germanDosText) {
  EXPECT_EQ(detectEncoding("// F\x94rderband l\x84uft, \x9A"
                           "berlauf"),
            Encoding::Cp850);
  EXPECT_EQ(detectEncoding("// Stra\xE1"
                           "e"),
            Encoding::Cp850);
  // A frame of C4h is no row of the letter that CP1252 has there.
  EXPECT_EQ(detectEncoding("\xDA\xC4\xC4\xC4\xC4\xBF\n\xB3T\x81r\xB3\n\xC0\xC4\xC4\xC4\xC4\xD9"),
            Encoding::Cp850);
  EXPECT_EQ(detectEncoding("\xD5\xCD\xCD\xCD\xCD\xB8\n\xB3T\x81r\xB3\n\xD4\xCD\xCD\xCD\xCD\xBE"),
            Encoding::Cp437);
}

TEST(DetectEncoding, binary) {
  EXPECT_EQ(detectEncoding(std::string_view("pp\0\1\2", 5)), Encoding::Binary);
  EXPECT_EQ(detectEncoding("\1\2\3abc"), Encoding::Binary);
}

TEST(ToUtf8, upperHalves) {
  EXPECT_EQ(toUtf8("\xE4\x80\x96", Encoding::Cp1252), "ä€–");
  EXPECT_EQ(toUtf8("\x84\x9B\xF5\xD5", Encoding::Cp850), "äø§ı");
  EXPECT_EQ(toUtf8("\x84\x9B\xE0\xD5", Encoding::Cp437), "ä¢α╒");
  EXPECT_EQ(toUtf8("\x81\x9D", Encoding::Cp1252), "\uFFFD\uFFFD");
}

TEST(ToUtf8, whatIsNoTextStays) { EXPECT_EQ(toUtf8("\x81\x01Z", Encoding::Binary), "\x81\x01Z"); }

TEST(ToUtf8, utf16WithSurrogates) {
  EXPECT_EQ(toUtf8(std::string_view("\xFF\xFEL\0\xE4\0\x3D\xD8\x00\xDE", 10), Encoding::Utf16Le),
            "Lä😀");
  EXPECT_EQ(toUtf8(std::string_view("\xFE\xFF\0L\0\xE4", 6), Encoding::Utf16Be), "Lä");
  EXPECT_EQ(toUtf8(std::string_view("\x3D\xD8L\0\xE4", 5), Encoding::Utf16Le), "\uFFFDL\uFFFD");
}

TEST(ToUtf8, utf8WithoutMarkAndWithoutRubbish) {
  EXPECT_EQ(toUtf8("\xEF\xBB\xBFL", Encoding::Utf8), "L");
  EXPECT_EQ(toUtf8("a\xC3", Encoding::Utf8), "a\uFFFD");
  EXPECT_EQ(toUtf8("\xED\xA0\x80", Encoding::Utf8), "\uFFFD\uFFFD\uFFFD");
}

TEST(Utf8, refusesOverlongAndTooLarge) {
  EXPECT_FALSE(isValidUtf8("\xC0\xAF"));
  EXPECT_FALSE(isValidUtf8("\xE0\x80\x80"));
  EXPECT_FALSE(isValidUtf8("\xF4\x90\x80\x80"));
  EXPECT_TRUE(isValidUtf8("\xF4\x8F\xBF\xBF"));
}

TEST(Utf8, asciiWithAnyLength) {
  for (std::size_t length = 0; length < 20; ++length) {
    std::string text(length, '\x7F');
    EXPECT_TRUE(isAscii(text));
    for (char& c : text) {
      c = '\x80';
      EXPECT_FALSE(isAscii(text));
      c = 'a';
    }
  }
}

TEST(ToCp1252, oneBytePerCharacter) {
  EXPECT_EQ(toCp1252("Förderband 5 €"), "F\xF6rderband 5 \x80");
  EXPECT_EQ(toCp1252("Ω\uFFFD\u0085"), "???");
}

TEST(Text, asciiCaseOnly) {
  EXPECT_EQ(upper("äb z"), "äB Z");
  EXPECT_TRUE(equalsIgnoreCase("Motor", "mOTOR"));
  EXPECT_FALSE(equalsIgnoreCase("Motor", "Motors"));
  EXPECT_FALSE(equalsIgnoreCase("@", "`"));
}

TEST(Text, trimAndCount) {
  EXPECT_EQ(trim(" \t a b\r\n"), "a b");
  EXPECT_EQ(trim(" \t"), "");
  EXPECT_EQ(characterCount("aä€😀"), 4u);
}

// Any bytes become valid UTF-8, in every encoding.
RC_GTEST_PROP(ToUtf8, alwaysValid, (const std::string& bytes)) {
  const auto encoding = *rc::gen::element(Encoding::Utf8, Encoding::Cp1252, Encoding::Cp850,
                                          Encoding::Cp437, Encoding::Utf16Le, Encoding::Utf16Be);
  RC_ASSERT(isValidUtf8(toUtf8(bytes, encoding)));
  (void)detectEncoding(bytes);
}

RC_GTEST_PROP(Utf8, characterThereAndBack, ()) {
  auto character = *rc::gen::inRange<std::uint32_t>(0, 0x110000 - 0x800);
  if (character >= 0xD800) character += 0x800;
  std::string text;
  appendCharacter(text, character);
  std::size_t position = 0;
  RC_ASSERT(nextCharacter(text, position) == character);
  RC_ASSERT(position == text.size());
}

}  // namespace
}  // namespace merker
