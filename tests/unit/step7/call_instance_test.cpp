// CALL of FB and SFB, instruction for instruction (code patterns, section 3). The code is written
// from the rules by hand.
#include <gtest/gtest.h>

#include "golden.h"

namespace merker::step7 {
namespace {

constexpr const char* kInstances = R"(
FUNCTION_BLOCK FB 10
BEGIN
END_FUNCTION_BLOCK
FUNCTION_BLOCK FB 11
VAR_INPUT
 b : BOOL; w : WORD;
END_VAR
VAR_OUTPUT
 q : BOOL; o : INT;
END_VAR
VAR_IN_OUT
 x : INT;
END_VAR
VAR
 s : INT;
END_VAR
BEGIN
END_FUNCTION_BLOCK
FUNCTION_BLOCK FB 12
VAR_INPUT
 a : ANY; t : TIMER;
END_VAR
VAR_IN_OUT
 s : STRUCT m : INT; n : BOOL; END_STRUCT;
END_VAR
BEGIN
END_FUNCTION_BLOCK
FUNCTION_BLOCK FB 13
VAR_INPUT
 w : WORD;
END_VAR
VAR_OUTPUT
 o : WORD;
END_VAR
BEGIN
END_FUNCTION_BLOCK
DATA_BLOCK DB 10
FB 10
BEGIN
END_DATA_BLOCK
DATA_BLOCK DB 11
FB 11
BEGIN
END_DATA_BLOCK
DATA_BLOCK DB 12
FB 12
BEGIN
END_DATA_BLOCK
DATA_BLOCK DB 13
FB 13
BEGIN
END_DATA_BLOCK
DATA_BLOCK DB 4
SFB 4
BEGIN
END_DATA_BLOCK
DATA_BLOCK DB 5
STRUCT
 w : WORD; f : BOOL; i : INT; s : STRUCT m : INT; n : BOOL; END_STRUCT;
END_STRUCT
BEGIN
END_DATA_BLOCK
)";

// S7-FB-13, S7-PAR-03: AR2, then the VKE; parameters that are not supplied are left out.
constexpr Golden kWithDataBlock[] = {
    {"", "CALL FB 10, DB 10;",
     "BLD 3; = L 4.0; TDB; AUF DI 10; TAR2 LD 0; LAR2 P#DBX0.0; UC FB 10; LAR2 LD 0; TDB; BLD 4; "
     "BE"},
    {"VAR_TEMP\n f : BOOL;\nEND_VAR", "CALL FB 11, DB 11 (b := E 1.0, q := #f, x := MW 4);",
     "BLD 3; = L 5.0; TDB; AUF DI 11; TAR2 LD 1; U E 1.0; = DIX 0.0; L MW 4; T DIW 8; "
     "LAR2 P#DBX0.0; UC FB 11; LAR2 LD 1; U DIX 4.0; = L 0.0; L DIW 8; T MW 4; TDB; BLD 4; BE"},
    {"", "CALL FB 11, DB 11 (b := TRUE, w := W#16#10);",
     "BLD 3; = L 4.0; TDB; AUF DI 11; TAR2 LD 0; SET; = DIX 0.0; L 16; T DIW 2; LAR2 P#DBX0.0; "
     "UC FB 11; LAR2 LD 0; TDB; BLD 4; BE"},
    // the foreign block is opened as DI
    {"", "CALL FB 11, DB 11 (b := DB5.f, o := DB5.i, x := DB5.i);",
     "BLD 3; = L 4.0; TDB; AUF DI 11; TAR2 LD 0; AUF DI 5; U DIX 2.0; AUF DI 11; = DIX 0.0; "
     "AUF DI 5; L DIW 4; AUF DI 11; T DIW 8; LAR2 P#DBX0.0; UC FB 11; LAR2 LD 0; L DIW 6; "
     "AUF DI 5; T DIW 4; AUF DI 11; L DIW 8; AUF DI 5; T DIW 4; AUF DI 11; TDB; BLD 4; BE"},
    {"", "CALL FB 12, DB 12 (a := P#DB5.DBX0.0 BYTE 4, t := T 3, s := DB5.s);",
     "BLD 3; = L 4.0; TDB; AUF DI 12; TAR2 LD 0; L ANY#16#1002; T DIW 0; L 4; T DIW 2; L 5; "
     "T DIW 4; L P#DBX0.0; T DID 6; L 3; T DIW 10; L 5; T DIW 12; L P#DBX6.0; T DID 14; "
     "LAR2 P#DBX0.0; UC FB 12; LAR2 LD 0; TDB; BLD 4; BE"},
    {"", "CALL SFB 4, DB 4 (IN := E 0.0, PT := T#1S, Q := A 0.0);",
     "BLD 9; = L 4.0; TDB; AUF DI 4; TAR2 LD 0; U E 0.0; = DIX 0.0; L L#1000; T DID 2; "
     "LAR2 P#DBX0.0; UC SFB 4; LAR2 LD 0; U DIX 6.0; = A 0.0; TDB; BLD 10; BE"},
    // by the block that was open: no known block of STEP 7 has it
    {"", "CALL FB 13, DB 13 (w := DBW 2, o := DBW 4);",
     "BLD 3; = L 4.0; L DBNO; T LW 5; TDB; AUF DI 13; TAR2 LD 0; AUF DI [LW 5]; L DIW 2; "
     "AUF DI 13; T DIW 0; LAR2 P#DBX0.0; UC FB 13; LAR2 LD 0; L DIW 2; AUF DI [LW 5]; T DIW 4; "
     "AUF DI 13; TDB; BLD 4; BE"},
};

TEST(CallInstance, WithDataBlock) { expectCode(BlockKind::FC, kWithDataBlock, kInstances); }

// S7-PAR-10: own data of the calling FB are behind DB; multiple instances open the own data block
// again.
constexpr Golden kFromFunctionBlock[] = {
    {"VAR\n i : INT; first, second : FB 11;\nEND_VAR",
     "CALL #first (); CALL #second (x := #i, o := #i);",
     "BLD 14; = L 6.0; L DINO; T LW 4; TDB; AUF DI [LW 4]; TAR2 LD 0; +AR2 P#2.0; UC FB 11; "
     "LAR2 LD 0; TDB; BLD 15; "
     "BLD 14; = L 6.0; L DINO; T LW 4; TDB; AUF DI [LW 4]; TAR2 LD 0; L DBW [AR2,P#0.0]; "
     "T DIW [AR2,P#22.0]; +AR2 P#14.0; UC FB 11; LAR2 LD 0; L DIW [AR2,P#20.0]; "
     "T DBW [AR2,P#0.0]; L DIW [AR2,P#22.0]; T DBW [AR2,P#0.0]; TDB; BLD 15; BE"},
    {"VAR\n inst : FB 10;\nEND_VAR", "CALL #inst ();",
     "BLD 14; = L 6.0; L DINO; T LW 4; TDB; AUF DI [LW 4]; TAR2 LD 0; +AR2 P#0.0; UC FB 10; "
     "LAR2 LD 0; TDB; BLD 15; BE"},
    {"VAR\n t : SFB 4;\nEND_VAR", "CALL #t (IN := DB5.f, Q := DB5.f);",
     "BLD 16; = L 6.0; L DINO; T LW 4; TDB; AUF DI [LW 4]; TAR2 LD 0; AUF DI 5; U DIX 2.0; "
     "AUF DI [LW 4]; = DIX [AR2,P#0.0]; +AR2 P#0.0; UC SFB 4; LAR2 LD 0; U DIX [AR2,P#6.0]; "
     "AUF DI 5; = DIX 2.0; AUF DI [LW 4]; TDB; BLD 17; BE"},
    {"VAR\n w : WORD; t : FB 12;\nEND_VAR", "CALL #t (a := #w);",
     "BLD 14; = L 6.0; L DINO; T LW 4; TDB; AUF DI [LW 4]; TAR2 LD 0; L ANY#16#1004; "
     "T DIW [AR2,P#2.0]; L 1; T DIW [AR2,P#4.0]; L DBNO; T DIW [AR2,P#6.0]; +AR2 P#0.0; TAR2; "
     "LAR2 LD 0; T DID [AR2,P#8.0]; +AR2 P#2.0; UC FB 12; LAR2 LD 0; TDB; BLD 15; BE"},
    // element of an own IN_OUT structure
    {"VAR_IN_OUT\n s : STRUCT m : INT; d : WORD; END_STRUCT;\nEND_VAR\nVAR\n t : FB 13;\nEND_VAR",
     "CALL #t (w := #s.d);",
     "BLD 14; = L 6.0; L DINO; T LW 4; TDB; AUF DI [LW 4]; TAR2 LD 0; L DBW [AR2,P#0.0]; T LW 7; "
     "AUF DI [LW 7]; L DBD [AR2,P#2.0]; LAR1; TDB; L W [AR1,P#2.0]; TDB; AUF DI [LW 4]; "
     "T DIW [AR2,P#6.0]; +AR2 P#6.0; UC FB 13; LAR2 LD 0; TDB; BLD 15; BE"},
};

TEST(CallInstance, FromFunctionBlock) { expectCode(BlockKind::FB, kFromFunctionBlock, kInstances); }

// The interface of a system block may stand in the sources: those of an S7-400 (section 8). The CPU
// does not have it, and it is not part of the program.
TEST(CallInstance, SystemBlockDeclaredInTheSource) {
  const Compiled compiled = compileText(
      "FUNCTION_BLOCK SFB 12\nVAR_INPUT\n REQ : BOOL;\nEND_VAR\nVAR_OUTPUT\n DONE : BOOL;\n"
      "END_VAR\nBEGIN\nEND_FUNCTION_BLOCK\n"
      "FUNCTION_BLOCK FB 9\nVAR\n send : SFB 12;\nEND_VAR\nBEGIN\n"
      "CALL #send (REQ := M 0.0, DONE := M 0.1);\nEND_FUNCTION_BLOCK\n");
  EXPECT_EQ(compiled.problems(), std::vector<std::string>{"15:6 P0508"});
  EXPECT_EQ(codeOf(compiled, BlockKind::FB, 9),
            "BLD 16; = L 6.0; L DINO; T LW 4; TDB; AUF DI [LW 4]; TAR2 LD 0; U M 0.0; "
            "= DIX [AR2,P#0.0]; +AR2 P#0.0; UC SFB 12; LAR2 LD 0; U DIX [AR2,P#2.0]; = M 0.1; TDB; "
            "BLD 17; BE");
  EXPECT_EQ(compiled.result.program.count({BlockKind::SFB, 12}), 0u);
}

}  // namespace
}  // namespace merker::step7
