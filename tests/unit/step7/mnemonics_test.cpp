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

TEST(Mnemonics, MixtureIsAProblem) {
  EXPECT_EQ(compileText(ob("U E 0.0; UN E 0.1\nA I 0.1\nU I 0.2")).problems(),
            (std::vector<std::string>{"4:1 P0314", "5:3 P0314"}));
  EXPECT_EQ(compileText(ob("A I 0.0; AN I 0.1\nU E 0.1\nA E 0.2")).problems(),
            (std::vector<std::string>{"4:1 P0315", "5:3 P0315"}));
}

}  // namespace
}  // namespace merker::step7
