// E-mails of a CP 343-1 IT (S7-NET-16): from the bytes of the program to the lines of a dialogue.
#include <gtest/gtest.h>

#include "itcp/quoted_printable.h"
#include "itcp/smtp.h"

namespace merker::itcp {
namespace {

using system::MailData;
using system::mailOf;

std::vector<std::uint8_t> strings(const std::vector<std::pair<std::uint8_t, std::string>>& all) {
  std::vector<std::uint8_t> bytes;
  for (const auto& [longest, text] : all) {
    bytes.resize((bytes.size() + 1) / 2 * 2);
    bytes.push_back(longest);
    bytes.push_back(static_cast<std::uint8_t>(text.size()));
    const std::size_t end = bytes.size() + longest;
    bytes.insert(bytes.end(), text.begin(), text.end());
    bytes.resize(end);
  }
  return bytes;
}

TEST(MailData, StringsOneBehindTheOther) {
  const auto mail =
      mailOf(strings({{31, "a@b.de; c@d.de"}, {9, ""}, {3, "Hi"}, {5, "one "}, {3, "two"}}));
  ASSERT_TRUE(mail);
  EXPECT_EQ(*mail, (MailData{{"a@b.de", "c@d.de"}, "", "Hi", "one two"}));
  EXPECT_EQ(mailOf(strings({{6, "a@b.de"}, {6, "c@d.de"}, {1, ""}, {1, ""}}))->from, "c@d.de");
}

TEST(MailData, WhatIsNone) {
  EXPECT_FALSE(mailOf({}));
  EXPECT_FALSE(mailOf(strings({{6, "a@b.de"}, {1, ""}, {1, ""}})));
  EXPECT_FALSE(mailOf(strings({{6, "a b.de"}, {1, ""}, {1, ""}, {1, ""}})));
  EXPECT_FALSE(mailOf(strings({{6, "a@b.de"}, {6, "nobody"}, {1, ""}, {1, ""}})));
  EXPECT_FALSE(mailOf(strings({{6, ""}, {1, ""}, {1, ""}, {1, ""}})));
  auto longer = strings({{6, "a@b.de"}, {1, ""}, {1, ""}, {1, ""}});
  longer[1] = 7;  // than it may be
  EXPECT_FALSE(mailOf(longer));
}

TEST(Letter, PlainTextStaysAsItIs) {
  const Letter letter =
      letterOf({{"a@b.de"}, "", "Hi", "one\ntwo\r\nthree\rfour"}, "me@b.de", "now");
  EXPECT_EQ(letter.content,
            "Date: now\r\nFrom: me@b.de\r\nTo: a@b.de\r\nSubject: Hi\r\nMIME-Version: 1.0\r\n"
            "Content-Type: text/plain; charset=utf-8\r\nContent-Transfer-Encoding: 7bit\r\n\r\n"
            "one\r\ntwo\r\nthree\r\nfour\r\n");
}

TEST(QuotedPrintable, LinesAndBlanks) {
  EXPECT_EQ(quotedPrintable("a=b \r\n\xC3\xBC"), "a=3Db=20\r\n=C3=BC");
  const std::string line = quotedPrintable(std::string(100, 'x'));
  EXPECT_EQ(line, std::string(75, 'x') + "=\r\n" + std::string(25, 'x'));
  EXPECT_FALSE(isPlainText(std::string(999, 'x')));
  EXPECT_TRUE(isPlainText(std::string(998, 'x') + "\r\n" + std::string(998, 'x')));
}

// No character is torn apart, no line is longer than 76 (RFC 2047, 2).
TEST(QuotedPrintable, WordsOfAHeader) {
  EXPECT_EQ(encodedWords("plain = text"), "plain = text");
  EXPECT_EQ(encodedWords("\xC3\x96l: 5"), "=?UTF-8?Q?=C3=96l=3A_5?=");
  std::string text;
  for (int i = 0; i < 20; ++i) text += "\xC3\xBC";
  const std::string words = encodedWords(text);
  EXPECT_EQ(words.find("\r\n "), 10u + 9u * 6u + 2u);
}

std::string talk(Smtp& smtp, const std::vector<std::string>& lines) {
  std::string all;
  for (const std::string& line : lines) all += smtp.hear(line);
  return all;
}

TEST(Smtp, ADialogue) {
  Smtp smtp({"me@b.de", {"a@b.de", "c@d.de"}, "x\r\n.y\r\n.\r\n"}, "[1.2.3.4]");
  EXPECT_EQ(talk(smtp, {"220-hello", "220 x"}), "EHLO [1.2.3.4]\r\n");
  EXPECT_EQ(talk(smtp, {"250-a", "250 b"}), "MAIL FROM:<me@b.de>\r\n");
  EXPECT_EQ(talk(smtp, {"250 ok"}), "RCPT TO:<a@b.de>\r\n");
  EXPECT_EQ(talk(smtp, {"251 ok"}), "RCPT TO:<c@d.de>\r\n");
  EXPECT_EQ(talk(smtp, {"250 ok"}), "DATA\r\n");
  EXPECT_EQ(talk(smtp, {"354 go"}), "x\r\n..y\r\n..\r\n.\r\n");
  EXPECT_EQ(smtp.state(), Smtp::State::Talks);
  EXPECT_EQ(talk(smtp, {"250 ok", "250 more"}), "QUIT\r\n");
  EXPECT_EQ(smtp.state(), Smtp::State::Sent);
}

TEST(Smtp, EachRefusalEndsIt) {
  const std::vector<std::string> good = {"220 a", "250 b", "250 c", "250 d", "354 e", "250 f"};
  for (std::size_t step = 0; step < good.size(); ++step) {
    std::vector<std::string> lines(good.begin(), good.begin() + static_cast<long>(step));
    lines.emplace_back("554 no\x01");
    if (step == 1) lines.emplace_back("554 no\x01");  // an old server, perhaps
    Smtp smtp({"me@b.de", {"a@b.de"}, "x\r\n"}, "x");
    EXPECT_TRUE(talk(smtp, lines).ends_with("QUIT\r\n"));
    EXPECT_EQ(smtp.state(), Smtp::State::Refused) << step;
    EXPECT_EQ(smtp.reason(), "554 no ");
  }
  for (const char* const wrong : {"", "22", "nonsense", "2 0 x", "-20 x"}) {
    Smtp smtp({"me@b.de", {"a@b.de"}, "x\r\n"}, "x");
    smtp.hear(wrong);
    EXPECT_EQ(smtp.state(), Smtp::State::Refused) << wrong;
  }
  Smtp endless({"me@b.de", {"a@b.de"}, "x\r\n"}, "x");
  for (std::size_t i = 0; i <= Smtp::kMostReplies; ++i) endless.hear("220-more");
  EXPECT_EQ(endless.state(), Smtp::State::Refused);
}

}  // namespace
}  // namespace merker::itcp
