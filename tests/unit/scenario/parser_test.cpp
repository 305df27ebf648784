#include <gtest/gtest.h>

#include "scenario/scenario.h"

namespace merker::simulator {
namespace {

using steps::Expect;

struct Parsed {
  std::vector<Scenario> scenarios;
  Problems problems;
  const std::vector<Step>& steps() const { return scenarios.at(0).steps; }
  template <typename S>
  const S& step(std::size_t i) const {
    return std::get<S>(steps().at(i).does);
  }
  template <typename E>
  const E& expected(std::size_t i) const {
    return std::get<E>(step<Expect>(i).what);
  }
  // "3:8 P0950" of the only problem.
  std::string problem() const {
    if (problems.size() != 1) return std::to_string(problems.size()) + " problems";
    const Problem& p = problems.list()[0];
    return std::to_string(p.position.line) + ":" + std::to_string(p.position.column) + " " +
           std::string(p.name());
  }
};

Parsed parse(std::string text) {
  Parsed parsed;
  const source::SourceFile file("dir/plant.scn", std::move(text));
  parsed.scenarios = parseScenarios(file, parsed.problems);
  return parsed;
}

TEST(ScenarioParser, TheExampleOfTheContract) {
  const Parsed p = parse(R"(scenario "a large box is pushed out by the third slider after 7 s"
  set E 0.0 = 1, E 0.1 = 1, "Light barrier large" = 1
  wait 50ms
  expect A 1.2 = 0 for 6.8s          # holds during the whole time
  expect A 1.2 = 1 within 300ms      # becomes true, at the latest then
  expect A 1.0 = 0                   # holds now
  wait 3 cycles
  expect mode = RUN
)");
  EXPECT_TRUE(p.problems.empty());
  ASSERT_EQ(p.scenarios.size(), 1u);
  EXPECT_EQ(p.scenarios[0].name, "a large box is pushed out by the third slider after 7 s");
  ASSERT_EQ(p.steps().size(), 7u);
  EXPECT_EQ(p.step<steps::Set>(0).assignments.size(), 3u);
  EXPECT_EQ(p.step<steps::Set>(0).assignments[2].operand.text, "\"Light barrier large\"");
  EXPECT_EQ(p.step<steps::Wait>(1).duration, Duration::milliseconds(50));
  EXPECT_EQ(p.step<Expect>(2).when, Expect::When::During);
  EXPECT_EQ(p.step<Expect>(2).duration, Duration::milliseconds(6800));
  EXPECT_EQ(p.step<Expect>(3).when, Expect::When::Within);
  EXPECT_EQ(p.expected<expectations::Values>(3).left.text, "A 1.2");
  EXPECT_EQ(p.expected<expectations::Values>(3).right.text, "1");
  EXPECT_EQ(p.steps()[3].position, (Position{"dir/plant.scn", 5, 3, 29}));
  EXPECT_EQ(p.step<steps::Wait>(5).cycles, 3u);
  EXPECT_EQ(p.expected<expectations::Mode>(6).mode, controller::Mode::Run);
}

// S5-ERR-06: fields of the stacks of a SINUMERIK.
TEST(ScenarioParser, Stacks) {
  const Parsed p = parse("expect ustack XX-NR. = PB 5 within 1s\nexpect BSTACK 1 adr >= 002A\n");
  ASSERT_TRUE(p.problems.empty());
  const auto& first = p.expected<expectations::Stack>(0);
  EXPECT_EQ(first.stack + "|" + first.name + "|" + first.value, "USTACK|XX-NR.|PB 5");
  EXPECT_EQ(p.step<Expect>(0).when, Expect::When::Within);
  EXPECT_EQ(p.expected<expectations::Stack>(1).name, "1 adr");
  EXPECT_EQ(p.expected<expectations::Stack>(1).relation, block::Relation::GreaterEqual);
  EXPECT_EQ(parse("expect ustack = 01\n").problem(), "1:8 P0952");
  EXPECT_EQ(parse("expect ustack SAZ\n").problem(), "1:8 P0952");
  EXPECT_EQ(parse("expect ustack SAZ =\n").problem(), "1:8 P0952");
  EXPECT_EQ(parse("expect ustack SAZ ~= 1\n").problem(), "1:8 P0952");
}

// S7-SIM-13, S7-CPU-31
TEST(ScenarioParser, StepsOfTheDevice) {
  const Parsed p = parse(
      "switch mres\ntrigger OB 82 going address W#16#100 data DW#16#05000000\n"
      "trigger OB 85 fault B#16#B1\ntrigger OB 40 points 2#101\nexpect LED stop = slow\n"
      "power on unbuffered\npower on\nbattery low\nhot restart\n");
  EXPECT_TRUE(p.problems.empty());
  ASSERT_EQ(p.steps().size(), 9u);
  EXPECT_EQ(p.step<steps::Switch>(0).position, cpu::SwitchPosition::Mres);
  const cpu::Trigger& fault = p.step<steps::Trigger>(1).event;
  EXPECT_EQ(fault.ob, 82);
  EXPECT_TRUE(fault.going);
  EXPECT_EQ(fault.address, 256);
  EXPECT_EQ(fault.data, 0x05000000u);
  EXPECT_EQ(p.step<steps::Trigger>(2).event.fault, 0xB1);
  EXPECT_EQ(p.step<steps::Trigger>(3).event.points, 5u);
  EXPECT_EQ(p.expected<expectations::Led>(4).led, &cpu::Leds::stop);
  EXPECT_EQ(p.expected<expectations::Led>(4).light, cpu::Light::Slow);
  EXPECT_TRUE(std::holds_alternative<steps::PowerOnUnbuffered>(p.steps()[5].does));
  EXPECT_TRUE(std::holds_alternative<steps::PowerOn>(p.steps()[6].does));
}

TEST(ScenarioParser, SeveralScenariosInAFile) {
  const Parsed p = parse("wait 1s\nscenario \"a\"\nrun\nscenario \"b\"\nstop\n");
  ASSERT_EQ(p.scenarios.size(), 3u);
  EXPECT_EQ(p.scenarios[0].name, "plant");
  EXPECT_EQ(p.scenarios[1].name, "a");
  EXPECT_TRUE(std::holds_alternative<steps::Stop>(p.scenarios[2].steps.at(0).does));
}

TEST(ScenarioParser, EveryStepWithoutWordsBehindIt) {
  const Parsed p =
      parse("Run\nSTOP\ncold  restart\nwarm restart\npower off\npower on\nmemory reset\nunforce\n");
  EXPECT_TRUE(p.problems.empty());
  const AnyStep wanted[] = {steps::Run{},         steps::Stop{},     steps::ColdRestart{},
                            steps::WarmRestart{}, steps::PowerOff{}, steps::PowerOn{},
                            steps::MemoryReset{}, steps::Unforce{}};
  ASSERT_EQ(p.steps().size(), std::size(wanted));
  for (std::size_t i = 0; i < std::size(wanted); ++i)
    EXPECT_EQ(p.steps()[i].does.index(), wanted[i].index());
}

TEST(ScenarioParser, RelationsAndOperands) {
  struct Row {
    const char* text;
    block::Relation relation;
    const char *left, *right;
  };
  const Row rows[] = {
      {"expect MW 10 <> W#16#5", block::Relation::NotEqual, "MW 10", "W#16#5"},
      {"expect MD 4 ~= 1.5", block::Relation::About, "MD 4", "1.5"},
      {"expect \"a = b\" <= 5", block::Relation::LessEqual, "\"a = b\"", "5"},
      {"expect DB1.a[1, 2] >= -3", block::Relation::GreaterEqual, "DB1.a[1, 2]", "-3"},
      {"expect MB 1 == 2", block::Relation::Equal, "MB 1", "2"},
      {"expect MB 1<2", block::Relation::Less, "MB 1", "2"},
      {"expect MB 1 > MB 2", block::Relation::Greater, "MB 1", "MB 2"}};
  for (const Row& row : rows) {
    const Parsed p = parse(row.text);
    ASSERT_TRUE(p.problems.empty()) << row.text;
    EXPECT_EQ(p.expected<expectations::Values>(0).relation, row.relation) << row.text;
    EXPECT_EQ(p.expected<expectations::Values>(0).left.text, row.left);
    EXPECT_EQ(p.expected<expectations::Values>(0).right.text, row.right);
  }
}

TEST(ScenarioParser, WordsInSymbolsAreNoKeywords) {
  const Parsed p = parse("expect \"wait for it\" = 1 within 5s\n");
  EXPECT_TRUE(p.problems.empty());
  EXPECT_EQ(p.expected<expectations::Values>(0).left.text, "\"wait for it\"");
}

TEST(ScenarioParser, DiagnosticsAndModes) {
  const Parsed p =
      parse("expect diagnostics contains \"BCD # error\" within 1s\nexpect mode <> stop\n");
  EXPECT_TRUE(p.problems.empty());
  EXPECT_EQ(p.expected<expectations::Diagnostics>(0).words, "BCD # error");
  EXPECT_EQ(p.step<Expect>(0).when, Expect::When::Within);
  EXPECT_EQ(p.expected<expectations::Mode>(1).mode, controller::Mode::Stop);
  EXPECT_EQ(p.expected<expectations::Mode>(1).relation, block::Relation::NotEqual);
}

TEST(ScenarioParser, RepeatsNest) {
  const Parsed p = parse("repeat 3\n wait 1 cycle\n repeat 2\n  run\n end\nend\nstop\n");
  EXPECT_TRUE(p.problems.empty());
  ASSERT_EQ(p.steps().size(), 2u);
  const auto& outer = p.step<steps::Repeat>(0);
  EXPECT_EQ(outer.count, 3u);
  ASSERT_EQ(outer.body.size(), 2u);
  EXPECT_EQ(std::get<steps::Repeat>(outer.body[1].does).count, 2u);
}

TEST(ScenarioParser, ProblemsNameTheirPlace) {
  EXPECT_EQ(parse("run\n  sett E 0.0 = 1\n").problem(), "2:3 P0950");
  EXPECT_EQ(parse("wait 5\n").problem(), "1:6 P0953");
  EXPECT_EQ(parse("wait\n").problem(), "1:1 P0953");
  EXPECT_EQ(parse("switch ON\n").problem(), "1:8 P0952");
  EXPECT_EQ(parse("expect mode of CPU = RUN\n").problem(), "1:8 P0952");
  EXPECT_EQ(parse("expect partner LED RUN = on\n").problem(), "1:16 P0952");
  EXPECT_EQ(parse("partner set MW 0 = 1\n").problem(), "1:9 P0952");
  EXPECT_EQ(parse("partner end\n").problem(), "1:9 P0952");
  EXPECT_EQ(parse("encoder 2.2.DI0 2.2.DI0 1kHz\n").problem(), "1:17 P0952");
  EXPECT_EQ(parse("trigger OB 35\n").problem(), "1:9 P0952");
  EXPECT_EQ(parse("trigger OB 82 adress 4\n").problem(), "1:15 P0952");
  EXPECT_EQ(parse("trigger OB 82 address 70000\n").problem(), "1:23 P0952");
  EXPECT_EQ(parse("expect LED POWER = on\n").problem(), "1:12 P0952");
  EXPECT_EQ(parse("expect LED RUN = red\n").problem(), "1:18 P0952");
  EXPECT_EQ(parse("expect LED RUN < on\n").problem(), "1:8 P0952");
  EXPECT_EQ(parse("wait x cycles\n").problem(), "1:6 P0952");
  EXPECT_EQ(parse("expect A 0.0\n").problem(), "1:8 P0952");
  EXPECT_EQ(parse("expect A 0.0 = \n").problem(), "1:8 P0952");
  EXPECT_EQ(parse("expect A 0.0 = 1 for ever\n").problem(), "1:22 P0953");
  EXPECT_EQ(parse("expect mode = FAST\n").problem(), "1:15 P0954");
  EXPECT_EQ(parse("expect diagnostics BCD\n").problem(), "1:20 P0952");
  EXPECT_EQ(parse("set E 0.0\n").problem(), "1:5 P0952");
  EXPECT_EQ(parse("set\n").problem(), "1:1 P0952");
  EXPECT_EQ(parse("set E 0.0 = 1,\n").problem(), "1:1 P0952");
  EXPECT_EQ(parse("run now\n").problem(), "1:5 P0959");
  EXPECT_EQ(parse("repeat 2\nrun\n").problem(), "1:1 P0956");
  EXPECT_EQ(parse("run\nend\n").problem(), "2:1 P0957");
  EXPECT_EQ(parse("scenario a\nrun\n").problem(), "1:10 P0952");
  EXPECT_EQ(parse("# nothing\n").problem(), "0:0 P0958");
}

// However deep a file says: nothing that follows the depth is built, and one problem tells it.
TEST(ScenarioParser, RepeatsEndAtADepth) {
  const auto nested = [](std::size_t depth) {
    std::string text;
    for (std::size_t i = 0; i < depth; ++i) text += "repeat 1\n";
    text += "run\n";
    for (std::size_t i = 0; i < depth; ++i) text += "end\n";
    return text;
  };
  EXPECT_TRUE(parse(nested(16)).problems.empty());
  EXPECT_EQ(parse(nested(17)).problem(), "17:1 P0952");
  EXPECT_EQ(parse(nested(300'000)).problem(), "17:1 P0952");
}

TEST(ScenarioParser, StepsOfOtherPartsSayWhichExist) {
  for (const char* text : {"expect pulses 1 = 5", "expect encoder 1 = 5"}) {
    const Parsed p = parse(text);
    ASSERT_EQ(p.problems.size(), 1u) << text;
    EXPECT_EQ(p.problems.list()[0].code, ProblemCode::P0951);
    EXPECT_NE(p.problems.list()[0].message.find("expect"), std::string::npos);
  }
}

TEST(ScenarioParser, AnApostropheInsideAText) {
  const Parsed p = parse("set DB1.a = 'it$'s, or = not', MB 1 = 2\n");
  EXPECT_TRUE(p.problems.empty());
  ASSERT_EQ(p.step<steps::Set>(0).assignments.size(), 2u);
  EXPECT_EQ(p.step<steps::Set>(0).assignments[0].value.text, "'it$'s, or = not'");
}

TEST(ScenarioParser, AllProblemsInOnePass) {
  EXPECT_EQ(parse("foo\nwait x\nexpect 5\nrun\n").problems.size(), 3u);
}

TEST(ScenarioParser, AssignmentsOfAnOption) {
  Problems problems;
  const source::SourceFile file("--set", "E 0.0=1, MW 10=W#16#0005");
  const auto list = parseAssignments(file, file.text(), problems);
  EXPECT_TRUE(problems.empty());
  ASSERT_EQ(list.size(), 2u);
  EXPECT_EQ(list[1].operand.text, "MW 10");
  EXPECT_EQ(list[1].value.text, "W#16#0005");
  EXPECT_EQ(list[1].value.position, (Position{"--set", 1, 16, 9}));
}

}  // namespace
}  // namespace merker::simulator
