// Trigger points of the variable table: begin and end of the cycle, transition to STOP; once or
// every time (S7-MGR-16).
#include "bench.h"

namespace merker::workbench::test {
namespace {

// M 0.0 is 1 in the middle of the cycle only; MW 2 is what MW 4 was at the begin.
constexpr const char* kCycle = R"(ORGANIZATION_BLOCK OB 1
BEGIN
NETWORK
      L     MW 4;
      T     MW 2;
      L     MW 4;
      +     1;
      T     MW 4;
END_ORGANIZATION_BLOCK
)";

Json watch(const std::string& point, bool once) {
  return {{"list", 1},
          {"items",
           {{{"operand", "MW 2"}, {"format", "DEC"}}, {{"operand", "MW 4"}, {"format", "DEC"}}}},
          {"point", point},
          {"once", once}};
}

int number(const Json& event, std::size_t index) {
  for (const Json& value : event["values"])
    if (value[0] == index) return value[2];
  return -1;
}

TEST(Trigger, MonitorsAtTheBeginAndAtTheEndOfTheCycle) {
  Bench bench(kCycle);
  bench.call("watch.set", watch("end", false));
  bench.run(Duration::milliseconds(20));
  Json event = bench.event("values");
  EXPECT_EQ(number(event, 0) + 1, number(event, 1));  // OB 1 has counted
  bench.call("watch.set", watch("begin", false));
  bench.run(Duration::milliseconds(20));
  event = bench.event("values");
  EXPECT_EQ(number(event, 0) + 1, number(event, 1));
  EXPECT_FALSE(event.contains("done"));
}

TEST(Trigger, OnceIsThatOneTime) {
  Bench bench(kCycle);
  bench.call("watch.set", watch("end", true));
  EXPECT_TRUE(bench.event("values").is_null());
  bench.run(Duration::milliseconds(20));
  const Json event = bench.event("values");
  EXPECT_EQ(event["done"], true);
  bench.run(Duration::milliseconds(20));
  EXPECT_TRUE(bench.event("values").is_null());
}

TEST(Trigger, TheTransitionToStopShowsAndSetsTheLastValues) {
  Bench bench(kCycle);
  bench.call("watch.set", watch("stop", false));
  bench.call("modify.set", {{"list", 1},
                            {"items", {{{"operand", "MW 4"}, {"value", "7"}, {"format", "DEC"}}}},
                            {"point", "stop"},
                            {"once", true}});
  bench.run(Duration::milliseconds(20));
  EXPECT_TRUE(bench.event("values").is_null());
  EXPECT_TRUE(bench.event("modified").is_null());
  bench.call("cpu.stop");
  const std::vector<Json> events = bench.events();
  const auto found = [&](const char* name) -> Json {
    for (const Json& one : events)
      if (one["event"] == name) return one;
    return nullptr;
  };
  EXPECT_EQ(number(found("values"), 1), 7);
  EXPECT_EQ(found("modified")["list"], 1);
}

TEST(Trigger, ModifiesEachByItself) {
  Bench bench(kCycle);
  const Json wanted = {{"list", 1},
                       {"items",
                        {{{"operand", "MW 2"}, {"value", "abc"}, {"format", "DEC"}},
                         {{"operand", "MW 4"}, {"value", "100"}, {"format", "DEC"}}}},
                       {"point", "begin"},
                       {"each", true}};
  const Json refused = bench.call("modify.set", wanted)["refused"];
  ASSERT_EQ(refused.size(), 1u);
  EXPECT_EQ(refused[0]["item"], 0);
  bench.call("watch.set", watch("begin", false));
  bench.run(Duration::milliseconds(50));
  EXPECT_EQ(number(bench.event("values"), 1), 100);
}

// At the begin of each cycle MW 4 is 100: OB 1 sees nothing else.
TEST(Trigger, ModifiesAtTheBeginOfEachCycle) {
  Bench bench(kCycle);
  const Json hundred = {{"list", 1},
                        {"items", {{{"operand", "MW 4"}, {"value", "100"}, {"format", "DEC"}}}},
                        {"point", "begin"}};
  bench.call("modify.set", hundred);
  bench.call("watch.set", watch("end", false));
  bench.run(Duration::milliseconds(50));
  Json event = bench.event("values");
  EXPECT_EQ(number(event, 0), 100);
  EXPECT_EQ(number(event, 1), 101);
  bench.call("watch.set", watch("begin", false));
  bench.run(Duration::milliseconds(50));
  EXPECT_EQ(number(bench.event("values"), 1), 100);
  bench.call("watch.set", watch("end", false));
  bench.call("modify.drop", {{"list", 1}});
  bench.run(Duration::milliseconds(50));
  event = bench.event("values");
  EXPECT_GT(number(event, 1), 110);
  EXPECT_EQ(bench.problem("modify.set", {{"list", 1},
                                         {"items", {{{"operand", "XX 3"}, {"value", "1"}}}},
                                         {"point", "begin"}}),
            bench.problem("variables.write", {{"items", {{{"operand", "XX 3"}, {"value", "1"}}}}}));
  EXPECT_EQ(bench.problem("modify.set", {{"list", 1}, {"items", Json::array()}}), "P1306");
  EXPECT_EQ(bench.problem("modify.set", {{"list", 1}, {"items", Json::array()}, {"point", "now"}}),
            "P1305");
}

// A value that its operand never takes, and an operand that is forced, are refused at once.
TEST(Trigger, RefusesWhatIsNeverModified) {
  Bench bench(kCycle);
  const auto items = [](const char* operand, const char* value, const char* format) -> Json {
    return {{"list", 1},
            {"items", {{{"operand", operand}, {"value", value}, {"format", format}}}},
            {"point", "begin"}};
  };
  for (const char* method : {"variables.write", "modify.set"}) {
    EXPECT_EQ(bench.problem(method, items("T 1", "W#16#FFFF", "AUTO")), "P0988") << method;
    EXPECT_EQ(bench.problem(method, items("Z 1", "W#16#FFFF", "CHAR")), "P0988") << method;
  }
  bench.call("variables.force", {{"items", {{{"operand", "E 0.0"}, {"value", "0"}}}}});
  EXPECT_EQ(bench.problem("modify.set", items("E 0.0", "1", "AUTO")), "P1217");
}

// They are read and written in every cycle: so many of each browser.
TEST(Trigger, PointsHaveALimit) {
  Bench bench(kCycle);
  std::map<std::string, Json> items;
  for (int i = 0; i < 1000; ++i) {
    items["watch.set"].push_back({{"operand", "MW 2"}});
    items["modify.set"].push_back({{"operand", "MW 2"}, {"value", "1"}});
  }
  const auto set = [&](const char* method, int list) {
    return bench.ask(method, {{"list", list}, {"point", "end"}, {"items", items[method]}});
  };
  EXPECT_TRUE(set("watch.set", 1).contains("result"));
  EXPECT_TRUE(set("modify.set", 1).contains("result"));
  EXPECT_TRUE(set("watch.set", 1).contains("result"));  // in place of the old one
  for (const char* method : {"watch.set", "modify.set"})
    EXPECT_EQ(set(method, 2)["problems"][0]["code"], "P1314") << method;
  bench.call("watch.drop", {{"list", 1}});
  EXPECT_TRUE(set("watch.set", 2).contains("result"));
}

}  // namespace
}  // namespace merker::workbench::test
