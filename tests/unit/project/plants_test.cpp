// [[plant]]: what is read, and each wrong one as one problem with its place.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "project/settings.h"

namespace merker::project {
namespace {

struct WrongLine {
  std::string_view name;
  std::string_view text;     // merker.toml
  std::string_view problem;  // "line:column code"
  std::string_view words;    // that the message contains
};

#define OVEN "[[plant]]\nname = \"Oven\"\nkind = \"first order\"\n"
#define SECOND "[[plant]]\nname = \"B\"\nkind = \"first order\"\n"
#define BOARD "[hardware]\n"

constexpr WrongLine kWrong[] = {
    {"noKind", "[[plant]]\nname = \"Oven\"\n", "1:1 P0760", "first order"},
    {"noName", "[[plant]]\nkind = \"first order\"\n", "1:1 P0760", "name"},
    {"unknownKind", "[[plant]]\nname = \"Oven\"\nkind = \"oven\"\n", "3:8 P0761", "first order"},
    {"blankInName", "[[plant]]\nname = \"my oven\"\nkind = \"first order\"\n", "2:8 P0704", "word"},
    {"nameTwice", OVEN OVEN, "5:8 P0742", "another plant"},
    {"unknownParameter", OVEN "gian = 2\n", "4:1 P0703", "gain"},
    {"parameterOutside", OVEN "time_constant = \"0s\"\n", "4:17 P0704", "1ms"},
    {"parameterIsText", OVEN "gain = \"2\"\n", "4:8 P0704", "a number from"},
    {"stepTooShort", OVEN "step = \"1us\"\n", "4:8 P0704", "0.1ms"},
    {"unknownSignal", BOARD OVEN "wire.SP = \"2.3.AO0\"\n", "5:6 P0762", "DISTURBANCE"},
    {"wireToNowhere", BOARD OVEN "wire.PV = \"9.AI0\"\n", "5:11 P0763", "9.AI0"},
    {"wireIsNumber", BOARD OVEN "wire.PV = 3\n", "5:11 P0704", "Panel.DO0"},
    {"wireToMissingChannel", BOARD OVEN "wire.PV = \"2.3.AI9\"\n", "5:11 P0984", "AI9"},
    {"wireToOutput", BOARD OVEN "wire.PV = \"2.3.AO0\"\n", "5:11 P0764", "an analog input"},
    {"wireToDigital", BOARD OVEN "wire.PV = \"2.2.DI0\"\n", "5:11 P0764", "AI"},
    {"outputToPlant", BOARD OVEN SECOND "wire.PV = \"Oven.LMN\"\n", "8:11 P0764", "with the input"},
    {"wireToUnknownSignal", BOARD OVEN SECOND "wire.LMN = \"Oven.X\"\n", "8:12 P0762",
     "no signal 'X'"},
    {"scaleBetweenPlants", BOARD OVEN SECOND "wire.LMN = { to = \"Oven.PV\", low = 1 }\n",
     "8:6 P0744", "analog terminal"},
    {"terminalTwice", BOARD OVEN "wire.PV = \"2.3.AI0\"\n" SECOND "wire.PV = \"2.3.AI0\"\n",
     "9:11 P0765", "Oven.PV"},
    {"standsBelow", BOARD OVEN "wire.LMN = \"B.PV\"\n" SECOND, "5:12 P0767", "below"},
    {"feedsItself", BOARD OVEN "wire.LMN = \"Oven.PV\"\n", "5:12 P0764", "itself"},
    {"fedByAWrongOne",
     BOARD "[[plant]]\nname = \"V\"\nkind = \"vavle\"\n" OVEN "wire.LMN = \"V.POSITION\"\n",
     "4:8 P0761", "valve"},
    {"wireTwice", BOARD OVEN "wire.PV = \"2.3.AI0\"\nwire.pv = \"2.3.AI1\"\n", "6:6 P0742",
     "another wire of PV"},
    {"slashInName", "[[plant]]\nname = \"a/b\"\nkind = \"first order\"\n", "2:8 P0704", "word"},
    {"wireToAnotherStation", BOARD OVEN "wire.LMN = \"Press/4.AO0\"\n", "5:12 P0704", "Press"},
    {"bitForANumber",
     BOARD "[[plant]]\nname = \"V\"\nkind = \"valve\"\n" SECOND "wire.LMN = \"V.LMNR_HS\"\n",
     "8:12 P0764", "that is a bit"},
    {"seedWithAPoint", OVEN "seed = 1.5\n", "4:8 P0704", "whole"},
    {"sameEnds", BOARD OVEN "wire.PV = { to = \"2.3.AI0\", low = 1, high = 1 }\n", "5:45 P0704",
     "different"},
};

class WrongPlant : public testing::TestWithParam<WrongLine> {};

TEST_P(WrongPlant, isOneProblemWithItsPlace) {
  Problems problems;
  readSettings(source::SourceFile("merker.toml", std::string(GetParam().text)), problems);
  ASSERT_EQ(problems.size(), 1u) << (problems.empty() ? "" : problems.list().back().message);
  const Problem& problem = problems.list().front();
  EXPECT_EQ(fmt::format("{}:{} {}", problem.position.line, problem.position.column, problem.name()),
            GetParam().problem)
      << problem.message;
  EXPECT_NE(problem.message.find(GetParam().words), std::string::npos) << problem.message;
}

INSTANTIATE_TEST_SUITE_P(Toml, WrongPlant, testing::ValuesIn(kWrong),
                         [](const auto& one) { return std::string(one.param.name); });

plant::PlantSettings plantOf(std::string text) {
  Problems problems;
  Settings settings =
      readSettings(source::SourceFile("merker.toml", BOARD OVEN + std::move(text)), problems);
  EXPECT_TRUE(problems.empty()) << (problems.empty() ? "" : problems.list()[0].message);
  return settings.plants.plants.at(0);
}

TEST(Plants, readsParametersAndWires) {
  const plant::PlantSettings oven =
      plantOf("gain = 3\ntime_constant = \"1m\"\nstep = \"100ms\"\nwire.LMN = \"2.3.AO1\"\n");
  EXPECT_EQ(oven.parameters, (std::vector<double>{3, 60, 0, 0, 0, 1}));
  EXPECT_EQ(oven.step, Duration::milliseconds(100));
  ASSERT_EQ(oven.wires.size(), 1u);
  EXPECT_EQ(std::get<io::Terminal>(oven.wires[0].end),
            (io::Terminal{1, io::Side::AnalogOutput, 1}));
}

// PID-SIM-07: 27648 = 10 V = 100 %; zero stays zero in a range with both signs.
TEST(Plants, scalesByTheRange) {
  const plant::PlantSettings plain = plantOf("wire.PV = \"2.3.AI0\"\n");
  EXPECT_DOUBLE_EQ(plain.wires[0].scale, 0.1);
  EXPECT_DOUBLE_EQ(plain.wires[0].offset, 0);
  const plant::PlantSettings given =
      plantOf("wire.PV = { to = \"2.3.AI0\", low = 0, high = 200 }\n");
  EXPECT_DOUBLE_EQ(given.wires[0].scale, 0.1);
  EXPECT_DOUBLE_EQ(given.wires[0].offset, -10);
}

}  // namespace
}  // namespace merker::project
