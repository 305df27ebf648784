// CALL of FC and SFC, instruction for instruction (MC7 section 7.3; code patterns, sections 1 and
// 2). Each row is a row of the table there; the code is written from the rules by hand.
#include <gtest/gtest.h>

#include "golden.h"

namespace merker::step7 {
namespace {

constexpr const char* kBlocks = R"(
FUNCTION FC 10 : VOID
BEGIN
END_FUNCTION
FUNCTION FC 300 : VOID
BEGIN
END_FUNCTION
FUNCTION FC 11 : VOID
VAR_INPUT
 b : BOOL; y : BYTE; w : WORD; d : DWORD;
END_VAR
BEGIN
END_FUNCTION
FUNCTION FC 12 : INT
VAR_INPUT
 i : INT;
END_VAR
VAR_OUTPUT
 q : BOOL; o : INT;
END_VAR
VAR_IN_OUT
 x : INT; z : BOOL;
END_VAR
BEGIN
END_FUNCTION
FUNCTION FC 13 : VOID
VAR_INPUT
 t : TIMER; c : COUNTER; d : BLOCK_DB; f : BLOCK_FC;
END_VAR
BEGIN
END_FUNCTION
FUNCTION FC 14 : VOID
VAR_INPUT
 a : ANY;
END_VAR
BEGIN
END_FUNCTION
FUNCTION FC 15 : VOID
VAR_INPUT
 p : POINTER;
END_VAR
VAR_IN_OUT
 s : STRUCT m : INT; n : BOOL; END_STRUCT;
END_VAR
BEGIN
END_FUNCTION
FUNCTION FC 16 : VOID
VAR_INPUT
 b0, b1, b2, b3, b4, b5, b6, b7, b8 : BOOL; w : WORD;
END_VAR
BEGIN
END_FUNCTION
FUNCTION FC 17 : VOID
VAR_INPUT
 i : INT; r : REAL; c : CHAR; s : S5TIME; n : DINT;
END_VAR
BEGIN
END_FUNCTION
FUNCTION FC 18 : VOID
VAR_IN_OUT
 s : STRUCT m : INT; n : BOOL; END_STRUCT;
END_VAR
BEGIN
END_FUNCTION
DATA_BLOCK DB 5
STRUCT
 w : WORD; f : BOOL; i : INT; s : STRUCT m : INT; n : BOOL; END_STRUCT;
END_STRUCT
BEGIN
END_DATA_BLOCK
)";

// S7-PAR-12: bracket, VKE and list are there also without parameters (section 2); the first byte
// behind the declared variables is not rounded up, an OB has at least 20 (section 1).
constexpr Golden kInFunctionPlain[] = {
    {"", "CALL FC 10;", "BLD 1; = L 0.0; UC FC 10; SPA 2; BLD 2; BE"},
    {"", "CALL FC 300;", "BLD 1; = L 0.0; UC FC 300; SPA 2; BLD 2; BE"},
    {"", "CALL SFC 46;", "BLD 7; = L 0.0; UC SFC 46; SPA 2; BLD 8; BE"},
    {"VAR_TEMP\n t : ARRAY [0..63] OF BOOL; f : BOOL;\nEND_VAR", "CALL FC 10;",
     "BLD 1; = L 9.0; UC FC 10; SPA 2; BLD 2; BE"},
    {"VAR_TEMP\n t : WORD;\nEND_VAR", "T LB 6; CALL FC 10; CALL FC 10;",
     "T LB 6; BLD 1; = L 7.0; UC FC 10; SPA 2; BLD 2; "
     "BLD 1; = L 7.0; UC FC 10; SPA 2; BLD 2; BE"},
};

TEST(CallFunction, BracketAndLocalData) {
  expectCode(BlockKind::FC, kInFunctionPlain, kBlocks);
  EXPECT_EQ(compiledIn(BlockKind::OB, {"", "CALL FC 10;", ""}, kBlocks),
            "BLD 1; = L 20.0; UC FC 10; SPA 2; BLD 2; BE");
  EXPECT_EQ(compiledIn(BlockKind::FB, {"", "CALL FC 10;", ""}, kBlocks),
            "BLD 1; = L 4.0; TAR2 LD 0; UC FC 10; SPA 2; LAR2 LD 0; BLD 2; BE");
}

// S7-PAR-01, S7-PAR-02: the table of section 2, in an FC whose own data end in byte 2.
constexpr Golden kElementary[] = {
    // E A M, periphery: their pointers
    {"VAR_TEMP\n t : WORD; f : BOOL;\nEND_VAR",
     "CALL FC 11 (b := E 1.2, y := AB 3, w := PEW 256, d := MD 4);",
     "BLD 1; = L 3.0; UC FC 11; SPA 10; P#E 1.2; P#A 3.0; P#P 256.0; P#M 4.0; BLD 2; BE"},
    // temporary data: V; of the open data blocks: DBX, DIX
    {"VAR_TEMP\n t : WORD; f : BOOL;\nEND_VAR",
     "CALL FC 11 (b := #f, y := DBB 3, w := #t, d := DID 4);",
     "BLD 1; = L 3.0; UC FC 11; SPA 10; P#V 2.0; P#DBX 3.0; P#V 0.0; P#DIX 4.0; BLD 2; BE"},
    // numbers
    {"", "CALL FC 13 (t := T 7, c := Z 8, d := DB 9, f := FC 10);",
     "BLD 1; = L 0.0; UC FC 13; SPA 10; 7; 8; 9; 10; BLD 2; BE"},
    // constants: nothing remains of their notation
    {"", "CALL FC 11 (b := TRUE, y := B#16#7F, w := W#16#8000, d := DW#16#FFFFFFFF);",
     "BLD 1; = L 0.0; SET; = L 0.1; L B#16#7F; T LB 1; L -32768; T LW 2; L L#-1; T LD 4; "
     "UC FC 11; SPA 10; P#V 0.1; P#V 1.0; P#V 2.0; P#V 4.0; BLD 2; BE"},
    {"", "CALL FC 17 (i := 5, r := 1.0, c := 'A', s := S5T#2S, n := L#7);",
     "BLD 1; = L 0.0; L 5; T LW 1; L L#1065353216; T LD 3; L B#16#41; T LB 7; L 512; T LW 8; "
     "L L#7; T LD 10; UC FC 17; SPA 12; P#V 1.0; P#V 3.0; P#V 7.0; P#V 8.0; P#V 10.0; BLD 2; BE"},
    {"", "CALL FC 11 (b := FALSE, y := B#16#0, w := 2#1, d := P#M10.1);",
     "BLD 1; = L 0.0; CLR; = L 0.1; L B#16#00; T LB 1; L 1; T LW 2; L P#M10.1; T LD 4; "
     "UC FC 11; SPA 10; P#V 0.1; P#V 1.0; P#V 2.0; P#V 4.0; BLD 2; BE"},
    // DBn.DBx: opened for each parameter anew; IN, RETURN, OUT, IN_OUT
    {"",
     "CALL FC 12 (i := DB5.DBW 0, RET_VAL := DB5.i, q := DB5.f, o := MW 0, x := DB5.DBW 4, "
     "z := DB5.f);",
     "BLD 1; = L 0.0; AUF DB 5; L DBW 0; T LW 1; AUF DB 5; L DBW 4; T LW 5; AUF DB 5; U DBX 2.0; "
     "= L 0.2; UC FC 12; SPA 14; P#V 1.0; P#V 3.0; P#V 0.1; P#M 0.0; P#V 5.0; P#V 0.2; "
     "L LW 3; AUF DB 5; T DBW 4; U L 0.1; AUF DB 5; = DBX 2.0; L LW 5; AUF DB 5; T DBW 4; "
     "U L 0.2; AUF DB 5; = DBX 2.0; BLD 2; BE"},
    // own parameters of an FC
    {"VAR_INPUT\n w : INT;\nEND_VAR\nVAR_OUTPUT\n o : BOOL;\nEND_VAR\nVAR_IN_OUT\n x : INT; y : "
     "BOOL;\nEND_VAR",
     "CALL FC 12 (i := #w, RET_VAL := #x, q := #o, o := #x, x := #x, z := #y);",
     "BLD 1; = L 0.0; L W #P0; T LW 1; L W #P2; T LW 7; U #P3; = L 0.2; UC FC 12; SPA 14; "
     "P#V 1.0; P#V 3.0; P#V 0.1; P#V 5.0; P#V 7.0; P#V 0.2; L LW 3; T W #P2; U L 0.1; = #P1; "
     "L LW 5; T W #P2; L LW 7; T W #P2; U L 0.2; = #P3; BLD 2; BE"},
    // the ninth bit takes a byte of its own, the VKE being the first
    {"",
     "CALL FC 16 (b0 := 1, b1 := 0, b2 := 0, b3 := 0, b4 := 0, b5 := 0, b6 := 0, b7 := 0, b8 := "
     "0, w := 1);",
     "BLD 1; = L 0.0; SET; = L 0.1; CLR; = L 0.2; CLR; = L 0.3; CLR; = L 0.4; CLR; = L 0.5; CLR; "
     "= L 0.6; CLR; = L 0.7; CLR; = L 1.0; CLR; = L 1.1; L 1; T LW 2; UC FC 16; SPA 22; P#V 0.1; "
     "P#V 0.2; P#V 0.3; P#V 0.4; P#V 0.5; P#V 0.6; P#V 0.7; P#V 1.0; P#V 1.1; P#V 2.0; BLD 2; BE"},
};

TEST(CallFunction, ElementaryParameters) { expectCode(BlockKind::FC, kElementary, kBlocks); }

// S7-IND-11, S7-IND-12: in local data.
constexpr Golden kPointers[] = {
    {"", "CALL FC 14 (a := P#DB5.DBX0.0 BYTE 10);",
     "BLD 1; = L 0.0; L ANY#16#1002; T LW 1; L 10; T LW 3; L 5; T LW 5; L P#DBX0.0; T LD 7; "
     "UC FC 14; SPA 4; P#V 1.0; BLD 2; BE"},
    {"", "CALL FC 14 (a := P#M 10.0 WORD 2);",
     "BLD 1; = L 0.0; L ANY#16#1004; T LW 1; L 2; T LW 3; L 0; T LW 5; L P#M10.0; T LD 7; "
     "UC FC 14; SPA 4; P#V 1.0; BLD 2; BE"},
    // temporary data: area V
    {"VAR_TEMP\n t : WORD;\nEND_VAR", "CALL FC 14 (a := #t);",
     "BLD 1; = L 2.0; L ANY#16#1004; T LW 3; L 1; T LW 5; L 0; T LW 7; L P#V0.0; T LD 9; "
     "UC FC 14; SPA 4; P#V 3.0; BLD 2; BE"},
    // an own ANY is handed on as it stands
    {"VAR_TEMP\n t : WORD; a : ANY;\nEND_VAR", "CALL FC 14 (a := #a);",
     "BLD 1; = L 12.0; UC FC 14; SPA 4; P#V 2.0; BLD 2; BE"},
    {"", "CALL FC 15 (p := P#DB5.DBX2.1, s := DB5.s);",
     "BLD 1; = L 0.0; L 5; T LW 1; L P#DBX2.1; T LD 3; L 5; T LW 7; L P#DBX6.0; T LD 9; "
     "UC FC 15; SPA 6; P#V 1.0; P#V 7.0; BLD 2; BE"},
};

TEST(CallFunction, PointersAndComplexParameters) { expectCode(BlockKind::FC, kPointers, kBlocks); }

// In an FB: AR2 is kept, own data are staged, pointers to them are made by AR2.
constexpr Golden kInFunctionBlock[] = {
    {"VAR_INPUT\n i : INT;\nEND_VAR\nVAR_IN_OUT\n x : INT;\nEND_VAR\nVAR\n f, g : BOOL; n : "
     "INT;\nEND_VAR",
     "CALL FC 12 (i := #i, RET_VAL := #n, q := #f, o := MW 0, x := #x, z := #g);",
     "BLD 1; = L 4.0; TAR2 LD 0; L DIW [AR2,P#0.0]; T LW 5; L DIW [AR2,P#2.0]; T LW 9; "
     "U DIX [AR2,P#4.1]; = L 4.2; UC FC 12; SPA 14; P#V 5.0; P#V 7.0; P#V 4.1; P#M 0.0; P#V 9.0; "
     "P#V 4.2; LAR2 LD 0; L LW 7; T DIW [AR2,P#6.0]; U L 4.1; = DIX [AR2,P#4.0]; L LW 9; "
     "T DIW [AR2,P#2.0]; U L 4.2; = DIX [AR2,P#4.1]; BLD 2; BE"},
    {"VAR\n w : WORD; v : DWORD;\nEND_VAR", "CALL FC 14 (a := #w); CALL FC 14 (a := #v);",
     "BLD 1; = L 4.0; TAR2 LD 0; L ANY#16#1004; T LW 5; L 1; T LW 7; L DINO; T LW 9; "
     "+AR2 P#0.0; TAR2; LAR2 LD 0; T LD 11; UC FC 14; SPA 4; P#V 5.0; LAR2 LD 0; BLD 2; "
     "BLD 1; = L 4.0; TAR2 LD 0; L ANY#16#1006; T LW 5; L 1; T LW 7; L DINO; T LW 9; "
     "+AR2 P#2.0; TAR2; LAR2 LD 0; T LD 11; UC FC 14; SPA 4; P#V 5.0; LAR2 LD 0; BLD 2; BE"},
    {"VAR\n s : STRUCT m : INT; n : BOOL; END_STRUCT;\nEND_VAR", "CALL FC 18 (s := #s);",
     "BLD 1; = L 4.0; TAR2 LD 0; L DINO; T LW 5; +AR2 P#0.0; TAR2; LAR2 LD 0; T LD 7; "
     "UC FC 18; SPA 4; P#V 5.0; LAR2 LD 0; BLD 2; BE"},
};

TEST(CallFunction, FromFunctionBlock) { expectCode(BlockKind::FB, kInFunctionBlock, kBlocks); }

// KOP and FUP: the macros of each network lie behind the bits of that network (section 1).
const Golden kInNetworks[] = {
    {"VAR_TEMP\n t : BOOL;\nEND_VAR",
     "//# KOP\nNETWORK\nU M 0.0; = L 2.0; BLD 103; CALL FC 10;\nNETWORK\nCALL FC 10;",
     "U M 0.0; = L 2.0; BLD 103; BLD 1; = L 3.0; UC FC 10; SPA 2; BLD 2; "
     "BLD 1; = L 1.0; UC FC 10; SPA 2; BLD 2; BE"},
    {"", "//# FUP\nNETWORK\nCALL FC 10;\nNETWORK\nT LW 4; CALL FC 10;",
     "BLD 1; = L 0.0; UC FC 10; SPA 2; BLD 2; T LW 4; BLD 1; = L 6.0; UC FC 10; SPA 2; BLD 2; BE"},
    {"", "NETWORK\nCALL FC 10;\nNETWORK\nT LW 4; CALL FC 10;",
     "BLD 1; = L 6.0; UC FC 10; SPA 2; BLD 2; T LW 4; BLD 1; = L 6.0; UC FC 10; SPA 2; BLD 2; BE"},
};

TEST(CallFunction, InNetworksOfKopAndFup) { expectCode(BlockKind::FC, kInNetworks, kBlocks); }

// The old version of the code keeps neither AR2 nor the VKE: two FBs of projects, whose AGRESERVED
// is 0.
const Golden kInCodeVersion1[] = {
    {"CODE_VERSION1\nVAR_TEMP\n t : BOOL;\nEND_VAR", "CALL FC 10;",
     "BLD 1; UC FC 10; SPA 2; BLD 2; BE"},
};

TEST(CallFunction, FromCodeVersion1) { expectCode(BlockKind::FB, kInCodeVersion1, kBlocks); }

// LOCDATALEN: highest byte used + 1, rounded up to even (section 1).
TEST(CallFunction, LocalDataLength) {
  const auto length = [](std::string_view statements) {
    return compileText(std::string(kBlocks) + "FUNCTION FC 9 : VOID\nBEGIN\n" +
                       std::string(statements) + "\nEND_FUNCTION\n")
        .block(BlockKind::FC, 9)
        .localBytes;
  };
  EXPECT_EQ(length("L 1;"), 0u);
  EXPECT_EQ(length("CALL FC 10;"), 2u);
  EXPECT_EQ(length("CALL FC 14 (a := P#M 10.0 WORD 2);"), 12u);
  EXPECT_EQ(length("T LB 6; CALL FC 10;"), 8u);
}

}  // namespace
}  // namespace merker::step7
