// Several projects on one server, a PLC each: browsers are at one of them.
#include "workbench/workbenches.h"

#include "bench.h"

namespace merker::workbench::test {
namespace {

class Several : public ::testing::Test {
 protected:
  Several() {
    folder.write("examples/README.md", "# Examples\n");
    folder.write("examples/lamp/merker.toml", "[project]\nname = \"Lamp\"\n");
    folder.write("examples/lamp/main.awl", kProgram);
    all.each([&](Workbench& one) { one.use({folder.path("mine"), folder.path("examples"), {}}); });
    all.opened(1);
  }

  Json ask(Workbench::BrowserId who, const std::string& method, Json fields = Json::object()) {
    fields["id"] = ++last_;
    fields["do"] = method;
    return Json::parse(all.handle(who, fields.dump()));
  }
  Json call(Workbench::BrowserId who, const std::string& method, Json fields = Json::object()) {
    const Json answer = ask(who, method, std::move(fields));
    EXPECT_TRUE(answer.contains("result")) << method << ": " << answer.dump();
    const Json result = answer.value("result", Json());
    EXPECT_EQ(mismatch(findMethodRow(method)->result, result, method), "");
    return result;
  }
  // What the next event tells of the state.
  Json state(Workbench::BrowserId who) {
    all.beginFrame(now_ += 33);
    for (const std::string& text : all.events(who, Workbench::never)) {
      const Json event = Json::parse(text);
      if (event["event"] == "state") return event;
    }
    return nullptr;
  }

  Folder folder;
  Workbench first;
  Workbenches all{first};

 private:
  std::uint64_t last_ = 0;
  std::int64_t now_ = 0;
};

TEST_F(Several, AProjectOfOnePlcIsNotThatOfAnother) {
  all.opened(2);
  call(1, "projects.open", {{"example", "lamp"}});
  EXPECT_EQ(state(1)["project"]["name"], "Lamp");
  EXPECT_EQ(state(2)["plcs"], (Json{{"here", 1}, {"count", 1}}));

  call(2, "plcs.enter", {{"plc", 2}});
  const Json elsewhere = state(2);
  EXPECT_EQ(elsewhere["plcs"], (Json{{"here", 2}, {"count", 2}}));
  EXPECT_TRUE(elsewhere["project"].is_null());
  EXPECT_EQ(elsewhere["browsers"], 1);

  call(2, "projects.open", {{"example", "lamp"}, {"fresh", true}});
  const Json list = call(1, "plcs.list");
  EXPECT_EQ(list["here"], 1);
  ASSERT_EQ(list["plcs"].size(), kPlcs);
  EXPECT_EQ(list["plcs"][1]["project"], "Lamp");
  EXPECT_NE(list["plcs"][0]["folder"], list["plcs"][1]["folder"]);
  EXPECT_EQ(list["plcs"][2],
            (Json{{"plc", 3}, {"project", ""}, {"folder", ""}, {"mode", ""}, {"browsers", 0}}));

  const Json items = {{{"operand", "MW 100"}, {"value", "7"}}};
  call(1, "variables.write", {{"items", items}});
  const auto valueAt = [&](Workbench::BrowserId who) {
    return call(who, "variables.read",
                {{"items", {{{"operand", "MW 100"}, {"format", "DEC"}}}}})["items"][0]["raw"];
  };
  EXPECT_EQ(valueAt(1), 7);
  EXPECT_EQ(valueAt(2), 0);
}

TEST_F(Several, TwoPlcsDoNotShareAFolder) {
  call(1, "projects.open", {{"example", "lamp"}});
  all.opened(2);
  call(2, "plcs.enter", {{"plc", 2}});
  const Json answer = ask(2, "projects.open", {{"example", "lamp"}});
  EXPECT_EQ(answer["problems"][0]["code"], "P1308") << answer.dump();
  EXPECT_NE(answer["problems"][0]["text"].get<std::string>().find("PLC 1"), std::string::npos);
  call(1, "projects.close");
  call(2, "projects.open", {{"example", "lamp"}});
}

TEST_F(Several, AllMoveInTheSameSlice) {
  call(1, "projects.open", {{"example", "lamp"}});
  all.opened(2);
  call(2, "plcs.enter", {{"plc", 2}});
  call(2, "projects.open", {{"example", "lamp"}, {"fresh", true}});
  std::int64_t wall = 0;
  const auto clock = [&] { return wall += 10'000; };
  for (int i = 0; i < 100; ++i) all.advance(clock, Duration::milliseconds(5));
  for (const Workbench::BrowserId who : {1, 2}) EXPECT_GT(state(who)["time"], 0) << who;
}

TEST_F(Several, WhoLeavesLetsGoOfWhatItHolds) {
  call(1, "projects.open", {{"example", "lamp"}});
  const Json items = {{{"operand", "M 10.0"}, {"value", "1"}}};
  call(1, "variables.write", {{"items", items}, {"held", true}});
  all.opened(2);
  const auto bit = [&] {
    return call(2, "variables.read", {{"items", {{{"operand", "M 10.0"}}}}})["items"][0]["raw"];
  };
  EXPECT_EQ(bit(), 1);
  call(1, "plcs.enter", {{"plc", 3}});
  EXPECT_EQ(bit(), 0);
  // There already: nothing changes.
  state(1);
  call(1, "plcs.enter", {{"plc", 3}});
  EXPECT_TRUE(state(1).is_null());
}

TEST_F(Several, ThereAreOnlySoMany) {
  for (const std::size_t number : {std::size_t{0}, kPlcs + 1})
    EXPECT_EQ(ask(1, "plcs.enter", {{"plc", number}})["problems"][0]["code"], "P1305");
}

}  // namespace
}  // namespace merker::workbench::test
