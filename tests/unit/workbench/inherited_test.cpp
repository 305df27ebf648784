#include "bench.h"

namespace merker::workbench::test {
namespace {

std::int64_t rawOf(Bench& bench, const std::string& operand) {
  return bench.call("variables.read", {{"items", {{{"operand", operand}}}}})["items"][0]["raw"];
}

void setValue(Bench& bench, const std::string& operand, const std::string& value) {
  bench.call("variables.write", {{"items", {{{"operand", operand}, {"value", value}}}}});
}

// A CPU in RUN whose flags, data block, clock and forces are not as they come.
void useCpu(Bench& bench) {
  bench.call("cpu.setClock", {{"time", "2024-05-06 07:08:09"}});
  setValue(bench, "MW 12", "77");
  setValue(bench, "DB1.DBW 0", "9");
  bench.call("variables.force", {{"items", {{{"operand", "A 0.7"}, {"value", "1"}}}}});
  bench.run(Duration::milliseconds(20));
  bench.call("cpu.stop");
}

// S7-MEM-02, S7-CPU-32: a configuration that is loaded in STOP is no memory reset.
TEST(Inherited, AnotherConfigurationLeavesTheMemoryOfTheCpu) {
  Bench bench;
  useCpu(bench);
  bench.folder.write("merker.toml", "[cpu]\nmpi_address = 5\n");
  bench.call("program.load");
  EXPECT_EQ(rawOf(bench, "MW 12"), 77);
  EXPECT_EQ(rawOf(bench, "DB1.DBW 0"), 9);
  const Json state = bench.state();
  EXPECT_EQ(state["clock"].get<std::string>().substr(0, 16), "2024-05-06 07:08");
  EXPECT_EQ(state["forces"].size(), 1u);
  EXPECT_EQ(state["switch"], "RUN-P");
  const Json entries = bench.call("diagnosis.buffer")["entries"];
  ASSERT_FALSE(entries.empty());
  EXPECT_EQ(entries[0]["event"], "16#4304");
  EXPECT_GT(entries.size(), 2u);
  bench.call("cpu.start");
  bench.run(Duration::milliseconds(20));
  EXPECT_EQ(rawOf(bench, "MW 12"), 77);
  EXPECT_EQ(rawOf(bench, "A 0.7"), 1);
}

// What the new configuration has not retentive goes with the next start (S7-STATE-09).
TEST(Inherited, TheNewConfigurationSaysWhatIsRetentive) {
  Bench bench;
  useCpu(bench);
  bench.folder.write("merker.toml", "[cpu]\nretentive_flags = 4\n");
  bench.call("program.load");
  bench.call("cpu.start");
  EXPECT_EQ(rawOf(bench, "MW 12"), 0);
  EXPECT_EQ(rawOf(bench, "DB1.DBW 0"), 9);
}

// S7-MEM-04
TEST(Inherited, ADataBlockThatComesAnewWithTheConfigurationHasItsOwnValues) {
  Bench bench;
  useCpu(bench);
  std::string other = kProgram;
  other.replace(other.find("INT := 5"), 8, "INT := 6");
  bench.folder.write("main.awl", other);
  bench.folder.write("merker.toml", "[cpu]\nmpi_address = 5\n");
  bench.call("program.load");
  EXPECT_EQ(rawOf(bench, "DB1.DBW 0"), 6);
  EXPECT_EQ(rawOf(bench, "MW 12"), 77);
}

TEST(Inherited, AnotherCpuHasNothingToKeep) {
  Bench bench;
  useCpu(bench);
  bench.folder.write("merker.toml", "[cpu]\nmodel = \"313C\"\n");
  bench.call("program.load");
  EXPECT_EQ(rawOf(bench, "MW 12"), 0);
  EXPECT_EQ(bench.state()["forces"].size(), 0u);
}

}  // namespace
}  // namespace merker::workbench::test
