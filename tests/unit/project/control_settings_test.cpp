// What merker.toml says of a SINUMERIK.
#include <gtest/gtest.h>

#include "project/settings.h"

namespace merker::project {
namespace {

struct ControlRead {
  Settings settings;
  Problems problems;
  // "2:1 P0703" of the only problem.
  std::string problem() const {
    if (problems.size() != 1) return std::to_string(problems.size()) + " problems";
    const Problem& p = problems.list()[0];
    return std::to_string(p.position.line) + ":" + std::to_string(p.position.column) + " " +
           std::string(p.name());
  }
};

// The tables begin in line 3.
ControlRead readControl(const std::string& tables) {
  ControlRead result;
  result.settings = readSettings(
      source::SourceFile("merker.toml", "[cpu]\nmodel = \"SINUMERIK 810 GA3\"\n" + tables),
      result.problems);
  return result;
}

TEST(ControlSettings, DataOfTheNc) {
  const ControlRead r = readControl(R"([nc]
input_system = "inch"
alarms = [3016, 2041]
machining_stop = true
[nc.machine_data]
4999 = -1
[nc.position]
5 = -12345
[nc.following_error]
1 = 70000
[nc.feed]
2 = "1425.67"
[nc.spindle_speed]
2 = 1500
[nc.tool.99]
15 = "-0.5"
[nc.parameters.2]
499 = "12"
[nc.parameters.0]
900 = "1.25"
)");
  EXPECT_TRUE(r.problems.empty());
  ASSERT_TRUE(r.settings.control);
  const nc::Control& control = r.settings.control->control;
  EXPECT_EQ(control.inputSystem, nc::InputSystem::Inch);
  EXPECT_EQ(control.alarms, (std::vector<std::uint16_t>{3016, 2041}));
  EXPECT_TRUE(control.machiningStop);
  EXPECT_EQ(control.machineData[4999], -1);
  EXPECT_EQ(control.axes[4].position, -12345);
  EXPECT_EQ(control.axes[0].followingError, 70000);
  EXPECT_EQ(control.axes[1].feed[0], (nc::Number{142567, 2}));
  EXPECT_EQ(control.spindleSpeed[1], 1500);
  EXPECT_EQ(control.tools[98][15], (nc::Number{-5, 1}));
  EXPECT_EQ(control.parameters[1][499], (nc::Number{12, 0}));
  EXPECT_EQ(control.centralParameters[0], (nc::Number{125, 2}));
}

TEST(ControlSettings, WrongNumbersHaveTheirPlace) {
  EXPECT_EQ(readControl("[nc.feed]\n1 = \"1.2.3\"\n").problem().substr(0, 4), "4:5 ");
  EXPECT_EQ(readControl("[nc.feed]\n1 = \"123456789\"\n").problem().substr(0, 4), "4:5 ");
  EXPECT_EQ(readControl("[nc.feed]\n1 = 12\n").problem().substr(0, 4), "4:5 ");
  EXPECT_EQ(readControl("[nc.feed]\n1 = \"\"\n").problem().substr(0, 4), "4:5 ");
  EXPECT_EQ(readControl("[nc.feed]\n6 = \"1\"\n").problem(), "4:1 P0703");
  EXPECT_NE(readControl("[nc.tool.100]\n1 = \"1\"\n").problem().find("P0703"), std::string::npos);
  EXPECT_EQ(readControl("[nc.parameters.0]\n50 = \"1\"\n").problem(), "4:1 P0703");
  EXPECT_NE(readControl("[nc.parameters.3]\n50 = \"1\"\n").problem().find("P0703"),
            std::string::npos);
  EXPECT_EQ(readControl("[nc]\nfed = 1\n").problem(), "4:1 P0703");
}

}  // namespace
}  // namespace merker::project
