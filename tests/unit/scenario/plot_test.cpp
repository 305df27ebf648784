// A trace read again and drawn.
#include "scenario/plot.h"

#include <gtest/gtest.h>

namespace merker::simulator {
namespace {

std::vector<Curve> read(std::string text, Problems& problems) {
  return readCurves(source::SourceFile("a.csv", std::move(text)), problems);
}

TEST(Curves, valuesOfEachNotation) {
  Problems problems;
  const auto curves = read(
      "0.5,A 0.0,1\n1.0,A 0.0,0\n1.0,MW 2,W#16#00FF\n1.5,DB1.T,T#2S\n"
      "2.0,DB1.R,2.500000e+001\n2.0,\"DB1.X[1,2]\",-7\n2.5,DB1.S,'text'\n",
      problems);
  EXPECT_TRUE(problems.empty());
  ASSERT_EQ(curves.size(), 5u);
  EXPECT_TRUE(curves[0].binary);
  EXPECT_EQ(curves[0].changes.size(), 2u);
  EXPECT_FALSE(curves[1].binary);
  EXPECT_EQ(curves[1].changes[0].value, 255);
  EXPECT_EQ(curves[2].changes[0].value, 2);
  EXPECT_EQ(curves[3].changes[0].value, 25);
  EXPECT_EQ(curves[4].operand, "DB1.X[1,2]");
  EXPECT_EQ(curves[4].changes[0].value, -7);
  EXPECT_EQ(endOf(curves), 2);
}

TEST(Curves, whatIsNoTrace) {
  Problems problems;
  read("0.5,A 0.0,1\nhello\n", problems);
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_EQ(problems.list()[0].name(), "P0990");
  EXPECT_EQ(problems.list()[0].position.line, 2u);
  Problems value;  // neither a number nor a text
  read("0.5,A 0.0,1\n0.7,MW 10,xyz\n", value);
  ASSERT_EQ(value.size(), 1u);
  EXPECT_EQ(value.list()[0].name(), "P0990");
  EXPECT_EQ(value.list()[0].position.line, 2u);
  EXPECT_EQ(value.list()[0].position.column, 11u);
  Problems texts;
  read("0.5,A 0.0,1\n0.7,DB1.S,'a longer text'\n0.8,DB1.D,DT#2020-1-2-3:4:5\n", texts);
  EXPECT_TRUE(texts.empty());
  Problems empty;
  read("", empty);
  EXPECT_EQ(empty.list().at(0).name(), "P0992");
}

TEST(Plot, steps) {
  EXPECT_DOUBLE_EQ(niceStep(0, 100, 5), 20);
  EXPECT_DOUBLE_EQ(niceStep(0, 101, 5), 50);
  EXPECT_DOUBLE_EQ(niceStep(-0.3, 0.3, 6), 0.1);
}

// The value stays until it changes: horizontal, then vertical.
TEST(Plot, curveOfABit) {
  Problems problems;
  Plot plot{"A < B", rowsOf(read("1.0,A 0.0,1\n3.0,A 0.0,0\n4.0,MW 2,9\n", problems)), 0, 4};
  const std::string svg = drawSvg(plot);
  EXPECT_NE(svg.find("A &lt; B"), std::string::npos);
  EXPECT_NE(svg.find("M70.0 84.0H272.5V62.0H677.5V84.0H880.0"), std::string::npos) << svg;
  EXPECT_NE(svg.find(">MW 2</text>"), std::string::npos);
}

// Many values in one column of pixels leave its lowest and its highest.
TEST(Plot, manyChanges) {
  Curve curve{"MW 2", false, {}};
  for (int i = 0; i <= 100'000; ++i) curve.changes.push_back({i / 1000.0, double(i % 10)});
  const std::string svg = drawSvg({"", rowsOf({curve}), 0, 100});
  EXPECT_LT(svg.size(), 150'000u);
  EXPECT_GT(svg.size(), 10'000u);
}

}  // namespace
}  // namespace merker::simulator
