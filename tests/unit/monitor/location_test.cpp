#include <gtest/gtest.h>

#include "plc.h"

namespace merker::monitor::test {
namespace {

struct Location : ::testing::Test {
  Plc plc{kProgram, "\"Adder\" FC 1\n\"Motor\" A 0.0 BOOL\n"};
  std::string find(const std::string& text) {
    const auto place = findLocation(text, plc->locations("plant.awl"));
    if (!place) return std::string(place.error().name());
    return toString(place->block) + ":" + std::to_string(place->line);
  }
};

TEST_F(Location, IsWrittenInManyWays) {
  for (const char* text :
       {"FC 1:12", "FC1:12", "fc1 : 12", "plant.awl:12", "12", "\"Adder\":12", "FC 1 byte 8"})
    EXPECT_EQ(find(text), "FC 1:12") << text;
  EXPECT_EQ(find("FC 1"), "FC 1:10");
  EXPECT_EQ(find("FC 1 network 2"), "FC 1:14");
  EXPECT_EQ(find("FC1 nw 1"), "FC 1:10");
  EXPECT_EQ(find("13"), "FC 1:14");  // a line without statement: the next one
  EXPECT_EQ(find("17"), "OB 1:20");
}

TEST_F(Location, ThatIsWrongSaysWhy) {
  EXPECT_EQ(find("nonsense"), "P1201");
  EXPECT_EQ(find(""), "P1201");
  EXPECT_EQ(find("FC 1 network"), "P1201");
  EXPECT_EQ(find("\"Motor\""), "P1201");
  EXPECT_EQ(find("other.awl:3"), "P1202");
  EXPECT_EQ(find("FC 1:20"), "P1203");
  EXPECT_EQ(find("FC 1:2"), "P1203");
  EXPECT_EQ(find("900"), "P1204");
  EXPECT_EQ(find("FC 1 network 3"), "P1205");
  EXPECT_EQ(find("FC 1 network 0"), "P1205");
  EXPECT_EQ(find("FC 7:1"), "P1206");
}

TEST_F(Location, KnowsStatements) {
  const block::Block& fc = plc.program().at({BlockKind::FC, 1});
  const SourcePlace place = plc.place("FC 1:11");
  EXPECT_EQ(statementAt(fc, place.offset).line, 11u);
  EXPECT_EQ(statementAt(fc, place.offset + 2).begin, place.offset);
  EXPECT_TRUE(beginsStatement(fc, place.offset));
  EXPECT_FALSE(beginsStatement(fc, place.offset + 2));
  EXPECT_EQ(place.network, 1u);
  EXPECT_EQ(toString(place), "FC 1 byte 4 (plant.awl:11)");
}

// S7-STATE-07: HALT comes before an instruction; a byte inside one, or in the list behind a call,
// means it.
TEST(Breakpoint, StandsBeforeAnInstruction) {
  Plc plc(kProgram);
  const auto call = plc.place("23");
  std::string code = toString(call.block) + " byte ";
  EXPECT_EQ(plc.place(code + std::to_string(call.offset)).offset, call.offset);
  EXPECT_EQ(plc.place(code + std::to_string(call.offset + 1)).offset, call.offset);
  const auto next = plc.place("24");
  EXPECT_LT(plc.place(code + std::to_string(next.offset - 1)).offset, next.offset);
  for (std::uint32_t byte = 0; byte < plc.program().at(call.block).code.size(); ++byte) {
    Plc other(kProgram);
    other.breakAt(code + std::to_string(byte));
    other.start();
    other->write("M 0.0",
                 byte >= plc.place("26").offset && byte < plc.place("27").offset ? "1" : "0");
    EXPECT_EQ(other.run().why, Pause::Why::Breakpoint) << byte;
  }
}

}  // namespace
}  // namespace merker::monitor::test
