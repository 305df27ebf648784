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

Kind kindOf(const std::string& text) {
  return recognise(*archive::fileOf({text.begin(), text.end()}));
}

// Issue: recognised by content, not by name.
TEST(Recognise, byContent) {
  EXPECT_EQ(kindOf(kSource), Kind::AwlSource);
  EXPECT_EQ(kindOf("// comment\r\n\r\n  data_block \"x\"\r\n"), Kind::AwlSource);
  EXPECT_EQ(kindOf(container()), Kind::Containers);
  EXPECT_EQ(kindOf("\"Motor                   \",\"A       1.0 \",\"BOOL      \",\"drives\"\r\n"),
            Kind::Sdf);
  EXPECT_EQ(kindOf("126,Motor                   A       1.0 BOOL      drives\r\n"), Kind::Asc);
  EXPECT_EQ(kindOf("TABLE\n0,1\n\"x\"\n"), Kind::Dif);
  EXPECT_EQ(kindOf("\tA 1.0\tMotor\tdrives\n"), Kind::Seq);
  EXPECT_EQ(kindOf("FILEVERSION \"3.2\"\n#STEP7_VERSION V5.5\n"), Kind::Hardware);
  EXPECT_EQ(kindOf("Dear reader,\nthis is a letter.\n"), Kind::Unknown);
  EXPECT_EQ(kindOf(std::string("\0\1\2\3", 4)), Kind::Unknown);
  EXPECT_EQ(kindOf(""), Kind::Unknown);
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
  const std::string start = "\xCF\xF3\xF1\xEA";  // Пуск in 1251
  const std::string source = "FUNCTION FC 5 : VOID\nBEGIN\nU \"" + start + "\"; // " + start +
                             "\nL '" + start.substr(0, 2) + "';\nEND_FUNCTION\n";
  const TestFolder folder;
  folder.write("in/a.awl", source);
  folder.write("in/a.seq", "\tE 1.0\t" + start + "\t\n");
  const Outcome outcome = importSource({folder.path("in"), folder.path("out"), ""});
  EXPECT_FALSE(outcome.lost) << outcome.report;
  EXPECT_NE(outcome.report.find("characters are those of code page 1251"), std::string::npos);
  EXPECT_EQ(outcome.report.find("finds"), std::string::npos) << outcome.report;
  EXPECT_NE(folder.read("out/a.awl").find("U \"Пуск\"; // Пуск\nL 'Пу'"), std::string::npos);
  Options named{folder.path("in"), folder.path("latin"), ""};
  named.page = 1252;
  EXPECT_EQ(importSource(named).report.find("1251"), std::string::npos);
  EXPECT_NE(folder.read("latin/a.awl").find("\"Ïóñê\""), std::string::npos);
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
