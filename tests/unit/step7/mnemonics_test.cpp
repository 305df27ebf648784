// S7-SRC-10, S7-MNE-01 … 12: one setting per source, found by the words that exist in only one.
#include <gtest/gtest.h>

#include "support.h"

namespace merker::step7 {
namespace {

std::string ob(std::string_view code) {
  return "ORGANIZATION_BLOCK OB 1\nBEGIN\n" + std::string(code) + "\nEND_ORGANIZATION_BLOCK\n";
}

TEST(Mnemonics, BothSettingsGiveTheSameCode) {
  const Compiled german = compileText(
      ob("U E 0.0; UN A 1.1; SE T 1; ZV Z 2; L PEW 256; T PAW 256; UD; SPB m; m: TAW; BEA"));
  const Compiled international = compileText(
      ob("A I 0.0; AN Q 1.1; SD T 1; CU C 2; L PIW 256; T PQW 256; AD; JC m; m: CAW; BEU"));
  EXPECT_EQ(german.problems(), std::vector<std::string>{});
  EXPECT_EQ(international.problems(), std::vector<std::string>{});
  EXPECT_EQ(german.block(BlockKind::OB, 1).code, international.block(BlockKind::OB, 1).code);
}

// S7-MNE-03: SE is the on-delay in German, the extended pulse in international mnemonics.
TEST(Mnemonics, SeDependsOnTheSetting) {
  EXPECT_EQ(compileText(ob("U E 0.0; SE T 1")).listing(BlockKind::OB, 1),
            "U     E 0.0\nSE    T 1\nBE\n");
  EXPECT_EQ(compileText(ob("A I 0.0; SE T 1")).listing(BlockKind::OB, 1),
            "U     E 0.0\nSV    T 1\nBE\n");
}

TEST(Mnemonics, OperandsAloneDecideToo) {
  EXPECT_EQ(compileText(ob("L IW 0; T QW 4")).problems(), std::vector<std::string>{});
  EXPECT_EQ(compileText(ob("L EW 0; T AW 4")).problems(), std::vector<std::string>{});
}

using List = std::vector<std::string>;

// The source says it once, and its code is that of one setting.
TEST(Mnemonics, AMixtureIsUnderstoodWhereItIsClear) {
  const Compiled german = compileText(ob("U E 0.0; UN E 0.1\nA I 0.1\nU I 0.2"));
  EXPECT_EQ(german.problems(), (List{"4:1 P0355"}));
  EXPECT_EQ(german.listing(BlockKind::OB, 1),
            "U     E 0.0\nUN    E 0.1\nU     E 0.1\nU     E 0.2\nBE\n");
  const Compiled international = compileText(ob("A I 0.0; AN I 0.1\nU E 0.1\nA E 0.2"));
  EXPECT_EQ(international.problems(), (List{"4:1 P0356"}));
  EXPECT_EQ(international.listing(BlockKind::OB, 1),
            "U     E 0.0\nUN    E 0.1\nU     E 0.1\nU     E 0.2\nBE\n");
}

TEST(Mnemonics, EachSourceSaysItOnceForAllItsBlocks) {
  const std::string fc =
      "FUNCTION FC 1 : VOID\nBEGIN\nU E 0.0; UN E 0.1; SPA m; m: A I 0.0\n"
      "END_FUNCTION\n";
  EXPECT_EQ(compileText(fc + ob("U E 0.0; A Q 0.0")).problems(), (List{"3:30 P0355"}));
}

// S7-MNE-03: SE exists in both and is not the same.
TEST(Mnemonics, SeIsNotClearInAMixture) {
  const std::string text = ob("U E 0.0; SE T 1\nUN E 0.1\nA I 0.1; SE T 2");
  EXPECT_EQ(compileText(text).problems(), (List{"3:10 P0357", "5:1 P0355", "5:10 P0357"}));
}

TEST(Mnemonics, TheSettingOfAProjectDecides) {
  CompileOptions options;
  const source::SourceFile file("a.awl", ob("U E 0.0; SE T 1\nUN E 0.1\nA I 0.1"));
  const auto code = [&](std::optional<Mnemonics> mnemonics) {
    options.mnemonics = mnemonics;
    const Compiled compiled{compile({file}, options)};
    return std::pair(compiled.listing(BlockKind::OB, 1).substr(12, 12), compiled.problems());
  };
  EXPECT_EQ(code(Mnemonics::German), std::pair(std::string("SE    T 1\nUN"), List{"5:1 P0355"}));
  EXPECT_EQ(code(Mnemonics::International),
            std::pair(std::string("SV    T 1\nUN"), List{"3:1 P0356"}));
}

// Names of parameters that are words of the other mnemonics, in brackets and one a line.
TEST(Mnemonics, ParameterListsDoNotVote) {
  const std::string fc =
      "FUNCTION FC 1 : VOID\nVAR_INPUT a, an, ju, i : INT; END_VAR\nEND_FUNCTION\n";
  for (const std::string_view list :
       {"(a := 1, an := 2,\n ju := 3,\n i := MW 10)", "\n(a := 1,\nan := 2, ju := 3, i := 4)",
        "\na := 1\nan := 2\nju := 3\ni := 4", "\n(a := 1\n, an := 2\n, ju := 3\n, i := EW 0)"})
    EXPECT_EQ(compileText(fc + ob("CALL FC 1 " + std::string(list) + "\nU M 0.0")).problems(),
              List{})
        << list;
}

// Where no statement says anything, the operands that calls supply do.
TEST(Mnemonics, SuppliedOperandsVoteLast) {
  const std::string fc = "FUNCTION FC 1 : VOID\nVAR_INPUT u : BOOL; END_VAR\nEND_FUNCTION\n";
  EXPECT_EQ(compileText(fc + ob("CALL FC 1 (u := I 0.0)\nSE T 1")).listing(BlockKind::OB, 1),
            compileText(fc + ob("CALL FC 1 (u := E 0.0)\nSV T 1")).listing(BlockKind::OB, 1));
}

TEST(Mnemonics, TitlesDoNotVote) {
  EXPECT_EQ(compileText(ob("NETWORK\nTITLE = x; A I 0.0; A I 0.1; A I 0.2\nU E 0.0")).problems(),
            List{});
}

}  // namespace
}  // namespace merker::step7
