// Timers by hand, the CPU in a file, recording and playback (S7-SIM-13).
#include "workbench/recording.h"

#include <fmt/format.h>

#include "bench.h"
#include "workbench/protocol.h"

namespace merker::workbench::test {
namespace {

Json input(const std::string& operand, const std::string& value) {
  return {{"items", {{{"operand", operand}, {"value", value}}}}};
}

std::string text(Bench& bench, const std::string& operand, const std::string& format = "AUTO") {
  const Json item = {{"operand", operand}, {"format", format}};
  return bench.call("variables.read", {{"items", {item}}})["items"][0]["text"];
}

TEST(Timers, StandStillByHandAndGoOnAutomatically) {
  Bench bench;
  bench.call("timers.mode", {{"manual", true}});
  EXPECT_EQ(bench.state()["timersByHand"], true);
  bench.call("variables.write", input("E 0.0", "1"));
  bench.run(Duration::seconds(10));  // it would have run out five times
  EXPECT_EQ(text(bench, "T 1"), "S5T#2S");
  EXPECT_EQ(text(bench, "A 0.1"), "0");
  bench.call("variables.write", input("T 1", "S5T#500MS"));
  bench.run(Duration::seconds(10));
  EXPECT_EQ(text(bench, "T 1"), "S5T#500MS");
  bench.call("timers.mode", {{"manual", false}});
  bench.run(Duration::milliseconds(400));
  EXPECT_EQ(text(bench, "A 0.1"), "0");
  bench.run(Duration::milliseconds(200));
  EXPECT_EQ(text(bench, "A 0.1"), "1");
}

TEST(Timers, AreResetAllOrOne) {
  Bench bench;
  bench.call("timers.mode", {{"manual", true}});
  for (const char* timer : {"T 1", "T 2", "T 3"})
    bench.call("variables.write", input(timer, "S5T#5S"));
  bench.call("timers.reset", {{"timers", {2}}});
  EXPECT_EQ(text(bench, "T 1"), "S5T#5S");
  EXPECT_EQ(text(bench, "T 2"), "S5T#0MS");
  bench.call("timers.reset");
  EXPECT_EQ(text(bench, "T 1"), "S5T#0MS");
  EXPECT_EQ(text(bench, "T 3"), "S5T#0MS");
  EXPECT_EQ(bench.problem("timers.reset", {{"timers", {99999}}}), "P1305");
}

TEST(CpuState, ComesBackAsItWas) {
  Bench bench;
  bench.call("variables.write", input("E 0.0", "1"));
  bench.call("variables.write", input("DB1.count", "77"));
  bench.call("variables.force", input("A 0.7", "1"));
  bench.run(Duration::milliseconds(700));
  bench.call("cpu.save", {{"path", "half.state"}});
  const std::string counted = text(bench, "MW 20"), timer = text(bench, "T 1");
  const Json clock = bench.state()["clock"];
  bench.call("variables.write", input("E 0.0", "0"));
  bench.call("variables.write", input("DB1.count", "1"));
  bench.call("variables.unforce");
  bench.call("cpu.stop");
  bench.run(Duration::seconds(50));
  bench.call("cpu.load", {{"path", "half.state"}});
  EXPECT_EQ(bench.state()["mode"], "RUN");
  EXPECT_EQ(text(bench, "MW 20"), counted);
  EXPECT_EQ(text(bench, "T 1"), timer);
  EXPECT_EQ(text(bench, "DB1.count"), "77");
  EXPECT_EQ(text(bench, "A 0.7"), "1");
  EXPECT_EQ(bench.state()["clock"], clock);
  EXPECT_EQ(bench.state()["forces"].size(), 1u);
  bench.run(Duration::milliseconds(1200));
  EXPECT_EQ(text(bench, "A 0.1"), "0");
  bench.run(Duration::milliseconds(200));
  EXPECT_EQ(text(bench, "A 0.1"), "1");
}

// An interrupt of a time of day that has come, and comes never again.
TEST(CpuState, WithAnInterruptThatIsOverComesBack) {
  Bench bench(std::string(kProgram) +
                  "ORGANIZATION_BLOCK OB 10\nBEGIN\nNETWORK\n      L     MW 30;\n      +     1;\n"
                  "      T     MW 30;\nEND_ORGANIZATION_BLOCK\n",
              "[cpu.OB10]\nperiod = \"once\"\nstart = \"DT#2005-09-01-08:00:00\"\n");
  bench.call("cpu.setClock", {{"time", "2005-09-01 07:59:59.900"}});
  bench.run(Duration::seconds(1));
  EXPECT_EQ(text(bench, "MW 30", "DEC"), "1");
  bench.call("cpu.save", {{"path", "over.state"}});
  bench.call("variables.write", input("MW 30", "7"));
  bench.call("cpu.load", {{"path", "over.state"}});
  bench.run(Duration::seconds(1));
  EXPECT_EQ(text(bench, "MW 30", "DEC"), "1");
}

TEST(CpuState, ComesBackInCompiledCodeToo) {
  Bench bench;
  bench.call("cpu.stop");
  if (bench.ask("cpu.engine", {{"engine", "jit"}}).contains("problems")) GTEST_SKIP();
  bench.call("cpu.start");
  bench.run(Duration::milliseconds(100));
  bench.call("cpu.save", {{"path", "jit.state"}});
  const std::string counted = text(bench, "MW 20");
  bench.run(Duration::milliseconds(100));
  EXPECT_NE(text(bench, "MW 20"), counted);
  bench.call("cpu.load", {{"path", "jit.state"}});
  EXPECT_EQ(text(bench, "MW 20"), counted);
  bench.run(Duration::milliseconds(100));
  EXPECT_NE(text(bench, "MW 20"), counted);
}

// A process that ended while it saved has left a part beside the old file.
TEST(CpuState, IsWholeWhenSavingWasCutOff) {
  Bench bench;
  bench.call("cpu.save", {{"path", "old.state"}});
  const std::string before = bench.folder.read("old.state");
  bench.folder.write(".merker-saving-old.state", before.substr(0, before.size() / 2));
  bench.call("cpu.load", {{"path", "old.state"}});
  bench.call("cpu.save", {{"path", "old.state"}, {"replace", true}});
  EXPECT_FALSE(std::filesystem::exists(bench.folder.path(".merker-saving-old.state")));
  bench.call("cpu.load", {{"path", "old.state"}});
  EXPECT_EQ(bench.state()["mode"], "RUN");
}

TEST(CpuState, OfAnotherProgramBringsItsBlocks) {
  Bench bench;
  bench.call("cpu.save", {{"path", "first.state"}});
  bench.folder.write(
      "main.awl",
      "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\n SET;\n = M 9.0;\nEND_ORGANIZATION_BLOCK\n");
  bench.call("program.load");
  bench.run(Duration::milliseconds(50));
  EXPECT_EQ(text(bench, "M 9.0"), "1");
  bench.call("cpu.load", {{"path", "first.state"}});
  const Json blocks = bench.call("program.blocks", {{"side", "online"}})["blocks"];
  EXPECT_EQ(blocks.size(), 2u);
  const std::string counted = text(bench, "MW 20");
  bench.run(Duration::milliseconds(50));
  EXPECT_NE(text(bench, "MW 20"), counted);
  EXPECT_EQ(text(bench, "M 9.0"), "0");
}

TEST(CpuState, IsRefusedByAnotherCpuAndWhereItIsNone) {
  Bench bench;
  bench.call("cpu.save", {{"path", "here.state"}});
  EXPECT_EQ(bench.problem("cpu.save", {{"path", "here.state"}}), "P1312");
  bench.call("cpu.save", {{"path", "here.state"}, {"replace", true}});
  EXPECT_EQ(bench.problem("cpu.save", {{"path", "main.awl"}, {"replace", true}}), "P1305");
  Json saved = Json::parse(bench.folder.read("here.state"));
  saved["cpu"] = "412-1";
  bench.folder.write("there.state", saved.dump());
  EXPECT_EQ(bench.problem("cpu.load", {{"path", "there.state"}}), "P1319");
  bench.folder.write("no.state", "{}");
  EXPECT_EQ(bench.problem("cpu.load", {{"path", "no.state"}}), "P1320");
  saved = Json::parse(bench.folder.read("here.state"));
  saved["memory"]["timers"][0]["base"] = 77;
  bench.folder.write("bad.state", saved.dump());
  EXPECT_EQ(bench.problem("cpu.load", {{"path", "bad.state"}}), "P1320");
  EXPECT_EQ(bench.problem("cpu.load", {{"path", "none.state"}}), "P1310");
}

TEST(CpuState, OfAnotherSizeIsRefused) {
  Bench bench;
  bench.call("cpu.save", {{"path", "here.state"}});
  const std::string before = text(bench, "MW 20");
  const Json whole = Json::parse(bench.folder.read("here.state"));
  for (const auto& [key, value] :
       {std::pair{"flags", Json("00")}, {"timers", Json::array()}, {"counters", Json::array()}}) {
    Json saved = whole;
    saved["memory"][key] = value;
    bench.folder.write("short.state", saved.dump());
    EXPECT_EQ(bench.problem("cpu.load", {{"path", "short.state"}}), "P1320") << key;
    EXPECT_EQ(text(bench, "MW 20"), before);
  }
}

// As they were written before: one by one.
TEST(CpuState, OfTimersThatAreAlike) {
  Bench bench;
  bench.call("cpu.save", {{"path", "here.state"}});
  Json saved = Json::parse(bench.folder.read("here.state"));
  for (const char* key : {"timers", "counters"}) {
    Json& list = saved["memory"][key];
    EXPECT_LT(list.size(), 10u);
    Json single = Json::array();
    for (Json item : list) {
      const std::size_t times = item.value("times", 1u);
      item.erase("times");
      single.insert(single.end(), times, item);
    }
    EXPECT_EQ(single.size(), 256u);
    list = single;
    bench.folder.write("old.state", saved.dump());
    bench.call("cpu.load", {{"path", "old.state"}});
    for (const Json& times : {Json(257), Json(99'999), Json(1'000'000'000), Json(-1)}) {
      Json longer = saved;
      longer["memory"][key] = {list[0]};
      longer["memory"][key][0]["times"] = times;
      bench.folder.write("bad.state", longer.dump());
      EXPECT_EQ(bench.problem("cpu.load", {{"path", "bad.state"}}), "P1320") << times;
    }
  }
}

std::string dataBlocks(int count) {
  std::string text;
  for (int number = 10; number < 10 + count; ++number)
    text += fmt::format(
        "DATA_BLOCK DB {}\nSTRUCT\n a : ARRAY [0..8000] OF INT := {};\nEND_STRUCT\nBEGIN\n"
        "END_DATA_BLOCK\n",
        number, number);
  return text;
}

// What cpu.load could not read is not written: neither what the data alone show, nor what only the
// blocks do.
TEST(CpuState, IsNotWrittenLongerThanItCanBeRead) {
  for (const auto& [count, fits] : {std::pair{60, true}, {90, false}, {140, false}}) {
    SCOPED_TRACE(count);
    Bench bench(kProgram + dataBlocks(count), "[cpu]\nmodel = \"generic\"\n");
    const Json answer = bench.ask("cpu.save", {{"path", "big.state"}, {"replace", true}});
    EXPECT_EQ(answer.contains("problems"), !fits) << answer.dump();
    if (fits) {
      bench.call("cpu.load", {{"path", "big.state"}});
    } else {
      EXPECT_EQ(bench.problem("cpu.save", {{"path", "big.state"}}), "P1308");
      EXPECT_FALSE(std::filesystem::exists(bench.folder.path("big.state")));
    }
  }
}

// A wall clock that each look moves on.
class Recording : public ::testing::Test {
 protected:
  void pass(Duration time) {
    const Instant end = bench.workbench.plc()->controller().now() + time;
    while (bench.workbench.plc()->controller().now() < end)
      bench.workbench.advance([this] { return wall_ += 100'000; }, Duration::milliseconds(1));
  }
  Instant now() { return bench.workbench.plc()->controller().now(); }

  Bench bench;

 private:
  std::int64_t wall_ = 0;
};

TEST_F(Recording, IsPlayedBackAtTheSameInstants) {
  bench.call("time.pace", {{"mode", "fast"}});
  bench.call("cpu.save", {{"path", "begin.state"}});
  bench.call("record.start");
  const Instant begin = now();
  pass(Duration::milliseconds(300));
  bench.call("variables.write", input("E 0.0", "1"));
  const Duration pressed = now() - begin;
  pass(Duration::milliseconds(3000));
  const std::string counted = text(bench, "MW 20");
  const Duration length = now() - begin;
  EXPECT_EQ(bench.state()["recording"]["actions"], 1);
  EXPECT_EQ(bench.call("record.stop", {{"path", "press.rec"}})["actions"], 1);
  EXPECT_TRUE(bench.state()["recording"].is_null());
  const Json line = Json::parse(bench.folder.read("press.rec"));
  EXPECT_EQ(line["at"], pressed.ns);
  EXPECT_EQ(line["do"], "variables.write");

  bench.call("cpu.load", {{"path", "begin.state"}});
  EXPECT_EQ(text(bench, "E 0.0"), "0");
  bench.call("play.start", {{"path", "press.rec"}});
  const Instant again = now();
  pass(pressed + Duration::milliseconds(-20));
  EXPECT_EQ(bench.state()["playback"]["done"], 0);
  pass(Duration::milliseconds(40));
  ASSERT_LT(now(), again + length);
  bench.workbench.plc()->controller().advanceTo(again + length);
  EXPECT_EQ(bench.state()["playback"]["state"], "ended");
  EXPECT_EQ((now() - again).ns, length.ns);
  EXPECT_EQ(text(bench, "MW 20"), counted);
  EXPECT_EQ(text(bench, "A 0.1"), "1");
}

TEST_F(Recording, WaitsWhileItIsPausedAndEndsWhenItIsStopped) {
  bench.folder.write("two.rec",
                     "{\"at\":100000000,\"do\":\"variables.write\",\"items\":[{\"operand\":\"M "
                     "1.0\",\"value\":\"1\"}]}\n"
                     "{\"at\":200000000,\"do\":\"variables.write\",\"items\":[{\"operand\":\"M "
                     "1.1\",\"value\":\"1\"}]}\n");
  bench.call("play.start", {{"path", "two.rec"}});
  pass(Duration::milliseconds(150));
  EXPECT_EQ(text(bench, "M 1.0"), "1");
  bench.call("play.pause", {{"on", true}});
  pass(Duration::milliseconds(500));
  EXPECT_EQ(text(bench, "M 1.1"), "0");
  EXPECT_EQ(bench.state()["playback"]["state"], "paused");
  bench.call("play.pause", {{"on", false}});
  pass(Duration::milliseconds(30));
  EXPECT_EQ(text(bench, "M 1.1"), "0");
  pass(Duration::milliseconds(50));
  EXPECT_EQ(text(bench, "M 1.1"), "1");
  bench.call("play.start", {{"path", "two.rec"}});
  bench.call("play.stop");
  EXPECT_TRUE(bench.state()["playback"].is_null());
}

// Time stands still between single cycles; so does the recording.
TEST_F(Recording, FollowsSingleCycles) {
  bench.folder.write("one.rec",
                     "{\"at\":1,\"do\":\"variables.write\",\"items\":[{\"operand\":\"M "
                     "1.0\",\"value\":\"1\"}]}\n");
  bench.call("time.pace", {{"mode", "pause"}});
  bench.call("play.start", {{"path", "one.rec"}});
  const auto before = bench.workbench.plc()->controller().cycles();
  bench.workbench.advance([] { return 0; }, Duration::milliseconds(5));
  EXPECT_EQ(text(bench, "M 1.0"), "0");
  bench.call("time.step");
  bench.workbench.advance([] { return 0; }, Duration::milliseconds(5));
  EXPECT_EQ(bench.workbench.plc()->controller().cycles(), before + 1);
  EXPECT_EQ(text(bench, "M 1.0"), "1");
}

TEST_F(Recording, WithALineThatIsNoneIsRefusedWithItsPlace) {
  bench.folder.write(
      "bad.rec",
      "{\"at\":5,\"do\":\"cpu.stop\"}\n{\"at\":9,\"do\":\"files.delete\",\"path\":\"x\"}\n");
  const Json answer = bench.ask("play.start", {{"path", "bad.rec"}});
  EXPECT_EQ(answer["problems"][0]["code"], "P1321");
  EXPECT_EQ(answer["problems"][0]["file"], "bad.rec");
  EXPECT_EQ(answer["problems"][0]["line"], 2);
  bench.folder.write("back.rec",
                     "{\"at\":5,\"do\":\"cpu.stop\"}\n{\"at\":4,\"do\":\"cpu.stop\"}\n");
  EXPECT_EQ(bench.problem("play.start", {{"path", "back.rec"}}), "P1321");
  bench.folder.write(
      "gone.rec",
      "{\"at\":5,\"do\":\"variables.write\",\"items\":[{\"operand\":\"XX\",\"value\":\"1\"}]}\n");
  bench.call("play.start", {{"path", "gone.rec"}});
  pass(Duration::milliseconds(10));
  EXPECT_EQ(bench.state()["playback"]["state"], "failed");
  EXPECT_FALSE(bench.state()["playback"]["problem"]["text"].get<std::string>().empty());
}

// A field that means nothing is not kept, whatever a browser puts into it.
// The number of the request means nothing in a file.
TEST(Recorded, KeepsOnlyWhatMeansSomething) {
  Recorder recorder;
  recorder.start(Instant{0});
  recorder.note({{"id", 7}, {"do", "cpu.stop"}, {"padding", std::string(1 << 20, 'x')}}, Instant{});
  ASSERT_EQ(recorder.actions().size(), 1u);
  EXPECT_EQ(*recorder.actions()[0].request, (Json{{"do", "cpu.stop"}}));
}

// A value with every field that the shape has.
Json whole(const Shape& shape) {
  if (shape.kind == Shape::Kind::List) return Json::array({whole(shape.parts[0])});
  if (shape.kind == Shape::Kind::Object) {
    Json object = Json::object();
    for (const Shape& field : shape.parts) object[field.name] = whole(field);
    return object;
  }
  return "x";
}

TEST(Recorded, KeepsEachFieldOfEachAction) {
  for (const MethodRow& row : methodRows()) {
    if (row.kind != Kind::Action) continue;
    Json request = whole(row.fields);
    request["do"] = row.name;
    Recorder recorder;
    recorder.start(Instant{0});
    recorder.note(request, Instant{});
    ASSERT_EQ(recorder.actions().size(), 1u) << row.name;
    EXPECT_EQ(*recorder.actions()[0].request, request);
  }
}

TEST(Recorded, EndsWhereItIsFull) {
  Recorder recorder;
  recorder.start(Instant{0});
  const Json big = {{"do", "cpu.load"}, {"path", std::string(1 << 20, 'x')}};
  for (int i = 0; i < 10; ++i) recorder.note(big, Instant{i});
  EXPECT_TRUE(recorder.full());
  EXPECT_EQ(recorder.actions().size(), Recorder::kMostBytes / (1 << 20) - 1);
}

}  // namespace
}  // namespace merker::workbench::test
