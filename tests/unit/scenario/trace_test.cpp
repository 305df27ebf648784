#include "scenario/trace.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "machine.h"
#include "scenario/coverage.h"

namespace merker::simulator {
namespace {

constexpr const char* kProgram = R"(ORGANIZATION_BLOCK OB 1
BEGIN
NETWORK
      U     E 0.0
      =     A 0.0
      SPBN  over
      L     5
      T     MW 10
over: NOP 0
END_ORGANIZATION_BLOCK
)";

std::string traced(const Machine& machine) {
  std::ostringstream out;
  station::Station station = machine.station();
  startFresh(station);
  Trace trace(
      out,
      {{machine.reference("E 0.0"), machine.reference("A 0.0"), machine.reference("MW 10")}, {}},
      station);
  station.onCycle([&](controller::Controller& s) { trace.sample(s); });
  station.advanceTo({10'000'000});
  station.write(machine.reference("E 0.0"), 1);
  station.advanceTo({20'000'000});
  return out.str();
}

TEST(Trace, TextsInTheirNotation) {
  const Machine machine(
      "DATA_BLOCK DB 1\nSTRUCT\n s : STRING [4] := 'ab';\nEND_STRUCT;\nBEGIN\nEND_DATA_BLOCK\n"
      "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\nL B#16#78; T DB1.DBB 2;\nEND_ORGANIZATION_BLOCK\n");
  std::ostringstream out;
  station::Station station = machine.station();
  Trace trace(out, {{machine.reference("DB1.s")}, {}}, station);
  startFresh(station);
  station.advanceCycles(2);
  trace.sample(station);
  trace.sample(station);
  const std::string text = out.str();
  EXPECT_TRUE(text.ends_with(",DB1.s,'xb'\n")) << text;
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 1);
}

TEST(Trace, OneLinePerChange) {
  const Machine machine(kProgram);
  std::istringstream lines(traced(machine));
  std::vector<std::string> seen;
  for (std::string line; std::getline(lines, line);) {
    EXPECT_NEAR(std::stod(line), 0.012, 0.003) << line;
    seen.push_back(line.substr(line.find(',') + 1));
  }
  EXPECT_EQ(seen.size(), 3u);
  EXPECT_NE(std::find(seen.begin(), seen.end(), "A 0.0,1"), seen.end());
  EXPECT_NE(std::find(seen.begin(), seen.end(), "MW 10,W#16#0005"), seen.end());
}

TEST(Trace, TwoRunsGiveTheSameBytes) {
  const Machine machine(kProgram);
  EXPECT_EQ(traced(machine), traced(machine));
}

TEST(Coverage, LinesThatRanAndLinesThatDidNot) {
  const Machine machine(kProgram);
  station::Station station = machine.station(true);
  startFresh(station);
  station.advanceCycles(10);
  Coverage coverage;
  coverage.add(station);
  std::ostringstream out;
  coverage.write(out);
  EXPECT_TRUE(out.str().starts_with("TN:\nSF:test.awl\nDA:4,1")) << out.str();
  EXPECT_NE(out.str().find("DA:7,0\nDA:8,0\n"), std::string::npos) << out.str();
  EXPECT_NE(out.str().find("LF:6\nLH:4\nend_of_record\n"), std::string::npos) << out.str();
}

}  // namespace
}  // namespace merker::simulator
