// The masks of the counting channels in the hardware view.
#include "bench.h"

namespace merker::workbench::test {
namespace {

const std::string kPlainCpu = "[cpu]\nmodel = \"314C-2 PtP\"\n";
const std::string kCountingModule = kPlainCpu + "\n[[module]]\nslot = \"2.4\"\n";

std::string withChannel(const std::string& lines) {
  return kCountingModule + "\n[[module.channel]]\nnumber = 1\n" + lines;
}

Json channelChange(const char* key, Json value) {
  return {{"change", "set"},          {"rack", 0},   {"slot", "2.4"},
          {"side", "number"},         {"number", 1}, {"key", key},
          {"value", std::move(value)}};
}

Json countingChannelsOf(const Json& plan) {
  for (const Json& slot : plan["racks"][0]["slots"])
    if (slot["slot"] == "2.4") return slot["channels"];
  return {};
}

std::map<std::string, Json> countingRowsOf(Bench& bench, const std::string& text) {
  std::map<std::string, Json> rows;
  const Json channels = countingChannelsOf(bench.call("hardware.edit", {{"text", text}}));
  for (const Json& row : channels[1]["parameters"]) rows[row["key"]] = row;
  return rows;
}

std::string changed(Bench& bench, const std::string& text, const char* key, Json value) {
  return bench.call(
      "hardware.edit",
      {{"text", text}, {"changes", Json::array({channelChange(key, std::move(value))})}})["text"];
}

// CNT-PARAM-01, CNT-OVW-03: as many channels as the CPU has; without a mode nothing else is set.
TEST(CountingRows, EachCpuHasItsChannels) {
  Bench bench;
  const auto channels = [&](const std::string& model) {
    return countingChannelsOf(
        bench.call("hardware.edit", {{"text", "[cpu]\nmodel = \"" + model + "\"\n"}}));
  };
  EXPECT_EQ(channels("312C").size(), 2u);
  EXPECT_EQ(channels("313C").size(), 3u);
  const Json four = channels("314C-2 PtP");
  ASSERT_EQ(four.size(), 4u);
  EXPECT_EQ(four[3]["side"], "number");
  EXPECT_EQ(four[3]["number"], 3);
  ASSERT_EQ(four[3]["parameters"].size(), 1u);
  EXPECT_EQ(four[3]["parameters"][0]["key"], "mode");
  EXPECT_EQ(four[3]["parameters"][0]["value"], "none");
}

// CNT-PARAM-03 to -19
TEST(CountingRows, CountingHasTheMaskOfItsMode) {
  Bench bench;
  auto rows = countingRowsOf(bench, withChannel("mode = \"periodic\"\n"
                                                "main_direction = \"forward\"\nend_value = 100\n"
                                                "comparison_value = 90\noutput = \">=\"\n"
                                                "interrupts = [\"overflow\"]\n"));
  EXPECT_EQ(rows["end_value"]["value"], 100);
  EXPECT_EQ(rows["comparison_value"]["max"], 99);
  EXPECT_EQ(rows["output"]["value"], ">=");
  EXPECT_EQ(rows["max_frequency"]["value"], "60kHz");
  EXPECT_EQ(rows["latch_frequency"]["value"], "10kHz");
  EXPECT_EQ(rows["interrupts"]["value"], Json({"overflow"}));
  EXPECT_EQ(rows["interrupts"]["choices"].size(), 6u);
  EXPECT_FALSE(rows.contains("start_value"));
  EXPECT_FALSE(rows.contains("input_data"));  // at 1 kHz only
  EXPECT_FALSE(
      countingRowsOf(bench, withChannel("mode = \"endless\"\n")).contains("main_direction"));
  EXPECT_TRUE(countingRowsOf(bench, withChannel("mode = \"once\"\nmax_frequency = \"1kHz\"\n"))
                  .contains("input_data"));
}

// CNT-PARAM-20 to -36
TEST(CountingRows, MeasuringAndPulsesHaveMasksOfTheirOwn) {
  Bench bench;
  auto frequency = countingRowsOf(bench, withChannel("mode = \"frequency\"\n"));
  EXPECT_EQ(frequency["integration_time"]["value"], "100ms");
  EXPECT_EQ(frequency["high_limit"]["value"], 60'000'000);
  EXPECT_EQ(frequency["evaluation"]["choices"], Json({"pulse", "single"}));
  auto pulses = countingRowsOf(bench, withChannel("mode = \"pwm\"\ntime_base = \"1ms\"\n"));
  EXPECT_EQ(pulses["period"]["min"], 1);
  EXPECT_EQ(pulses["format"]["value"], "per mille");
  EXPECT_EQ(pulses["interrupts"]["choices"], Json({"gate opened"}));
}

TEST(CountingRows, AChangeIsALineOfItsChannel) {
  Bench bench;
  const std::string once = changed(bench, kPlainCpu, "mode", "once");
  EXPECT_NE(once.find("[[module.channel]]\nnumber = 1\nmode = \"once\"\n"), std::string::npos)
      << once;
  const std::string caused = changed(bench, once, "interrupts", Json({"overflow", "comparator"}));
  EXPECT_NE(caused.find("interrupts = [\"overflow\",\"comparator\"]"), std::string::npos) << caused;
}

// As in the dialog of STEP 7: another mode begins with its defaults.
TEST(CountingRows, WhatHasNoMeaningAnyMoreLeavesTheFile) {
  Bench bench;
  const std::string counting = withChannel(
      "mode = \"periodic\"\nmain_direction = \"forward\"\nend_value = 100\nhysteresis = 3\n"
      "hardware_gate = true\ninterrupts = [\"gate opened\"]\n");
  EXPECT_EQ(changed(bench, counting, "mode", "pwm"), withChannel("mode = \"pwm\"\n"));
  EXPECT_EQ(changed(bench, counting, "main_direction", "backward").find("end_value"),
            std::string::npos);
  const std::string slow =
      withChannel("mode = \"once\"\nmax_frequency = \"1kHz\"\ninput_data = \"period\"\n");
  EXPECT_EQ(changed(bench, slow, "max_frequency", "5kHz"),
            withChannel("mode = \"once\"\nmax_frequency = \"5kHz\"\n"));
}

// What a mask offers can be set, beside the defaults of its mode; an interrupt has a need that is
// told.
TEST(CountingRows, EachChoiceOfEachMaskIsAccepted) {
  Bench bench;
  std::size_t set = 0;
  for (const char* mode : {"none", "endless", "once", "periodic", "frequency", "pwm"}) {
    const std::string begun = changed(bench, kPlainCpu, "mode", mode);
    for (const auto& [key, row] : countingRowsOf(bench, begun)) {
      if (row["kind"] != "choice") continue;
      for (const Json& choice : row["choices"]) {
        const std::string text = changed(bench, begun, key.c_str(), choice);
        EXPECT_EQ(countingRowsOf(bench, text)[key]["value"], choice) << mode << " " << key;
        ++set;
      }
    }
  }
  EXPECT_GT(set, 100u);
}

// S7-MGR-15
TEST(CountingRows, AreComparedWithTheModule) {
  Bench bench(kProgram, withChannel("mode = \"periodic\"\noutput = \"pulse\"\n"));
  std::map<std::string, std::string> found;
  const Json looked = bench.call("projects.look");
  for (const Json& slot : looked["racks"][0]["slots"])
    if (slot["slot"] == "2.4")
      for (const Json& one : slot["properties"]) found[one[0]] = one[1];
  EXPECT_EQ(found["channel 1 mode"], "periodic");
  EXPECT_EQ(found["channel 1 output"], "pulse");
  EXPECT_EQ(found["channel 0 mode"], "none");
}

}  // namespace
}  // namespace merker::workbench::test
