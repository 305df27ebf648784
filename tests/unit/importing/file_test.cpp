#include <gtest/gtest.h>

#include "../archive_zip.h"
#include "block/container.h"
#include "compilation/build.h"
#include "importing/import.h"
#include "importing/look.h"
#include "importing/recognise.h"
#include "step7/compiler.h"

namespace merker::importing {
namespace {

const std::string kSource =
    "FUNCTION FC 5 : VOID\nBEGIN\nU \"Schalter\";\n= A 4.0;\nEND_FUNCTION\n";

std::string container() {
  const auto program =
      step7::compile(
          {source::SourceFile("a.awl",
                              "FUNCTION FC 7 : VOID\nBEGIN\nU E 0.0;\n= A 4.0;\nEND_FUNCTION\n"
                              "DATA_BLOCK DB 3\nSTRUCT\na : INT := 5;\nEND_STRUCT;\nBEGIN\n"
                              "END_DATA_BLOCK\n")},
          {})
          .program;
  std::string bytes;
  for (const auto& [id, block] : program)
    for (const std::uint8_t byte : block::writeContainer(block)) bytes += static_cast<char>(byte);
  return bytes;
}

Kind kindOf(const std::string& text, std::string_view path = "file") {
  return recognise(*archive::fileOf({text.begin(), text.end()}), path);
}

// Issue: recognised by content, not by name.
TEST(Recognise, byContent) {
  EXPECT_EQ(kindOf(kSource), Kind::AwlSource);
  EXPECT_EQ(kindOf("// comment\r\n\r\n  data_block \"x\"\r\n"), Kind::AwlSource);
  EXPECT_EQ(kindOf(container()), Kind::Containers);
  EXPECT_EQ(kindOf("\"Motor                   \",\"A       1.0 \",\"BOOL      \",\"drives\"\r\n"),
            Kind::Sdf);
  EXPECT_EQ(kindOf("\"Motor                   \",\"A       1.0 \",\"BOOL      \",\"drives\"\r\n" +
                   std::string(3, '\0')),
            Kind::Sdf);
  EXPECT_EQ(kindOf("126,Motor                   A       1.0 BOOL      drives\r\n"), Kind::Asc);
  EXPECT_EQ(kindOf("TABLE\n0,1\n\"x\"\n"), Kind::Dif);
  EXPECT_EQ(kindOf("\tA 1.0\tMotor\tdrives\n"), Kind::Seq);
  EXPECT_EQ(kindOf("FILEVERSION \"3.2\"\n#STEP7_VERSION V5.5\n"), Kind::Hardware);
  EXPECT_EQ(kindOf("Dear reader,\nthis is a letter.\n"), Kind::Unknown);
  EXPECT_EQ(kindOf(std::string("\0\1\2\3", 4)), Kind::Unknown);
  EXPECT_EQ(kindOf(""), Kind::Unknown);
}

TEST(Recognise, listingsOfStep5) {
  EXPECT_EQ(kindOf("! a pump\r\nOB 1\r\n SPA PB 5\r\n BE\r\n"), Kind::Listing);
  EXPECT_EQ(kindOf("FB 7 VENTIL\n : U E 1.0\n : BE\n"), Kind::Listing);
  EXPECT_EQ(kindOf("DB10\n  0: KF +5\n"), Kind::Listing);
  EXPECT_EQ(kindOf("PB 5\nis the pump\n"), Kind::Unknown);
  EXPECT_EQ(kindOf("DBX 5\n : BE\n"), Kind::Unknown);
  EXPECT_EQ(kindOf("\tE 1.0\tSTART\n", "a/PUMPEZ0.SEQ"), Kind::Assignments);
  EXPECT_EQ(kindOf("  E 1.0     START     Taster\r\n", "PUMPEZ0.SEQ"), Kind::Assignments);
  EXPECT_EQ(kindOf("\tE 1.0\tSTART\n", "PUMPE.SEQ"), Kind::Seq);
}

TEST(Files, sourcesAndSymbolsBecomeAProject) {
  const TestFolder folder;
  folder.write("in/a.txt",
               "// \xDC"
               "bung\r\n" +
                   kSource);
  folder.write("in/names", "\tE 1.0\tSchalter\tT\xFCr\r\n");
  folder.write("in/letter.doc", "Dear reader");
  const Outcome outcome = importSource({folder.path("in"), folder.path("out"), ""});
  ASSERT_EQ(outcome.result, Result::Imported);
  const auto build = compilation::build(project::load(folder.path("out"), ""), false);
  EXPECT_TRUE(build.ok()) << outcome.report;
  EXPECT_TRUE(build.program->contains({BlockKind::FC, 5}));
  EXPECT_NE(folder.read("out/a.awl").find("Übung"), std::string::npos);
  EXPECT_FALSE(folder.has("out/letter.doc"));
}

TEST(Files, aWldFileIsAChainOfBlocks) {
  const TestFolder folder;
  folder.write("card.wld", container());
  const Outcome outcome = importSource({folder.path("card.wld"), folder.path("out"), ""});
  ASSERT_EQ(outcome.result, Result::Imported);
  const auto build = compilation::build(project::load(folder.path("out"), ""), false);
  EXPECT_TRUE(build.ok()) << outcome.report;
  EXPECT_TRUE(build.program->contains({BlockKind::FC, 7}));
  EXPECT_EQ(build.program->at({BlockKind::DB, 3}).actualData, (std::vector<std::uint8_t>{0, 5}));
  EXPECT_FALSE(outcome.lost);
}

// A zip that the workbench gave to download: all its files, as they were.
TEST(Files, aProjectOfMerkerComesAsItWas) {
  const TestFolder folder;
  const std::map<std::string, std::string> files{
      {"plant/merker.toml", "[project]\nname = \"Plant\"\n"},
      {"plant/main.awl", "// no block\n"},
      {"plant/lib/picture.bin", std::string("\0\1", 2)},
      {"plant/.git/config", "secret"},
      {"beside.txt", "x"}};
  folder.zip("p.zip", files);
  const Contents found = look(folder.path("p.zip"), {});
  EXPECT_EQ(found.programs, std::vector<std::string>{"plant"});
  EXPECT_TRUE(found.whole);
  const Outcome outcome = importSource({folder.path("p.zip"), folder.path("out"), ""});
  ASSERT_EQ(outcome.result, Result::Imported);
  EXPECT_EQ(folder.read("out/main.awl"), "// no block\n");
  EXPECT_EQ(folder.read("out/lib/picture.bin"), std::string("\0\1", 2));
  EXPECT_FALSE(folder.has("out/.git/config"));
  EXPECT_FALSE(folder.has("out/beside.txt"));
  EXPECT_NE(outcome.report.find("beside.txt is not a file that can be imported"),
            std::string::npos);
  EXPECT_EQ(outcome.folders, std::vector<std::string>{folder.path("out")});
}

TEST(Look, saysWhatWouldCome) {
  const TestFolder folder;
  folder.write("in/a.awl", kSource);
  Contents found = look(folder.path("in"), {});
  EXPECT_TRUE(found.programs.empty());
  EXPECT_TRUE(found.step7);
  EXPECT_FALSE(found.step5 || found.whole || found.empty());
  folder.write("in/station.cfg", "FILEVERSION \"3.2\"\n");
  EXPECT_TRUE(look(folder.path("in"), {}).whole);
  folder.write("other/letter.doc", "Dear reader");
  EXPECT_TRUE(look(folder.path("other"), {}).empty());
  EXPECT_FALSE(look(folder.path("none"), {}).readable);
}

// A name that is bad costs itself, in a zip of any kind.
TEST(Files, aFileWithABadNameIsNamed) {
  const TestFolder folder;
  folder.zip("p.zip", {{"merker.toml", "[project]\nname = \"Plant\"\n"},
                       {"a.awl", kSource},
                       {"b~.awl", kSource},
                       {"\u00fc~.awl", kSource}});
  std::string bytes = folder.read("p.zip");
  for (std::size_t at = 0; (at = bytes.find('~', at)) != std::string::npos;) bytes[at] = '\n';
  folder.write("p.zip", bytes);
  const Outcome outcome = importSource({folder.path("p.zip"), folder.path("out"), ""});
  EXPECT_EQ(outcome.result, Result::Imported);
  EXPECT_TRUE(outcome.lost);
  EXPECT_TRUE(folder.has("out/a.awl"));
  EXPECT_NE(outcome.report.find("b\\x0A.awl: its name has control characters"), std::string::npos)
      << outcome.report;
  EXPECT_NE(outcome.report.find("\u00fc\\x0A.awl: its name has"), std::string::npos);
}

TEST(Files, anImportThatIsStoppedSaysSo) {
  const TestFolder folder;
  folder.write("in.wld", container());
  std::stop_source stop;
  stop.request_stop();
  Options options{folder.path("in.wld"), folder.path("out"), ""};
  options.stop = stop.get_token();
  EXPECT_EQ(importSource(options).result, Result::Stopped);
  EXPECT_FALSE(folder.has("out/FC7.awl"));
}

// The security word alone protects as well as the attribute bit (docs/formats/block.md).
TEST(Files, theSecurityWordProtects) {
  const TestFolder folder;
  std::string bytes = container();
  constexpr std::size_t kSecurityEnd = 15;
  const std::size_t fc = bytes.rfind("pp\x01");
  bytes[fc + kSecurityEnd] = 3;
  folder.write("card.wld", bytes);
  const Outcome outcome = importSource({folder.path("card.wld"), folder.path("out"), ""});
  EXPECT_NE(outcome.report.find("FC 7 is protected"), std::string::npos) << outcome.report;
  EXPECT_EQ(folder.read("out/FC7.awl").find("E 0.0"), std::string::npos);
  EXPECT_TRUE(folder.has("out/FC7.mc7"));
}

TEST(Files, aDamagedChainKeepsWhatIsBeforeIt) {
  const TestFolder folder;
  const std::string bytes = container();
  folder.write("card.wld", bytes.substr(0, bytes.size() - 20));
  const Outcome outcome = importSource({folder.path("card.wld"), folder.path("out"), ""});
  EXPECT_TRUE(outcome.lost);
  EXPECT_TRUE(folder.has("out/DB3.awl")) << outcome.report;
  EXPECT_FALSE(folder.has("out/FC7.awl"));
}

TEST(Files, anExportedStationGivesTheHardware) {
  const TestFolder folder;
  folder.write(
      "plant.cfg",
      "FILEVERSION \"3.2\"\r\n#STEP7_VERSION V5.5\r\nSTATION S7300 , \"SIMATIC "
      "300(1)\"\r\nBEGIN\r\nEND\r\n"
      "RACK 0, \"6ES7 390-1???0-0AA0\", \"UR\"\r\nBEGIN\r\nEND\r\n"
      "RACK 0, SLOT 2, \"6ES7 314-6BF01-0AB0\" \"V2.0\", \"CPU 314C-2 PtP\"\r\nBEGIN\r\nEND\r\n"
      "RACK 0, SLOT 4, \"6ES7 321-1BH02-0AA0\", \"DI16xDC24V\"\r\nBEGIN\r\nLOCAL_IN_ADDRESSES \r\n"
      "  ADDRESS  8, 0, 2, 0, 0, 0\r\nSYMBOL  I , 0, \"a\", \"b\"\r\nEND\r\n"
      "RACK 0, SLOT 5, \"6ES7 999-0AA00-0AA0\", \"unknown\"\r\nBEGIN\r\nLOCAL_OUT_ADDRESSES\r\n"
      "  ADDRESS  12, 0, 2, 0, 0, 0\r\nEND\r\n"
      "DPSUBSYSTEM 1, DPADDRESS 3, \"x\", \"y\"\r\nBEGIN\r\nLOCAL_IN_ADDRESSES\r\n  ADDRESS 900, "
      "0, 1, 0, 0, 0\r\nEND\r\n");
  folder.write("x.awl", "");
  const Outcome outcome = importSource({folder.path("plant.cfg"), folder.path("out"), ""});
  ASSERT_EQ(outcome.result, Result::Imported);
  const std::string toml = folder.read("out/merker.toml");
  EXPECT_NE(toml.find("model = \"314C-2 PtP\""), std::string::npos) << toml;
  EXPECT_NE(toml.find("slot = 4\ntype = \"6ES7 321-1BH02-0AA0\"\ninput = 8\n"), std::string::npos)
      << toml;
  EXPECT_EQ(toml.find("900"), std::string::npos);
  EXPECT_TRUE(outcome.lost);
  EXPECT_NE(outcome.report.find("rack 0, slot 5: 6ES7 999-0AA00-0AA0 unknown"), std::string::npos);
}

TEST(Files, nothingKnown) {
  const TestFolder folder;
  folder.write("in/letter", "Dear reader");
  EXPECT_EQ(importSource({folder.path("in"), folder.path("out"), ""}).result, Result::Nothing);
  EXPECT_FALSE(folder.has("out"));
  EXPECT_EQ(importSource({folder.path("no"), folder.path("out"), ""}).result, Result::Unreadable);
}

// By its letters, or as the user says; names of sources and symbol tables come out alike.
TEST(Files, aSourceOfAnotherCodePage) {
  const std::string start = "\xCF\xF3\xF1\xEA \xED\xE0\xF1\xEE\xF1\xE0";  // Пуск насоса in 1251
  const std::string source = "FUNCTION FC 5 : VOID\nBEGIN\nU \"" + start + "\"; // " + start +
                             "\nL '" + start.substr(0, 2) + "';\nEND_FUNCTION\n";
  const TestFolder folder;
  folder.write("in/a.awl", source);
  folder.write("in/a.seq", "\tE 1.0\t" + start + "\t\n");
  const Outcome outcome = importSource({folder.path("in"), folder.path("out"), ""});
  EXPECT_FALSE(outcome.lost) << outcome.report;
  EXPECT_NE(outcome.report.find("characters are those of code page 1251"), std::string::npos);
  EXPECT_EQ(outcome.report.find("finds"), std::string::npos) << outcome.report;
  EXPECT_NE(folder.read("out/a.awl").find("U \"Пуск насоса\"; // Пуск насоса\nL 'Пу'"),
            std::string::npos);
  Options named{folder.path("in"), folder.path("latin"), ""};
  named.page = 1252;
  EXPECT_EQ(importSource(named).report.find("1251"), std::string::npos);
  EXPECT_NE(folder.read("latin/a.awl").find("\"Ïóñê íàñîñà\""), std::string::npos);
}

// Every conversion is named; a guess that is not certain is a warning.
TEST(Files, theReportNamesTheCharacters) {
  const TestFolder folder;
  const auto reportOf = [&](const std::string& name, const std::string& bytes) {
    folder.write(name + "/a.awl", bytes);
    const Outcome outcome = importSource({folder.path(name), folder.path(name + ".out"), ""});
    EXPECT_EQ(outcome.result, Result::Imported);
    return outcome.report;
  };
  const auto has = [](const std::string& report, const char* text) {
    return report.find(text) != std::string::npos;
  };
  const std::string latin = reportOf("latin", kSource + "// \xDC" + "bergabe\n");
  EXPECT_TRUE(has(latin, "a.awl: characters are those of code page 1252 by")) << latin;
  const std::string unsure = reportOf("unsure", kSource + "// \xC2\xF5\n");
  EXPECT_TRUE(
      has(unsure, "In another form:\n  a.awl: characters are perhaps those of code page 1251"))
      << unsure;
  std::string wide = "\xFF\xFE";
  for (const char c : kSource) (wide += c) += '\0';
  EXPECT_TRUE(has(reportOf("wide", wide), "a.awl: UTF-16 became UTF-8"));
  const std::string odd = reportOf("odd", wide + "x");
  EXPECT_TRUE(has(odd, "Not imported:\n  a.awl is UTF-16 with an odd number of bytes")) << odd;
  EXPECT_EQ(folder.read("odd.out/a.awl"), kSource);
  const std::string lone = reportOf("lone", wide + std::string("/\0/\0\0\xD8", 6));
  EXPECT_TRUE(has(lone, "characters that UTF-16 does not have are shown as U+FFFD: 1")) << lone;
  const std::string ascii = reportOf("ascii", kSource);
  EXPECT_FALSE(has(ascii, "code page") || has(ascii, "UTF")) << ascii;
}

// One word tells nothing; the files beside it do.
TEST(Files, aShortTextHasThePageOfTheOthers) {
  const TestFolder folder;
  folder.write("in/a.awl", kSource + "// \xC2\xF5\n");
  folder.write("in/b.awl",
               "FUNCTION FC 6 : VOID\n// \xCD\xE0\xF1\xEE\xF1 \xE2\xEA\xEB\xFE\xF7\xE5\xED\n"
               "BEGIN\nEND_FUNCTION\n");
  const Outcome outcome = importSource({folder.path("in"), folder.path("out"), ""});
  EXPECT_NE(outcome.report.find("a.awl: characters are those of code page 1251"), std::string::npos)
      << outcome.report;
  EXPECT_EQ(outcome.report.find("perhaps"), std::string::npos);
}

TEST(Files, zeroBytesInASourceAreNamed) {
  const TestFolder folder;
  folder.write("in/a.awl", kSource + std::string("// a\0b\n", 7));
  Outcome outcome = importSource({folder.path("in"), folder.path("out"), ""});
  EXPECT_NE(outcome.report.find("a.awl: zero bytes became blanks: 1, the first at byte " +
                                std::to_string(kSource.size() + 4)),
            std::string::npos)
      << outcome.report;
  EXPECT_EQ(folder.read("out/a.awl"), kSource + "// a b\n");
  folder.write("sector/a.awl", kSource + std::string(512, '\0'));
  outcome = importSource({folder.path("sector"), folder.path("filled"), ""});
  EXPECT_EQ(folder.read("filled/a.awl"), kSource);
  folder.write("bad/a.awl", kSource + std::string(500, '\0') + "x");
  outcome = importSource({folder.path("bad"), folder.path("none"), ""});
  EXPECT_EQ(outcome.result, Result::Nothing);
  EXPECT_NE(outcome.report.find("a.awl begins like a source or a table, but 500 of its"),
            std::string::npos)
      << outcome.report;
}

TEST(Files, aSourceInScl) {
  const TestFolder folder;
  folder.write("in/a.scl", "FUNCTION FC 1 : VOID\nBEGIN\nIF TRUE THEN\n;\nEND_IF;\nEND_FUNCTION\n");
  const Outcome outcome = importSource({folder.path("in"), folder.path("out"), ""});
  EXPECT_EQ(outcome.result, Result::Imported);
  EXPECT_TRUE(outcome.lost);
  EXPECT_NE(outcome.report.find("a.scl is a source in SCL"), std::string::npos) << outcome.report;
  EXPECT_TRUE(folder.has("out/sources/a.txt"));
  EXPECT_FALSE(folder.has("out/a.awl"));
}

TEST(Files, aZipWithoutAWholeFileSaysThatItIsDamaged) {
  const TestFolder folder;
  folder.write("p.zip", std::string("PK\3\4\x14\0\0\0", 8) + std::string(100, '\7'));
  const Outcome outcome = importSource({folder.path("p.zip"), folder.path("out"), ""});
  EXPECT_EQ(outcome.result, Result::Nothing);
  EXPECT_NE(outcome.report.find("p.zip, from byte 0 on: it is damaged or cut off"),
            std::string::npos)
      << outcome.report;
}

}  // namespace
}  // namespace merker::importing
