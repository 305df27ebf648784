#include "bench.h"

namespace merker::workbench::test {
namespace {

Json items(std::initializer_list<const char*> names) {
  Json list = Json::array();
  for (const char* name : names) list.push_back({{"operand", name}});
  return list;
}

TEST(Trend, HasARowForEachCycle) {
  Bench bench;
  const Json set = bench.call("trend.set", {{"list", 1}, {"items", items({"MW 20", "\"Start\""})}});
  EXPECT_EQ(set["items"][0]["symbol"], "Counted");
  EXPECT_EQ(set["items"][1]["operand"], "E 0.0");
  const auto before = bench.workbench.plc()->controller().cycles();
  bench.run(Duration::milliseconds(20));
  const auto cycles = bench.workbench.plc()->controller().cycles() - before;
  const Json event = bench.event("samples");
  EXPECT_EQ(event["list"], 1);
  ASSERT_EQ(event["rows"].size(), cycles);
  const Json &first = event["rows"][0], &second = event["rows"][1];
  EXPECT_LT(first[0], second[0]);                                  // ms
  EXPECT_EQ(second[1].get<double>() - first[1].get<double>(), 1);  // counts cycles
  EXPECT_TRUE(bench.event("samples").is_null());
}

TEST(Trend, TakesOneRowInSoManyMilliseconds) {
  Bench bench;
  bench.call("trend.set", {{"list", 1}, {"items", items({"MW 20"})}, {"everyMs", 100}});
  bench.run(Duration::seconds(1));
  EXPECT_NEAR(static_cast<double>(bench.event("samples")["rows"].size()), 10, 1);
}

TEST(Trend, ShowsWhatIsNotThereAsNothing) {
  Bench bench;
  const Json set =
      bench.call("trend.set", {{"list", 1}, {"items", items({"?", "DB1.level", "plant.a.b"})}});
  EXPECT_TRUE(set["items"][0].contains("problem"));
  EXPECT_TRUE(set["items"][2].contains("problem"));
  bench.run(Duration::milliseconds(5));
  const Json row = bench.event("samples")["rows"][0];
  EXPECT_EQ(row[1], nullptr);
  EXPECT_EQ(row[2], 1.5);
}

// What lies at a terminal or is put out there, whoever drives it.
TEST(Trend, TakesTerminals) {
  Bench bench(kProgram, "[[module]]\nslot = \"2.2\"\nname = \"D\"\ninput = 0\noutput = 0\n");
  const Json set =
      bench.call("trend.set", {{"list", 1},
                               {"items", items({"terminal.D.DO0", "terminal.2.3.AI0",
                                                "terminal.D.DO99", "terminal.X.DO0"})}});
  EXPECT_EQ(set["items"][0]["bits"], 1);
  EXPECT_EQ(set["items"][1]["unit"], "V");
  EXPECT_TRUE(set["items"][2].contains("problem"));
  EXPECT_TRUE(set["items"][3].contains("problem"));
  bench.run(Duration::milliseconds(5));
  EXPECT_EQ(bench.event("samples")["rows"].back()[1], 0);
  bench.call("variables.write", {{"items", {{{"operand", "E 0.0"}, {"value", "1"}}}}});
  bench.run(Duration::milliseconds(5));
  const Json row = bench.event("samples")["rows"].back();
  EXPECT_EQ(row[1], 1);
  EXPECT_EQ(row[2], 0);
  EXPECT_EQ(row[3], nullptr);
}

TEST(Trend, IsCheckedBeforeItIsAdded) {
  Bench bench;
  const Json checked =
      bench.call("trend.check", {{"items", items({"xx 3", "Furnace.PV", "MW 20"})}})["items"];
  EXPECT_FALSE(checked[0]["problem"]["text"].get<std::string>().empty());
  EXPECT_FALSE(checked[1]["problem"]["text"].get<std::string>().empty());
  EXPECT_FALSE(checked[2].contains("problem"));
  bench.run(Duration::milliseconds(5));
  EXPECT_TRUE(bench.event("samples").is_null());
}

TEST(Trend, KeepsTheNewestRowsForASlowBrowser) {
  Bench bench;
  bench.call("trend.set", {{"list", 1}, {"items", items({"MW 20"})}});
  bench.run(Duration::seconds(20));
  Json rows = Json::array();
  for (Json event; !(event = bench.event("samples")).is_null();)
    rows.insert(rows.end(), event["rows"].begin(), event["rows"].end());
  EXPECT_EQ(rows.size(), 20000u);
  const double now = static_cast<double>(bench.workbench.plc()->controller().now().ns) / 1e6;
  EXPECT_NEAR(rows.back()[0].get<double>(), now, 5);
  bench.call("trend.drop", {{"list", 1}});
  bench.run(Duration::milliseconds(20));
  EXPECT_TRUE(bench.event("samples").is_null());
}

TEST(Trend, CurvesHaveALimit) {
  Bench bench;
  Json many = Json::array();
  for (int i = 0; i < 100; ++i) many.push_back({{"operand", "MW 20"}});
  for (int list = 0; list < 5; ++list) bench.call("trend.set", {{"list", list}, {"items", many}});
  EXPECT_EQ(bench.problem("trend.set", {{"list", 5}, {"items", items({"MW 20"})}}), "P1314");
  bench.call("trend.set", {{"list", 4}, {"items", items({"MW 20"})}});
  bench.call("trend.set", {{"list", 5}, {"items", items({"MW 20"})}});
}

// The oldest ones are lost; what is kept comes in events of a limited length.
TEST(Trend, WaitingValuesHaveALimit) {
  Plc plc(compilation::build(project::load(Bench().folder.path(), {}), false));
  Trend trend(std::vector<std::string>(9, "MW 20"), 0);
  trend.describe(plc);
  trend.limit(30'000);
  for (int i = 0; i < 5000; ++i) {
    plc.controller().advanceTo(plc.controller().now() + Duration::milliseconds(1));
    trend.sample(plc);
  }
  std::size_t rows = 0, events = 0;
  double first = 0;
  for (std::string text; !(text = trend.takeRows(plc, 1)).empty(); ++events) {
    const Json list = Json::parse(text);
    EXPECT_LE(list.size() * list[0].size(), 10'000u);
    if (rows == 0) first = list[0][0];
    rows += list.size();
  }
  EXPECT_EQ(rows, 3000u);
  EXPECT_EQ(events, 3u);
  EXPECT_NEAR(first, 2001, 1);
}

}  // namespace
}  // namespace merker::workbench::test
