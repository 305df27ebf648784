// An S5D file becomes a project that compiles to the same words.
#include "s5project/project.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "compilation/build.h"
#include "s5d/program.h"
#include "s5project/symbols.h"
#include "step5/compiler.h"

namespace merker::s5project {
namespace {

namespace fs = std::filesystem;

const std::string kText =
    "OB 1\nNETZWERK 1 Größe\n SPA PB 5\n BE\nPB 5\n U E 1.0 ! Taster\n = A 1.0\n SPA FB 7\nNAME : "
    "VENTIL\n"
    "EIN : E 2.0\n BE\nFB 7 VENTIL\nBEZ : EIN E BI\nM9 : U =EIN\n SPB =M9\n BE\nDB 10\n 0: KF +5\n";
const std::string kList =
    "\tE 1.0\tTASTER\tEin\r\n\tPB 5\tFOLGE\r\n\tFX 3\tFERN\r\n\tA 1.0\tAUF ZU\r\n";

mc5::Program program() {
  return step5::compile({source::SourceFile("t.s5", kText)}, false).program;
}

Output made(const mc5::Program& from, Encoding codePage = Encoding::Cp437) {
  const auto bytes = s5d::writeProgram(from, "PUMPE@ST", Encoding::Cp437);
  Input input;
  input.name = "PUMPE@ST.S5D";
  input.program = bytes;
  input.assignments = kList;
  input.codePage = codePage;
  input.beside = {"PUMPE@Z0.INI", "pumpe@do.s5d", "OTHER.TXT", "PUMPE@ST.S5D"};
  return makeProject(input);
}

std::string textOf(const Output& output, const std::string& path) {
  for (const OutputFile& file : output.files)
    if (file.path == path) return file.text;
  return "no " + path;
}

bool has(const Output& output, const std::string& note) {
  return std::ranges::any_of(
      output.notes, [&](const Note& one) { return one.text.find(note) != std::string::npos; });
}

TEST(Project, CompilesToTheWordsOfTheFile) {
  const Output output = made(program());
  EXPECT_EQ(output.name, "PUMPE");
  EXPECT_EQ(output.blocks, 4u);
  EXPECT_EQ(output.symbols, 3u);
  const fs::path folder = fs::temp_directory_path() / "merker-s5project-test";
  fs::remove_all(folder);
  for (const OutputFile& file : output.files) {
    const fs::path path = folder / file.path;
    fs::create_directories(path.parent_path());
    std::ofstream(path, std::ios::binary) << file.text;
  }
  const compilation::Build build = compilation::build(project::load(folder.string(), ""), false);
  for (const Problem& p : build.problems.list()) ADD_FAILURE() << p.position.file << p.message;
  for (const auto& [id, block] : program()) EXPECT_EQ(build.listings.at(id).words, block.words);
  EXPECT_EQ(build.project.name, "PUMPE");
  fs::remove_all(folder);
}

TEST(Project, ListingsHaveSymbolsTitlesAndComments) {
  const Output output = made(program());
  const std::string listing = textOf(output, "PB5.s5");
  EXPECT_NE(listing.find("U     -TASTER"), std::string::npos) << listing;
  EXPECT_NE(listing.find("=     \"AUF ZU\""), std::string::npos) << listing;
  EXPECT_NE(listing.find("! Taster"), std::string::npos) << listing;
  EXPECT_NE(textOf(output, "OB1.s5").find("NETZWERK 1 Größe"), std::string::npos);
  EXPECT_NE(textOf(output, "FB7.s5").find("M9   : U"), std::string::npos);
  EXPECT_EQ(
      textOf(output, "merker.toml"),
      "# From PUMPEST.S5D.\n[project]\nname = \"PUMPE\"\n\n[cpu]\nmodel = \"SINUMERIK 810 GA3\"\n");
}

TEST(Project, SaysWhatDidNotCome) {
  const Output output = made(program());
  EXPECT_TRUE(has(output, "Z0.SEQ, line 3: 'FX 3' is not a valid operand"));
  EXPECT_TRUE(has(output, "PUMPE@Z0.INI: the compiled assignment list; it is not read"));
  EXPECT_TRUE(has(output, "pumpe@do.s5d: the documentation; it is not read"));
  EXPECT_FALSE(has(output, "OTHER"));
  EXPECT_TRUE(has(output, "texts were read in code page 437; the other one is 850"));
}

TEST(Project, ABlockThatCannotRunHereStaysBesideTheProgram) {
  mc5::Program from = program();
  mc5::Block odd = from.at({mc5::BlockType::Pb, 5});
  odd.id.number = 6;
  odd.words = {0x7803, 0x1105, 0x6500};  // AX DX 5 of another PLC
  odd.networks.clear();
  odd.comments.clear();
  from[odd.id] = odd;
  const Output output = made(from);
  EXPECT_EQ(output.blocks, 4u);
  EXPECT_TRUE(has(output, "PB 6: it is not in the program but in not-compiled/PB6.s5.txt: line "));
  EXPECT_NE(textOf(output, "not-compiled/PB6.s5.txt").find("illegal 7803"), std::string::npos);
  EXPECT_EQ(textOf(output, "PB6.s5"), "no PB6.s5");
}

TEST(Project, AFileWithoutBlocksGivesNone) {
  const Output output = makeProject({});
  EXPECT_FALSE(output.usable());
  EXPECT_TRUE(output.files.empty());
}

TEST(Project, FilesThatBelongTogetherAreFoundByTheirNames) {
  EXPECT_TRUE(isAssignmentList("pumpe@z0.seq", "PUMPE@ST.S5D"));
  EXPECT_FALSE(isAssignmentList("ANDERSZ0.SEQ", "PUMPE@ST.S5D"));
  EXPECT_FALSE(isAssignmentList("PUMPE@A0.SEQ", "PUMPE@ST.S5D"));
}

TEST(Project, SymbolsThatAreTooLongStayOut) {
  const Symbols symbols = readAssignments(
      "\tE 1.0\t" + std::string(30, 'X') + "\n\tE 1.1\tGUT\t" + std::string(100, 'c') + "\n",
      Encoding::Cp437);
  ASSERT_EQ(symbols.table.list().size(), 1u);
  EXPECT_EQ(symbols.table.list()[0].comment.size(), 80u);
  EXPECT_EQ(symbols.notes.size(), 2u);
  EXPECT_EQ(readAssignments("\tE 1.0\tT\x9AR\n", Encoding::Cp850).table.list()[0].name, "TÜR");
  // DCh would be "Ü" in code page 1252.
  EXPECT_EQ(readAssignments("\tE 1.0\tT\xDCR\n", Encoding::Cp437).table.list()[0].name, "T▄R");
  EXPECT_EQ(readAssignments("\tE 1.0\tTÜR\n", Encoding::Cp437).table.list()[0].name, "TÜR");
  EXPECT_EQ(readAssignments(std::string("\0\0\1\2", 4), Encoding::Cp437).notes.size(), 1u);
}

}  // namespace
}  // namespace merker::s5project
