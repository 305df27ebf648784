#include "importing/import.h"

#include <gtest/gtest.h>

#include "../archive_zip.h"
#include "../s7p_files.h"
#include "block/container.h"
#include "compilation/build.h"
#include "step7/compiler.h"

namespace merker::importing {
namespace {

const std::string kProgram =
    "TYPE UDT 1\nSTRUCT\nA : INT;\nB : BOOL;\nEND_STRUCT;\nEND_TYPE\n"
    "FUNCTION FC 1 : INT\nVAR_INPUT\nIN1 : INT;\nTIM : TIMER;\nEND_VAR\nVAR_OUTPUT\nOUT1 : "
    "BOOL;\nEND_VAR\n"
    "VAR_TEMP\nsum : INT;\nEND_VAR\nBEGIN\nNETWORK\nTITLE = first\nL #IN1;\nL 5;\n+I;\nT #sum;\nT "
    "#RET_VAL;\n"
    "NETWORK\nU M 1.0;\nSPB m1;\nU #TIM;\n= #OUT1;\nm1: L DB10.DBW 0;\nT MW 20;\nEND_FUNCTION\n"
    "FUNCTION_BLOCK FB 1\nVAR_INPUT\nSTART : BOOL;\nEND_VAR\nVAR\ncount : INT := "
    "7;\nEND_VAR\nBEGIN\nNETWORK\n"
    "U #START;\nL #count;\nINC 1;\nT #count;\nEND_FUNCTION_BLOCK\n"
    "DATA_BLOCK DB 1\nFB 1\nBEGIN\nEND_DATA_BLOCK\n"
    "DATA_BLOCK DB 10\nSTRUCT\nspeed : INT := 3;\ntext : STRING [8] := 'abc';\nlist : ARRAY [1..3] "
    "OF REAL;\n"
    "END_STRUCT;\nBEGIN\nspeed := 99;\nlist[2] := 1.5;\nEND_DATA_BLOCK\n"
    "ORGANIZATION_BLOCK OB 1\nVAR_TEMP\ninfo : ARRAY [0..19] OF BYTE;\nEND_VAR\nBEGIN\nNETWORK\nU "
    "E 0.0;\n= A 0.0;\n"
    "L DB1.DBW 2;\nT MW 30;\nL DB10.DBW 0;\nT MW 32;\nEND_ORGANIZATION_BLOCK\n";

const block::Program& program() {
  static const block::Program compiled =
      step7::compile({source::SourceFile("a.awl", kProgram)}, {}).program;
  return compiled;
}

const std::map<BlockId, std::string> kDeclarations{
    {{BlockKind::FC, 1},
     "VAR_INPUT\r\n  IN1 : INT ;\t//first\r\n  TIM : TIMER ;\t\r\nEND_VAR\r\nVAR_OUTPUT\r\n  "
     "RET_VAL : INT ;\t\r\n"
     "  OUT1 : BOOL ;\t\r\nEND_VAR\r\nVAR_TEMP\r\n  sum : INT ;\t\r\nEND_VAR\r\n"},
    {{BlockKind::FB, 1},
     "VAR_INPUT\r\n  START : BOOL ;\t\r\nEND_VAR\r\nVAR\r\n  count : INT  := 7;\t\r\nEND_VAR\r\n"},
    {{BlockKind::DB, 10},
     "  STRUCT \t\r\n   speed : INT  := 3;\t\r\n   text : STRING  [8 ] := 'abc';\t\r\n"
     "   list : ARRAY  [1 .. 3 ] OF //a list\r\nREAL ;\t\r\n  END_STRUCT ;\t\r\n"}};

s7p_files::BlockFolder blocks(int password = 0) {
  s7p_files::BlockFolder folder;
  for (const auto& [id, block] : program()) {
    if (id.kind == BlockKind::UDT) continue;
    s7p_files::BlockFolder::Extra extra;
    if (const auto at = kDeclarations.find(id); at != kDeclarations.end())
      extra.declaration = at->second;
    if (id == BlockId{BlockKind::FC, 1}) {
      extra.password = password;
      extra.title = "F\xFCllstand";
      extra.networks = {{"first", "comment", {{1, 0x80, "load"}, {3, 0x80, "store"}}},
                        {"second", "", {{5, 0x80, "the data"}}}};
    }
    folder.add(block, extra);
  }
  folder.addText(1, 1, "  STRUCT \r\n   A : INT ;\r\n   B : BOOL ;\r\n  END_STRUCT ;\r\n");
  return folder;
}

struct Import {
  explicit Import(const s7p_files::Files& files, const std::string& program = "") {
    for (const auto& [name, bytes] : files) folder.write("in/" + name, bytes);
    outcome = importSource({folder.path("in"), folder.path("out"), program});
  }
  compilation::Build build() const {
    return compilation::build(project::load(folder.path("out"), ""), false);
  }
  TestFolder folder;
  Outcome outcome;
};

s7p_files::Project project(int password = 0) {
  s7p_files::Project project;
  project.blocks = blocks(password);
  project.symbolRows = {{{"_SKZ", "Motor"},
                         {"_OPHIST", "A       0.0"},
                         {"_DATATYP", "BOOL"},
                         {"_COMMENT", "K\xFChlung"}},
                        {{"_SKZ", "Axis"}, {"_OPHIST", "DB     1"}, {"_DATATYP", "FB     1"}},
                        {{"_SKZ", "wrong"}, {"_OPHIST", "L      1"}, {"_DATATYP", "BOOL"}}};
  return project;
}

bool hasLine(const std::string& text, const std::string& one, const std::string& two) {
  const std::size_t at = text.find(one);
  return at != std::string::npos &&
         text.substr(at, text.find('\n', at) - at).find(two) != std::string::npos;
}

// Whatever the way: what the project compiles to is what was stored.
void expectSameBlocks(const compilation::Build& build) {
  for (const auto& [id, block] : program()) {
    if (id.kind == BlockKind::UDT) continue;
    ASSERT_TRUE(build.program->contains(id)) << toString(id);
    const block::Block& now = build.program->at(id);
    EXPECT_EQ(now.code, block.code) << toString(id);
    EXPECT_EQ(now.actualData, block.actualData) << toString(id);
  }
}

TEST(Import, aProjectComesBackByteForByte) {
  const Import done(project().files());
  ASSERT_EQ(done.outcome.result, Result::Imported) << done.outcome.report;
  const auto build = done.build();
  EXPECT_TRUE(build.ok()) << done.outcome.report;
  expectSameBlocks(build);
  EXPECT_FALSE(done.folder.has("out/FC1.mc7")) << done.outcome.report;
  const std::string fc = done.folder.read("out/FC1.awl");
  EXPECT_NE(fc.find("FUNCTION FC 1 : INT\nTITLE = Füllstand\n"), std::string::npos) << fc;
  EXPECT_NE(fc.find("IN1 : INT ;\t//first"), std::string::npos) << fc;
  EXPECT_EQ(fc.find("RET_VAL : INT"), std::string::npos) << fc;
  EXPECT_NE(fc.find("TITLE = first\n//comment\n"), std::string::npos) << fc;
  EXPECT_TRUE(hasLine(fc, "L     #IN1;", "//load")) << fc;
  EXPECT_TRUE(hasLine(fc, "T     #sum;", "//store")) << fc;
  EXPECT_TRUE(hasLine(fc, "L     DB10.DBW 0;", "//the data")) << fc;
  EXPECT_NE(done.folder.read("out/DB10.awl").find("  speed := 99;\n  list[2] := 1.5"),
            std::string::npos);
  EXPECT_NE(done.folder.read("out/symbols.sym").find("Kühlung"), std::string::npos);
  EXPECT_TRUE(done.folder.has("out/UDT1.awl"));
  EXPECT_TRUE(done.outcome.lost) << "the symbol of a local operand";
  EXPECT_NE(done.outcome.report.find("symbol wrong"), std::string::npos) << done.outcome.report;
  EXPECT_EQ(done.folder.read("out/import-report.txt"), done.outcome.report);
}

TEST(Import, aSourceThatCompilesToTheStoredBytesIsKept) {
  auto stored = project();
  stored.sources = {
      {"Old",
       "FUNCTION FC 1 : INT\nVAR_INPUT\nIN1 : INT;\nTIM : TIMER;\nEND_VAR\nVAR_OUTPUT\n"
       "OUT1 : BOOL;\nEND_VAR\nBEGIN\nL #IN1;\nEND_FUNCTION\n"},
      {"All", "// \xC4nderung\r\n" + kProgram.substr(kProgram.find("FUNCTION FC 1"))}};
  const Import done(stored.files());
  expectSameBlocks(done.build());
  EXPECT_NE(done.folder.read("out/FC1.awl").find("m1: L DB10.DBW 0;"), std::string::npos);
  EXPECT_NE(done.outcome.report.find("source Old belongs to no stored block"), std::string::npos);
  EXPECT_TRUE(done.folder.has("out/sources/Old.txt"));
  EXPECT_FALSE(done.folder.has("out/sources/All.txt"));
}

// The same code with other parameters: callers would see the difference.
TEST(Import, aSourceWithAnotherInterfaceIsNotTaken) {
  auto stored = project();
  std::string source = kProgram.substr(kProgram.find("FUNCTION FC 1"));
  source.replace(source.find("IN1 : INT"), 9, "IN1 : WORD");
  stored.sources = {{"All", source}};
  const Import done(stored.files());
  expectSameBlocks(done.build());
  EXPECT_EQ(done.folder.read("out/FC1.awl").find("m1: L DB10"), std::string::npos);
  EXPECT_NE(done.folder.read("out/FC1.awl").find("IN1 : INT"), std::string::npos);
}

// S7P section 5: respect the mark, run the code, show the interface, do not show the body.
TEST(Import, aProtectedBlockRunsAndCanBeCalled) {
  const Import done(project(3).files());
  const auto build = done.build();
  EXPECT_TRUE(build.ok()) << done.outcome.report;
  expectSameBlocks(build);
  ASSERT_TRUE(done.folder.has("out/FC1.mc7"));
  const std::string fc = done.folder.read("out/FC1.awl");
  EXPECT_NE(fc.find("KNOW_HOW_PROTECT"), std::string::npos);
  EXPECT_EQ(fc.find("+I"), std::string::npos) << "the body is not shown";
  EXPECT_TRUE(build.program->at({BlockKind::FC, 1}).attributes.knowHowProtect);
  done.folder.write("out/FC2.awl",
                    "FUNCTION FC 2 : VOID\nBEGIN\nCALL FC 1 (IN1 := 5, TIM := T 1, RET_VAL := MW "
                    "4, OUT1 := M 9.0);\n"
                    "END_FUNCTION\n");
  EXPECT_TRUE(done.build().ok());
}

TEST(Import, withoutDeclarationsVariablesAreNamedByTheirPlace) {
  s7p_files::Project stored;
  for (const auto& [id, block] : program())
    if (id.kind != BlockKind::UDT) stored.blocks.add(block);
  const Import done(stored.files());
  EXPECT_TRUE(done.build().ok()) << done.outcome.report;
  expectSameBlocks(done.build());
  EXPECT_NE(done.folder.read("out/FC1.awl").find("IN0 : INT"), std::string::npos);
}

TEST(Import, neverOverExistingFiles) {
  const TestFolder folder;
  for (const auto& [name, bytes] : project().files()) folder.write("in/" + name, bytes);
  folder.write("out/OB1.awl", "mine");
  EXPECT_EQ(importSource({folder.path("in"), folder.path("out"), ""}).result, Result::Exists);
  EXPECT_EQ(folder.read("out/OB1.awl"), "mine");
  EXPECT_FALSE(folder.has("out/merker.toml"));
}

TEST(Import, aZipOfSeveralProjectsGivesAFolderEach) {
  const TestFolder folder;
  s7p_files::Files all;
  for (const std::string name : {"A/", "B/"})
    for (const auto& [file, bytes] : project().files()) all[name + file] = bytes;
  folder.zip("p.zip", all);
  const Outcome outcome = importSource({folder.path("p.zip"), folder.path("out"), ""});
  ASSERT_EQ(outcome.programs.size(), 2u);
  EXPECT_TRUE(folder.has("out/S7 Program(1)/OB1.awl")) << outcome.report;
  EXPECT_TRUE(folder.has("out/S7 Program(1) 2/OB1.awl"));
  EXPECT_EQ(importSource({folder.path("p.zip"), folder.path("no"), "missing"}).result,
            Result::NoSuchProgram);
}

// S7P section 8: as in a network of a pump station: a comment behind a line counts this line, one
// on a line of its own the lines before it, and is no line itself.
TEST(Import, commentsStandAtTheirStatements) {
  auto stored = project();
  stored.blocks = {};
  stored.symbolRows.clear();
  const auto compiled =
      step7::compile({source::SourceFile("a.awl",
                                         "FUNCTION FC 2 : VOID\nVAR_INPUT\nA : INT;\nB : "
                                         "INT;\nEND_VAR\nBEGIN\nEND_FUNCTION\n"
                                         "FUNCTION FC 3 : VOID\nBEGIN\nU E 0.0;\n= A "
                                         "0.0;\nCALL FC 2 (A := 1, B := 2);\nU E 0.1;\n"
                                         "= A 0.1;\nEND_FUNCTION\n")},
                     {})
          .program;
  s7p_files::BlockFolder::Extra called, calling;
  called.declaration = "VAR_INPUT\r\n  A : INT ;\r\n  B : INT ;\r\nEND_VAR\r\n";
  calling.networks = {{"",
                       "",
                       {{1, 0x80, "first"},
                        {1, 0x00, "own 1"},
                        {0, 0x00, "own 2"},
                        {2, 0x80, "A"},
                        {1, 0x20, ""},
                        {0, 0x00, "own 3"},
                        {1, 0x80, "input"},
                        {1, 0x00, "at\rthe"},
                        {0, 0x00, "end"}}}};
  stored.blocks.add(compiled.at({BlockKind::FC, 2}), called);
  stored.blocks.add(compiled.at({BlockKind::FC, 3}), calling);
  const Import done(stored.files());
  const std::string fc = done.folder.read("out/FC3.awl");
  EXPECT_TRUE(hasLine(fc, "U     E 0.0;", "//first")) << fc;
  EXPECT_NE(fc.find("=     A 0.0;\n//own 1\n//own 2\n      CALL"), std::string::npos) << fc;
  EXPECT_TRUE(hasLine(fc, "A := 1", "//A")) << fc;
  EXPECT_NE(fc.find("B := 2);\n//own 3\n"), std::string::npos) << fc;
  EXPECT_TRUE(hasLine(fc, "U     E 0.1;", "//input")) << fc;
  EXPECT_NE(fc.find("=     A 0.1;\n//at the\n//end\nEND_FUNCTION"), std::string::npos) << fc;
  EXPECT_TRUE(done.build().ok());
}

// One block as it is stored and comes back: its code, and no machine code beside it.
void expectSource(const Import& done, const block::Block& stored) {
  const auto build = done.build();
  ASSERT_TRUE(build.ok()) << done.outcome.report;
  EXPECT_EQ(build.program->at(stored.id).code, stored.code) << done.outcome.report;
  EXPECT_FALSE(done.folder.has("out/" + std::string(name(stored.id.kind)) +
                               std::to_string(stored.id.number) + ".mc7"))
      << done.outcome.report;
}

// Its interface is stored with the project; the block is there as machine code, its caller as
// source.
TEST(Import, aSystemFunctionOfAnotherCpu) {
  const std::string interface = "VAR_INPUT\nIN0 : INT;\nEND_VAR\nBEGIN\nEND_FUNCTION\n";
  const auto compiled =
      step7::compile({source::SourceFile("a.awl", "FUNCTION FC 200 : VOID\n" + interface +
                                                      "FUNCTION SFC 200 : VOID\n" + interface +
                                                      "FUNCTION FC 3 : VOID\nBEGIN\nCALL SFC 200 "
                                                      "(IN0 := MW 2);\nEND_FUNCTION\n")},
                     {})
          .program;
  block::Block system = compiled.at({BlockKind::FC, 200});
  system.id.kind = BlockKind::SFC;
  auto stored = project();
  stored.blocks = {};
  stored.symbolRows.clear();
  stored.blocks.add(system);
  stored.blocks.add(compiled.at({BlockKind::FC, 3}));
  const Import done(stored.files());
  EXPECT_TRUE(done.folder.has("out/SFC200.mc7")) << done.outcome.report;
  EXPECT_TRUE(hasLine(done.folder.read("out/FC3.awl"), "CALL  SFC 200", "("));
  expectSource(done, compiled.at({BlockKind::FC, 3}));
}

// The jump over the empty list belongs to UC, also where the function's number is a parameter.
TEST(Import, unconditionalCallsOfParameters) {
  const auto compiled =
      step7::compile(
          {source::SourceFile("a.awl",
                              "FUNCTION FC 4 : VOID\nVAR_INPUT\nf : BLOCK_FC;\nb : BLOCK_FB;\n"
                              "END_VAR\nBEGIN\nUC #f;\nCC FC [MW 2];\nUC #b;\nU E 0.0;\n= A "
                              "0.0;\nEND_FUNCTION\n")},
          {})
          .program;
  auto stored = project();
  stored.blocks = {};
  stored.symbolRows.clear();
  stored.blocks.add(compiled.at({BlockKind::FC, 4}));
  const Import done(stored.files());
  EXPECT_EQ(done.folder.read("out/FC4.awl").find("SPA"), std::string::npos);
  expectSource(done, compiled.at({BlockKind::FC, 4}));
}

TEST(Import, textsOfTheHeaderCannotEndIt) {
  for (const std::string author :
       {"a'b", "'\"'", "a\nBEGIN", "a;b", "//x", "a\tb\x01", "{x}", "A:B"}) {
    auto stored = project();
    stored.blocks = {};
    stored.symbolRows.clear();
    block::Block block = program().at({BlockKind::FB, 1});
    block.attributes.author = author;
    stored.blocks.add(block);
    const Import done(stored.files());
    const auto build = done.build();
    ASSERT_TRUE(build.ok()) << done.folder.read("out/FB1.awl") << done.outcome.report;
    EXPECT_FALSE(done.folder.has("out/FB1.mc7")) << done.outcome.report;
    EXPECT_EQ(build.program->at({BlockKind::FB, 1}).attributes.author.size(), author.size());
  }
}

// S7P section 10: what the header counts must be there.
TEST(Import, cutTablesSaySo) {
  for (const std::string name :
       {"ombstx/offline/0000000a/SUBBLK.DBF", "YDBs/27/SYMLIST.DBF", "hrs/S7RESOFF.DBF"}) {
    auto files = project().files();
    std::string& bytes = files.at(name);
    bytes.resize(bytes.size() - 10);
    const Import done(files);
    ASSERT_EQ(done.outcome.result, Result::Imported);
    EXPECT_TRUE(done.outcome.lost);
    EXPECT_NE(done.outcome.report.find(" is cut off: rows that its header counts are missing: 1\n"),
              std::string::npos)
        << name << done.outcome.report;
  }
}

TEST(Import, sourcesWithoutTheirProgramAreNamed) {
  auto stored = project();
  stored.sources = {{"One", "x"}, {"Two", "x"}, {"Three", "x"}, {"Four", "x"}};
  EXPECT_EQ(Import(stored.files()).outcome.report.find("were not used"), std::string::npos);
  auto files = stored.files();
  files.erase("hrs/S7RESOFF.DBF");
  const Import done(files);
  EXPECT_TRUE(done.outcome.lost);
  EXPECT_TRUE(
      hasLine(done.outcome.report, "S7ASRCOM/00000001 holds sources", "One, Two, Three, ..."))
      << done.outcome.report;
}

TEST(Import, filesBesideAProjectAreNamed) {
  s7p_files::Files files{{"extra.awl", kProgram}, {"letter.txt", "Dear reader"}};
  for (const auto& [name, bytes] : project().files()) files["plant/" + name] = bytes;
  files["plant/more.awl"] = kProgram;
  const Import done(files);
  EXPECT_TRUE(done.outcome.lost);
  EXPECT_TRUE(
      hasLine(done.outcome.report, "files beside the projects", ": 2 (extra.awl, plant/more.awl)"))
      << done.outcome.report;
}

// What the manager shows tells programs of one name apart, and if that is equal, too, their folder.
TEST(Import, programsOfOneNameAreChosenByTheirPath) {
  s7p_files::Files files;
  for (const auto& [name, bytes] : project().files())
    for (const char* folder : {"old/", "new/"}) files[folder + name] = bytes;
  const Import all(files);
  ASSERT_EQ(all.outcome.programs.size(), 2u);
  EXPECT_NE(all.outcome.programs[0], all.outcome.programs[1]);
  EXPECT_TRUE(all.outcome.programs[0].starts_with("new/")) << all.outcome.programs[0];
  EXPECT_EQ(all.outcome.folders.size(), 2u);
  const Import one(files, all.outcome.programs[1]);
  ASSERT_EQ(one.outcome.result, Result::Imported);
  EXPECT_EQ(one.outcome.folders.size(), 1u);
  const std::string name = all.outcome.programs[0].substr(all.outcome.programs[0].rfind('/') + 1);
  EXPECT_EQ(Import(files, name).outcome.result, Result::NoSuchProgram);
}

// S7P section 10
TEST(Import, aMissingMemoCostsTheBlocksOnly) {
  auto files = project().files();
  files.erase("ombstx/offline/0000000A/subblk.dbt");
  const Import done(files);
  ASSERT_EQ(done.outcome.result, Result::Imported);
  EXPECT_TRUE(done.outcome.lost);
  EXPECT_TRUE(done.folder.has("out/symbols.sym"));
  EXPECT_NE(done.outcome.report.find("SUBBLK.DBT is missing"), std::string::npos);
}

}  // namespace
}  // namespace merker::importing
