#include "bench.h"

namespace merker::workbench::test {
namespace {

constexpr const char* kSource =
    "FUNCTION FC 1 : VOID\n"  // 1
    "BEGIN\n"
    "NETWORK\n"
    "      L     5;\n"  // 4
    "      T     MW 100;\n"
    "END_FUNCTION\n"
    "ORGANIZATION_BLOCK OB 1\n"
    "BEGIN\n"
    "NETWORK\n"
    "      U     E 0.0;\n"  // 10
    "      SPBN  end;\n"
    "      CALL  FC 1;\n"
    "end:  NOP   0;\n"
    "END_ORGANIZATION_BLOCK\n";

class Debugging : public ::testing::Test {
 protected:
  void input(const char* value) {
    bench.call("variables.write", {{"items", {{{"operand", "E 0.0"}, {"value", value}}}}});
    bench.run(Duration::milliseconds(20));
  }
  Json place() { return bench.state()["breakpoint"]; }
  // Frames bring probes to where they are wanted.
  Json status(Workbench::BrowserId who = 1) {
    Json last;
    for (int frame = 0; frame < 2; ++frame) {
      const Json event = bench.event("status", who);
      if (!event.is_null()) last = event;
      bench.run(Duration::milliseconds(20));
    }
    const Json event = bench.event("status", who);
    return event.is_null() ? last : event;
  }
  Bench bench{kSource};
};

// S7-EDIT-21
TEST_F(Debugging, StatusShowsTheLinesThatWereReached) {
  bench.call("status.show", {{"file", "main.awl"}, {"line", 10}});
  Json event = status();
  EXPECT_EQ(event["block"], "OB 1");
  EXPECT_EQ(event["file"], "main.awl");
  ASSERT_EQ(event["rows"].size(), 3u);
  EXPECT_EQ(event["rows"][0][0], 10);
  EXPECT_EQ(event["rows"][0][1], "0");  // VKE
  input("1");
  event = bench.event("status");
  ASSERT_EQ(event["rows"].size(), 4u);
  EXPECT_EQ(event["rows"][0][1], "1");
  EXPECT_TRUE(bench.event("status").is_null());  // nothing new
}

TEST_F(Debugging, ABlockThatDoesNotRunHasNoRows) {
  bench.call("status.show", {{"block", "FC 1"}});
  EXPECT_EQ(status()["rows"], nullptr);
  input("1");
  EXPECT_EQ(bench.event("status")["rows"].size(), 2u);
  EXPECT_EQ(bench.problem("status.show", {{"block", "FC 7"}}), "P1206");
}

TEST_F(Debugging, EachBrowserLooksAtItsOwnBlock) {
  bench.workbench.opened(2);
  input("1");
  bench.call("status.show", {{"block", "FC 1"}}, 1);
  bench.call("status.show", {{"block", "OB 1"}}, 2);
  EXPECT_EQ(status(1)["block"], "FC 1");
  EXPECT_EQ(status(2)["block"], "OB 1");
  bench.call("status.hide", Json::object(), 1);
  EXPECT_TRUE(status(1).is_null());
  bench.workbench.closed(1);
  bench.workbench.opened(1);
}

// S7-EDIT-21
TEST(StatusOfAnInstance, IsThatOfTheChosenDataBlock) {
  Bench bench{
      "FUNCTION_BLOCK FB 1\nVAR_INPUT\n a : INT;\nEND_VAR\nBEGIN\nNETWORK\n L #a;\n"
      "END_FUNCTION_BLOCK\n"
      "DATA_BLOCK DB 11 FB 1\nBEGIN\nEND_DATA_BLOCK\n"
      "DATA_BLOCK DB 12 FB 1\nBEGIN\nEND_DATA_BLOCK\n"
      "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\n CALL FB 1, DB 11 (a := 5);\n"
      " CALL FB 1, DB 12 (a := 7);\nEND_ORGANIZATION_BLOCK\n"};
  const auto shown = [&](const Json& fields) {
    bench.call("status.show", fields);
    bench.run(Duration::milliseconds(40));
    return bench.event("status");
  };
  Json event = shown({{"block", "FB 1"}});
  EXPECT_EQ(event["instances"], Json::array({11, 12}));
  EXPECT_EQ(event["instance"], 12);
  EXPECT_EQ(event["rows"][0][4], "00000007");
  event = shown({{"block", "FB 1"}, {"instance", 11}});
  EXPECT_EQ(event["instances"], Json::array({11, 12}));
  EXPECT_EQ(event["instance"], 11);
  EXPECT_EQ(event["rows"][0][4], "00000005");
  EXPECT_EQ(shown({{"block", "FB 1"}, {"instance", 13}})["rows"], nullptr);
  EXPECT_EQ(bench.problem("status.show", {{"block", "FB 1"}, {"instance", 0}}), "P1305");
}

// S7-STATE-07
TEST_F(Debugging, BreakpointsStopAndStepsGoOn) {
  const Json set = bench.call("breakpoints.set", {{"file", "main.awl"}, {"lines", {3, 500}}});
  EXPECT_EQ(set["lines"], Json::array({4}));  // the statement behind
  EXPECT_EQ(bench.state()["breakpoints"], Json({{"main.awl", {4}}}));
  EXPECT_EQ(place(), nullptr);
  input("1");
  EXPECT_EQ(bench.state()["mode"], "HALT");
  EXPECT_EQ(place()["line"], 4);
  EXPECT_EQ(place()["file"], "main.awl");
  EXPECT_EQ(place()["block"], "FC 1");
  bench.call("debug.step", {{"kind", "over"}});
  EXPECT_EQ(place()["line"], 5);
  bench.call("debug.step", {{"kind", "out"}});
  EXPECT_EQ(place()["block"], "OB 1");
  bench.call("debug.go");
  bench.run(Duration::milliseconds(20));
  EXPECT_EQ(place()["line"], 4);  // again
  bench.call("breakpoints.set", {{"file", "main.awl"}, {"lines", Json::array()}});
  bench.call("debug.go");
  bench.run(Duration::milliseconds(20));
  EXPECT_EQ(bench.state()["mode"], "RUN");
}

// Clients of S7 communication set breakpoints, too.
TEST_F(Debugging, BreakpointsOfOthersStay) {
  monitor::Debugger& debugger = bench.workbench.plc()->monitor().debugger();
  debugger.setBreakpoint({.block = {BlockKind::FC, 1}, .offset = 0, .file = "main.awl"});
  bench.call("breakpoints.set", {{"file", "main.awl"}, {"lines", {10}}});
  EXPECT_EQ(debugger.breakpoints().size(), 2u);
  bench.call("breakpoints.set", {{"file", "main.awl"}, {"lines", Json::array()}});
  ASSERT_EQ(debugger.breakpoints().size(), 1u);
  EXPECT_EQ(debugger.breakpoints()[0].place.block, (BlockId{BlockKind::FC, 1}));
}

TEST_F(Debugging, BreakpointsStayThroughALoad) {
  bench.call("breakpoints.set", {{"file", "main.awl"}, {"lines", {4}}});
  std::string text = kSource;
  text.replace(text.find("L     5"), 7, "L     6");
  bench.folder.write("main.awl", text);
  bench.call("program.load");
  bench.run(Duration::milliseconds(20));
  bench.events();
  input("1");
  EXPECT_EQ(place()["line"], 4);
}

TEST_F(Debugging, ABreakpointTakenAwayWhileALoadWaitsIsGone) {
  bench.call("breakpoints.set", {{"file", "main.awl"}, {"lines", {4}}});
  input("1");
  ASSERT_EQ(bench.state()["mode"], "HALT");
  bench.call("program.load");  // from the next checkpoint on
  bench.call("breakpoints.set", {{"file", "main.awl"}, {"lines", Json::array()}});
  bench.call("debug.go");
  bench.run(Duration::milliseconds(20));
  EXPECT_EQ(bench.state()["mode"], "RUN");
}

// "One cycle" while time stands: its values stay in sight.
TEST_F(Debugging, StatusOfOneCycleStays) {
  bench.call("time.pace", {{"mode", "pause"}});
  bench.call("status.show", {{"block", "OB 1"}});
  bench.call("time.step", {{"cycles", 2}});
  bench.run(Duration::milliseconds(20));
  EXPECT_EQ(bench.event("status")["rows"].size(), 3u);
  for (int frame = 0; frame < 30; ++frame) EXPECT_TRUE(bench.event("status").is_null());
}

TEST_F(Debugging, StatusStaysWhenSomebodyLooksAtAnotherBlockWhileTimeStands) {
  bench.workbench.opened(2);
  bench.call("status.show", {{"block", "OB 1"}});
  EXPECT_EQ(status()["rows"].size(), 3u);
  bench.call("time.pace", {{"mode", "pause"}});
  bench.events();
  bench.call("status.show", {{"block", "FC 1"}}, 2);
  for (int frame = 0; frame < 30; ++frame) EXPECT_TRUE(bench.event("status").is_null());
  // who comes now sees it too
  bench.call("status.show", {{"block", "OB 1"}}, 2);
  EXPECT_EQ(bench.event("status", 2)["rows"].size(), 3u);
}

// Inputs as they are handed over, outputs as they come back: at the CALL, not at the end of the
// cycle.
TEST(Debug, StatusOfACallHasTheValuesOfItsOperands) {
  Bench bench(R"(FUNCTION_BLOCK FB 90
VAR_INPUT
  a : BOOL;
  t : S5TIME;
  n : INT;
END_VAR
VAR_OUTPUT
  q : BOOL;
  r : REAL;
END_VAR
BEGIN
NETWORK
      U     #a;
      =     #q;
      L     2.5;
      T     #r;
      L     99;
      T     MW 10;
END_FUNCTION_BLOCK
DATA_BLOCK DB 90
FB 90
BEGIN
END_DATA_BLOCK
FUNCTION FC 90 : VOID
VAR_INPUT
  x : WORD;
END_VAR
VAR_OUTPUT
  y : INT;
END_VAR
BEGIN
NETWORK
      L     7;
      T     #y;
END_FUNCTION
ORGANIZATION_BLOCK OB 1
VAR_TEMP
  info : ARRAY [0..19] OF BYTE;
  rest : INT;
END_VAR
BEGIN
NETWORK
      L     5;
      T     MW 10;
      L     W#16#FF;
      T     MW 30;
      CALL  FB 90, DB 90 (
       a := E 0.0,
       t := S5T#50MS,
       n := MW 10,
       q := A 4.0,
       r := MD 20);
      CALL  FC 90 (
       x := MW 30,
       y := #rest);
      L     0;
      T     MD 20;
      T     #rest;
      U     E 0.7;
      SPB   end;
      CALL  FC 90 (
       x := MW 30,
       y := MW 32);
end:  NOP   0;
END_ORGANIZATION_BLOCK
)");
  bench.call("variables.write", {{"items", {{{"operand", "E 0.0"}, {"value", "1"}}}}});
  bench.call("status.show", {{"block", "OB 1"}});
  Json rows;
  for (int frame = 0; frame < 4; ++frame) {
    const Json event = bench.event("status");
    if (!event.is_null() && event["rows"].is_array()) rows = event["rows"];
    bench.run(Duration::milliseconds(20));
  }
  std::vector<Json> values;
  for (const Json& row : rows)
    if (!row.back().empty()) values.push_back(row.back());
  ASSERT_EQ(values.size(), 3u) << rows;
  EXPECT_EQ(values[0], Json({{"a", "TRUE"}, {"n", "5"}, {"q", "TRUE"}, {"r", "2.500000e+000"}}));
  EXPECT_EQ(values[1], Json({{"x", "W#16#00FF"}, {"y", "7"}}));
  EXPECT_EQ(values[2], Json({{"x", "W#16#00FF"}, {"y", "7"}}));
}

TEST_F(Debugging, StatusStaysInStop) {
  bench.call("status.show", {{"block", "OB 1"}});
  EXPECT_EQ(status()["rows"].size(), 3u);
  bench.call("cpu.stop");
  for (int frame = 0; frame < 30; ++frame) {
    bench.run(Duration::milliseconds(33));
    EXPECT_TRUE(bench.event("status").is_null());
  }
}

TEST_F(Debugging, NothingStepsInStop) {
  bench.call("cpu.stop");
  EXPECT_EQ(bench.problem("debug.step"), "P1308");
}

TEST(Debug, BreakpointsHaveALimit) {
  std::string source;
  for (int i = 0; i < 3; ++i) {
    source += "FUNCTION FC " + std::to_string(i + 1) + " : VOID\nBEGIN\nNETWORK\n";
    for (int line = 0; line < 100; ++line) source += "      L     1;\n";
    source += "END_FUNCTION\n";
  }
  Bench bench("ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\n      NOP   0;\nEND_ORGANIZATION_BLOCK\n");
  for (int i = 0; i < 3; ++i)
    bench.folder.write("f" + std::to_string(i) + ".awl",
                       source.substr(source.size() / 3 * i, source.size() / 3));
  bench.call("program.load");
  const auto set = [&](int file) {
    Json lines = Json::array();
    for (int line = 4; line < 104; ++line) lines.push_back(line);
    return bench.ask("breakpoints.set",
                     {{"file", "f" + std::to_string(file) + ".awl"}, {"lines", lines}});
  };
  EXPECT_EQ(set(0)["result"]["lines"].size(), 100u);
  EXPECT_EQ(set(1)["result"]["lines"].size(), 100u);
  EXPECT_EQ(set(2)["problems"][0]["code"], "P1314");
}

// A step over a call that takes long goes on in further slices, whatever the pace is.
TEST(Debug, ALongStepIsMadeInParts) {
  constexpr const char* kLong =
      "FUNCTION FC 1 : VOID\n"
      "BEGIN\n"
      "NETWORK\n"
      "      L     30000;\n"
      "next: T     MW 100; L MW 102; L MW 104; L MW 102; L MW 104; L MW 102; L MW 104;\n"
      "      L     MW 100;\n"
      "      LOOP  next;\n"
      "END_FUNCTION\n"
      "ORGANIZATION_BLOCK OB 1\n"
      "BEGIN\n"
      "NETWORK\n"
      "      CALL  FC 1;\n"  // 12
      "      NOP   0;\n"     // 13
      "END_ORGANIZATION_BLOCK\n";
  Bench bench(kLong);
  bench.call("breakpoints.set", {{"file", "main.awl"}, {"lines", {12}}});
  bench.run(Duration::milliseconds(100));
  ASSERT_EQ(bench.state()["breakpoint"]["line"], 12);
  bench.call("time.pace", {{"mode", "pause"}});
  bench.call("debug.step", {{"kind", "over"}});
  EXPECT_EQ(bench.state()["mode"], "RUN");
  std::int64_t wall = 0;
  int slices = 0;
  while (bench.state()["mode"] == "RUN" && ++slices < 1000)
    bench.workbench.advance([&] { return wall += 1'000'000; }, Duration::milliseconds(5));
  EXPECT_EQ(bench.state()["breakpoint"]["line"], 13);
  EXPECT_GE(slices, 1);
}

}  // namespace
}  // namespace merker::workbench::test
