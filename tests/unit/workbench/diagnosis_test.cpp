#include "bench.h"

namespace merker::workbench::test {
namespace {

void fault(Bench& bench) {
  bench.call("variables.write", {{"items", {{{"operand", "E 0.7"}, {"value", "1"}}}}});
  bench.run(Duration::milliseconds(20));
}

// S7-DIAG-01, S7-DIAG-02
TEST(Diagnosis, TheBufferLeadsToTheLine) {
  Bench bench;
  const Json before = bench.state()["diagnostics"];
  fault(bench);
  EXPECT_GT(bench.state()["diagnostics"], before);
  const Json entries = bench.call("diagnosis.buffer")["entries"];
  EXPECT_EQ(entries[0]["number"], 1);
  EXPECT_EQ(entries[0]["event"], "16#4562");
  const Json& cause = entries[1];
  EXPECT_EQ(cause["event"], "16#2521");
  EXPECT_NE(cause["help"], "");
  EXPECT_EQ(cause["file"], "main.awl");
  EXPECT_EQ(cause["block"], "OB 1");
  EXPECT_EQ(cause["line"], 23);
  const std::string reason = bench.state()["stopReason"];
  EXPECT_NE(reason.find("(main.awl:23)"), std::string::npos) << reason;
}

// S7-NETPRO-08, S7-SFB-10: those of S7 communication and those of a CP.
TEST(Diagnosis, ConfiguredConnectionsAreListed) {
  Bench bench(kProgram,
              "[cpu]\nmodel = \"generic\"\n"
              "[[module]]\nslot = 4\ntype = \"6GK7 343-1EX30-0XE0\"\n"
              "[[connection]]\nid = \"W#16#A\"\npartner = \"tcp://127.0.0.1:102\"\n"
              "[[connection]]\nkind = \"udp\"\nid = 3\npartner = \"udp://127.0.0.1:2003\"\n"
              "local_port = 2004\n");
  const auto row = [](const char* kind, int id, const char* partner, const char* state) {
    return Json{
        {"kind", kind}, {"id", id}, {"partner", partner}, {"active", true}, {"state", state}};
  };
  const Json closed = bench.call("diagnosis.connections")["configured"];
  EXPECT_EQ(closed[0], row("s7", 10, "127.0.0.1:102", "closed"));
  EXPECT_EQ(closed[1], row("udp", 3, "127.0.0.1:2003", "closed"));
  bench.workbench.s7By([] {
    S7Outside outside;
    outside.place = "127.0.0.1:102";
    outside.partners.emplace_back();
    outside.partners[0].id = "W#16#A";
    outside.partners[0].state = "connected";
    outside.ofCp.push_back({.id = 3, .connected = true});
    return outside;
  });
  const Json open = bench.call("diagnosis.connections")["configured"];
  EXPECT_EQ(open[0]["state"], "connected");
  EXPECT_EQ(open[1]["state"], "connected");
}

// S7-DIAG-01: the module that an event is about, by its address.
TEST(Diagnosis, AnEventLeadsToItsModule) {
  Bench bench(kProgram, "[[module]]\nslot = 4\ntype = \"6ES7 321-1BH02-0AA0\"\n");
  bench.call("hardware.fault", {{"rack", 0}, {"slot", "4"}, {"fault", "removed"}, {"on", true}});
  bench.run(Duration::milliseconds(1500));
  const Json entries = bench.call("diagnosis.buffer")["entries"];
  const auto removed =
      std::ranges::find_if(entries, [](const Json& entry) { return entry["event"] == "16#3961"; });
  ASSERT_NE(removed, entries.end()) << entries.dump();
  EXPECT_EQ((*removed)["module"], Json({{"address", 0},
                                        {"output", false},
                                        {"rack", 0},
                                        {"slot", "4"},
                                        {"name", "SM 321 DI16xDC24V"}}));
  EXPECT_FALSE(entries.back().contains("module"));
}

// S7-DIAG-04
TEST(Diagnosis, StacksShowWhereItStopped) {
  Bench bench;
  EXPECT_EQ(bench.call("diagnosis.stacks")["blocks"].size(), 0u);
  fault(bench);
  const Json stacks = bench.call("diagnosis.stacks");
  EXPECT_EQ(stacks["blocks"][0]["block"], "OB 1");
  EXPECT_EQ(stacks["blocks"][0]["line"], 23);
  EXPECT_EQ(stacks["interrupts"][0]["registers"]["AKKU1"], "0000FFFF");
  EXPECT_EQ(stacks["locals"][0]["block"], "OB 1");
  EXPECT_EQ(stacks["locals"][0]["rows"], Json::array());
}

TEST(Diagnosis, InformationIsThatOfTheCpu) {
  Bench bench;
  const Json info = bench.call("diagnosis.information");
  EXPECT_EQ(info["model"], "CPU 314C-2 PtP");
  EXPECT_EQ(info["mode"], "RUN");
  EXPECT_GT(info["memory"]["workMemoryUsed"], 0);
  EXPECT_EQ(info["cycle"]["monitoringMs"], 150);
}

}  // namespace
}  // namespace merker::workbench::test
