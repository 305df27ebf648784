// Formal parameters in a block (S7-IND-09, S7-PAR-03), the end of a block, shared symbols without
// quotation marks and calls without parameters (code patterns, sections 4, 5 and 8). Written from
// the rules by hand.
#include <gtest/gtest.h>

#include "golden.h"

namespace merker::step7 {
namespace {

constexpr const char* kStructure = "STRUCT m : INT; n : BOOL; d : DWORD; END_STRUCT";

std::string with(const char* section) {
  return std::string(section) + "\n s : " + kStructure + ";\nEND_VAR\n";
}

std::string codeIn(BlockKind kind, const std::string& declarations, const char* statements) {
  return compiledIn(kind, {declarations.c_str(), statements, ""}, "");
}

TEST(ParameterAccess, ElementaryInFunction) {
  EXPECT_EQ(codeIn(BlockKind::FC,
                   "VAR_INPUT\n b : BOOL; w : WORD; t : TIMER; c : COUNTER; d : BLOCK_DB; a : "
                   "ANY;\nEND_VAR\nVAR_OUTPUT\n q : BOOL;\nEND_VAR",
                   "U #b; = #q; L #w; L #t; U #c; AUF #d; L P##a;"),
            "U #P0; = #P6; L W #P1; L T #P2; U Z #P3; AUF DB #P4; L P##P5; BE");
}

// BLD 5, every access anew.
TEST(ParameterAccess, ElementOfComplexParameterInFunction) {
  const std::string way =
      "BLD 5; T LD 3; TAK; T LD 7; L P##P0; LAR1; L W [AR1,P#0.0]; T LW 1; AUF DB [LW 1]; "
      "L D [AR1,P#2.0]; LAR1; L LD 7; L LD 3; ";
  EXPECT_EQ(codeIn(BlockKind::FC, with("VAR_IN_OUT") + "VAR_TEMP\n f : BOOL;\nEND_VAR",
                   "L #s.m; S #s.n; T #s.d;"),
            way + "L W [AR1,P#0.0]; " + way + "S [AR1,P#2.0]; " + way + "T D [AR1,P#4.0]; BE");
}

// BLD 18.
TEST(ParameterAccess, ElementOfInOutInFunctionBlock) {
  const std::string way =
      "BLD 18; T LD 0; TAK; T LD 4; L DIW [AR2,P#2.0]; T LW 8; AUF DB [LW 8]; "
      "L DID [AR2,P#4.0]; LAR1; L LD 4; L LD 0; ";
  EXPECT_EQ(codeIn(BlockKind::FB, "VAR_INPUT\n i : INT;\nEND_VAR\n" + with("VAR_IN_OUT"),
                   "U #s.n; T #s.m; L P##i;"),
            way + "U [AR1,P#2.0]; " + way + "T W [AR1,P#0.0]; L P#DIX0.0; BE");
}

// Before every use, without BLD.
TEST(ParameterAccess, NumberInFunctionBlock) {
  const auto way = [](const char* offset) {
    return "T LD 0; TAK; T LD 4; L DIW [AR2,P#" + std::string(offset) +
           "]; T LW 8; L LD 4; L LD 0; ";
  };
  EXPECT_EQ(codeIn(BlockKind::FB,
                   "VAR_INPUT\n t : TIMER; c : COUNTER; d : BLOCK_DB; f : BLOCK_FC;\nEND_VAR",
                   "SE #t; UN #t; ZV #c; AUF #d; UC #f;"),
            way("0.0") + "SE T [LW 8]; " + way("0.0") + "UN T [LW 8]; " + way("2.0") +
                "ZV Z [LW 8]; " + way("4.0") + "AUF DB [LW 8]; " + way("6.0") +
                "UC FC [LW 8]; SPA 2; BE");
}

// Section 5: the compiler adds BE, whatever the source ends with.
TEST(BlockEnd, IsAlwaysAdded) {
  EXPECT_EQ(codeIn(BlockKind::FC, "", "SET; BE;"), "SET; BE; BE");
  EXPECT_EQ(codeIn(BlockKind::FC, "", "SET; BEA;"), "SET; BEA; BE");
  EXPECT_EQ(codeIn(BlockKind::FC, "", "SET; BEB;"), "SET; BEB; BE");
  EXPECT_EQ(codeIn(BlockKind::FC, "", ""), "BE");
}

// Section 8: UC of a block that has parameters gives it none.
TEST(CallWithoutParameters, OfBlocksThatHaveParameters) {
  EXPECT_EQ(compiledIn(BlockKind::FC, {"", "UC FC 8; UC FB 8;", ""},
                       "FUNCTION FC 8 : VOID\nVAR_INPUT\n i : INT;\nEND_VAR\nBEGIN\nEND_FUNCTION\n"
                       "FUNCTION_BLOCK FB 8\nVAR_INPUT\n i : INT;\nEND_VAR\nBEGIN\n"
                       "END_FUNCTION_BLOCK\n"),
            "UC FC 8; SPA 2; UC FB 8; BE");
}

}  // namespace
}  // namespace merker::step7
