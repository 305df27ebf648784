#include "bench.h"

namespace merker::workbench::test {
namespace {

constexpr const char* kAnalogOff = R"(
[cpu]
model = "314C-2 PtP"

[[module]]
slot = "2.2"
name = "Terminals"
input = 124
output = 124

[[module]]
slot = "2.3"
[[module.channel]]
output = 0
range = "off"
)";
constexpr const char* kAxis = R"(
[[module]]
slot = "2.5"
drive = "analog"
max_speed = 10000
creep_speed = 1000
target_range = 51
reference_point = 500
)";
constexpr const char* kCalled = R"(DATA_BLOCK DB 20
SFB 44
BEGIN
END_DATA_BLOCK
ORGANIZATION_BLOCK OB 1
BEGIN
NETWORK
      CALL  SFB 44, DB 20;
END_ORGANIZATION_BLOCK
)";

TEST(AxisView, ACpuWithoutAxisHasNone) {
  Bench bench;
  EXPECT_EQ(bench.call("process.list")["axis"], nullptr);
  bench.call("process.watch", {{"on", true}});
  EXPECT_EQ(bench.event("process")["axis"], nullptr);
}

// POS-WIRE-01, -02, -05, -06: where the plant belongs; POS-PARAM-02: 51 counts as 52.
TEST(AxisView, TellsParametersWiresAndInstances) {
  Bench bench(kCalled, std::string(kAnalogOff) + kAxis);
  const Json axis = bench.call("process.list")["axis"];
  EXPECT_EQ(axis["output"], "analog");
  EXPECT_EQ(axis["rotary"], false);
  EXPECT_EQ(axis["targetRange"], 52);
  EXPECT_EQ(axis["creepSpeed"], 1000);
  EXPECT_EQ(axis["blocks"], (Json{{{"id", "DB 20"}, {"function", 44}}}));
  std::map<std::string, std::string> wires;
  for (const Json& wire : axis["wires"]) wires[wire["signal"]] = wire["operand"];
  const std::map<std::string, std::string> expected{
      {"SETPOINT", "PAW 752"}, {"ENABLE", "A 124.6"},    {"A", "E 124.0"},        {"B", "E 124.1"},
      {"N", "E 124.2"},        {"WORKPIECE", "E 124.3"}, {"REFERENCE", "E 124.4"}};
  EXPECT_EQ(wires, expected);
}

// A multiple instance is named as its operands are, also one in the instance of another FB.
TEST(AxisView, FindsMultipleInstances) {
  Bench bench(R"(FUNCTION_BLOCK FB 1
VAR
  Table : SFB 44;
  Count : INT;
END_VAR
BEGIN
NETWORK
      CALL  #Table;
END_FUNCTION_BLOCK
FUNCTION_BLOCK FB 2
VAR
  Machine : FB 1;
END_VAR
BEGIN
NETWORK
      CALL  #Machine;
END_FUNCTION_BLOCK
DATA_BLOCK DB 30
FB 1
BEGIN
END_DATA_BLOCK
DATA_BLOCK DB 31
FB 2
BEGIN
END_DATA_BLOCK
ORGANIZATION_BLOCK OB 1
BEGIN
NETWORK
      CALL  FB 1, DB 30;
      CALL  FB 2, DB 31;
END_ORGANIZATION_BLOCK
)",
              std::string(kAnalogOff) + kAxis);
  const Json blocks = bench.call("process.list")["axis"]["blocks"];
  EXPECT_EQ(blocks, (Json{{{"id", "DB 30.Table"}, {"function", 44}},
                          {{"id", "DB 31.Machine.Table"}, {"function", 44}}}));
  for (const char* operand : {"DB30.Table.DIR_P", "DB31.Machine.Table.DIR_P"}) {
    bench.call("variables.write", {{"items", {{{"operand", operand}, {"value", "1"}}}}});
    const Json items = {{{"operand", operand}, {"format", "AUTO"}}};
    EXPECT_EQ(bench.call("variables.read", {{"items", items}})["items"][0]["raw"], 1) << operand;
  }
}

TEST(AxisView, DigitalOutputsAndDirectionSignalHaveTheirWires) {
  const auto signalsOf = [](const std::string& settings) {
    Bench bench(kCalled, kAnalogOff + settings);
    const Json axis = bench.call("process.list")["axis"];
    std::string signals;
    for (const Json& wire : axis["wires"]) signals += wire["signal"].get<std::string>() + " ";
    return signals;
  };
  EXPECT_EQ(signalsOf("[[module]]\nslot = \"2.5\"\ndrive = \"digital\"\n"),
            "Q0 Q1 Q2 Q3 A B N WORKPIECE REFERENCE ");
  EXPECT_EQ(signalsOf("[[module]]\nslot = \"2.5\"\ndrive = \"analog\"\nvoltage = \"0..10V\"\n"),
            "SETPOINT ENABLE DIRECTION A B N WORKPIECE REFERENCE ");
}

TEST(AxisView, TheEventHasWhatTheAxisShows) {
  Bench bench(kCalled, std::string(kAnalogOff) + kAxis);
  bench.call("process.watch", {{"on", true}});
  const Json axis = bench.event("process")["axis"];
  EXPECT_EQ(axis["position"], 500);
  EXPECT_EQ(axis["parameterised"], 1);
  EXPECT_EQ(axis["working"], 0);
}

Json pagesOf(Bench& bench, const std::string& settings) {
  const Json plan = bench.call("hardware.edit", {{"text", settings}});
  for (const Json& slot : plan["racks"][0]["slots"])
    if (slot["slot"] == "2.5") return slot["parameters"];
  return nullptr;
}

// POS-OVW-17, POS-PARAM-22, -31
TEST(AxisView, ParametersHaveThePagesOfTheManual) {
  Bench bench(kCalled, std::string(kAnalogOff) + kAxis);
  std::string order;
  std::map<std::string, Json> rows;
  for (const Json& row : pagesOf(bench, std::string(kAnalogOff) + kAxis)) {
    const std::string page = row["page"];
    if (!order.ends_with(page + " ")) order += page + " ";
    rows[row["key"]] = row;
  }
  EXPECT_EQ(order, "general addresses basic drive axis encoder diagnosis ");
  EXPECT_EQ(rows["monitor_traversing_range"]["fixed"], true);
  EXPECT_FALSE(rows["monitor_working_range"].contains("fixed"));
  EXPECT_EQ(rows["max_speed"]["value"], 10000);
  EXPECT_FALSE(rows.contains("control_type"));
}

TEST(AxisView, WithoutDriveOnlyTheFirstPagesAreThere) {
  Bench bench;
  std::string keys;
  for (const Json& row : pagesOf(bench, kAnalogOff)) keys += row["key"].get<std::string>() + " ";
  EXPECT_EQ(keys, "name input output drive interrupts ");
}

}  // namespace
}  // namespace merker::workbench::test
