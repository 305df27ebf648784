// Blocks of a listing: heads, declarations, calls with lists, labels, networks, data.
#include "compile.h"

namespace merker::step5 {
namespace {

using mc5::BlockType;
using Words = std::vector<std::uint16_t>;

constexpr const char* kFb203 = R"(FB 203          BEISPIEL
NAME : BEISPIEL
BEZ  : ANNA  E/A/D/B/T/Z: E   BI/BY/W/D: BI
BEZ  : BERT  E/A/D/B/T/Z: T
BEZ  : HANS  E/A/D/B/T/Z: A   BI/BY/W/D: BI
     : U    =ANNA
     : L    KT 010.2
     : SSV  =BERT
     : U    =BERT
     : =    =HANS
     : BE
)";

// S5-FB-03, S5-FB-06, S5-FB-08, S5-FB-09, S5-FB-10, S5-FB-16: the manual's FB 203.
TEST(Compiler, CallWithParameterList) {
  const auto c = compileText(std::string(R"(OB1
: SPA FB203
NAME : BEISPIEL
ANNA : E 10.3
BERT : T 17
HANS : A 18.4
: BE
)") + kFb203);
  ASSERT_TRUE(c.ok());
  EXPECT_EQ(words(c, BlockType::Ob, 1), (Words{0x3DCB, 0x2D04, 0xC30A, 0x0211, 0xC492, 0x6500}));
  EXPECT_EQ(words(c, BlockType::Fb, 203),
            (Words{0x0701, 0x3002, 0x2010, 0x2E02, 0x0702, 0x1F03, 0x6500}));
  EXPECT_EQ(c.program.at({BlockType::Fb, 203}).name, "BEISPIEL");
}

// S5-FM-01, S5-FM-03, S5-FM-24: resident macros bring their declaration.
TEST(Compiler, CallOfAMacro) {
  const auto c = compileText(R"(OB 20
  SPA FB 11
NAME : EINR-DB
DBAN : KY 100,3
DWNR : KF +9
  BE
)");
  ASSERT_TRUE(c.ok());
  EXPECT_EQ(words(c, BlockType::Ob, 20), (Words{0x3D0B, 0x2D03, 0x6403, 0x0009, 0x6500}));
}

// S5-JUMP-01, S5-JUMP-03, S5-JUMP-05: the manual's compare example with three labels.
TEST(Compiler, LabelsAndDistances) {
  const auto c = compileText(R"(FB 1
NAME : VERGL
     : L  DW67
     : L  DW107
     : !=F
     : SPB =GLCH
     : SPM =KLNR
     : SPP =GRSS
GLCH : BEA
KLNR : BEA
GRSS : BE
)");
  ASSERT_TRUE(c.ok()) << problemsOf("");
  EXPECT_EQ(words(c, BlockType::Fb, 1),
            (Words{0x3243, 0x326B, 0x2180, 0xFA03, 0x2503, 0x1503, 0x6501, 0x6501, 0x6500}));
}

// S5-MISC-04, S5-MISC-06: networks are separated by BLD 255.
TEST(Compiler, Networks) {
  const auto c = compileText("PB 1\nNETZWERK 1 a\n:U E0.0\n:= A0.0\nNETZWERK 2 b\n:BE\n");
  ASSERT_TRUE(c.ok());
  EXPECT_EQ(words(c, BlockType::Pb, 1), (Words{0xC000, 0xD880, 0x10FF, 0x6500}));
  const auto& networks = c.program.at({BlockType::Pb, 1}).networks;
  ASSERT_EQ(networks.size(), 2u);
  EXPECT_EQ(networks[1].title, "b");
}

// S5-DB-02, S5-DB-03, S5-DB-04
// The end of a network is a word of its own: jumps and labels behind it count from there.
TEST(Compiler, JumpsAtTheBeginOfANetwork) {
  const auto c = compileText(
      "FB 1\nNAME : X\n : NOP 0\n***\n : SPA =M2\nM1 : NOP 0\nM2 : SPA =M1\n***\n"
      "M3 : SPA =M3\n : BE\n");
  ASSERT_TRUE(c.ok()) << source::format(c.problems.list().front(), nullptr);
  EXPECT_EQ(
      words(c, mc5::BlockType::Fb, 1),
      (std::vector<std::uint16_t>{0x0000, 0x10FF, 0x2D02, 0x0000, 0x2DFF, 0x10FF, 0x2D00, 0x6500}));
}

TEST(Compiler, DataWords) {
  const auto c = compileText(R"(DB 10
   0: KH = 1F00;
   1: KF = -1;
 DW 2 KY 1,2
      KT 10.2
      KZ 100
      KM 00000000 11111111
      KC AB
      KG +1000000+01
      KS = 'TEXT1'
)");
  ASSERT_TRUE(c.ok());
  EXPECT_EQ(words(c, BlockType::Db, 10), (Words{0x1F00, 0xFFFF, 0x0102, 0x2010, 0x0100, 0x00FF,
                                                0x4142, 0x0140, 0x0000, 0x5445, 0x5854, 0x3120}));
}

// S5-FB-07, S5-FM-47: the manual's FB 140 as printed, comments and all.
TEST(Compiler, ManualExampleFb140) {
  const auto c = compileText(R"(FB 140          SPRM-A          BIB=14050

NETZWERK 1
NAME           : STAZ
BEZ           : DBZW  E/A/D/B/T/Z: B
BEZ           : BEAR  E/A/D/B/T/Z: E          BI/BY/W/D: BI
BEZ           : NSBY  E/A/D/B/T/Z: E          BI/BY/W/D: BY
BEZ           : P-NR  E/A/D/B/T/Z: D          KM/KH/KY/KC/KT/KZ/KG/: KF
:
: LW          =DBZW !          PARAMETERVERSORGUNG
: T          MB 254 ZIEL, DB-Nr. FB 61 KOMMANDO TOS
:                               (WZ-Korrektur lesen)
: L          KB 40 !
: T          MB 255 ! ZIEL, DW-Nr.
: L          KC F5 !
: T          MW 252 ! ZFPN
: A          DB 36 !          MW 190 soll ein freies Anwender-Merker-
: L          =NSBY !          wort darstellen.
: T          MB 190 !          Der Lese-Befehl
: U          = BEAR !          FB 61 wird gebildet aus:
: UN         M 190.3 !          Leseanforderung=BEAR
: =          M 191.0          Datenschnittstelle nicht belegt (M 190.3)
: RB         = BEAR !
: LW         =NSBY !          Der Operationscode des Parameters
:                               "NSBY" vom FB 140
: T          MW 241 ! NSBY
: L          KB 1 !
: T          MB 243 ! ANZ
: LW         =P-Nr. !
: T          MW250 ! WER3
: L          DR 54 !
: T          MW 244 ! WER1
: SPA        FB 61
NAME          : NCD  LESE
LESE         :      M 191.0
NSBY         :      MB 242          (jede andere Adresse)
ANZ          :      KF+128
DTY1         :      KCTO
DTY2         :      KCS
DTY3         :      KC
WER1         :      KF+0
WER2         :      KF+0
WER3         :      KF+0
ZFPN        :      KC 00
ZIEL         :      KY 0,0
:
: BE
)");
  ASSERT_TRUE(c.ok()) << (c.problems.empty() ? "" : c.problems.list()[0].message);
  const mc5::Block& block = c.program.at({BlockType::Fb, 140});
  EXPECT_EQ(block.name, "SPRM-A");
  EXPECT_EQ(block.library, 14050u);
  ASSERT_EQ(block.parameters.size(), 4u);
  EXPECT_EQ(block.parameters[3].name, "P-NR");
  EXPECT_EQ(block.words[0], 0x3F01);
  const Words list(block.words.end() - 12, block.words.end());
  EXPECT_EQ(list,
            (Words{0x80BF, 0x0AF2, 0x0080, 0x544F, 0x5320, 0x2020, 0, 0, 0, 0x3030, 0, 0x6500}));
}

}  // namespace
}  // namespace merker::step5
