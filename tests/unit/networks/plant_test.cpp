// What a plant needs, drawn element by element: the function blocks of the sorting plant as their
// authors wrote them, and the networks that are in every other program.
#include <gtest/gtest.h>

#include "drawing.h"
#include "projects.h"

namespace merker::networks {
namespace {

constexpr auto kParallel = graph::Place::Parallel, kBranch = graph::Place::Branch;

compilation::Build sortingPlant(const std::map<std::string, std::string>& texts) {
  return compilation::build(
      project::load(MERKER_SOURCE_DIR "/examples/sorting-plant", "", {texts.begin(), texts.end()}),
      false);
}

bool isDrawn(const Block& block) {
  return block.symbol == "Classify box" || block.symbol == "Slider";
}

// Without what is drawn.
source::SourceFile emptied(const source::SourceFile& file, const Surroundings& around) {
  std::string text;
  std::set<std::uint32_t> gone;
  for (const Block& one : blocks(file, around))
    if (const auto block = blockAt(file, one.line, around); isDrawn(*block))
      for (const Network& network : block->networks)
        for (std::uint32_t line = network.source.code; line < network.source.end; ++line)
          gone.insert(line);
  for (std::uint32_t line = 1; line <= file.lineCount(); ++line)
    if (!gone.contains(line)) text += std::string(file.line(line)) + "\n";
  return {file.name(), text};
}

void drawClassifier(Drawing& drawing) {
  drawing.at("Classify box", 1)
      .add("CONTACT_NOT", {"#BeamSmall"})
      .add("SF", {"#FilterTime", "#Filter"})
      .rung("CONTACT", {"#FilterTime"})
      .add("COIL", {"#BoxThere"});
  drawing.at("Classify box", 2)
      .add("CONTACT_NOT", {"#BeamSmall"})
      .add("CONTACT_NOT", {"#BeamMiddle"})
      .add("S", {"#SeenMiddle"})
      .rung("CONTACT_NOT", {"#BeamSmall"})
      .add("CONTACT_NOT", {"#BeamLarge"})
      .add("S", {"#SeenLarge"});
  drawing.at("Classify box", 3)
      .add("CONTACT", {"#BoxThere"})
      .add("N", {"#Edge"})
      .add("COIL", {"#BoxLeft"});
  // the first one as FUP
  drawing.at("Classify box", 4)
      .rung("AND", {})
      .name("#BoxLeft")
      .name(1, "#SeenMiddle")
      .addInput()
      .name("#SeenLarge")
      .negate(1)
      .negate(2)
      .add("COIL", {"#Small"})
      .rung("CONTACT", {"#BoxLeft"})
      .add("CONTACT", {"#SeenMiddle"})
      .add("CONTACT_NOT", {"#SeenLarge"})
      .add("COIL", {"#Middle"})
      .rung("CONTACT", {"#BoxLeft"})
      .add("CONTACT", {"#SeenLarge"})
      .add("COIL", {"#Large"});
  drawing.at("Classify box", 5)
      .add("CONTACT", {"#BoxLeft"})
      .add("R", {"#SeenMiddle"})
      .add("R", {"#SeenLarge"});
}

void drawSlider(Drawing& drawing) {
  drawing.at("Slider", 1)
      .add("CONTACT", {"#OutTime"})
      .add("R", {"#Out"})
      .rung("CONTACT", {"#Out"})
      .add("SD", {"#OutTime", "#PushTime"});
  drawing.at("Slider", 2)
      .add("CONTACT", {"#TravelTime"})
      .add("S", {"#Out"})
      .add("R", {"#OnTheWay"})
      .rung("CONTACT", {"#OnTheWay"})
      .add("SD", {"#TravelTime", "#Travel"});
  drawing.at("Slider", 3).add("CONTACT", {"#Box"}).add("S", {"#OnTheWay"});
}

TEST(Plant, isDrawnAsItWasWritten) {
  const auto written = sortingPlant({});
  const Surroundings around = surroundingsOf(written);
  const source::SourceFile& file = written.project.sources.front();
  Drawing drawing(emptied(file, around), around);
  drawClassifier(drawing);
  drawSlider(drawing);
  EXPECT_EQ(drawing.refusal(), "");
  const auto drawn = sortingPlant({{file.name(), std::string(drawing.file().text())}});
  ASSERT_TRUE(drawn.ok());
  ASSERT_EQ(drawn.program->size(), written.program->size());
  for (const auto& [id, block] : *written.program)
    EXPECT_EQ(drawn.program->at(id).code, block.code) << toString(id);
}

constexpr std::string_view kBlocks =
    "FUNCTION FC 1 : VOID\nBEGIN\nNETWORK\nNETWORK\nU E 7.7; = A 7.7;\nEND_FUNCTION\n"
    "FUNCTION_BLOCK FB 1\nVAR_INPUT\n  Go : BOOL ;\n  Speed : INT ;\n  Stop : BOOL ;\nEND_VAR\n"
    "VAR_OUTPUT\n  Runs : BOOL ;\nEND_VAR\nBEGIN\nNETWORK\nEND_FUNCTION_BLOCK\n"
    "FUNCTION_BLOCK FB 2\nVAR\n  Motor : FB 1 ;\nEND_VAR\nBEGIN\nNETWORK\nEND_FUNCTION_BLOCK\n";

Drawing ladder() { return Drawing(kBlocks); }

TEST(Plant, flipFlopsWithBranches) {
  EXPECT_EQ(
      ladder()
          .add("CONTACT", {"E 0.0"})
          .add("SR", {"M 1.0"})
          .name(2, "E 0.2")
          .insert({2}, kParallel, "CONTACT_NOT", {"E 0.3"})
          .insert({0}, kParallel, "CONTACT", {"E 0.1"})
          .add("COIL", {"A 4.0"})
          .text(),
      "U(; O E 0.0; O E 0.1; ); S M 1.0; U(; O E 0.2; ON E 0.3; ); R M 1.0; U M 1.0; = A 4.0");
}

TEST(Plant, comparisonsInSeries) {
  EXPECT_EQ(ladder()
                .add("CONTACT", {"E 0.0"})
                .add("GE_I", {"", "MW 10", "5"})
                .add("LT_I", {"", "MW 10", "8"})
                .add("COIL", {"A 4.0"})
                .text(),
            "U E 0.0; U(; L MW 10; L 5; >=I; ); U(; L MW 10; L 8; <I; ); = A 4.0");
  EXPECT_EQ(ladder()
                .rung("GT_R", {"", "MD 10", "1.5"})
                .add("COIL", {"A 4.0"})
                .insert({2}, kParallel, "CONTACT", {"E 0.0"})
                .text(),
            "O(; L MD 10; L 1.5; >R; ); O E 0.0; = A 4.0");
}

TEST(Plant, boxesBehindEachOther) {
  EXPECT_EQ(ladder()
                .add("CONTACT", {"E 0.0"})
                .add("MOVE", {"", "MW 1", "MW 3"})
                .add("ADD_I", {"", "MW 3", "5", "MW 7"})
                .add("COIL", {"A 4.0"})
                .text(),
            "U(; U E 0.0; SPBNB _001; L MW 1; T MW 3; SET; SAVE; CLR; _001: U BIE; ); "
            "SPBNB _002; L MW 3; L 5; +I; T MW 7; UN OV; SAVE; CLR; _002: U BIE; = A 4.0");
}

TEST(Plant, callsOfFunctionBlocks) {
  EXPECT_EQ(ladder()
                .add("CALL_BOX", {"FB 1, DB 1"})
                .give(2, "MW 10")
                .give(4, "A 4.0")
                .add(1, "E 0.0")
                .add(3, "E 0.1")
                .add(0, "E 0.2")
                .text(),
            "U E 0.0; = L 0.0; BLD 103; U E 0.1; = L 0.1; BLD 103; U E 0.2; SPBNB _001; "
            "CALL FB 1, DB 1 ( Go := L 0.0, Speed := MW 10, Stop := L 0.1, Runs := A 4.0); "
            "_001: NOP 0");
  EXPECT_EQ(ladder().at("FB 2", 1).add("CALL_BOX", {"#Motor"}).give(2, "5").text(),
            "CALL #Motor ( Speed := 5); NOP 0");
}

// Of the other block: parameters with the same names keep what is given.
TEST(Plant, callsOfAnotherBlock) {
  Drawing drawing(
      "FUNCTION FC 1 : VOID\nBEGIN\nNETWORK\nCALL FC 2 (A := MW 10, B := 5); NOP 0;\nEND_FUNCTION\n"
      "FUNCTION FC 2 : VOID\nVAR_INPUT\n A : INT ;\n B : INT ;\nEND_VAR\nBEGIN\nEND_FUNCTION\n"
      "FUNCTION FC 3 : VOID\nVAR_INPUT\n B : INT ;\n C : INT ;\nEND_VAR\nBEGIN\nEND_FUNCTION\n");
  EXPECT_EQ(drawing.name(1, "FC 3").text(), "CALL FC 3 ( B := 5); NOP 0");
  EXPECT_EQ(drawing.give(2, "7").text(), "CALL FC 3 ( B := 5, C := 7); NOP 0");
}

// What is given without a contact stays so.
TEST(Plant, parametersKeepTheirForm) {
  Drawing drawing(
      "FUNCTION FC 1 : VOID\nVAR_INPUT\n  Go : BOOL ;\nEND_VAR\nBEGIN\nNETWORK\n"
      "      CALL FC 1 (\n           Go := E 0.0); // why\n      NOP   0;\nEND_FUNCTION\n");
  EXPECT_EQ(drawing.give(1, "E 0.1").text(), "CALL FC 1 ( Go := E 0.1); NOP 0");
  EXPECT_NE(drawing.file().text().find("// why"), std::string::npos);
}

TEST(Plant, jumps) {
  Drawing drawing = ladder();
  EXPECT_EQ(drawing.add("CONTACT", {"E 0.0"}).add("JMP", {"M001"}).text(), "U E 0.0; SPB M001");
  EXPECT_EQ(drawing.at("FC 1", 2).label("M001").text(), "M001: U E 7.7; = A 7.7");
  EXPECT_EQ(drawing.at("FC 1", 1).text(), "U E 0.0; SPB M001");
  EXPECT_EQ(ladder().rung("JMP_RAIL", {"M001"}).text(), "SPA M001");
  // The label is typed afterwards; it need not be there yet, and may look like an address.
  for (const char* jump : {"JMP", "JMP_RAIL", "JMPN"}) {
    Drawing later = ladder();
    const std::string word = jump == std::string("JMPN") ? "SPBN " : "SPB ";
    EXPECT_EQ(later.add("CONTACT", {"E 0.0"}).add(jump, {}).text(), "U E 0.0; " + word + "???");
    EXPECT_EQ(later.name("e1").text(), "U E 0.0; " + word + "e1");
    EXPECT_EQ(later.name("toolong").text().substr(0, 7), "a label");
  }
  EXPECT_EQ(ladder().rung("JMP", {}).text(), "SPA ???");
}

TEST(Plant, branchesOfARung) {
  EXPECT_EQ(ladder()
                .add("CONTACT", {"E 0.0"})
                .add("CONTACT", {"E 0.1"})
                .add("COIL", {"A 4.0"})
                .insert({0}, kBranch, "CONTACT", {"E 0.2"})
                .name(7, "A 4.1")
                .text(),
            "U E 0.0; = L 0.0; U L 0.0; U E 0.1; = A 4.0; U L 0.0; U E 0.2; = A 4.1");
  EXPECT_EQ(ladder()
                .add("CONTACT", {"E 0.0"})
                .add("COIL", {"A 4.0"})
                .insert({0}, kBranch, "S", {"A 4.1"})
                .text(),
            "U E 0.0; = L 0.0; U L 0.0; BLD 102; = A 4.0; U L 0.0; BLD 102; S A 4.1");
}

Drawing listing() { return Drawing("PB 1\nNETZWERK 1\n : BE\n", source::Language::Step5); }

// S5-CALL-05: PB 5 is a block here, not a byte
TEST(Plant, callsOfStep5) {
  EXPECT_EQ(listing().rung("CALL_RAIL", {"PB 5"}).name(0, "PB 6").text(), "SPA PB 6");
  EXPECT_EQ(listing().add("CONTACT", {"E 0.0"}).add("CALL_IF", {"PB 5"}).text(),
            "U E 0.0; SPB PB 5");
}

TEST(Plant, negationsOfStep5) {
  EXPECT_EQ(listing().add("CONTACT", {"E 0.0"}).negate(0).add("COIL", {"A 0.0"}).text(),
            "UN E 0.0; = A 0.0");
  EXPECT_EQ(listing()
                .add("CONTACT", {"E 0.0"})
                .add("CONTACT", {"E 0.1"})
                .add("COIL", {"A 0.0"})
                .negate(2)
                .text(),
            "only contacts can be negated here");
}

// F7 while the cursor stands in a branch: the rung ends.
TEST(Plant, coilsEndRungsWithoutOne) {
  EXPECT_EQ(ladder()
                .add("CONTACT", {"E 0.0"})
                .add("CONTACT", {"E 0.1"})
                .insert({0}, kParallel, "CONTACT", {"A 1.0"})
                .insert({2}, graph::Place::Behind, "COIL", {"A 3.0"})
                .text(),
            "U(; O E 0.0; O A 1.0; ); U E 0.1; = A 3.0");
}

// S5-KOPFUP-01, -02, -03: the worked example of the course in STEP 5
TEST(Plant, laddersOfStep5) {
  EXPECT_EQ(listing()
                .add("CONTACT", {"E 0.0"})
                .add("CONTACT", {"E 0.1"})
                .add("COIL", {"A 3.0"})
                .insert({0}, kParallel, "CONTACT", {"A 1.0"})
                .closeBranch()
                .text(),
            "U E 0.0; U E 0.1; O A 1.0; = A 3.0");
  EXPECT_EQ(listing()
                .rung("AND", {})
                .name("E 0.0")
                .name(1, "E 0.1")
                .insert({1, graph::kNoPin, 0}, graph::Place::Behind, "OR", {})
                .name("A 1.0")
                .insert({2, graph::kNoPin, 0}, graph::Place::Behind, "COIL", {"A 3.0"})
                .text(),
            "U E 0.0; U E 0.1; O A 1.0; = A 3.0");
  EXPECT_EQ(listing()
                .add("CONTACT", {"E 0.0"})
                .add("SR", {"M 1.0"})
                .name(2, "E 0.2")
                .insert({2}, kParallel, "CONTACT_NOT", {"E 0.3"})
                .add("COIL", {"A 4.0"})
                .text(),
            "U E 0.0; S M 1.0; U(; O E 0.2; ON E 0.3; ); R M 1.0; U M 1.0; = A 4.0");
}

}  // namespace
}  // namespace merker::networks
