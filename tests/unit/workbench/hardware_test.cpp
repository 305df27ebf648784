#include "bench.h"
#include "workbench/hardware_plan.h"

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

TEST(Hardware, EachSubmoduleHasItsKind) {
  Bench bench(kProgram, "[cpu]\nmodel = \"314C-2 PtP\"\n[[module]]\nslot = \"2.1\"\n");
  EXPECT_EQ(slot(bench, "2.1")["kind"], "point to point");
  EXPECT_EQ(slot(bench, "2.5")["kind"], "positioning");
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

std::map<std::string, std::string> propertiesOf(const Json& slot) {
  std::map<std::string, std::string> found;
  for (const Json& one : slot["properties"]) EXPECT_TRUE(found.emplace(one[0], one[1]).second);
  return found;
}

// What is printed and shown of a module is all that is set on it, in operation and configured.
TEST(Hardware, WhatIsSetIsReadWithTheModules) {
  const std::string settings =
      "[cpu]\nmodel = \"314C-2 PtP\"\nclock_memory = 7\npassword = \"secret\"\n"
      "[[module]]\nslot = \"2.3\"\n[[module.channel]]\ninput = 1\nrange = \"4..20mA\"\n"
      "[[module]]\nslot = \"2.4\"\n[[module.channel]]\nnumber = 1\nmode = \"endless\"\n";
  Bench bench(kProgram, settings);
  const Json planned = bench.call("hardware.edit", {{"text", settings}});
  for (const Json& answer : {bench.call("hardware.read"), planned}) {
    std::map<std::string, std::map<std::string, std::string>> slots;
    for (const Json& one : answer["racks"][0]["slots"]) slots[one["slot"]] = propertiesOf(one);
    EXPECT_EQ(slots["2"]["clock_memory"], "7");
    EXPECT_EQ(slots["2"]["cycle_monitoring"], "150ms");
    EXPECT_FALSE(slots["2"].contains("password"));
    EXPECT_EQ(slots["2.3"]["input 1 range"], "4..20mA");
    EXPECT_EQ(slots["2.4"]["channel 1 mode"], "endless");
    EXPECT_EQ(slots["2.3"]["supply"], "DC 24 V");
    EXPECT_FALSE(slots["2.3"].contains("signal"));
    EXPECT_EQ(slots["2.2"]["signal"], "DC 24 V");
  }
}

Json cpuLookedAt(const std::string& settings) {
  Bench bench(kProgram, settings);
  const Json answer = bench.call("projects.look");
  for (const Json& one : answer["racks"][0]["slots"])
    if (one["kind"] == "cpu") return one;
  return nullptr;
}

// S7-MGR-15
TEST(Hardware, WhatIsSetOnChannelsIsComparedWithTheModule) {
  Bench bench(kProgram,
              "[cpu]\nmodel = \"314C-2 PtP\"\n[[module]]\nslot = \"2.3\"\n"
              "[[module.channel]]\ninput = 1\nrange = \"4..20mA\"\n");
  const Json answer = bench.call("projects.look");
  std::map<std::string, std::string> found;
  for (const Json& slot : answer["racks"][0]["slots"])
    if (slot["slot"] == "2.3") {
      for (const Json& one : slot["properties"]) EXPECT_TRUE(found.emplace(one[0], one[1]).second);
    }
  EXPECT_EQ(found["input 1 range"], "4..20mA");
  EXPECT_TRUE(found.contains("input 0 range"));
  EXPECT_FALSE(found.contains("name"));
}

// S7-MGR-15
TEST(Hardware, WhatIsSetOnTheCpuIsComparedWithIt) {
  const Json cpu = cpuLookedAt(
      "[cpu]\nmpi_address = 5\ncycle_monitoring = \"300ms\"\nprotection = 3\n"
      "password = \"secret\"\n[cpu.OB35]\ninterval = \"50ms\"\n");
  EXPECT_EQ(cpu["order"], "6ES7 314-6BF01-0AB0");
  std::map<std::string, std::string> found;
  for (const Json& one : cpu["properties"]) found[one[0]] = one[1];
  EXPECT_EQ(found["mpi_address"], "5");
  EXPECT_EQ(found["cycle_monitoring"], "300ms");
  EXPECT_EQ(found["protection"], "3");
  EXPECT_EQ(found["start_on_mismatch"], "on");
  EXPECT_EQ(found["OB 35 interval"], "50ms");
  EXPECT_EQ(found["work memory"], "49152 bytes");
  EXPECT_FALSE(found.contains("password"));
}

TEST(Hardware, AControlIsComparedByItsModelAndMachineData) {
  const Json small = cpuLookedAt("[cpu]\nmodel = \"SINUMERIK 810 GA3\"\n");
  EXPECT_EQ(small["name"], "SINUMERIK 810 GA3");
  EXPECT_EQ(cpuLookedAt("[cpu]\nmodel = \"SINUMERIK 820 GA3\"\n")["name"], "SINUMERIK 820 GA3");
}

// S7-NET-17
TEST(Hardware, SlavesOfAnAsInterfaceHangOnTheirCp) {
  constexpr std::string_view kFormat =
      "[[module]]\nslot = 4\ntype = \"CP 343-2\"\ninput = {0}\noutput = {0}\n"
      "slave = [ {{address = 3, name = \"Gate\", profile = \"S-3.0\"}} ]\n";
  Bench bench(kProgram, fmt::format(kFormat, 32));
  const Json bus = bench.call("hardware.read")["racks"].back();
  EXPECT_EQ(bus["bus"], "asi");
  EXPECT_EQ(bus["place"], "4");
  const Json gate = bus["slots"][0];
  EXPECT_EQ(gate["name"], "Gate");
  ASSERT_EQ(gate["terminals"].size(), 4u);  // two inputs, two outputs
  EXPECT_EQ(gate["terminals"][1]["operand"], "E 33.1");
  EXPECT_EQ(gate["terminals"][2]["text"], "DO2");
  EXPECT_EQ(gate["terminals"][2]["operand"], "A 33.2");
  const Json fault = {
      {"rack", bus["rack"]}, {"slot", gate["slot"]}, {"fault", "removed"}, {"on", true}};
  bench.call("hardware.fault", fault);
  EXPECT_EQ(bench.call("hardware.read")["racks"].back()["slots"][0]["present"], false);
  Bench far(kProgram, fmt::format(kFormat, 256));
  const Json terminal = far.call("hardware.read")["racks"].back()["slots"][0]["terminals"][0];
  EXPECT_EQ(terminal["operand"], "PEB 257");
  EXPECT_EQ(terminal["text"], "DI0 = .0");
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

constexpr const char* kPlan = R"([project]
name = "Test"

# the panel
[[module]]
slot = 4  # beside the CPU
type = "SM 321 DI16xDC24V"
)";

Json change(const char* what, const char* place, Json more = Json::object()) {
  more.update({{"change", what}, {"rack", 0}, {"slot", place}});
  return {{"text", kPlan}, {"changes", {std::move(more)}}};
}

Json placed(const Json& plan, const std::string& place) {
  for (const Json& one : plan["racks"][0]["slots"])
    if (one["slot"] == place) return one;
  return nullptr;
}

// S7-HWCFG-01, S7-HWCFG-02, S7-HWCFG-03
TEST(HardwareEdit, AModuleIsPlacedAddressedAndMoved) {
  Bench bench;
  Json plan = bench.call("hardware.edit", change("place", "5", {{"type", "6ES7 322-1BH01-0AA0"}}));
  EXPECT_EQ(placed(plan, "5")["outputs"], (Json{{"first", 4}, {"bytes", 2}}));
  EXPECT_EQ(plan["problems"], Json::array());
  const Json to = {{"change", "set"}, {"rack", 0}, {"slot", "5"}, {"key", "output"}, {"value", 20}};
  plan = bench.call("hardware.edit", {{"text", plan["text"]}, {"changes", {to}}});
  EXPECT_EQ(placed(plan, "5")["outputs"]["first"], 20);
  const Json away = {
      {"change", "move"}, {"rack", 0}, {"slot", "4"}, {"toRack", 0}, {"toSlot", "6"}};
  plan = bench.call("hardware.edit", {{"text", plan["text"]}, {"changes", {away}}});
  EXPECT_EQ(placed(plan, "6")["inputs"]["first"], 8);  // the address of its new slot
  EXPECT_EQ(plan["problems"][0]["code"], "P0732");     // slot 4 is empty now
  EXPECT_NE(plan["text"].get<std::string>().find("slot = 6  # beside the CPU"), std::string::npos);
  EXPECT_EQ(bench.folder.read("merker.toml"),
            "[project]\nname = \"Test\"\n");  // nothing is written
}

TEST(HardwareEdit, APlantIsPutBesideTheCpu) {
  Bench bench;
  const auto plant = [](const char* name, const char* terminal, Json parameters = Json::array()) {
    const Json wire = {{"key", "ENABLE"}, {"value", terminal}};
    const Json one = {{"change", "plant"},
                      {"name", name},
                      {"kind", "axis"},
                      {"parameters", std::move(parameters)},
                      {"wires", {wire}}};
    return Json{{"text", "[project]\nname = \"Test\"\n"}, {"changes", {one}}};
  };
  const Json plan = bench.call("hardware.edit",
                               plant("Axis", "2.2.DO6", {{{"key", "increments"}, {"value", 4}}}));
  EXPECT_EQ(plan["text"],
            "[project]\nname = \"Test\"\n\n[[plant]]\nname = \"Axis\"\nkind = \"axis\"\n"
            "increments = 4\n\n[plant.wire]\nENABLE = \"2.2.DO6\"\n");
  EXPECT_EQ(plan["problems"], Json::array());
  EXPECT_EQ(bench.problem("hardware.edit", plant("Axis", "2.2.DO60")), "P0984");
  EXPECT_EQ(bench.problem("hardware.edit", plant("My axis", "2.2.DO6")), "P0704");
  EXPECT_EQ(bench.problem("hardware.edit", plant("A\"\n[x]", "2.2.DO6")), "P0704");
  const Json kinds = bench.call("process.kinds");
  ASSERT_EQ(kinds["kinds"].size(), plant::kinds().size());
  EXPECT_EQ(kinds["kinds"][0]["name"], plant::kinds()[0]->name);
}

// S7-HWCFG-07: slot and cause
TEST(HardwareEdit, WhatCannotStandThereIsRefused) {
  Bench bench;
  const auto refused = [&](const char* place, const char* type) {
    return bench.problem("hardware.edit", change("place", place, {{"type", type}}));
  };
  EXPECT_EQ(refused("4", "6ES7 322-1BH01-0AA0"), "P0725");
  EXPECT_EQ(refused("3", "6ES7 322-1BH01-0AA0"), "P0726");
  EXPECT_EQ(refused("12", "6ES7 322-1BH01-0AA0"), "P0723");
  EXPECT_EQ(refused("5", "6ES7 999"), "P0720");
  const auto set = [&](const char* key, Json value) {
    return bench.problem("hardware.edit", change("set", "4", {{"key", key}, {"value", value}}));
  };
  EXPECT_EQ(set("input", 124), "P0733");
  EXPECT_EQ(set("input", 5000), "P0734");
  EXPECT_EQ(set("output", 4), "P0735");
  EXPECT_EQ(set("x = 1\ny", 4), "P1305");
  EXPECT_EQ(set("name", Json::object()), "P1305");
  EXPECT_EQ(bench.problem("hardware.edit", {{"text", "a = = 1"}}), "P0702");
  const Json odd =
      bench.call("hardware.edit", change("place", "3", {{"type", "6ES7 360-3AA01-0AA0"}}));
  EXPECT_EQ(placed(odd, "3")["type"], "IM 360 sender");
}

// An error that stood there before is no reason against a change elsewhere.
TEST(HardwareEdit, OnlyItsOwnErrorsAreReasonsAgainstAChange) {
  Bench bench;
  const std::string text =
      "[[module]]\nslot = 4\ntype = \"SM 321 DI16xDC24V\"\n"
      "[[module]]\nslot = 5\ntype = \"SM 321 DI16xDC24V\"\ninput = 5000\n";
  Json named = change("set", "4", {{"key", "name"}, {"value", "Panel"}});
  named["text"] = text;
  const Json plan = bench.call("hardware.edit", named);
  EXPECT_EQ(plan["problems"][0]["code"], "P0734");
  EXPECT_NE(plan["text"].get<std::string>().find("name = \"Panel\""), std::string::npos);
  Json moved = change("set", "4", {{"key", "input"}, {"value", 124}});
  moved["text"] = text;
  EXPECT_EQ(bench.problem("hardware.edit", moved), "P0733");
}

// S7-HWCFG-08, S7-HWCFG-09
TEST(HardwareEdit, ParametersAreRowsAndKeys) {
  Bench bench;
  const Json plan = bench.call("hardware.edit", {{"text", kPlan}});
  EXPECT_EQ(placed(plan, "4")["parameters"][1],
            (Json{{"key", "input"}, {"kind", "address"}, {"value", 0}, {"given", false}}));
  EXPECT_EQ(placed(plan, "2.3")["channels"].size(), 7U);
  const Json set = {
      {"change", "set"}, {"table", "cpu.OB35"}, {"key", "interval"}, {"value", "50ms"}};
  const Json after = bench.call("hardware.edit", {{"text", kPlan}, {"changes", {set}}});
  EXPECT_EQ(after["cpu"][1]["parameters"][0]["value"], "50ms");
  const Json channel = {{"change", "set"}, {"rack", 0},      {"slot", "2.3"},    {"side", "input"},
                        {"number", 1},     {"key", "range"}, {"value", "0..10V"}};
  const Json ranged = bench.call("hardware.edit", {{"text", kPlan}, {"changes", {channel}}});
  EXPECT_EQ(placed(ranged, "2.3")["channels"][1]["parameters"][0]["value"], "0..10V");
}

Json ofAxis(const char* key, Json value) {
  return {{"change", "set"}, {"rack", 0}, {"slot", "2.5"}, {"key", key}, {"value", value}};
}

std::string pagesOf(const Json& plan) {
  std::string pages;
  const Json slot = placed(plan, "2.5");
  for (const Json& row : slot["parameters"]) {
    const std::string page = row.value("page", "-");
    if (pages.find(page) == std::string::npos) pages += (pages.empty() ? "" : " ") + page;
  }
  return pages;
}

bool hasRow(const Json& plan, const char* key) {
  const Json slot = placed(plan, "2.5");
  for (const Json& row : slot["parameters"])
    if (row["key"] == key) return true;
  return false;
}

// POS-OVW-17, POS-OVW-18, POS-OPEN-03, POS-PARAM-22, POS-PARAM-31: AO 0 off, then the drive, then
// the pages with what this drive and this axis have.
TEST(HardwareEdit, PagesOfAnAxis) {
  Bench bench;
  const Json drive = ofAxis("drive", "analog");
  EXPECT_EQ(bench.problem("hardware.edit", {{"text", kPlan}, {"changes", {drive}}}), "P0744");
  const Json off = {{"change", "set"}, {"rack", 0},      {"slot", "2.3"}, {"side", "output"},
                    {"number", 0},     {"key", "range"}, {"value", "off"}};
  Json plan = bench.call("hardware.edit",
                         {{"text", kPlan}, {"changes", {off, drive, ofAxis("max_speed", 10'000)}}});
  EXPECT_EQ(plan["problems"], Json::array());
  EXPECT_EQ(pagesOf(plan), "general addresses basic drive axis encoder diagnosis");
  EXPECT_TRUE(hasRow(plan, "creep_speed") && hasRow(plan, "low_limit"));
  EXPECT_FALSE(hasRow(plan, "control_type") || hasRow(plan, "rotary_end"));
  EXPECT_EQ(
      bench.problem("hardware.edit", {{"text", plan["text"]},
                                      {"changes", {ofAxis("monitor_traversing_range", false)}}}),
      "P0704");
  plan = bench.call(
      "hardware.edit",
      {{"text", plan["text"]},
       {"changes",
        {ofAxis("max_speed", nullptr), ofAxis("drive", "digital"), ofAxis("axis", "rotary")}}});
  EXPECT_EQ(plan["problems"], Json::array());
  EXPECT_TRUE(hasRow(plan, "control_type") && hasRow(plan, "rotary_end"));
  EXPECT_FALSE(hasRow(plan, "creep_speed") || hasRow(plan, "monitor_working_range"));
}

TEST(HardwareEdit, TheCatalogueSaysWhereModulesStand) {
  Bench bench;
  const Json types = bench.call("hardware.catalogue")["types"];
  EXPECT_EQ(types[0]["slots"], (Json{1, 1}));
  EXPECT_GT(types.size(), 30U);
}

// The text is read once for each change, not once for each of its problems.
TEST(HardwareEdit, ProblemsOfManyModulesKnowTheirPlaces) {
  Bench bench;
  std::string text = "[project]\nname = \"Test\"\n";
  for (int i = 0; i < 400; ++i) text += "[[module]]\nslot = 4\n";
  const Json plan = bench.call("hardware.edit", {{"text", text}});
  ASSERT_GT(plan["problems"].size(), 390u);
  for (const Json& problem : plan["problems"]) EXPECT_EQ(problem["slot"], "4") << problem;
  text += std::string(kLongestSettings, '#');
  EXPECT_EQ(bench.problem("hardware.edit", {{"text", text}}), "P1305");
}

}  // namespace
}  // namespace merker::workbench::test
