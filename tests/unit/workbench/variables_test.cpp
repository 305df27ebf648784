#include "bench.h"

namespace merker::workbench::test {
namespace {

Json item(const std::string& operand, const std::string& format = "AUTO") {
  return {{"operand", operand}, {"format", format}};
}
Json wish(const std::string& operand, const std::string& value) {
  return {{"operand", operand}, {"value", value}};
}
Json items(std::initializer_list<Json> list) { return {{"items", Json(list)}}; }

// S7-SIM-12
TEST(Variables, AreReadInTheirFormats) {
  Bench bench;
  const Json list = bench.call(
      "variables.read", items({item("DB1.count", "HEX"), item("DB1.level"), item("DB9.DBW 0"),
                               item("?"), item("MB 0", "REAL")}))["items"];
  EXPECT_EQ(list[0]["text"], "W#16#0005");
  EXPECT_EQ(list[0]["raw"], 5);
  EXPECT_EQ(list[1]["raw"], 1.5);
  EXPECT_EQ(list[2]["text"], "?");
  EXPECT_EQ(list[3]["problem"]["code"], "P0316");
  EXPECT_EQ(list[4]["problem"]["code"], "P1209");
}

TEST(Variables, AreWrittenAllOrNone) {
  Bench bench;
  EXPECT_EQ(bench.problem("variables.write", items({wish("MW 40", "7"), wish("MW 42", "x")})),
            "P0201");
  EXPECT_EQ(bench.call("variables.read", items({item("MW 40")}))["items"][0]["raw"], 0);
  bench.call("variables.write", items({wish("MW 40", "7"), wish("\"Start\"", "1")}));
  bench.run(Duration::milliseconds(20));
  const Json read = bench.call("variables.read", items({item("MW 40"), item("\"Motor\"")}));
  EXPECT_EQ(read["items"][0]["raw"], 7);
  EXPECT_EQ(read["items"][1]["raw"], 1);
}

// As a variable table of STEP 7 does it: what cannot be modified is told, the others are.
TEST(Variables, AreWrittenEachByItself) {
  Bench bench;
  bench.call("variables.force", items({wish("A 0.1", "1")}));
  Json wanted = items({wish("MW 40", "x"), wish("MW 42", "7"), wish("A 0.1", "1")});
  wanted["each"] = true;
  wanted["held"] = true;
  const Json refused = bench.call("variables.write", wanted)["refused"];
  ASSERT_EQ(refused.size(), 2u);
  EXPECT_EQ(refused[0]["item"], 0);
  EXPECT_EQ(refused[0]["problem"]["code"], "P0201");
  EXPECT_EQ(refused[1]["item"], 2);
  EXPECT_EQ(refused[1]["problem"]["code"], "P1217");
  EXPECT_EQ(bench.call("variables.read", items({item("MW 42")}))["items"][0]["raw"], 7);
}

// As long as a finger holds it: nobody does when the page is gone. What is no bit stays.
TEST(Variables, AHeldBitIsZeroWhenItsBrowserHasGone) {
  for (const bool held : {true, false}) {
    Bench bench;
    Json wanted = items({wish("MW 40", "7"), wish("M 50.0", "1"), wish("M 50.1", "1")});
    wanted["held"] = held;
    bench.call("variables.write", wanted);
    bench.call("variables.write", items({wish("M 50.1", "1")}));  // no longer held
    bench.workbench.closed(1);
    const Json read =
        bench.call("variables.read", items({item("MW 40"), item("M 50.0"), item("M 50.1")}));
    EXPECT_EQ(read["items"][0]["raw"], 7);
    EXPECT_EQ(read["items"][1]["raw"], held ? 0 : 1);
    EXPECT_EQ(read["items"][2]["raw"], 1);
  }
}

// The bits of a project that is closed are not those of the next one.
TEST(Variables, HoldingEndsWithTheProject) {
  Bench bench;
  Json wanted = items({wish("M 50.0", "1")});
  wanted["held"] = true;
  bench.call("variables.write", wanted);
  bench.workbench.show(
      std::make_unique<Plc>(compilation::build(project::load(bench.folder.path(), {}), false)));
  bench.call("variables.write", items({wish("M 50.0", "1")}));
  bench.workbench.closed(1);
  EXPECT_EQ(bench.call("variables.read", items({item("M 50.0")}))["items"][0]["raw"], 1);
}

TEST(Variables, HeldBitsAreLimited) {
  Bench bench;
  const auto hold = [&](int from, int count) {
    Json list = Json::array();
    for (int i = from; i < from + count; ++i)
      list.push_back(wish("M " + std::to_string(i / 8) + "." + std::to_string(i % 8), "1"));
    return bench.ask("variables.write", {{"items", list}, {"held", true}});
  };
  EXPECT_TRUE(hold(0, 1000).contains("result"));
  EXPECT_EQ(hold(1000, 1)["problems"][0]["code"], "P1314");
}

TEST(Variables, AreForcedAndReleased) {
  Bench bench;
  bench.call("variables.force", items({wish("A 0.0", "1"), wish("E 0.5", "1")}));
  bench.run(Duration::milliseconds(20));
  Json state = bench.state();
  EXPECT_EQ(state["forces"].size(), 2u);
  EXPECT_EQ(state["forces"][0]["operand"], "A 0.0");
  EXPECT_EQ(state["leds"]["FRCE"], "on");
  EXPECT_EQ(bench.problem("variables.force", items({wish("M 0.0", "1")})), "P1211");
  bench.call("variables.unforce", items({{{"operand", "A 0.0"}}}));
  EXPECT_EQ(bench.state()["forces"].size(), 1u);
  bench.call("variables.unforce");
  EXPECT_EQ(bench.state()["forces"].size(), 0u);
}

TEST(Watch, TellsWhatOperandsAre) {
  Bench bench;
  const Json list = bench.call(
      "watch.set",
      {{"list", 1},
       {"items",
        {item("\"Start\""), item("MW 20"), item("DB1.level"), item("T 1"), item("x")}}})["items"];
  EXPECT_EQ(list[0]["operand"], "E 0.0");
  EXPECT_EQ(list[0]["symbol"], "Start");
  EXPECT_EQ(list[0]["comment"], "the button");
  EXPECT_EQ(list[0]["type"], "BOOL");
  EXPECT_EQ(list[1]["symbol"], "Counted");
  EXPECT_EQ(list[1]["type"], "INT");
  EXPECT_EQ(list[1]["bits"], 16);
  EXPECT_EQ(list[2]["operand"], "DB1.DBD 2");
  EXPECT_EQ(list[2]["type"], "REAL");
  EXPECT_EQ(list[3]["operand"], "T 1");
  EXPECT_TRUE(list[4].contains("problem"));
}

TEST(Watch, WhatIsWrongWithOneItemLeavesTheOthers) {
  Bench bench;
  const Json wanted = {item("MW 40", "DEZ"), item(std::string(401, 'x')), item("MW 40")};
  const Json list = bench.call("watch.set", {{"list", 1}, {"items", wanted}})["items"];
  EXPECT_EQ(list[0]["problem"]["code"], "P1208");
  EXPECT_EQ(list[1]["problem"]["code"], "P1305");
  EXPECT_EQ(list[1]["problem"]["text"], "'operand' must be a text of at most 400 bytes");
  EXPECT_FALSE(list[2].contains("problem"));
  const Json values = bench.event("values")["values"];
  EXPECT_EQ(values[0], Json::array({0, "?", nullptr}));
  EXPECT_EQ(values[1], Json::array({1, "?", nullptr}));
  EXPECT_EQ(values[2][2], 0);
  const Json read = bench.call("variables.read", {{"items", wanted}})["items"];
  EXPECT_EQ(read[0]["problem"]["code"], "P1208");
  EXPECT_EQ(read[2]["raw"], 0);
}

// Its values would pass for those of the list that was refused.
TEST(Watch, ARefusedListLeavesNoneOfItsNumber) {
  Bench bench;
  for (const char* what : {"watch.set", "trend.set"})
    bench.call(what, {{"list", 1}, {"items", {item("MW 20")}}});
  for (const char* what : {"watch.set", "trend.set"})
    EXPECT_EQ(bench.problem(what, {{"list", 1}, {"items", {{{"operand", 5}}}}}), "P1305");
  bench.run(Duration::milliseconds(20));
  EXPECT_TRUE(bench.event("values").is_null());
  EXPECT_TRUE(bench.event("samples").is_null());
}

TEST(Watch, TellsChangesOnly) {
  Bench bench;
  bench.call("watch.set", {{"list", 7}, {"items", {item("MW 20"), item("MW 40"), item("x")}}});
  Json event = bench.event("values");
  EXPECT_EQ(event["list"], 7);
  EXPECT_EQ(event["values"].size(), 3u);
  EXPECT_EQ(event["values"][2], Json::array({2, "?", nullptr}));
  EXPECT_TRUE(bench.event("values").is_null());
  bench.run(Duration::milliseconds(20));
  event = bench.event("values");
  ASSERT_EQ(event["values"].size(), 1u);
  EXPECT_EQ(event["values"][0][0], 0);
  EXPECT_GT(event["values"][0][2], 0);
  bench.call("watch.drop", {{"list", 7}});
  bench.run(Duration::milliseconds(20));
  EXPECT_TRUE(bench.event("values").is_null());
}

TEST(Watch, ComesAsOftenAsWanted) {
  Bench bench;
  bench.call("watch.set", {{"list", 1}, {"items", {item("MW 20")}}, {"everyMs", 1000}});
  int seen = 0;
  for (int frame = 0; frame < 91; ++frame) {  // 3 s
    bench.run(Duration::milliseconds(5));
    seen += bench.event("values").is_null() ? 0 : 1;
  }
  EXPECT_EQ(seen, 3);
}

TEST(Watch, ListsHaveLimits) {
  Bench bench;
  for (std::size_t i = 0; i < kLists; ++i)
    bench.call("watch.set", {{"list", i}, {"items", Json::array()}});
  bench.call("watch.set", {{"list", 0}, {"items", Json::array()}});  // again
  EXPECT_EQ(bench.problem("watch.set", {{"list", 1000}, {"items", Json::array()}}), "P1314");
  Json many = Json::array();
  for (std::size_t i = 0; i <= kItems; ++i) many.push_back(item("M 0.0"));
  EXPECT_EQ(bench.problem("watch.set", {{"list", 0}, {"items", many}}), "P1305");
}

TEST(Watch, AllListsTogetherHaveLimits) {
  Bench bench;
  const auto set = [&](std::size_t list, const std::string& operand, std::size_t count) {
    Json items = Json::array();
    for (std::size_t i = 0; i < count; ++i) items.push_back(item(operand));
    return bench.ask("watch.set", {{"list", list}, {"items", items}});
  };
  for (std::size_t list = 0; list < kWatched / kItems; ++list)
    EXPECT_TRUE(set(list, "MW 2", kItems).contains("result"));
  EXPECT_EQ(set(20, "MW 2", 1)["problems"][0]["code"], "P1314");
  EXPECT_TRUE(set(3, "MW 4", kItems).contains("result"));  // in place of the old one
  bench.call("watch.drop", {{"list", 0}});
  EXPECT_TRUE(set(20, "MW 2", 1).contains("result"));
}

TEST(Watch, LongNamesHaveALimit) {
  Bench bench;
  const std::string name(390, 'x');
  std::string refusal;
  for (int list = 0; list < 10 && refusal.empty(); ++list) {
    Json items = Json::array();
    for (std::size_t i = 0; i < kItems; ++i) items.push_back(item(name));
    const Json answer = bench.ask("watch.set", {{"list", list}, {"items", items}});
    if (answer.contains("problems")) refusal = answer["problems"][0]["code"];
    EXPECT_EQ(refusal.empty(), list < 2);
  }
  EXPECT_EQ(refusal, "P1314");
}

TEST(Variables, ForcesHaveALimit) {
  Bench bench;
  const auto force = [&](int first) {
    Json items = Json::array();
    for (int i = first; i < first + 300; ++i)
      items.push_back({{"operand", "A " + std::to_string(i / 8) + "." + std::to_string(i % 8)},
                       {"value", "1"}});
    return bench.ask("variables.force", {{"items", items}});
  };
  EXPECT_TRUE(force(0).contains("result"));
  EXPECT_EQ(force(300)["problems"][0]["code"], "P1314");
  EXPECT_EQ(bench.state()["forces"].size(), 300u);
}

}  // namespace
}  // namespace merker::workbench::test
