// The pages of the sub-module PtP in the hardware view.
#include "bench.h"

namespace merker::workbench::test {
namespace {

constexpr const char* kPlain = "[cpu]\nmodel = \"314C-2 PtP\"\n\n[[module]]\nslot = \"2.1\"\n";

std::string withSerial(const std::string& lines) {
  return std::string(kPlain) + "[module.serial]\n" + lines;
}

Json serialChange(const char* key, Json value) {
  return {{"change", "set"}, {"rack", 0}, {"slot", "2.1"}, {"key", key}, {"value", value}};
}

std::map<std::string, Json> rowsOf(const Json& plan) {
  std::map<std::string, Json> rows;
  for (const Json& slot : plan["racks"][0]["slots"])
    if (slot["slot"] == "2.1")
      for (const Json& row : slot["parameters"]) rows[row["key"]] = row;
  return rows;
}

std::map<std::string, Json> rowsOf(Bench& bench, const std::string& text) {
  return rowsOf(bench.call("hardware.edit", {{"text", text}}));
}

std::string serialPagesOf(Bench& bench, const std::string& text) {
  std::string pages;
  const Json plan = bench.call("hardware.edit", {{"text", text}});
  for (const Json& slot : plan["racks"][0]["slots"])
    if (slot["slot"] == "2.1")
      for (const Json& row : slot["parameters"]) {
        const std::string page = row["page"];
        if (pages.find(page) == std::string::npos) pages += (pages.empty() ? "" : " ") + page;
      }
  return pages;
}

// PTP-PARAM-01, PTP-PARAM-02, PTP-PARAM-34, PTP-PARAM-35, PTP-OVW-02: RK 512 buffers nothing.
TEST(SerialRows, EachProtocolHasThePagesOfTheManual) {
  Bench bench;
  EXPECT_EQ(serialPagesOf(bench, kPlain),
            "general addresses basic transmission end reception interface");
  EXPECT_EQ(serialPagesOf(bench, withSerial("protocol = \"3964R\"\n")),
            "general addresses basic transmission telegram reception interface");
  EXPECT_EQ(serialPagesOf(bench, withSerial("protocol = \"RK512\"\n")),
            "general addresses basic transmission telegram interface");
  auto rows = rowsOf(bench, kPlain);
  EXPECT_EQ(rows["diagnostics"]["page"], "basic");
  EXPECT_EQ(rows["serial.protocol"]["value"], "ASCII");
  EXPECT_EQ(rows["serial.baud"]["value"], 9600);
  EXPECT_EQ(rows["serial.character_delay"]["value"], "4ms");
}

// PTP-PARAM-15 to -18, PTP-PARAM-23, PTP-PHY-08, PTP-PHY-09
TEST(SerialRows, WhatAChoiceMakesMeaninglessIsFixed) {
  Bench bench;
  const auto isFixed = [&](const std::string& text, const char* key) {
    auto rows = rowsOf(bench, text);
    EXPECT_TRUE(rows.contains(key)) << key;
    return rows[key].contains("fixed");
  };
  for (const char* key : {"serial.xon", "serial.length", "serial.end_characters",
                          "serial.check_characters", "serial.sending", "serial.telegrams"})
    EXPECT_TRUE(isFixed(kPlain, key)) << key;
  EXPECT_FALSE(isFixed(kPlain, "serial.flow_control"));
  EXPECT_TRUE(isFixed(withSerial("mode = \"RS485\"\n"), "serial.flow_control"));
  EXPECT_FALSE(isFixed(withSerial("flow_control = \"XON/XOFF\"\n"), "serial.xon"));
  EXPECT_FALSE(isFixed(withSerial("end = \"count\"\n"), "serial.length"));
  EXPECT_FALSE(isFixed(withSerial("end = \"characters\"\n"), "serial.sending"));
  EXPECT_FALSE(isFixed(withSerial("whole_buffer = false\n"), "serial.telegrams"));
  EXPECT_TRUE(isFixed(withSerial("protocol = \"3964\"\n"), "serial.mode"));
  EXPECT_FALSE(isFixed(withSerial("protocol = \"3964\"\n"), "serial.data_bits"));
  EXPECT_TRUE(isFixed(withSerial("protocol = \"RK512\"\n"), "serial.data_bits"));
}

// PTP-PARAM-08, PTP-PARAM-25: what cannot be selected is not offered.
TEST(SerialRows, OnlyWhatCanBeSelectedIsOffered) {
  Bench bench;
  auto seven = rowsOf(bench, withSerial("data_bits = 7\n"));
  EXPECT_EQ(seven["serial.parity"]["choices"], (Json{"odd", "even"}));
  auto wires = rowsOf(bench, withSerial("mode = \"RS485\"\n"));
  EXPECT_EQ(wires["serial.preset"]["choices"], (Json{"none", "idle"}));
  EXPECT_EQ(wires["serial.preset"]["value"], "idle");
}

TEST(SerialRows, AChangeIsALineOfTheTable) {
  Bench bench;
  const Json plan = bench.call(
      "hardware.edit",
      {{"text", kPlain},
       {"changes",
        {serialChange("serial.end", "characters"), serialChange("serial.end_characters", {13, 10}),
         serialChange("serial.flow_control", "XON/XOFF"), serialChange("serial.xon", 2)}}});
  EXPECT_EQ(plan["text"], std::string(kPlain) +
                              "\n[module.serial]\nend = \"characters\"\nend_characters = [13,10]\n"
                              "flow_control = \"XON/XOFF\"\nxon = 2\n");
  EXPECT_EQ(rowsOf(plan)["serial.end_characters"]["value"], (Json{13, 10}));
  EXPECT_EQ(rowsOf(plan)["serial.end_characters"]["kind"], "characters");
}

// PTP-PARAM-13, PTP-PARAM-37
TEST(SerialRows, ALowerRateRaisesTimes) {
  Bench bench;
  const auto slower = [&](const char* lines) {
    return rowsOf(bench.call("hardware.edit", {{"text", withSerial(lines)},
                                               {"changes", {serialChange("serial.baud", 300)}}}));
  };
  EXPECT_EQ(slower("character_delay = \"5ms\"\n")["serial.character_delay"]["value"], "130ms");
  auto link =
      slower("protocol = \"RK512\"\nacknowledge_delay = \"20ms\"\ncharacter_delay = \"1s\"\n");
  EXPECT_EQ(link["serial.acknowledge_delay"]["value"], "60ms");
  EXPECT_EQ(link["serial.character_delay"]["value"], "1s");
}

// PTP-PARAM-13, PTP-PHY-12, PTP-PARAM-36
TEST(SerialRows, WhatTheManualRefusesIsRefused) {
  Bench bench;
  const auto reason = [&](const char* lines, const char* key, Json value) {
    const Json answer = bench.ask(
        "hardware.edit",
        {{"text", withSerial(lines)}, {"changes", {serialChange(key, std::move(value))}}});
    return answer.contains("problems") ? answer["problems"][0]["text"].get<std::string>()
                                       : answer.dump();
  };
  const std::string all = "the serial interface cannot be set so: ";
  EXPECT_EQ(reason("baud = 9600\n", "serial.character_delay", "3ms"),
            all +
                "character delay time must be 4 to 65535 ms in steps of 1 ms at 9600 baud; 4ms "
                "is possible");
  EXPECT_EQ(reason("parity = \"none\"\n", "serial.data_bits", 7),
            all + "7 data bits need a parity");
}

}  // namespace
}  // namespace merker::workbench::test
