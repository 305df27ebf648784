// Single statements in the spellings that the manual prints.
#include <gtest/gtest.h>

#include "mc5/encoding.h"
#include "step5/compiler.h"

namespace merker::step5 {
namespace {

using Words = std::vector<std::uint16_t>;

Words code(std::string_view text) {
  Words words;
  const auto instruction = parseInstruction(text, {"", 1, 1});
  if (!instruction || !mc5::encode(instruction.value(), words)) return {};
  return words;
}

// S5-STMT-01, S5-STMT-02, S5-STMT-04, S5-LOAD-01, S5-LOAD-02
TEST(Statement, SpellingsOfTheManual) {
  EXPECT_EQ(code("U E 4.1"), Words{0xC104});
  EXPECT_EQ(code(": U      E 10.0"), Words{0xC00A});
  EXPECT_EQ(code(":=     A 2.0"), Words{0xD882});
  EXPECT_EQ(code("=  D 9.15"), (Words{0x783F, 0x6F09}));
  EXPECT_EQ(code("L EB19"), Words{0x4A13});
  EXPECT_EQ(code("T DW0"), Words{0x3300});
  EXPECT_EQ(code("A DB10"), Words{0x200A});
  EXPECT_EQ(code("SPA PB1"), Words{0x7501});
  EXPECT_EQ(code("SPB FB 203"), Words{0x1DCB});
  EXPECT_EQ(code("L PB 4"), Words{0x7204});
  EXPECT_EQ(code("L KH7F0A"), (Words{0x3040, 0x7F0A}));
  EXPECT_EQ(code("L KT 010.2"), (Words{0x3002, 0x2010}));
  EXPECT_EQ(code("L KZ100"), (Words{0x3001, 0x0100}));
  EXPECT_EQ(code("L KC F1"), (Words{0x3010, 0x4631}));
  EXPECT_EQ(code("L KF+128"), (Words{0x3004, 0x0080}));
  EXPECT_EQ(code("L KY 0, 160"), (Words{0x3020, 0x00A0}));
  EXPECT_EQ(code("L KM 00111110 01011011"), (Words{0x3080, 0x3E5B}));
  EXPECT_EQ(code("L KG +1250000+02"), (Words{0x3800, 0x0464, 0x0000}));
  EXPECT_EQ(code("U("), Words{0xBA00});
  EXPECT_EQ(code(")"), Words{0xBF00});
  EXPECT_EQ(code("O"), Words{0xFB00});
  EXPECT_EQ(code("O E 1.4"), Words{0xCC01});
  EXPECT_EQ(code("!=F"), Words{0x2180});
  EXPECT_EQ(code("GRF"), Words{0x2120});
  EXPECT_EQ(code(": :F"), Words{0x6000});
  EXPECT_EQ(code("*F"), Words{0x6004});
  EXPECT_EQ(code("xF"), Words{0x6004});
  EXPECT_EQ(code("NOP 0"), Words{0x0000});
  EXPECT_EQ(code("NOP1"), Words{0xFFFF});
  EXPECT_EQ(code("BLD 255"), Words{0x10FF});
  EXPECT_EQ(code("D 33"), Words{0x1921});
  EXPECT_EQ(code("I 16"), Words{0x1110});
  EXPECT_EQ(code("ADD BF -3"), Words{0x50FD});
  EXPECT_EQ(code("ADD KF +5"), (Words{0x5800, 0x0005}));
  EXPECT_EQ(code("P T 1.15"), (Words{0x7025, 0xCF01}));
  EXPECT_EQ(code("R T 5"), Words{0x3C05});
  EXPECT_EQ(code("F T 5"), Words{0x0405});
  EXPECT_EQ(code("B MW 250"), Words{0x4EFA});
  EXPECT_EQ(code("SPA =+4"), Words{0x2D04});
  EXPECT_EQ(code("U =1"), Words{0x0701});
  EXPECT_EQ(code("L KH 0010      Lesen des Vorschubwertes"), (Words{0x3040, 0x0010}));
  EXPECT_EQ(code("T MB 254 ZIEL, DB-Nr."), Words{0x0BFE});
  EXPECT_EQ(code("L KC F5 !"), (Words{0x3010, 0x4635}));
}

TEST(Statement, WhatIsNone) {
  const std::pair<const char*, const char*> wrong[] = {
      {"+D", "P1103"},    {"SRD 4", "P1103"},       {"L QB 1", "P1104"}, {"U P 1.0", "P1104"},
      {"U", "P1110"},     {"L", "P1110"},           {"T KF 1", "P1109"}, {"SPA OB 20", "P1139"},
      {"U E 4", "P1107"}, {"L KF +32768", "P1108"}, {"L DW", "P1106"},   {"L DW 5 6", "P1111"},
      {"SPA =", "P1105"}, {"SPA =M001", "P1105"},   {"XYZ", "P1103"}};
  for (const auto& [text, name] : wrong) {
    const auto instruction = parseInstruction(text, {"", 1, 1});
    ASSERT_FALSE(instruction.has_value()) << text;
    EXPECT_EQ(instruction.error().name(), name) << text;
  }
}

// S5-OPC-01: the text of every row reads back as the row's code.
TEST(Statement, EveryRowComesBack) {
  for (const mc5::Encoding& row : mc5::encodings())
    for (const std::uint64_t fill : {0ull, 0x000100010001ull, 0x0503050305ull, 0x7A297A297A29ull}) {
      const std::uint64_t code48 = row.bits | (fill & ~row.mask);
      const auto operand = mc5::decodeOperand(row, code48);
      if (!operand) continue;
      const mc5::Instruction instruction{row.operation, *operand};
      Words expected;
      ASSERT_TRUE(mc5::encode(instruction, expected));
      EXPECT_EQ(code(mc5::text(instruction)), expected) << mc5::text(instruction);
    }
}

// S5-CMP-06: the names of the table of codes are taken, the signs are written.
TEST(Statement, ShortFormsOfComparisons) {
  struct Pair {
    const char *name, *sign;
    std::uint16_t word;
  };
  constexpr Pair kPairs[] = {
      {"GRF", ">F", 0x2120},  {"KLF", "<F", 0x2140},  {"UGLF", "><F", 0x2160},
      {"GLF", "!=F", 0x2180}, {"GGF", ">=F", 0x21A0}, {"KGF", "<=F", 0x21C0},
      {"GRD", ">D", 0x3920},  {"KGD", "<=D", 0x39C0}, {"GGG", ">=G", 0x31A0},
      {"KGG", "<=G", 0x31C0}, {"ADDF", "+F", 0x7900}, {"DIVG", ":G", 0x6003}};
  for (const Pair& pair : kPairs) {
    EXPECT_EQ(code(pair.name), Words{pair.word}) << pair.name;
    EXPECT_EQ(code(pair.sign), Words{pair.word}) << pair.sign;
    const Words words{pair.word};
    EXPECT_EQ(mc5::text(mc5::decode(words)->instruction), pair.sign);
  }
}

// S5-SUBST-07: the 20 instructions with a formal operand, here the second one.
TEST(Statement, FormalOperands) {
  constexpr std::pair<const char*, std::uint16_t> kCodes[] = {
      {"S =2", 0x1702},   {"RB =2", 0x3702},  {"= =2", 0x1F02},   {"U =2", 0x0702},
      {"O =2", 0x0F02},   {"UN =2", 0x2702},  {"ON =2", 0x2F02},  {"L =2", 0x4602},
      {"T =2", 0x6602},   {"LC =2", 0x0E02},  {"LW =2", 0x3F02},  {"LD =2", 0x5602},
      {"SI =2", 0x3602},  {"SE =2", 0x2602},  {"FR =2", 0x0602},  {"RD =2", 0x3E02},
      {"SVZ =2", 0x1E02}, {"SSV =2", 0x2E02}, {"SAR =2", 0x1602}, {"B =2", 0x7602}};
  static_assert(std::size(kCodes) == 20);
  for (const auto& [text, word] : kCodes) EXPECT_EQ(code(text), Words{word}) << text;
  EXPECT_EQ(code("SV =2"), Words{});
}

// S5-LOAD-12: the periphery Q of other PLCs.
TEST(Statement, ThereIsNoPeripheryQ) {
  EXPECT_EQ(code("L PB 1"), Words{0x7201});
  EXPECT_EQ(code("L QB 1"), Words{});
  EXPECT_EQ(code("T QW 1"), Words{});
}

}  // namespace
}  // namespace merker::step5
