#include <algorithm>

#include "bench.h"

namespace merker::workbench::test {
namespace {

// S7-SIM-11
TEST(PlcMethods, TheSwitchStartsStopsAndResets) {
  Bench bench;
  EXPECT_EQ(bench.state()["mode"], "RUN");
  EXPECT_EQ(bench.state()["switch"], "RUN-P");
  bench.call("cpu.switch", {{"position", "STOP"}});
  Json state = bench.state();
  EXPECT_EQ(state["mode"], "STOP");
  EXPECT_EQ(state["leds"]["STOP"], "on");
  EXPECT_EQ(state["leds"]["RUN"], "off");
  EXPECT_NE(state["stopReason"], "");
  bench.call("cpu.switch", {{"position", "RUN"}});
  bench.run(Duration::milliseconds(10));
  EXPECT_EQ(bench.state()["mode"], "RUN");
  bench.call("variables.write", {{"items", {{{"operand", "MW 40"}, {"value", "7"}}}}});
  bench.call("cpu.switch", {{"position", "MRES"}});
  EXPECT_EQ(bench.state()["switch"], "STOP");
  EXPECT_EQ(bench.call("variables.read", {{"items", {{{"operand", "MW 40"}}}}})["items"][0]["raw"],
            0);
}

TEST(PlcMethods, StopAndStartOfTheProgrammer) {
  Bench bench;
  bench.run(Duration::milliseconds(50));
  EXPECT_EQ(bench.problem("cpu.reset"), "P1308");
  bench.call("cpu.stop");
  EXPECT_EQ(bench.state()["mode"], "STOP");
  EXPECT_EQ(bench.workbench.plc()->controller().diagnostics().back().event, 0x4304);
  bench.call("cpu.reset");
  bench.call("cpu.start", {{"kind", "warm"}});
  bench.run(Duration::milliseconds(50));
  EXPECT_EQ(bench.state()["mode"], "RUN");
  EXPECT_EQ(bench.problem("cpu.start", {{"kind", "cold"}}), "P1307");  // none on a 314C
}

TEST(PlcMethods, PowerGoesAndComes) {
  Bench bench;
  bench.call("cpu.power", {{"on", false}});
  Json state = bench.state();
  EXPECT_EQ(state["powered"], false);
  EXPECT_EQ(state["leds"]["DC5V"], "off");
  bench.call("cpu.power", {{"on", true}});
  bench.run(Duration::milliseconds(50));
  EXPECT_EQ(bench.state()["mode"], "RUN");
}

// S7-SIM-13: without its OB the event stops the CPU.
TEST(PlcMethods, EventsByHand) {
  Bench bench;
  bench.run(Duration::milliseconds(50));
  EXPECT_EQ(bench.problem("cpu.trigger", {{"ob", 1}}), "P1308");
  bench.call("cpu.trigger", {{"ob", 80}});
  bench.run(Duration::milliseconds(50));
  const Json state = bench.state();
  EXPECT_EQ(state["mode"], "STOP");
  EXPECT_NE(state["stopReason"].get<std::string>().find("16#4568"), std::string::npos);
}

// S7-CPU-32, S7-TYPES-18: the years of DATE_AND_TIME.
TEST(PlcMethods, TheClockIsSet) {
  Bench bench;
  bench.call("cpu.stop");
  bench.call("cpu.setClock", {{"time", "2024-02-29 23:59:59.5"}});
  const std::string clock = bench.state()["clock"];
  EXPECT_EQ(clock.substr(0, 19), "2024-02-29 23:59:59") << clock;
  for (const char* first : {"1990-01-01 00:00:00", "2089-12-31 23:59:59"}) {
    bench.call("cpu.setClock", {{"time", first}});
    EXPECT_EQ(bench.state()["clock"].get<std::string>().substr(0, 19), first);
  }
  for (const char* wrong : {"1989-12-31 23:59:59", "2090-01-01 00:00:00", "2023-02-29 00:00:00",
                            "2024-01-01 24:00:00", "2024-01-01", "", "tomorrow"})
    EXPECT_EQ(bench.problem("cpu.setClock", {{"time", wrong}}), "P1305") << wrong;
  EXPECT_EQ(bench.state()["clock"].get<std::string>().substr(0, 4), "2089");
  bench.call("cpu.power", {{"on", false}});
  EXPECT_EQ(bench.problem("cpu.setClock", {{"time", "2024-01-01 00:00:00"}}), "P1308");
}

// The panel, the buffer and what a program reads show the same year (S7-CPU-32).
TEST(PlcMethods, TheClockBeginsAgainBehind2089) {
  Bench bench;
  bench.call("cpu.setClock", {{"time", "2089-12-31 23:59:59.999"}});
  bench.run(Duration::milliseconds(50));
  bench.call("cpu.stop");
  EXPECT_EQ(bench.state()["clock"].get<std::string>().substr(0, 16), "1990-01-01 00:00");
  EXPECT_EQ(bench.call("diagnosis.buffer")["entries"][0]["clock"].get<std::string>().substr(0, 10),
            "1990-01-01");
  bench.call("cpu.setClock", {{"time", bench.state()["clock"]}});
}

TEST(PlcMethods, TheEngineChangesInStopOnly) {
  Bench bench;
  EXPECT_EQ(bench.problem("cpu.engine", {{"engine", "jit"}}), "P1308");
  bench.call("cpu.stop");
  bench.call("cpu.engine", {{"engine", "jit"}});
  EXPECT_EQ(bench.state()["engine"], "jit");
}

// Another configuration is another station.
TEST(PlcMethods, TheEngineStaysWithTheNextPlc) {
  Bench bench;
  bench.call("cpu.stop");
  bench.call("cpu.engine", {{"engine", "jit"}});
  bench.folder.write("merker.toml",
                     "[project]\nname = \"Test\"\n[cpu]\ncycle_monitoring = \"200ms\"\n");
  bench.call("program.load");
  EXPECT_EQ(bench.state()["engine"], "jit");
}

TEST(State, OnlyWhatChangedIsTold) {
  Bench bench;
  const Json first = bench.event("state");
  EXPECT_EQ(first["project"]["name"], "Test");
  EXPECT_EQ(first["project"]["family"], "S7");
  EXPECT_TRUE(bench.events().empty());
  bench.run(Duration::milliseconds(20));
  const Json second = bench.event("state");
  EXPECT_TRUE(second.contains("time"));
  EXPECT_TRUE(second.contains("cycles"));
  EXPECT_FALSE(second.contains("project"));
  EXPECT_FALSE(second.contains("mode"));
}

TEST(State, EachBrowserHasItsOwnView) {
  Bench bench;
  EXPECT_FALSE(bench.event("state").is_null());
  bench.workbench.opened(2);
  EXPECT_EQ(bench.event("state", 2)["mode"], "RUN");
  EXPECT_EQ(bench.event("state", 1), Json({{"event", "state"}, {"browsers", 2}}));
  EXPECT_TRUE(bench.event("state", 1).is_null());
}

TEST(State, AFaultTellsItsReason) {
  Bench bench;
  bench.call("variables.write", {{"items", {{{"operand", "E 0.7"}, {"value", "1"}}}}});
  bench.run(Duration::milliseconds(50));
  const Json state = bench.state();
  EXPECT_EQ(state["mode"], "STOP");
  EXPECT_EQ(state["leds"]["SF"], "on");
}

// All or none, on a SINUMERIK as on an S7: two of one list that share bits are refused.
TEST(Forces, OfOneRequestDoNotOverlap) {
  const auto forces = [](Workbench& workbench) {
    const auto ask = [&](const std::string& items) {
      const Json answer = Json::parse(
          workbench.handle(1, R"({"id": 1, "do": "variables.force", "items": [)" + items + "]}"));
      return answer.contains("problems") ? answer["problems"][0]["code"].get<std::string>() : "";
    };
    const std::string bit = R"({"operand": "E 0.0", "value": "1"})",
                      byte = R"({"operand": "EB 0", "value": "B#16#0"})";
    EXPECT_EQ(ask(bit + ", " + byte), "P1219");
    EXPECT_TRUE(workbench.plc()->monitor().forces().empty());
    EXPECT_EQ(ask(bit + R"(, {"operand": "E 0.1", "value": "1"})"), "");
    EXPECT_EQ(workbench.plc()->monitor().forces().size(), 2u);
    EXPECT_EQ(ask(byte), "P1219");
    EXPECT_EQ(workbench.plc()->monitor().forces().size(), 2u);
  };
  Bench s7;
  forces(s7.workbench);
  Folder folder;
  folder.write("main.s5", "OB 1\n      U     E 0.0\n      =     A 0.0\n      BE\n");
  Workbench sinumerik;
  sinumerik.show(
      std::make_unique<Plc>(compilation::build(project::load(folder.path("main.s5"), {}), false)));
  forces(sinumerik);
}

TEST(Sinumerik, HasPanelAndVariables) {
  Folder folder;
  folder.write("main.s5",
               "OB 1\n      U     E 0.0\n      =     A 0.0\n      L     KF +7\n"
               "      T     MW 40\n      BE\n");
  Workbench workbench;
  workbench.show(
      std::make_unique<Plc>(compilation::build(project::load(folder.path("main.s5"), {}), false)));
  const auto ask = [&](const std::string& text) { return Json::parse(workbench.handle(1, text)); };
  controller::Controller& plc = workbench.plc()->controller();
  plc.advanceTo(plc.now() + Duration::seconds(1));
  workbench.beginFrame(0);
  const Json state = Json::parse(workbench.events(1).front());
  EXPECT_EQ(state["project"]["family"], "S5");
  EXPECT_EQ(state["mode"], "RUN");
  const Json read = ask(R"({"id": 1, "do": "variables.read", "items": [{"operand": "MW 40"}]})");
  EXPECT_EQ(read["result"]["items"][0]["raw"], 7);
  const Json refused = ask(R"({"id": 2, "do": "process.list"})");
  EXPECT_EQ(refused["problems"][0]["code"], "P1307");
  const Json running = ask(R"({"id": 5, "do": "cpu.engine", "engine": "jit"})");
  EXPECT_EQ(running["problems"][0]["code"], "P1308");  // in STOP only
  const Json begun = ask(R"({"id": 4, "do": "cpu.start", "kind": "warm"})");
  EXPECT_TRUE(begun.contains("result")) << begun.dump();
  const auto& entries = plc.diagnostics();
  EXPECT_TRUE(std::ranges::any_of(entries, [](const auto& e) { return e.event == 6149; }))
      << "from RUN by way of STOP";
  const std::size_t before = plc.diagnostics().size();
  EXPECT_TRUE(ask(R"({"id": 7, "do": "cpu.switch", "position": "RUN"})").contains("result"));
  EXPECT_EQ(plc.diagnostics().size(), before) << "it runs already";
  EXPECT_TRUE(ask(R"({"id": 3, "do": "cpu.switch", "position": "STOP"})").contains("result"));
  EXPECT_EQ(plc.mode(), controller::Mode::Stop);
  EXPECT_TRUE(ask(R"({"id": 6, "do": "cpu.engine", "engine": "jit"})").contains("result"));
  workbench.beginFrame(1);
  EXPECT_EQ(Json::parse(workbench.events(1).front())["engine"], "jit");
}

// Operands of the partner keep its name, and are others than one's own.
TEST(Sinumerik, PartnerHasOperandsOfItsOwn) {
  Folder folder;
  const std::string cpu = "[cpu]\nmodel = \"SINUMERIK 820 GA3\"\n";
  folder.write("a/merker.toml", cpu + "[coupling]\npartner = \"../b\"\n");
  folder.write("a/a.s5", "OB 1\n      BE\n");
  folder.write("b/merker.toml", cpu + "[coupling]\npartner = \"../a\"\nrole = \"master\"\n");
  folder.write("b/b.s5", "OB 1\n      BE\n");
  Workbench workbench;
  workbench.show(
      std::make_unique<Plc>(compilation::build(project::load(folder.path("a"), {}), false)));
  const auto ask = [&](const std::string& text) { return Json::parse(workbench.handle(1, text)); };
  const Json watched = ask(
      R"({"id": 1, "do": "watch.set", "list": 0, "items": [{"operand": "partner.MW 10"}, {"operand": "MW 10"}]})");
  EXPECT_EQ(watched["result"]["items"][0]["operand"], "partner.MW 10") << watched.dump();
  EXPECT_EQ(watched["result"]["items"][1]["operand"], "MW 10");
  const Json forced = ask(
      R"({"id": 2, "do": "variables.force", "items": [{"operand": "partner.EB 0", "value": "1"}, {"operand": "E 0.0", "value": "1"}]})");
  EXPECT_TRUE(forced.contains("result")) << forced.dump();
  EXPECT_EQ(workbench.plc()->monitor().forces().size(), 2u);
}

}  // namespace
}  // namespace merker::workbench::test
