// What the course and the manual show as KOP and FUP, drawn element by element in a text that has
// no statement yet: the text is then their statement list, with what is stored for open pins.
#include <gtest/gtest.h>

#include "drawing.h"

namespace merker::networks {
namespace {

constexpr std::string_view kNothingDrawn =
    "FUNCTION FC 1 : VOID\nBEGIN\nNETWORK\nTITLE =\n\nEND_FUNCTION\n"
    "FUNCTION FC 2 : VOID\nVAR_INPUT\n  First : INT ;\nEND_VAR\n"
    "VAR_OUTPUT\n  Sum : INT ;\nEND_VAR\nBEGIN\nNETWORK\nEND_FUNCTION\n";

constexpr std::string_view kNothingDrawnInStep5 = "PB 1\nNETZWERK 1 Timer\n      BE\n";

constexpr std::string_view kWorkedExample = "U E 0.0; U E 0.1; O A 1.0; = A 3.0";

// S7-EDIT-15: two rungs of a ladder
TEST(Course, workedExampleAsLadder) {
  EXPECT_EQ(Drawing(kNothingDrawn)
                .add("CONTACT", {"E 0.0"})
                .add("CONTACT", {"E 0.1"})
                .add("COIL", {"A 3.0"})
                .insert({0}, graph::Place::Parallel, "CONTACT", {"A 1.0"})
                .closeBranch()
                .text(),
            kWorkedExample);
}

// S7-EDIT-14: AND box, OR box, assignment
TEST(Course, workedExampleAsFunctionBlocks) {
  EXPECT_EQ(Drawing(kNothingDrawn)
                .insert({}, graph::Place::Behind, "AND", {})
                .name("E 0.0")
                .name(1, "E 0.1")
                .insert({1, graph::kNoPin, 0}, graph::Place::Behind, "OR", {})
                .name("A 1.0")
                .insert({2, graph::kNoPin, 0}, graph::Place::Behind, "COIL", {"A 3.0"})
                .text(),
            kWorkedExample);
}

// S7-SETRESET-05: R below S, S below R
TEST(Course, latches) {
  EXPECT_EQ(
      Drawing(kNothingDrawn).add("CONTACT", {"E 0.1"}).add("SR", {"A 0.1"}).name(2, "E 0.2").text(),
      "U E 0.1; S A 0.1; U E 0.2; R A 0.1; NOP 0");
  EXPECT_EQ(
      Drawing(kNothingDrawn).add("CONTACT", {"E 0.2"}).add("RS", {"A 0.2"}).name(2, "E 0.1").text(),
      "U E 0.2; R A 0.2; U E 0.1; S A 0.2; NOP 0");
}

// S7-CNT-11: the operands of 15.4, and boxes with one count input
TEST(Course, counters) {
  EXPECT_EQ(Drawing(kNothingDrawn)
                .add("CONTACT", {"E 0.0"})
                .add("S_CUD", {"Z 1", "", "", "", "", "", "MW 0", "MW 2"})
                .add(2, "E 0.1")
                .add(3, "E 0.2")
                .give(4, "C#25")
                .add(5, "E 0.3")
                .add("COIL", {"M 10.0"})
                .text(),
            "U E 0.0; ZV Z 1; U E 0.1; ZR Z 1; U E 0.2; L C#25; S Z 1; U E 0.3; R Z 1; "
            "L Z 1; T MW 0; LC Z 1; T MW 2; U Z 1; = M 10.0");
  EXPECT_EQ(Drawing(kNothingDrawn).add("CONTACT", {"E 0.0"}).add("S_CU", {"Z 1"}).text(),
            "U E 0.0; ZV Z 1; BLD 101; NOP 0; NOP 0; NOP 0; NOP 0; NOP 0; NOP 0");
  EXPECT_EQ(
      Drawing(kNothingDrawn).add("CONTACT", {"E 0.0"}).add("S_CD", {"Z 1"}).add(4, "E 0.3").text(),
      "U E 0.0; ZR Z 1; BLD 101; NOP 0; NOP 0; U E 0.3; R Z 1; NOP 0; NOP 0; NOP 0");
}

// S7-TMR-09: the operands of 16.3, and the other kinds
TEST(Course, timers) {
  EXPECT_EQ(Drawing(kNothingDrawn)
                .add("CONTACT", {"E 0.0"})
                .add("S_ODT", {"T 1", "", "S5T#10S", "", "MW 0", "MW 2"})
                .add(3, "E 0.1")
                .add("COIL", {"A 0.0"})
                .text(),
            "U E 0.0; L S5T#10S; SE T 1; U E 0.1; R T 1; L T 1; T MW 0; LC T 1; T MW 2; "
            "U T 1; = A 0.0");
  const std::pair<std::string, std::string> kinds[] = {
      {"S_PULSE", "SI"}, {"S_PEXT", "SV"}, {"S_ODTS", "SS"}, {"S_OFFDT", "SA"}};
  for (const auto& [box, operation] : kinds)
    EXPECT_EQ(Drawing(kNothingDrawn)
                  .add("CONTACT", {"E 0.0"})
                  .add(box, {"T 1", "", "S5T#5S"})
                  .add("COIL", {"A 0.0"})
                  .text(),
              "U E 0.0; L S5T#5S; " + operation + " T 1; NOP 0; NOP 0; NOP 0; U T 1; = A 0.0");
}

// S7-PAR-08: EN and ENO of a box that calls
TEST(Course, calls) {
  EXPECT_EQ(Drawing(kNothingDrawn)
                .add("CALL_BOX", {"FC 2"})
                .give(1, "MW 20")
                .give(2, "MW 44")
                .add(0, "E 0.1")
                .add("COIL", {"A 4.0"})
                .text(),
            "U E 0.1; SPBNB _001; CALL FC 2 ( First := MW 20, Sum := MW 44); _001: U BIE; = A 4.0");
}

// S7-EDIT-10: nothing but a box loads, and it loads no indirect operand
TEST(Course, loadsInBoxesOnly) {
  for (const std::string operation : {"L", "T", "LOAD", "TRANSFER"})
    EXPECT_EQ(Drawing(kNothingDrawn).add(operation, {"MW 10"}).text(), "the element is unknown");
  EXPECT_EQ(Drawing(kNothingDrawn).add("MOVE", {"", "MW 10", "MW 12"}).text(),
            "L MW 10; T MW 12; NOP 0");
  for (const std::string operand : {"MW [MD 10]", "W [AR1,P#0.0]"}) {
    const std::string after = Drawing(kNothingDrawn).add("MOVE", {"", operand, "MW 12"}).text();
    EXPECT_EQ(after.find(operand), std::string::npos) << after;
  }
}

// S5-CODE-02, S5-LOAD-11: what stands at DU and DE is loaded from the timer
TEST(Manual, timers) {
  EXPECT_EQ(Drawing(kNothingDrawnInStep5, source::Language::Step5)
                .add("CONTACT", {"E 5.0"})
                .add("SI", {"T 10", "", "EW 22", "", "AW 64", "AW 50"})
                .text(),
            "U E 5.0; L EW 22; SI T 10; NOP 0; L T 10; T AW 64; LC T 10; T AW 50; NOP 0");
}

}  // namespace
}  // namespace merker::networks
