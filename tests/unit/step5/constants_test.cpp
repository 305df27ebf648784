// Characters and other constants in statements, data words and parameter lists.
#include "compile.h"

namespace merker::step5 {
namespace {

using Words = std::vector<std::uint16_t>;

Words data(const std::string& line) {
  return words(compileText("DB 10\n" + line + "\n"), mc5::BlockType::Db, 10);
}
std::string wrong(const std::string& line) { return problemsOf("DB 10\n" + line + "\n"); }

// S5-LOAD-02, S5-NUM-10: two characters, with and without quotes.
TEST(Constants, Characters) {
  EXPECT_EQ(data("0: KC = AB"), Words{0x4142});
  EXPECT_EQ(data("0: KC= 'AB'"), Words{0x4142});
  EXPECT_EQ(data("0: KC= A!"), Words{0x4121});
  EXPECT_EQ(data("0: KC= A"), Words{0x4120});
  EXPECT_EQ(data("0: KC= ' B'"), Words{0x2042});
  EXPECT_EQ(data("0: KC='!;' ! comment"), Words{0x213B});
  EXPECT_EQ(data("0: KC ="), Words{0x2020});
  EXPECT_EQ(data("0: KS= 'HELLO'"), (Words{0x4845, 0x4C4C, 0x4F20}));
}

// S5-NUM-10
TEST(Constants, CharactersThatAreNone) {
  EXPECT_EQ(wrong("0: KC= 'HELLO'"), "P1108@2:4");
  EXPECT_EQ(wrong("0: KC= HELLO"), "P1108@2:4");
  EXPECT_EQ(wrong("0: KC=  B"), "P1108@2:4");
  EXPECT_EQ(wrong("0: KC= 'A"), "P1108@2:4");
  EXPECT_EQ(wrong("0: KC= \xC3\xBC\x31"), "P1108@2:4");
  EXPECT_EQ(wrong("0: KS= 'H\xC3\xBC'"), "P1108@2:4");
  EXPECT_EQ(wrong("0: KH = 1F00 1F01"), "P1111@2:14");
}

// S5-DB-02: a faulty word keeps its place.
TEST(Constants, AFaultyWordIsOneProblem) {
  EXPECT_EQ(wrong("0: KF = 99999\n1: KH = 0\n2: XY = 1\n3: KH = 0"), "P1108@2:4 P1131@4:1");
}

// S5-LOAD-02: also in statements and parameter lists.
TEST(Constants, QuotesInStatements) {
  const auto c = compileText(
      "OB 1\n: L KC 'AB'\n: SPA FB 1\nART : KC 'TO'\n: BE\nFB 1\nNAME : X\nBEZ : ART D KC\n: BE\n");
  ASSERT_TRUE(c.ok());
  EXPECT_EQ(words(c, mc5::BlockType::Ob, 1),
            (Words{0x3010, 0x4142, 0x3D01, 0x2D02, 0x544F, 0x6500}));
}

// S5-NUM-06, 9.3.3: the printed limit is the largest number.
TEST(Constants, TheLargestNumber) {
  EXPECT_EQ(data("0: KG = +1701412+39"), (Words{0x7F7F, 0xFFFF}));
  EXPECT_EQ(data("0: KG = -1701412+39"), (Words{0x7F80, 0x0001}));
  EXPECT_EQ(wrong("0: KG = +1701413+39"), "P1108@2:4");
}

// S5-ARITH-08
TEST(Constants, SignedBytes) {
  EXPECT_EQ(problemsOf("FB 1\n: ADD BF -127\n: ADD BF +127\n: BE\n"), "");
  for (const char* bits : {"8000", "800000000", "0000000", "0000000G"})  // eight digits, no fewer
    EXPECT_EQ(problemsOf("PB 1\n: L KG #" + std::string(bits) + "\n: BE\n").substr(0, 5), "P1108")
        << bits;
  EXPECT_EQ(problemsOf("PB 1\n: L KG #80000000\n: BE\n"), "");
  EXPECT_EQ(problemsOf("FB 1\n: ADD BF -128\n: BE\n"), "P1108@2:7");
}

// S5-OPC-01, OP-46: every format byte has a text of its own.
TEST(Constants, EveryFormatByteComesBack) {
  for (std::uint16_t code = 0; code < 256; ++code) {
    const Words given{static_cast<std::uint16_t>(0x3000 | code), 0xABCD};
    const auto decoded = mc5::decode(given);
    ASSERT_TRUE(decoded.has_value());
    const std::string text = mc5::text(decoded->instruction);
    const auto back = parseInstruction(text, {"", 1, 1});
    ASSERT_TRUE(back.has_value()) << text;
    Words encoded;
    ASSERT_TRUE(mc5::encode(back.value(), encoded)) << text;
    EXPECT_EQ(encoded, given) << text;
  }
}

// 9.4.11, `merker assemble`: distances without "=".
TEST(Constants, DistancesOfJumps) {
  const auto code = [](std::string_view text) {
    Words encoded;
    const auto instruction = parseInstruction(text, {"", 1, 1});
    return instruction && mc5::encode(instruction.value(), encoded) ? encoded : Words{};
  };
  EXPECT_EQ(code("SPA 5"), Words{0x2D05});
  EXPECT_EQ(code("SPB -5"), Words{0xFAFB});
  EXPECT_EQ(code("SPA =+5"), Words{0x2D05});
  EXPECT_EQ(code("SPA PB 5"), Words{0x7505});
}

}  // namespace
}  // namespace merker::step5
