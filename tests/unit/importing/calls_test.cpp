// The sequences that STEP 7 makes of CALL come back as CALL.
#include <gtest/gtest.h>

#include "../archive_zip.h"
#include "../s7p_files.h"
#include "importing/import.h"
#include "step7/compiler.h"

namespace merker::importing {
namespace {

// A block FC 9 or FB 9 with these statements beside the blocks that it calls.
const std::string kCalled =
    "FUNCTION FC 1 : INT\nVAR_INPUT\nX : INT;\nB : BOOL;\nT1 : TIMER;\nR : REAL;\nEND_VAR\n"
    "VAR_OUTPUT\nY : WORD;\nEND_VAR\nVAR_IN_OUT\nZ : BOOL;\nEND_VAR\nBEGIN\nNOP 0;\nEND_FUNCTION\n"
    "FUNCTION FC 2 : VOID\nVAR_INPUT\nP : ANY;\nEND_VAR\nBEGIN\nNOP 0;\nEND_FUNCTION\n"
    "FUNCTION FC 3 : VOID\nBEGIN\nNOP 0;\nEND_FUNCTION\n"
    "FUNCTION_BLOCK FB 1\nVAR_INPUT\nX : INT;\nB : BOOL;\nEND_VAR\nVAR_OUTPUT\nY : "
    "INT;\nEND_VAR\nVAR\nS : INT;\nEND_VAR\n"
    "BEGIN\nNOP 0;\nEND_FUNCTION_BLOCK\n"
    "DATA_BLOCK DB 1\nFB 1\nBEGIN\nEND_DATA_BLOCK\n"
    "DATA_BLOCK DB 5\nSTRUCT\nA : INT;\nB : BOOL;\nW : WORD;\nEND_STRUCT;\nBEGIN\nEND_DATA_BLOCK\n";

std::string imported(const std::string& block, BlockId id, int language = 1) {
  const auto compiled = step7::compile({source::SourceFile("a.awl", kCalled + block)}, {});
  EXPECT_TRUE(compiled.ok()) << compiled.problems.list().front().message;
  s7p_files::Project project;
  s7p_files::BlockFolder::Extra extra;
  extra.language = language;
  for (const auto& [number, stored] : compiled.program) project.blocks.add(stored, extra);
  const TestFolder folder;
  for (const auto& [name, bytes] : project.files()) folder.write("in/" + name, bytes);
  const Outcome outcome = importSource({folder.path("in"), folder.path("out"), ""});
  const std::string file = std::string(name(id.kind)) + std::to_string(id.number);
  EXPECT_FALSE(folder.has("out/" + file + ".mc7")) << folder.read("out/" + file + ".awl");
  return folder.read("out/" + file + ".awl");
}

std::string function(const std::string& statements) {
  return imported(
      "FUNCTION FC 9 : VOID\nVAR_INPUT\nI : INT;\nEND_VAR\nVAR_TEMP\nt : "
      "INT;\nEND_VAR\nBEGIN\nNETWORK\n" +
          statements + "\nEND_FUNCTION\n",
      {BlockKind::FC, 9});
}

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(Calls, aFunctionWithAllKindsOfActuals) {
  const std::string text = function(
      "U E 0.0;\nCALL FC 1 (X := 5, B := M 1.0, T1 := T 7, R := 1.5, RET_VAL := #t, Y := DB5.DBW "
      "4, Z := DB5.DBX 2.0);\n"
      "CALL FC 1 (X := #I, B := TRUE, T1 := T 8, R := MD 20, RET_VAL := MW 2, Y := AW 4, Z := M "
      "3.0);\nCALL FC 3;");
  EXPECT_TRUE(has(text, "CALL  FC 1 (")) << text;
  EXPECT_TRUE(has(text, "IN0 := 5,")) << text;
  EXPECT_TRUE(has(text, "IN2 := T 7,")) << text;
  EXPECT_TRUE(has(text, "RET_VAL := #TEMP0,")) << text;
  EXPECT_TRUE(has(text, "OUT0 := DB5.DBW 4,")) << text;
  EXPECT_TRUE(has(text, "IN_OUT0 := DB5.DBX 2.0)")) << text;
  EXPECT_TRUE(has(text, "CALL  FC 3;")) << text;
  EXPECT_FALSE(has(text, "BLD")) << text;
}

// Section 8 of the code patterns: UC of an FC has the empty list.
TEST(Calls, aPlainCallHasNoList) {
  const std::string text = function("UC FC 3;\nUC FB 1;");
  EXPECT_TRUE(has(text, "UC    FC 3;")) << text;
  EXPECT_FALSE(has(text, "SPA")) << text;
}

TEST(Calls, anAny) {
  const std::string text =
      function("CALL FC 2 (P := P#DB5.DBX 0.0 BYTE 4);\nCALL FC 2 (P := P#M 10.0 WORD 2);");
  EXPECT_TRUE(has(text, "IN0 := P#DB5.DBX 0.0 BYTE 4)")) << text;
  EXPECT_FALSE(has(text, "BLD")) << text;
}

TEST(Calls, aFunctionBlockWithItsDataBlock) {
  const std::string text =
      function("CALL FB 1, DB 1 (X := MW 4, B := FALSE, Y := #t);\nCALL FB 1, DB 1;");
  EXPECT_TRUE(has(text, "CALL  FB 1, DB 1 (")) << text;
  EXPECT_TRUE(has(text, "IN0 := MW 4,")) << text;
  EXPECT_TRUE(has(text, "CALL  FB 1, DB 1;")) << text;
  EXPECT_FALSE(has(text, "BLD")) << text;
}

TEST(Calls, aMultipleInstance) {
  const std::string text = imported(
      "FUNCTION_BLOCK FB 9\nVAR_INPUT\nI : INT;\nEND_VAR\nVAR\ninst : FB 1;\nsum : "
      "INT;\nEND_VAR\nBEGIN\nNETWORK\n"
      "CALL #inst (X := #I, B := M 1.0, Y := #sum);\nEND_FUNCTION_BLOCK\n",
      {BlockKind::FB, 9});
  EXPECT_TRUE(has(text, "CALL  #STAT1 (")) << text;
  EXPECT_TRUE(has(text, "IN0 := #IN0,")) << text;
  EXPECT_FALSE(has(text, "BLD")) << text;
}

// A block that is called and missing: nobody knows its parameters.
TEST(Calls, theReportNamesAMissingCallee) {
  const auto compiled = step7::compile(
      {source::SourceFile("a.awl", kCalled + "FUNCTION FC 9 : VOID\nBEGIN\nCALL FC 2 (P := MW 0);\n"
                                             "END_FUNCTION\n")},
      {});
  s7p_files::Project project;
  project.blocks.add(compiled.program.at({BlockKind::FC, 9}));
  const TestFolder folder;
  for (const auto& [name, bytes] : project.files()) folder.write("in/" + name, bytes);
  const Outcome outcome = importSource({folder.path("in"), folder.path("out"), ""});
  EXPECT_TRUE(has(outcome.report, "(it calls FC 2, whose parameters are not known or are others)"))
      << outcome.report;
}

// The places of a network in KOP are not those of a block in AWL: the source says so.
TEST(Calls, inNetworksOfKop) {
  const std::string text = imported(
      "FUNCTION FC 9 : VOID\nBEGIN\n//# KOP\nNETWORK\nU M 0.0; = L 0.0; BLD 103; CALL FC 3;\n"
      "NETWORK\nCALL FC 3;\nEND_FUNCTION\n",
      {BlockKind::FC, 9}, 2);
  EXPECT_TRUE(has(text, "BEGIN\n//# KOP\nNETWORK\n")) << text;
  EXPECT_TRUE(has(text, "CALL  FC 3;")) << text;
}

// Where both forms give the same bytes, the source keeps the language.
TEST(Calls, ofABlockInFup) {
  const std::string text =
      imported("FUNCTION FC 9 : VOID\nBEGIN\n//# FUP\nNETWORK\nU M 0.0; = M 0.1;\nEND_FUNCTION\n",
               {BlockKind::FC, 9}, 3);
  EXPECT_TRUE(has(text, "BEGIN\n//# FUP\nNETWORK\n")) << text;
}

// The editor counts the lines of CALL, also where only its instructions give the same bytes.
TEST(Calls, commentsBehindACallThatIsWrittenAsInstructions) {
  const auto compiled = step7::compile(
      {source::SourceFile("a.awl", kCalled +
                                       "FUNCTION FC 9 : VOID\nBEGIN\n//# KOP\nNETWORK\nT LW 4;\n"
                                       "NETWORK\nCALL FB 1, DB 1 (X := 1);\nU E 0.1;\n"
                                       "END_FUNCTION\n")},
      {});
  s7p_files::BlockFolder::Extra calling;
  calling.networks = {{"", "", {}}, {"", "", {{3, 0x80, "input"}}}};
  s7p_files::Project project;
  for (const auto& [id, stored] : compiled.program)
    id.number == 9 ? project.blocks.add(stored, calling) : project.blocks.add(stored);
  const TestFolder folder;
  for (const auto& [name, bytes] : project.files()) folder.write("in/" + name, bytes);
  (void)importSource({folder.path("in"), folder.path("out"), ""});
  const std::string text = folder.read("out/FC9.awl");
  EXPECT_TRUE(has(text, "BLD   3;")) << text;
  const std::size_t statement = text.find("U     E 0.1;");
  ASSERT_NE(statement, std::string::npos) << text;
  EXPECT_TRUE(has(text.substr(statement, text.find('\n', statement) - statement), "//input"))
      << text;
}

}  // namespace
}  // namespace merker::importing
