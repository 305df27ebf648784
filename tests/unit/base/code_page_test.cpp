#include "base/code_page.h"

#include <gtest/gtest.h>

#include <string>

#include "base/text.h"

namespace merker {
namespace {

struct Sample {
  unsigned page;
  const char* text;
};
// As comments, names and titles of real programs; nothing but letters tells the page.
const Sample kSamples[] = {
    {1252, "// F\u00fcllstand zu hoch; St\u00f6rung \u00d6lpumpe, Ger\u00e4t 5 \u00b0C"},
    {1252, "// \u00c4\u00d6\u00dc\u00e4\u00f6\u00fc\u00df"},
    {1252,
     "// d\u00e9faut de la vanne cr\u00e9\u00e9e \u00e0 l'arr\u00eat, niveau tr\u00e8s "
     "\u00e9lev\u00e9"},
    {1252, "// V\u00e4stra pumpen l\u00e5g niv\u00e5, 5 m\u00b3/h"},
    {1252, "DESCRIÇÃO: OPERAÇÃO DAS POSIÇÕES, LIGAÇÃO"},
    {1252, "// ÆØÅ æøå"},
    {1252, "// Durchfluss in m\u00b3h"},
    {1251, "// Насос включен, уровень выше 5 м"},
    {1251, "\"ПУСК\" Ёлка"},
    {936, "// 水泵运行 输入 启动按钮, 速度过高"},
    {1254, "// Isıtıcı çalışıyor, BAŞLAT düğmesi İ"},
    {1250, "// zawór zasilaj\u0105cy pompy, prze\u0142\u0105cznik"},
    {1250, "Čerpadlo příliš žluťoučký kůň řízení"},
    {1250, "Szivattyú működik, hőmérséklet"},
    {1253, "Αντλία νερού έναρξη κινητήρας"},
    {866, "// Насос включен, уровень выше 5 м"},
    {20866, "// Насос включен, уровень выше 5 м"},
    {1251, "// Аварія насоса, рівень води їх є"},
    {852, "Čerpadlo příliš žluťoučký kůň"},
    {850, "d\u00e9faut de la vanne cr\u00e9\u00e9e \u00e0 l'arr\u00eat"},
    {1257, "sūknis ieslēgts, līmenis augsts; siurblys įjungtas"},
    {1252, "DÉFAUT GÉNÉRATEUR, ÉTÉ À CÔTÉ"},
    {1252, "più è così perché"},
    {1252, "// Öl"},
    {1251, "// Вх"},
    {1251, "Пуск"},
    {1253, "ΑΝΤΛΙΑ ΝΕΡΟΥ"},
    {1251, "НАСОС ПОДПИТКИ"},
    {1251, "Клапан DN50 открыт, 90 °C"}};

TEST(GuessedPage, ByTheLetters) {
  for (const Sample& sample : kSamples) {
    const std::string bytes = Encoder(sample.page).encode(sample.text);
    EXPECT_EQ(guessedPage(bytes).page, sample.page) << sample.text;
    EXPECT_EQ(decoded(bytes), sample.text);
  }
}

// A word or two: what is likely, and whether another page is almost as likely.
TEST(GuessedPage, SaysWhetherItIsCertain) {
  const auto certain = [](unsigned page, const char* text) {
    return guessedPage(Encoder(page).encode(text)).certain;
  };
  EXPECT_TRUE(certain(1252, "// Förderband läuft"));
  EXPECT_TRUE(certain(1252, "Größe"));
  EXPECT_TRUE(certain(1252, "5 °C"));
  EXPECT_TRUE(certain(1251, "Насос включен"));
  EXPECT_TRUE(certain(866, "Насос включен"));
  EXPECT_FALSE(certain(1251, "Вх"));
  EXPECT_FALSE(certain(1252, "procède"));
  EXPECT_TRUE(certain(1252, "plain"));
  EXPECT_EQ(guessedPage("plain").page, 0u);
}

TEST(FormOf, DamagedUtf8IsStillUtf8) {
  const std::string text = "Förderband läuft, Größe überschritten, Öl\xFF";
  EXPECT_EQ(formOf(text).encoding, Encoding::Utf8);
  EXPECT_EQ(decoded(text), "Förderband läuft, Größe überschritten, Öl\uFFFD");
}

TEST(Decoded, TakesTheNamedPageForWhatIsNotUnicode) {
  EXPECT_EQ(decoded("\xE8", 1250), "č");
  EXPECT_EQ(decoded("\x8F\xE3\xE1\xAA", 866), "Пуск");
  EXPECT_EQ(decoded("\xF0\xD5\xD3\xCB", 20866), "Пуск");
  EXPECT_EQ(decoded("ж", 1250), "ж");
  EXPECT_EQ(decoded("abc", 936), "abc");
}

TEST(Decoded, Utf16WithoutItsMark) {
  EXPECT_EQ(decoded(std::string_view("L\0 \0\x35\x04", 6)), "L е");
  EXPECT_EQ(decoded(std::string_view("\0L\0 \x04\x35", 6)), "L е");
  EXPECT_EQ(decoded(std::string_view("\0\0\0\1", 4)), std::nullopt);
}

TEST(Encoder, NamesWhatThePageDoesNotHave) {
  Encoder page(1251);
  EXPECT_EQ(page.encode("Насос ö 1"), "\xCD\xE0\xF1\xEE\xF1 ? 1");
  EXPECT_EQ(page.bytesOf("ö"), std::nullopt);
}

TEST(WindowsBytes, TheFirstPageThatHasTheCharacter) {
  EXPECT_EQ(windowsBytes("ä"), "\xE4");
  EXPECT_EQ(windowsBytes("ж"), "\xE6");
  EXPECT_EQ(windowsBytes("ğ"), "\xF0");
  EXPECT_EQ(windowsBytes("泵"), "\xB1\xC3");
  EXPECT_EQ(windowsBytes("😀"), std::nullopt);
}

}  // namespace
}  // namespace merker
