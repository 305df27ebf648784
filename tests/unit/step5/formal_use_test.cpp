// Formal operands of the wrong kind, calls that do not go with what they call, networks.
#include "compile.h"

namespace merker::step5 {
namespace {

// S5-SUBST-01 … S5-SUBST-06: each kind of parameter with each operation.
TEST(FormalUse, KindsOfParameters) {
  const auto takes = [](const std::string& operation, const std::string& kind) {
    const std::string result =
        problemsOf("FB 1\nNAME : X\nBEZ : P " + kind + "\n: " + operation + " =P\n: BE\n");
    EXPECT_TRUE(result.empty() || result.starts_with("P1145@4:")) << result;
    return result.empty();
  };
  const std::string kinds[] = {"E BI", "A BI", "E BY", "A W", "E D", "D KF", "D KG", "B", "T", "Z"};
  const std::pair<const char*, const char*> rows[] = {
      // S5-SUBST-01 … -06
      {"U", "1100000011"},   {"UN", "1100000011"},  {"O", "1100000011"},   {"ON", "1100000011"},
      {"S", "1100000000"},   {"RB", "1100000000"},  {"=", "1100000000"},   {"L", "0011100000"},
      {"T", "0011100000"},   {"LC", "0000000011"},  {"LW", "1111110111"},  {"LD", "0000001000"},
      {"SI", "0000000010"},  {"SE", "0000000010"},  {"FR", "0000000011"},  {"RD", "0000000011"},
      {"SVZ", "0000000011"}, {"SSV", "0000000011"}, {"SAR", "0000000011"}, {"B", "0000000100"}};
  for (const auto& [operation, possible] : rows)
    for (std::size_t i = 0; i < std::size(kinds); ++i)
      EXPECT_EQ(takes(operation, kinds[i]), possible[i] == '1') << operation << " " << kinds[i];
}

// S5-FB-12: B, T and Z have no type; S5-FB-08: a name begins with a letter.
TEST(FormalUse, Declarations) {
  EXPECT_EQ(problemsOf("FB 1\nBEZ : P1 T BI\n: BE\n"), "P1148@2:12");
  EXPECT_EQ(problemsOf("FB 1\nBEZ : P1 B\n: BE\n"), "");
  EXPECT_EQ(problemsOf("FB 1\n: SPA =1AB\n: BE\n"), "P1147@2:8");
}

// S5-FB-13: the range of an actual operand is told; the error of a declaration is told once.
TEST(FormalUse, ActualOperands) {
  const std::string fb = "FB 1\nNAME : RICHTIG\nBEZ : P1 E BI\nBEZ : P2 E W\nBEZ : P3 D KT\n: BE\n";
  const auto call = [&](const std::string& name, const std::string& bit, const std::string& word,
                        const std::string& time, const std::string& more = "") {
    return problemsOf(fb + "OB 1\n: SPA FB 1\nNAME : " + name + "\nP1 : " + bit + "\nP2 : " + word +
                      "\nP3 : " + time + "\n" + more + ": BE\n");
  };
  EXPECT_EQ(call("RICHTIG", "E 0.0", "MW 254", "KT 5.1"), "");
  EXPECT_EQ(call("RICHTIG", "E 128.0", "MW 255", "KT 5.1"), "P1112@10:6 P1112@11:6");
  EXPECT_EQ(call("RICHTIG", "E 0.0", "MW 254", "KT 5.0"), "P1136@12:6");
  EXPECT_EQ(call("FALSCH", "E 0.0", "MW 254", "KT 5.1"), "P1150@9:8");
  EXPECT_EQ(call("RICHTIG", "E 0.0", "MW 254", "KT 5.1", "P4 : E 0.1\n"), "P1146@13:1");
  EXPECT_EQ(problemsOf("OB 1\n: SPA FB 1\nP1 : KF 5\n: BE\nFB 1\nNAME : X\nBEZ : P1 D\n: BE\n"),
            "P1129@7:11");
}

// S5-ERR-T5 (6105), S5-PROC-04: calls of blocks that are not there; behind B the number is none.
TEST(FormalUse, CallsOfMissingBlocks) {
  EXPECT_EQ(problemsOf("OB 1\n: SPA PB 200\n: SPB SB 3\n: BE\n"), "P1149@2:7 P1149@3:7");
  EXPECT_EQ(problemsOf("OB 1\n: SPA PB 1\n: BE\nPB 1\n: BE\n"), "");
  EXPECT_EQ(problemsOf("FB 1\n: B MW 30\n: SPA PB 0\n: B DW 1\n: A DB 0\n: BE\n"), "");
  EXPECT_EQ(problemsOf("FB 1\n: A DB 0\n: BE\n"), "P1112@2:5");
}

// S5-MISC-04, S5-MISC-06: *** and BLD 255 end a network like NETZWERK does.
TEST(FormalUse, Networks) {
  for (const std::string end :
       {"***", ": BLD 255", "NETZWERK 2", "***\nNETZWERK 2", ": BLD 255\n***"}) {
    const auto c = compileText("FB 1\n: U E 0.0\n" + end + "\nZIEL : = A 0.0\n: BE\n");
    EXPECT_TRUE(c.ok()) << end;
    EXPECT_EQ(words(c, mc5::BlockType::Fb, 1),
              (std::vector<std::uint16_t>{0xC000, 0x10FF, 0xD880, 0x6500}))
        << end;
  }
  EXPECT_EQ(problemsOf("FB 1\n: SPA =ZIEL\n***\nZIEL : BE\n"), "P1118@2:8");
  EXPECT_EQ(problemsOf("FB 1\n: SPA =ZIEL\n: BLD 255\nZIEL : BE\n"), "P1118@2:8");
  EXPECT_EQ(problemsOf("PB 1\n: U(\n: U E 0.0\n***\n: )\n: BE\n"), "P1138@2:3 P1137@5:3");
}

// S5-MISC-04: a block that begins or repeats BLD 255 comes back from its listing.
TEST(FormalUse, BuildCommandsComeBack) {
  const auto first = compileText("PB 1\n: BLD 255\n: BLD 255\n: U E 0.0\n: BLD 255\n: BE\n");
  const auto second = compileText(listing(first.program));
  EXPECT_EQ(words(second, mc5::BlockType::Pb, 1), words(first, mc5::BlockType::Pb, 1))
      << listing(first.program);
}

}  // namespace
}  // namespace merker::step5
