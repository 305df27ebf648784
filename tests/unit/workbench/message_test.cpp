#include "workbench/message.h"

#include "bench.h"

namespace merker::workbench::test {
namespace {

std::string code(const Bench&, Workbench& workbench, const std::string& message) {
  const Json answer = Json::parse(workbench.handle(1, message));
  return answer["problems"][0]["code"];
}

TEST(Message, WhatIsNoRequestGetsAProblem) {
  Bench bench;
  Workbench& w = bench.workbench;
  EXPECT_EQ(code(bench, w, ""), "P1301");
  EXPECT_EQ(code(bench, w, "{"), "P1301");
  EXPECT_EQ(code(bench, w, "[1]"), "P1301");
  EXPECT_EQ(code(bench, w, "{\"id\": 1, \"do\": \"\xFF\"}"), "P1301");
  EXPECT_EQ(code(bench, w, "{}"), "P1303");
  EXPECT_EQ(code(bench, w, R"({"id": 0, "do": "cpu.stop"})"), "P1303");
  EXPECT_EQ(code(bench, w, R"({"id": -1, "do": "cpu.stop"})"), "P1303");
  EXPECT_EQ(code(bench, w, R"({"id": 1.5, "do": "cpu.stop"})"), "P1303");
  EXPECT_EQ(code(bench, w, R"({"id": 1})"), "P1306");
  EXPECT_EQ(code(bench, w, R"({"id": 1, "do": 5})"), "P1305");
  EXPECT_EQ(code(bench, w, R"({"id": 1, "do": "cpu.fly"})"), "P1304");
}

TEST(Message, NestingHasALimit) {
  const auto nested = [](std::size_t depth) {
    return "{\"id\": 1, \"do\": \"cpu.stop\", \"x\": " + std::string(depth - 1, '[') +
           std::string(depth - 1, ']') + "}";
  };
  Bench bench;
  EXPECT_TRUE(parseMessage(nested(kDeepest)));
  EXPECT_EQ(code(bench, bench.workbench, nested(kDeepest + 1)), "P1302");
  EXPECT_EQ(code(bench, bench.workbench, std::string(1 << 20, '[')), "P1302");
  // brackets in a text are text
  EXPECT_TRUE(parseMessage("{\"x\": \"" + std::string(100, '[') + "\"}"));
  EXPECT_TRUE(parseMessage("{\"x\": \"\\\"" + std::string(100, '{') + "\"}"));
}

TEST(Message, ValuesHaveALimit) {
  const auto with = [](std::size_t values) {
    std::string text = "{\"id\": 1, \"do\": \"ping\", \"x\": [0";
    while (--values > 0) text += ",0";
    return text + "]}";
  };
  Bench bench;
  constexpr std::size_t kOthers = 4;  // the object, id, do, the list
  EXPECT_TRUE(parseMessage(with(kMostValues - kOthers)));
  EXPECT_EQ(code(bench, bench.workbench, with(kMostValues)), "P1314");
  EXPECT_TRUE(parseMessage("{\"x\": \"" + std::string(2 * kMostValues, ',') + "\"}"));
}

// What a page needs to tell a problem in another language, with files as the project names them.
TEST(Message, ProblemsKeepTheirArgumentsAndNoFolder) {
  const ProjectFolder folder("/tmp/press");
  const auto told = [&](const Problem& problem) {
    Json json = toJson(problem);
    relate(json, folder);
    return json;
  };
  const Json twice = told(makeProblem(ProblemCode::P0501, Position{"/tmp/press/a.awl", 7, 1, 1},
                                      "FC 5", "/tmp/press/lib/b.awl", 34));
  EXPECT_EQ(twice["file"], "a.awl");
  EXPECT_EQ(twice["text"], "FC 5 already exists (lib/b.awl:34)");
  EXPECT_EQ(twice["arguments"], (Json{"FC 5", "lib/b.awl", "34"}));
}

TEST(Fields, WrongOnesAreNamed) {
  Bench bench;
  EXPECT_EQ(bench.problem("cpu.switch"), "P1306");
  EXPECT_EQ(bench.problem("cpu.switch", {{"position", 3}}), "P1305");
  EXPECT_EQ(bench.problem("cpu.switch", {{"position", "FAST"}}), "P1305");
  EXPECT_EQ(bench.problem("time.pace", {{"mode", "real"}, {"factor", 0.01}}), "P1305");
  EXPECT_EQ(bench.problem("time.pace", {{"mode", "real"}, {"factor", "1"}}), "P1305");
  EXPECT_EQ(bench.problem("watch.set", {{"list", 1.5}, {"items", Json::array()}}), "P1305");
  const Json answer = bench.ask("variables.read", {{"items", {{{"operand", 5}}, 7}}});
  EXPECT_EQ(answer["problems"][0]["text"], "'items[1]' must be an object");
  EXPECT_EQ(answer["problems"][1]["text"], "'items[0].operand' must be a text");
}

TEST(Fields, NamesHaveALimit) {
  Bench bench;
  const auto items = [](std::size_t blanks) {
    return Json{{{"operand", "MW 10" + std::string(blanks, ' ')}}};
  };
  EXPECT_EQ(bench.problem("variables.unforce", {{"items", items(400)}}), "P1305");
  for (const char* looks : {"watch.set", "trend.set", "trend.check", "variables.read"}) {
    const auto look = [&](std::size_t blanks) {
      return bench.call(looks, {{"list", 1}, {"items", items(blanks)}})["items"][0];
    };
    EXPECT_EQ(look(400)["problem"]["code"], "P1305") << looks;
    EXPECT_EQ(look(400).value("operand", ""), "") << looks;
    EXPECT_FALSE(look(300).contains("problem")) << looks;
  }
}

TEST(Fields, WithoutAProjectThereIsNoPlc) {
  Workbench workbench;
  const Json answer = Json::parse(workbench.handle(1, R"({"id": 1, "do": "cpu.stop"})"));
  EXPECT_EQ(answer["problems"][0]["code"], "P1315");
}

}  // namespace
}  // namespace merker::workbench::test
