// The listings of chapter 6, as printed.
#include "rig.h"

namespace merker::nc {
namespace {

// FB 56, FB 57, FB 58, section 5. S5-FM-12, S5-FM-17, S5-FM-18
TEST(ManualExample, ActualValues) {
  Rig rig;
  Control& control = rig.macros.control();
  control.axes[0].feed[0] = {142567, 2};
  control.axes[0].followingError = 70'000;
  control.spindleSpeed[0] = 1500;
  ASSERT_TRUE(rig.start(R"(OB 1
: L KH 0010      Lesen des achsialen Vorschubwertes G94 der 1. Achse
: T MB 224
: SPA FB 56
Name : VORSCHUB
: L MW 225      Ergebnis in
: T MW 175      Merkerwörtern
: L MW 227      retten
: T MW 177
: L KH 0001      Lesen des Schleppabstandes der 1. Achse
: T MB 224
: SPA FB 57
Name : SCHLEPPA
: L MW 225
: T MW 180
: L MW 227
: T MW 182
: L KH 0001      Lesen der Spindeldrehzahl von Spindel 1
: T MB 224
: SPA FB 58
Name : SPINDIST
: L MW 225
: T MW 190
: L MW 227
: T MW 192
: BE
)"));
  rig.cycles(1);
  EXPECT_EQ(rig.flagWord(175), 0x675Eu);
  EXPECT_EQ(rig.flagWord(177), 0x4201u);
  EXPECT_EQ(rig.flagWord(180), 70'000u - 65'536u);
  EXPECT_EQ(rig.flagWord(182), 1u);
  EXPECT_EQ(rig.flagWord(190), 1500u);
}

// FB 62, section 9: R 50 of channel 1 from MW 160 and MW 162, two places. S5-FM-46
TEST(ManualExample, WriteParameter) {
  Call call;
  call.macro = 62;
  call.format = "F3";
  JobRig rig(call);
  rig.setFlagWord(160, 0);
  rig.setFlagWord(162, 12345);
  EXPECT_EQ(rig.run(), "");
  EXPECT_EQ(rig.macros.control().parameters[0][50], (Number{12345, 2}));
}

// FB 140 SPRM-A, section 5: tool offset P-NR of D number (DR 51) in TO area (DR 54) to DW 40 of the
// block DBZW. S5-FM-47
TEST(ManualExample, Fb140) {
  Rig rig;
  rig.macros.control().tools[6][2] = {123456, 3};  // D 7, P 2
  ASSERT_TRUE(rig.start(dataBlock(50, 60) + R"(FB 140          SPRM-A          BIB=14050

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
: B          =DBZW
: LW         =NSBY !          Der Operationscode des Parameters
: T          MW 241 ! NSBY
: L          KB 1 !
: T          MB 243 ! ANZ
: LW         =P-NR !
: T          MW250 ! WER3
: L          DR 54 !
: T          MW 244 ! WER1
: L          DR 51 !
: T          MW 248 ! WER2
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
OB 1
: SPA FB 140
NAME : STAZ
DBZW : DB 50
BEAR : M 200.0
NSBY : DL 15
P-NR : KF +2
: BE
)"));
  rig.word(50, 51) = 7;
  rig.cycles(2);
  EXPECT_EQ(rig.word(50, 41), 0u);
  rig.machine().flags[200] = 1;
  rig.cycles(4);
  EXPECT_EQ(rig.stop(), "");
  EXPECT_EQ(rig.machine().flags[200], 0u);
  EXPECT_EQ(rig.word(50, 40) << 16 | rig.word(50, 41), 1234560);  // F5: four places
}

}  // namespace
}  // namespace merker::nc
