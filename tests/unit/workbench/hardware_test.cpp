#include "bench.h"

namespace merker::workbench::test {
namespace {

constexpr const char* kSettings = R"(
[[module]]
type = "SM 321 DI16xDC24V"
slot = 4
name = "Panel"

[[module]]
type = "SM 331 AI8x12Bit"
slot = 5
diagnostic_interrupt = true
)";

Json slot(Bench& bench, const std::string& name) {
  const Json answer = bench.call("hardware.read");
  for (const Json& one : answer["racks"][0]["slots"])
    if (one["slot"] == name) return one;
  return nullptr;
}

TEST(Hardware, WithoutConfigurationIsTheCpuAlone) {
  Bench bench;
  EXPECT_EQ(slot(bench, "2")["name"], "CPU 314C-2 PtP");
  const Json onBoard = slot(bench, "2.2");
  EXPECT_EQ(onBoard["kind"], "digital");
  EXPECT_EQ(onBoard["faults"], Json::array());
  EXPECT_EQ(bench.problem("hardware.fault",
                          {{"rack", 0}, {"slot", "2.2"}, {"fault", "load voltage"}, {"on", true}}),
            "P1307");
}

// S7-HWCFG-01, S7-HWCFG-02
TEST(Hardware, ModulesHaveAddressesTerminalsAndFaults) {
  Bench bench(kProgram, kSettings);
  const Json panel = slot(bench, "4");
  EXPECT_EQ(panel["name"], "Panel");
  EXPECT_EQ(panel["inputs"], (Json{{"first", 0}, {"bytes", 2}}));
  EXPECT_EQ(panel["terminals"][0]["operand"], "E 0.0");
  EXPECT_EQ(panel["terminals"][0]["symbol"], "Start");
  EXPECT_EQ(panel["terminals"][15]["text"], "DI15");
  EXPECT_EQ(slot(bench, "5")["terminals"][1]["operand"], "PEW 274");
}

TEST(Hardware, FaultsComeAndGo) {
  Bench bench(kProgram, kSettings);
  const Json pulled = {{"rack", 0}, {"slot", "4"}, {"fault", "removed"}, {"on", true}};
  const auto removed = [&] {
    const Json panel = slot(bench, "4");
    for (const Json& fault : panel["faults"])
      if (fault["name"] == "removed") return fault["on"].get<bool>();
    ADD_FAILURE();
    return false;
  };
  EXPECT_FALSE(removed());
  bench.call("hardware.fault", pulled);
  EXPECT_TRUE(removed());
  EXPECT_EQ(slot(bench, "4")["present"], false);
  bench.run(Duration::milliseconds(20));
  EXPECT_EQ(bench.state()["mode"], "STOP");  // no OB 83
  Json wrong = pulled;
  wrong["slot"] = "9";
  EXPECT_EQ(bench.problem("hardware.fault", wrong), "P1316");
  wrong = pulled;
  wrong["fault"] = "fire";
  EXPECT_EQ(bench.problem("hardware.fault", wrong), "P1316");
  wrong["fault"] = "fuse";
  EXPECT_EQ(bench.problem("hardware.fault", wrong), "P1307");
}

}  // namespace
}  // namespace merker::workbench::test
