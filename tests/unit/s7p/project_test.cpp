#include <gtest/gtest.h>

#include "../archive_zip.h"
#include "../s7p_files.h"
#include "s7p/catalogue.h"
#include "s7p/sources.h"
#include "s7p/symbols.h"
#include "step7/compiler.h"

namespace merker::s7p {
namespace {

s7p_files::Project sample() {
  s7p_files::Project project;
  const auto program =
      step7::compile(
          {source::SourceFile("a.awl", "FUNCTION FC 1 : VOID\nBEGIN\nU E 0.0;\nEND_FUNCTION\n")},
          {})
          .program;
  project.blocks.add(program.at({BlockKind::FC, 1}));
  project.symbolRows = {
      {{"_SKZ", "\xCD\xE0\xF1\xEE\xF1"}, {"_OPHIST", "PEW   370"}, {"_DATATYP", "WORD"}},
      {{"_SKZ", "unfinished"}, {"_OPHIST", ""}}};
  project.sources = {{"Main", "FUNCTION FC 1 : VOID\r\n"}};
  project.page = "1251";
  return project;
}

std::vector<Project> projectsOf(const TestFolder& folder, const s7p_files::Files& files,
                                Faults& faults) {
  for (const auto& [name, bytes] : files) folder.write("x/" + name, bytes);
  return findProjects(archive::Tree(folder.path()), faults);
}

TEST(Projects, aProgramAndItsParts) {
  const TestFolder folder;
  Faults faults;
  auto files = sample().files();
  const auto projects = projectsOf(folder, files, faults);
  ASSERT_EQ(projects.size(), 1u);
  EXPECT_EQ(projects[0].name, "Plant");
  EXPECT_EQ(projects[0].page.number(), 1251u);
  ASSERT_EQ(projects[0].programs.size(), 1u);
  const Program& program = projects[0].programs[0];
  EXPECT_EQ(program.name, "S7 Program(1)");
  EXPECT_EQ(program.blocks, "x/ombstx/offline/0000000a");
  const archive::Tree tree(folder.path());
  const auto symbols = readSymbols(tree, program.symbols, projects[0].page, faults);
  ASSERT_EQ(symbols.size(), 1u);
  EXPECT_EQ(symbols[0].name, "Насос");
  EXPECT_EQ(symbols[0].address, "PEW 370");
  const auto sources = readSources(tree, program.sources, projects[0].page, faults);
  ASSERT_EQ(sources.size(), 1u);
  EXPECT_TRUE(sources[0].awl);
  EXPECT_EQ(sources[0].path, "x/s7asrcom/00000001/1.AWL");
  EXPECT_TRUE(faults.empty());
}

TEST(Projects, withoutLinksTheOnlyFolderIsTheProgram) {
  const TestFolder folder;
  Faults faults;
  auto files = sample().files();
  files["hrs/linkhrs.lnk"] = "KNIL";
  files["YDBs/YLNKLIST.DBF"] = s7p_files::table(
      {{"SOT", 'N', 11}, {"SOI", 'N', 11}, {"TOT", 'N', 11}, {"TOI", 'N', 11}, {"RID", 'N', 11}},
      {{{"SOT", "1126401"}, {"SOI", "27"}, {"TOT", "1327361"}, {"TOI", "1"}, {"RID", "25"}}});
  const auto projects = projectsOf(folder, files, faults);
  ASSERT_EQ(projects[0].programs.size(), 1u);
  EXPECT_EQ(projects[0].programs[0].blocks, "x/ombstx/offline/0000000a");
  EXPECT_EQ(projects[0].programs[0].symbols, "x/ydbs/27");
  ASSERT_EQ(faults.size(), 1u);
  EXPECT_EQ(faults[0].kind, FaultKind::NoLinks);
}

TEST(Projects, aBlockFolderAloneIsAProgram) {
  const TestFolder folder;
  const auto blocks = sample().blocks;
  folder.write("SUBBLK.DBF", blocks.dbf());
  Faults faults;
  const auto projects = findProjects(archive::Tree(folder.path()), faults);
  ASSERT_EQ(projects.size(), 1u);
  ASSERT_EQ(projects[0].programs.size(), 1u);
  EXPECT_EQ(projects[0].programs[0].blocks, "");
  EXPECT_EQ(faults.at(0).kind, FaultKind::UnknownPage);
}

// S7P section 9: the CPU by the link of the program, the station above it.
TEST(Projects, stationAndCpuOfAProgram) {
  const TestFolder folder;
  Faults faults;
  auto files = sample().files();
  files["hrs/linkhrs.lnk"] =
      std::string(512, '\0') + s7p_files::linkPage(512, {{0x116001, 10, 30}, {0x141709, 1, 17}});
  const std::vector<s7p_files::Column> columns{{"ID", 'N', 11},
                                               {"OBJTYP", 'N', 11},
                                               {"UNITID", 'N', 11},
                                               {"UNITTYP", 'N', 11},
                                               {"NAME", 'C', 80}};
  files["hOmSave7/S7HK31AX/HOBJECT1.DBF"] = s7p_files::table(columns, {{{"ID", "1"},
                                                                        {"OBJTYP", "1316617"},
                                                                        {"UNITID", "1"},
                                                                        {"UNITTYP", "1314974"},
                                                                        {"NAME", "CPU 315-2 DP"}}});
  files["hOmSave7/s7hss30x/HOBJECT1.DBF"] = s7p_files::table(columns, {{{"ID", "1"},
                                                                        {"OBJTYP", "1314974"},
                                                                        {"UNITID", "1"},
                                                                        {"UNITTYP", "1314969"},
                                                                        {"NAME", "UR"}}});
  files["hOmSave7/s7hstatx/HOBJECT1.DBF"] =
      s7p_files::table(columns, {{{"ID", "1"},
                                  {"OBJTYP", "1314969"},
                                  {"UNITID", "3"},
                                  {"UNITTYP", "1"},
                                  {"NAME", "SIMATIC 300(1)"}}});
  const auto projects = projectsOf(folder, files, faults);
  EXPECT_EQ(projects[0].programs[0].cpu, "CPU 315-2 DP");
  EXPECT_EQ(projects[0].programs[0].station, "SIMATIC 300(1)");
}

}  // namespace
}  // namespace merker::s7p
