// AWL sources for STEP 7: order, names of operands, punctuation.
#include <gtest/gtest.h>

#include "exporting/awl_source.h"
#include "exporting/characters.h"
#include "exporting/step7.h"

namespace merker::exporting {
namespace {

const char* const kSymbols =
    "\"Start\"  E 0.0  BOOL  // push-button\n"
    "\"Speed\"  MW 10  INT\n"
    "\"Pause\"  T 1  TIMER\n"
    "\"Drive\"  FB 1  FB 1\n"
    "\"Motor\"  DB 5  FB 1\n"
    "\"Sub\"  FC 7  FC 7\n";

project::Project projectOf(const std::string& text) {
  project::Project project;
  Problems problems;
  source::readSymbols(source::SourceFile("s.sym", kSymbols), project.symbols, problems);
  EXPECT_TRUE(problems.empty());
  project.sources.emplace_back("a.awl", text);
  return project;
}

std::string function(const std::string& code) {
  return "FUNCTION FC 7 : VOID\nBEGIN\n" + code + "END_FUNCTION\n";
}

// The statements of one function after the export.
std::string exported(const std::string& code, Names names = Names::AsWritten,
                     bool punctuation = true) {
  const auto list = pieces(projectOf(function(code)), {names, punctuation});
  EXPECT_EQ(list.size(), 1u);
  const std::string& text = list.at(0).text;
  const std::size_t begin = text.find("BEGIN\n") + 6;
  return text.substr(begin, text.find("END_FUNCTION") - begin);
}

std::string orderOf(const std::string& text) {
  std::string order;
  for (const Piece& piece : ordered(pieces(projectOf(text), {})))
    order += (order.empty() ? "" : ", ") + toString(piece.id);
  return order;
}

TEST(AwlPunctuation, everyStatementEndsWithASemicolon) {
  EXPECT_EQ(exported("NETWORK\nTITLE = a; b\nU E 0.0 // x\nM1: = A 0.0;\nU(\nO E 0.1\n)\n"),
            "NETWORK\nTITLE = a; b\nU E 0.0; // x\nM1: = A 0.0;\nU(;\nO E 0.1;\n);\n");
  EXPECT_EQ(exported("U( O E 0.0\n)\nL ';'\nSPA\nM1\nM1: NOP 0\n"),
            "U(; O E 0.0;\n);\nL ';';\nSPA\nM1;\nM1: NOP 0;\n");
}

TEST(AwlPunctuation, listsOfParametersHaveBracketsAndCommas) {
  EXPECT_EQ(exported("CALL FC 1\nIN := 1 // one\n#OUT := MW 2\nL 1\n"),
            "CALL FC 1 (\nIN := 1, // one\n#OUT := MW 2);\nL 1;\n");
  EXPECT_EQ(exported("CALL FC 1 (A := 1\nB := P#DB5.DBX 0.0 BYTE 4)\nCALL FC 2\nU E 0.0\n"),
            "CALL FC 1 (A := 1,\nB := P#DB5.DBX 0.0 BYTE 4);\nCALL FC 2;\nU E 0.0;\n");
  const std::string complete = "CALL FB 1 , DB 1 (\n  A := 1,\n  B := '(,)');\n";
  EXPECT_EQ(exported(complete), complete);
}

TEST(AwlNames, symbolsBecomeAbsolute) {
  EXPECT_EQ(
      exported("U \"Start\";\nT \"Speed\";\nSE \"Pause\";\nAUF DI \"Motor\";\nAUF \"Motor\";\n",
               Names::Absolute),
      "U E 0.0;\nT MW 10;\nSE T 1;\nAUF DI 5;\nAUF DB 5;\n");
  // No absolute form; names of the block; comments and texts.
  const std::string kept =
      "L \"Motor\".speed;\nL #\"Start\";\nU E 1.0; // \"Start\"\n(* \"Start\" *) L '\"Start\"';\n";
  EXPECT_EQ(exported(kept, Names::Absolute), kept);
}

TEST(AwlNames, theMnemonicsAreThoseOfTheSource) {
  EXPECT_EQ(exported("A \"Start\";\nAN \"Start\";\n", Names::Absolute), "A I 0.0;\nAN I 0.0;\n");
}

TEST(AwlNames, absoluteOperandsBecomeSymbols) {
  EXPECT_EQ(exported("U E 0.0;\nT MW10;\nSE T 1;\nAUF DB 5;\nL DB5.speed;\nCALL FB 1, DB 5;\n",
                     Names::Symbolic),
            "U \"Start\";\nT \"Speed\";\nSE \"Pause\";\nAUF \"Motor\";\nL \"Motor\".speed;\n"
            "CALL \"Drive\", \"Motor\";\n");
  const std::string kept =
      "T1: L DB5.DBW 2;\nSPA T1;\nL MW [MW 10];\nL #a.T1;\nL P#E 0.0;\nL W#16#10;\nL E 0.00001; // "
      "E 0.0\n";
  EXPECT_EQ(exported(kept, Names::Symbolic), kept);
}

TEST(AwlNames, whatFollowsAnIndirectOperandIsReplaced) {
  EXPECT_EQ(exported("CALL FC 1 (A := W [AR1,P#2.0], B := MW 10);\n", Names::Symbolic),
            "CALL FC 1 (A := W [AR1,P#2.0], B := \"Speed\");\n");
}

TEST(AwlMnemonics, aSourceIsTranslated) {
  const auto in = [](const std::string& code, Mnemonics mnemonics) {
    return pieces(projectOf(function(code)), {Names::AsWritten, true, mnemonics}).at(0).text;
  };
  const std::string german =
      "U(;\nUN E 0.0;\nU A [MD 4];\n);\nL PEW [AR1,P#2.0];\nL P#A 1.0;\nZV Z 1;\nSPB E1;\n"
      "L #E1;\nL C#10;\nU BIE;\nE1: T PAW 4; // E 0.0\nSE T 1;\nCALL FC 1 (E := EB 1);\n";
  const std::string international =
      "A(;\nAN I 0.0;\nA Q [MD 4];\n);\nL PIW [AR1,P#2.0];\nL P#Q 1.0;\nCU C 1;\nJC E1;\n"
      "L #E1;\nL C#10;\nA BR;\nE1: T PQW 4; // E 0.0\nSD T 1;\nCALL FC 1 (E := IB 1);\n";
  EXPECT_EQ(in(german, Mnemonics::International), function(international));
  EXPECT_EQ(in(international, Mnemonics::German), function(german));
  EXPECT_EQ(in(german, Mnemonics::German), function(german));
}

TEST(AwlNames, headersAndTypesBecomeAbsolute) {
  const auto list = pieces(projectOf("DATA_BLOCK \"Motor\"\n\"Drive\"\nBEGIN\nEND_DATA_BLOCK\n"),
                           {Names::Absolute, true});
  EXPECT_EQ(list.at(0).text, "DATA_BLOCK DB 5\nFB 1\nBEGIN\nEND_DATA_BLOCK\n");
}

// What a block names stands before it; OB last.
TEST(AwlOrder, calleeBeforeCaller) {
  EXPECT_EQ(
      orderOf("ORGANIZATION_BLOCK OB 1\nBEGIN\nCALL \"Sub\";\nEND_ORGANIZATION_BLOCK\n"
              "FUNCTION FC 7 : VOID\nBEGIN\nCALL \"Drive\", \"Motor\";\nL DB2.x;\nEND_FUNCTION\n"
              "DATA_BLOCK DB 5\nFB 1\nBEGIN\nEND_DATA_BLOCK\n"
              "FUNCTION_BLOCK FB 1\nVAR\na : UDT 3;\nEND_VAR\nBEGIN\nEND_FUNCTION_BLOCK\n"
              "DATA_BLOCK DB 2\nUDT 3\nBEGIN\nEND_DATA_BLOCK\n"
              "TYPE UDT 3\nSTRUCT\nx : INT;\nEND_STRUCT;\nEND_TYPE\n"),
      "UDT 3, FB 1, DB 5, DB 2, FC 7, OB 1");
}

TEST(AwlOrder, blocksThatCallEachOtherComeOnce) {
  EXPECT_EQ(orderOf("FUNCTION FC 1 : VOID\nBEGIN\nCALL FC 2;\nEND_FUNCTION\n"
                    "FUNCTION FC 2 : VOID\nBEGIN\nCALL FC 1;\n// FC 9\nEND_FUNCTION\n"),
            "FC 2, FC 1");
}

TEST(AwlPieces, commentsBeforeAndBehindBlocksStay) {
  const auto list = pieces(projectOf("// head\r\n" + function("NOP 0;\n") + "// between\n" +
                                     function("NOP 1;\n") + "// end"),
                           {});
  ASSERT_EQ(list.size(), 2u);
  EXPECT_TRUE(list[0].text.starts_with("// head\nFUNCTION"));
  EXPECT_TRUE(list[1].text.starts_with("// between\nFUNCTION"));
  EXPECT_TRUE(list[1].text.ends_with("// end"));
}

// FC 7 with an operation that is not in its source any more.
TEST(AwlSource, whatGivesOtherBlocksIsNotWritten) {
  compilation::Build build = compilation::build(projectOf(function("U E 0.0;\n= A 0.0;\n")), false);
  ASSERT_TRUE(build.ok());
  EXPECT_EQ(writeAwl(build, "p.awl", {}).files.size(), 2u);
  block::Program program = *build.program;
  program.begin()->second.code[1] ^= 1;
  build.program = std::make_shared<const block::Program>(program);
  const Output output = writeAwl(build, "p.awl", {});
  EXPECT_TRUE(output.files.empty());
  ASSERT_EQ(output.warnings.size(), 1u);
  EXPECT_EQ(output.warnings[0], "error: no source gives the same blocks again; export .wld");
}

TEST(Characters, eachMissingOneIsNamedOnceWithItsPlace) {
  const auto warnings = missingIn(1252, projectOf("// Größe €\n// ж я\n// ж\n"));
  ASSERT_EQ(warnings.size(), 2u);
  EXPECT_EQ(warnings[0],
            "a.awl:2:4: warning: 'ж' is not in code page 1252 and is written as '?' (2 times)");
  EXPECT_EQ(warnings[1],
            "a.awl:2:6: warning: 'я' is not in code page 1252 and is written as '?' (1 time)");
}

TEST(Characters, thePageIsTheOneThatHasMostOfThem) {
  EXPECT_EQ(pageOf(projectOf("// pump\n")), 1252u);
  EXPECT_EQ(pageOf(projectOf("// Größe €\n")), 1252u);
  EXPECT_EQ(pageOf(projectOf("// Насос °C €\n")), 1251u);
  EXPECT_EQ(pageOf(projectOf("// ısıtıcı ö\n")), 1254u);
  EXPECT_EQ(pageOf(projectOf("// zawór łańcuch\n")), 1250u);
  EXPECT_EQ(pageOf(projectOf("// 水泵\n")), 936u);
  EXPECT_EQ(missingIn(1251, projectOf("// Насос ö\n")).size(), 1u);
}

}  // namespace
}  // namespace merker::exporting
