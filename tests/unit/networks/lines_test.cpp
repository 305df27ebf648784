// Which lines of a network stay when its statements change, as a user sees them in the editor.
#include <gtest/gtest.h>

#include "networks/text.h"

namespace merker::networks {
namespace {

std::string blockOf(const std::string& network) {
  return "FUNCTION FC 1 : VOID\nBEGIN\nNETWORK\nTITLE =\n" + network + "\nEND_FUNCTION\n";
}

std::string numbered(const TextEdit& edit) {
  std::string out = std::to_string(edit.from - 4) + "-" + std::to_string(edit.to - 4) + "\n";
  for (const std::string& line : edit.lines) out += line + "\n";
  return out;
}

// The statements of `now` in the lines of `old`: lines from-to of the network, and what they
// become.
std::string changed(const std::string& old, const std::string& now) {
  const source::SourceFile file("a.awl", blockOf(old)), other("b.awl", blockOf(now));
  const auto found = findBlock(file, 1, {}), wanted = findBlock(other, 1, {});
  const graph::SourceNetwork& network = found->block.networks[0].source;
  const Style style = found->text->style();
  return numbered(spliced({file,
                           network,
                           wanted->block.networks[0].source.statements,
                           style,
                           found->text->writer(style),
                           {"_001"}}));
}

const char* const kComments =
    "      U     E 0.0;   // the start button\n"
    "      // both hands\n"
    "      U     E 0.1;   // the other one\n"
    "      =     A 0.0;   // the press\n";

TEST(Lines, stayWhereNothingChanges) {
  EXPECT_EQ(changed(kComments, "U E 0.0; U E 0.1; = A 0.0;"), "5-5\n");
}

TEST(Lines, ofAnOperandThatChangesKeepTheirComment) {
  EXPECT_EQ(changed(kComments, "U E 0.0; U E 0.5; = A 0.0;"),
            "3-4\n      U     E 0.5;   // the other one\n");
  EXPECT_EQ(changed(kComments, "U E 0.0; U \"A long name\"; = A 0.0;"),
            "3-4\n      U     \"A long name\"; // the other one\n");
}

TEST(Lines, ofNewStatementsStandBetweenTheOthers) {
  EXPECT_EQ(changed(kComments, "U E 0.0; U E 0.1; ON M 1.0; = A 0.0;"),
            "4-4\n      ON    M 1.0;\n");
}

TEST(Lines, ofCommentsStayWhenAStatementGoes) {
  EXPECT_EQ(changed(kComments, "U E 0.0; = A 0.0;"), "3-4\n");
  EXPECT_EQ(changed(kComments, "U E 0.1; = A 0.0;"), "1-2\n");
}

TEST(Lines, withSeveralStatementsAreWrittenAnewIfOneChanges) {
  EXPECT_EQ(changed("  U E 0.0; U E 0.1; = A 0.0; // all\n", "U E 0.0; = A 0.0;"),
            "1-2\n  U E 0.0;\n      = A 0.0;               // all\n");
}

TEST(Lines, keepTheLabelAtTheBeginning) {
  EXPECT_EQ(changed("M1:   U     E 0.0;\n      =     A 0.0;\n", "U E 0.5; U E 0.0; = A 0.0;"),
            "1-2\nM1:   U     E 0.5;\n      U     E 0.0;\n");
  EXPECT_EQ(changed("M1:   U     E 0.0;\n      =     A 0.0;\n", "U E 0.5; = A 0.0;"),
            "1-2\nM1:   U     E 0.5;\n");
}

// _001 is taken.
TEST(Lines, ofBoxesGetLabelsThatAreFree) {
  EXPECT_EQ(changed("      U     E 0.0;\n      =     A 0.0;\n",
                    "U E 0.0; SPBNB x; L 1; T MW 2; x: NOP 0;"),
            "2-3\n      SPBNB _002;\n      L     1;\n      T     MW 2;\n_002: NOP   0;\n");
}

TEST(Lines, ofBoxesLoseLabelsThatNobodyNeeds) {
  EXPECT_EQ(changed("      U     E 0.0;\n      SPBNB _001;\n      L     1;\n      T     MW 2;\n"
                    "_001: NOP   0;\n",
                    "L 1; T MW 2; NOP 0;"),
            "1-6\n      L     1;\n      T     MW 2;\n      NOP   0;\n");
}

TEST(Lines, ofACallStayTogether) {
  const std::string call = "      CALL  FC 2 (\n        A := E 0.0, // in\n        B := A 0.0);\n";
  EXPECT_EQ(changed(call, "CALL FC 2 (A := E 0.0, B := A 0.0); NOP 0;"), "4-4\n      NOP   0;\n");
  EXPECT_EQ(changed(call, "CALL FC 2 (A := E 0.7, B := A 0.0);"), "2-3\n        A := E 0.7,\n");
}

}  // namespace
}  // namespace merker::networks
