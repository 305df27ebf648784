#include "importing/report.h"

#include <gtest/gtest.h>

#include "../archive_zip.h"
#include "importing/output.h"

namespace merker::importing {
namespace {

TEST(Report, whatIsLostStandsLast) {
  Report report;
  report.add(Note::NoCode, "FC 1");
  report.add(Note::Symbols, 3);
  report.add(Note::UnknownPage, "Plant");
  EXPECT_EQ(report.text(),
            "Imported:\n  3 symbols\n\n"
            "In another form:\n  Plant does not name its code page; 1252 is assumed\n\n"
            "Not imported:\n  FC 1 has no code or its code is cut off\n");
  EXPECT_EQ(report.count(Effect::Lost), 1u);
}

TEST(Report, aFileBesideIsNoLoss) {
  Report report;
  report.add(Note::UnknownFile, "letter.pdf");
  EXPECT_FALSE(report.lost());
  EXPECT_EQ(report.text(),
            "Beside it, not part of a program:\n  letter.pdf is not a file that can be imported\n");
}

TEST(Report, textsOfASourceAreNoPatterns) {
  Report report;
  report.add(Note::NoCode, "{0} {");
  EXPECT_NE(report.text().find("{0} { has no code"), std::string::npos);
}

TEST(Report, namesOfASourceReachNoTerminal) {
  Report report;
  report.add(Note::NoCode, "FC \x1B[31m\n\x9B");
  EXPECT_NE(report.text().find("FC \\x1B[31m\\x0A\\x9B has no code"), std::string::npos);
}

TEST(Report, whatIsLeftOutIsCounted) {
  Report report;
  for (int i = 0; i < 20'002; ++i) report.add(Note::NoCode, "FC 1");
  EXPECT_TRUE(report.text().ends_with("  and 2 more\n"));
}

TEST(Output, namesAreHarmlessAndUnique) {
  Report report;
  const TestFolder folder;
  Output output(folder.path("out"), report);
  EXPECT_EQ(output.unused("S7 Program(1)", ""), "S7 Program(1)");
  EXPECT_EQ(output.unused("s7 program(1)", ""), "s7 program(1) 2");
  EXPECT_EQ(output.unused("../../etc/passwd", ".txt"), "_.._etc_passwd.txt");
  EXPECT_EQ(output.unused("..", ""), "unnamed");
  EXPECT_EQ(output.unused("Füllstand", ".txt"), "Füllstand.txt");
  EXPECT_EQ(output.unused(std::string(500, 'x'), "").size(), 60u);
}

TEST(Output, writesNoFileTwice) {
  Report report;
  const TestFolder folder;
  Output output(folder.path("out"), report);
  EXPECT_TRUE(output.write("a.txt", "one"));
  EXPECT_FALSE(output.write("a.txt", "two"));
  EXPECT_EQ(folder.read("out/a.txt"), "one");
  EXPECT_EQ(report.count(Effect::Lost), 1u);
}

}  // namespace
}  // namespace merker::importing
