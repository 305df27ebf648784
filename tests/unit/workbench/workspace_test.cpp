// Where projects lie: copies of examples, new ones, and what may be opened.
#include "workbench/workspace.h"

#include <fmt/format.h>

#include "bench.h"
#include "catalogue/cpu_model.h"
#include "workbench/start_declaration.h"

namespace merker::workbench::test {
namespace {

namespace fs = std::filesystem;

class Projects : public ::testing::Test {
 protected:
  Projects() {
    folder.write("examples/lift/README.md",
                 "# The `lift`\n\n| a |\n\nGoes up\nand down:\n\nMore.\n");
    folder.write("examples/lift/merker.toml", "[project]\n");
    folder.write("examples/course/two/merker.toml", "[project]\n");
    folder.write("given/merker.toml", "[project]\n");
  }
  static std::string codeOf(const Result<std::string>& result) {
    return result ? "made " + *result : std::string(result.error().name());
  }
  Folder folder;
  Workspace workspace{folder.path("mine"), folder.path("examples"), folder.path("given")};
};

TEST_F(Projects, ExamplesAreDescribed) {
  const auto list = workspace.examples();
  ASSERT_EQ(list.size(), 2u);
  EXPECT_EQ(list[0].id, "course/two");
  EXPECT_EQ(list[0].title, "two");
  EXPECT_EQ(list[1].id, "lift");
  EXPECT_EQ(list[1].title, "The lift");
  EXPECT_EQ(list[1].description, "Goes up and down.");
}

TEST_F(Projects, AnExampleIsCopiedOnce) {
  const auto copy = workspace.copyExample("course/two");
  ASSERT_TRUE(copy);
  EXPECT_EQ(*copy, folder.path("mine/course-two"));
  folder.write("mine/course-two/merker.toml", "[project]\nname = \"changed\"\n");
  EXPECT_EQ(codeOf(workspace.copyExample("course/two")), "made " + *copy);
  EXPECT_EQ(folder.read("mine/course-two/merker.toml"), "[project]\nname = \"changed\"\n");
  for (const char* none : {"", "course", "nothing", "../given"})
    EXPECT_EQ(codeOf(workspace.copyExample(none)), "P1316") << none;
}

TEST_F(Projects, ACopyHasGermanWordsWhereTheyAreWanted) {
  folder.write("examples/lift/german.txt",
               "# words\nLift\tAufzug\nCall 1\tRuf 1\nwaits\twartet\nDoor jams\tTür klemmt\n"
               "#Cabin\tKabine\n");
  folder.write("examples/lift/merker.toml",
               "[project]\nname = \"Lift\" # waits\n[[plant]]\nname = \"Cabin\"\nkind = \"Lift\"\n"
               "UP = \"Cabin.DO0\"\n6000 = \"Door jams\"\n");
  folder.write("examples/lift/lift.awl",
               "TITLE = Lift\n      U     \"Call 1\"; // waits\n      U     \"Call 11\"; // waits "
               "here\n      L     #Cabin; //= \"Call 1\" = 1, DB1.Cabin = 1, Cabins = 2\n");
  folder.write("examples/lift/doors/main.s5", "NETZWERK 1  Lift\n : !=F\n : UN   E 1.0 ! waits\n");
  folder.write("examples/lift/lift.scn",
               "scenario \"waits\"\n  plant Cabin.UP = W#16#1  # waits\n");
  folder.write("examples/lift/README.md", "# Lift\n");
  folder.write("examples/lift/README.de.md", "# Aufzug\n");
  ASSERT_TRUE(workspace.copyExample("lift", false, true));
  EXPECT_EQ(folder.read("mine/lift/README.md"), "# Aufzug\n");
  EXPECT_FALSE(fs::exists(folder.path("mine/lift/README.de.md")));
  EXPECT_EQ(folder.read("mine/lift/lift.awl"),
            "TITLE = Aufzug\n      U     \"Ruf 1\"; // wartet\n      U     \"Call 11\"; // waits "
            "here\n      L     #Kabine; //= \"Ruf 1\" = 1, DB1.Kabine = 1, Cabins = 2\n");
  EXPECT_EQ(folder.read("mine/lift/merker.toml"),
            "[project]\nname = \"Aufzug\" # wartet\n[[plant]]\nname = \"Kabine\"\nkind = \"Lift\"\n"
            "UP = \"Kabine.DO0\"\n6000 = \"Tür klemmt\"\n");
  EXPECT_EQ(folder.read("mine/lift/doors/main.s5"),
            "NETZWERK 1  Aufzug\n : !=F\n : UN   E 1.0 ! wartet\n");
  EXPECT_EQ(folder.read("mine/lift/lift.scn"),
            "scenario \"wartet\"\n  plant Kabine.UP = W#16#1  # wartet\n");
  EXPECT_FALSE(fs::exists(folder.path("mine/lift/german.txt")));
  ASSERT_TRUE(workspace.copyExample("lift", true));
  EXPECT_EQ(folder.read("mine/lift 2/lift.awl"), folder.read("examples/lift/lift.awl"));
  EXPECT_FALSE(fs::exists(folder.path("mine/lift 2/german.txt")));
  EXPECT_EQ(folder.read("mine/lift 2/README.md"), "# Lift\n");
  EXPECT_FALSE(fs::exists(folder.path("mine/lift 2/README.de.md")));
}

TEST_F(Projects, ThoseThatNameEachOtherAreCopiedTogether) {
  folder.write("examples/course/pair/one/merker.toml", "[coupling]\npartner = \"../other\"\n");
  folder.write("examples/course/pair/other/merker.toml", "[project]\n");
  const auto copy = workspace.copyExample("course/pair/one");
  ASSERT_TRUE(copy);
  EXPECT_EQ(*copy, folder.path("mine/course-pair/one"));
  EXPECT_TRUE(fs::exists(folder.path("mine/course-pair/other/merker.toml")));
  EXPECT_EQ(codeOf(workspace.copyExample("course/pair/other")),
            "made " + folder.path("mine/course-pair/other"));
}

TEST_F(Projects, AFreshCopyOfAnExampleLiesBesideTheOldOne) {
  EXPECT_FALSE(workspace.examples()[0].copied);
  ASSERT_TRUE(workspace.copyExample("course/two", true));
  EXPECT_TRUE(workspace.examples()[0].copied);
  folder.write("mine/course-two/merker.toml", "[project]\nname = \"changed\"\n");
  EXPECT_EQ(codeOf(workspace.copyExample("course/two", true)),
            "made " + folder.path("mine/course-two 2"));
  EXPECT_EQ(folder.read("mine/course-two 2/merker.toml"), "[project]\n");
  EXPECT_EQ(folder.read("mine/course-two/merker.toml"), "[project]\nname = \"changed\"\n");
}

TEST_F(Projects, ThoseOfTheWorkspaceAreListed) {
  folder.write("mine/lift/merker.toml", "[project]\n");
  folder.write("mine/plant/mill/merker.toml", "[project]\n");
  folder.write("mine/lift/inner/merker.toml", "[project]\n");
  folder.write("mine/notes/text.txt", "x");
  EXPECT_EQ(workspace.projects(), (std::vector<std::string>{"lift", "plant/mill"}));
}

// S7-MGR-01
TEST_F(Projects, ANewOneIsMadeOnce) {
  NewProject wanted{.name = "Press", .model = "314C-2 PtP", .form = "empty", .mpiAddress = 4};
  EXPECT_EQ(codeOf(workspace.make(wanted)), "made " + folder.path("mine/Press"));
  EXPECT_NE(folder.read("mine/Press/merker.toml").find("mpi_address = 4"), std::string::npos);
  EXPECT_NE(folder.read("mine/Press/main.awl").find("ORGANIZATION_BLOCK OB 1"), std::string::npos);
  EXPECT_TRUE(fs::exists(folder.path("mine/Press/symbols.sym")));
  EXPECT_EQ(codeOf(workspace.make(wanted)), "P1312");
  wanted.name = "a/b";
  EXPECT_EQ(codeOf(workspace.make(wanted)), "P1317");
  wanted.name = "Other";
  wanted.form = "none";
  EXPECT_EQ(codeOf(workspace.make(wanted)), "P1316");
  wanted.form = "empty";
  wanted.model = "315";
  EXPECT_EQ(codeOf(workspace.make(wanted)), "P0705");
}

// S7-OBI-02, S7-FC-09: with its start information by name; what follows stands at 20.0.
TEST_F(Projects, ItsOrganizationBlocksDeclareTheirStartInformation) {
  const NewProject wanted{.name = "Line", .model = "generic", .form = "errors", .ob = 35};
  ASSERT_EQ(codeOf(workspace.make(wanted)), "made " + folder.path("mine/Line"));
  const auto built = compilation::build(project::load(folder.path("mine/Line"), {}), true);
  ASSERT_TRUE(built.ok()) << dump(toJson(built.problems));
  const auto& variables = built.program->at({BlockKind::OB, 1}).variables;
  ASSERT_EQ(variables.size(), 10u);
  EXPECT_EQ(variables[1].name, "OB1_SCAN_1");
  EXPECT_EQ(variables[6].name, "OB1_PREV_CYCLE");
  for (const auto& [id, block] : *built.program) EXPECT_EQ(block.localBytes, 20u) << toString(id);
}

// S7-OBI-01: any block has 20 bytes, without gaps.
TEST(StartDeclaration, OfAnyBlockHasTwentyBytes) {
  const Folder folder;
  folder.write("merker.toml", "[cpu]\nmodel = \"generic\"\n");
  std::string text;
  const CpuModel& model = *findCpuModel("generic");
  for (const std::uint32_t ob : model.organizationBlocks)
    text += fmt::format(
        "ORGANIZATION_BLOCK OB {}\n{}VAR_TEMP\n own : BYTE;\nEND_VAR\nBEGIN\nNETWORK\n"
        "END_ORGANIZATION_BLOCK\n",
        ob, startDeclaration(ob));
  folder.write("main.awl", text);
  const auto built = compilation::build(project::load(folder.path(), {}), true);
  ASSERT_TRUE(built.ok()) << dump(toJson(built.problems));
  EXPECT_EQ(built.program->size(), model.organizationBlocks.size());
  for (const auto& [id, block] : *built.program) {
    const auto& own = block.variables.back();
    EXPECT_EQ(own.address, 20u * 8) << toString(id);
    std::size_t bits = 0;  // no gaps
    for (const block::Variable& one : block.variables) bits += block::sizeInBits(*one.type);
    EXPECT_EQ(bits, 21u * 8) << toString(id);
  }
}

TEST_F(Projects, ANewOneOfASinumerikIsAListing) {
  const NewProject wanted{.name = "Mill", .model = "SINUMERIK 810 GA3", .form = "empty"};
  ASSERT_EQ(codeOf(workspace.make(wanted)), "made " + folder.path("mine/Mill"));
  const auto built = compilation::build(project::load(folder.path("mine/Mill"), {}), true);
  EXPECT_TRUE(built.ok()) << dump(toJson(built.problems));
  EXPECT_TRUE(built.isListing());
  EXPECT_TRUE(fs::exists(folder.path("mine/Mill/symbols.seq")));
}

TEST_F(Projects, OnlyThoseOfTheWorkspaceAndTheGivenOneAreOpened) {
  EXPECT_EQ(codeOf(workspace.folderToOpen("Press")), "made " + folder.path("mine/Press"));
  EXPECT_EQ(codeOf(workspace.folderToOpen(folder.path("given"))), "made " + folder.path("given"));
  for (const std::string& outside :
       {std::string(), std::string("../given2"), std::string("../examples/lift"),
        std::string("/etc"), std::string("a\0b", 3)})
    EXPECT_EQ(codeOf(workspace.folderToOpen(outside)), "P1318") << outside;
}

}  // namespace
}  // namespace merker::workbench::test
