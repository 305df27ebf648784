// The sub-module 2.5 in merker.toml (technology manual 3.2.3 to 3.2.7, 4.2.3 to 4.2.7).
#include <gtest/gtest.h>

#include <string>

#include "positioning/soundness.h"
#include "project/settings.h"

namespace merker::project {
namespace {

struct AxisRead {
  Settings settings;
  Problems problems;
  const io::AxisChannel* axis() const {
    return settings.hardware ? settings.hardware->axis() : nullptr;
  }
  std::string first() const {
    return problems.list().empty() ? "" : problems.list().front().message;
  }
};

AxisRead readFile(const std::string& text, std::string_view cpu = "314C-2 PtP") {
  AxisRead read;
  const source::SourceFile file("merker.toml",
                                "[cpu]\nmodel = \"" + std::string(cpu) + "\"\n" + text);
  read.settings = readSettings(file, read.problems, std::nullopt);
  return read;
}

const std::string kOff =
    "[[module]]\nslot = \"2.3\"\n[[module.channel]]\noutput = 0\nrange = \"off\"\n";

AxisRead analog(const std::string& keys) {
  return readFile(kOff + "[[module]]\nslot = \"2.5\"\ndrive = \"analog\"\n" + keys);
}
AxisRead digital(const std::string& keys) {
  return readFile("[[module]]\nslot = \"2.5\"\ndrive = \"digital\"\n" + keys);
}

// POS-OVW-13, POS-PARAM-01, POS-PARAM-02, POS-PARAM-03, POS-PARAM-04, POS-PARAM-05, POS-PARAM-06,
// POS-PARAM-07, POS-PARAM-08, POS-PARAM-09, POS-PARAM-10, POS-PARAM-11, POS-PARAM-12, POS-PARAM-13,
// POS-PARAM-14, POS-PARAM-15, POS-PARAM-16, POS-PARAM-17, POS-PARAM-18, POS-PARAM-19, POS-PARAM-20,
// POS-PARAM-21, POS-PARAM-22, POS-PARAM-23, POS-PARAM-24, POS-PARAM-25, POS-PARAM-26, POS-PARAM-27:
// the defaults of each page; nothing else is a parameter.
TEST(AxisSettings, Defaults) {
  const AxisRead read = analog("");
  ASSERT_FALSE(read.problems.hasErrors()) << read.first();
  ASSERT_NE(read.axis(), nullptr);
  const io::AxisChannel& a = *read.axis();
  EXPECT_EQ(a.output, io::AxisOutput::Analog);
  EXPECT_EQ(a.targetRange, 50);
  EXPECT_EQ(a.monitoringTime, 2000);
  EXPECT_EQ(a.highestSpeed, 1000);
  EXPECT_EQ(a.creepSpeed, 100);
  EXPECT_EQ(a.cutOffDelay, 1000);
  EXPECT_EQ(a.maxFrequency, 60u);
  EXPECT_EQ(a.accompanyingFrequency, 10u);
  EXPECT_EQ(a.analogControl, io::AnalogControl::Bipolar);
  EXPECT_FALSE(a.rotary);
  EXPECT_EQ(a.lowLimit, -100'000'000);
  EXPECT_EQ(a.highLimit, 100'000'000);
  EXPECT_EQ(a.lengthEdges, io::LengthEdges::Off);
  EXPECT_EQ(a.reference, 0);
  EXPECT_FALSE(a.referenceBelowSwitch);
  EXPECT_EQ(a.increments, 1000);
  EXPECT_FALSE(a.inverted);
  const io::AxisMonitors& m = a.monitors;
  EXPECT_TRUE(m.travel && m.workingRange && m.movement);
  EXPECT_FALSE(m.missingPulse || m.approach || m.targetRange);
  const io::AxisMonitors& i = a.interrupts;
  EXPECT_FALSE(i.travel || i.workingRange || i.movement || i.missingPulse || i.approach ||
               i.targetRange);
}

// POS-PARAM-05, POS-PARAM-06, POS-PARAM-07, POS-PARAM-08, POS-PARAM-09, POS-PARAM-10, POS-PARAM-16,
// POS-PARAM-18, POS-PARAM-19, POS-PARAM-21, POS-PARAM-24, POS-PARAM-25: each key reaches its
// parameter.
TEST(AxisSettings, EveryKeyOfAnAnalogAxis) {
  const AxisRead read = analog(
      "target_range = 51\nmonitoring_time = \"2001ms\"\nmax_speed = 10000\ncreep_speed = 500\n"
      "cut_off_delay = \"20ms\"\nmax_frequency = \"30kHz\"\nswitch_frequency = \"1kHz\"\n"
      "voltage = \"0..10V\"\nlow_limit = -500\nhigh_limit = 700\n"
      "length_measurement = \"falling to rising\"\nreference_point = -7\n"
      "reference_location = \"minus\"\nincrements = 512\ncount_direction = \"inverted\"\n"
      "monitor_missing_pulse = true\nmonitor_working_range = false\n"
      "monitor_actual_value = false\nmonitor_target_approach = true\n"
      "monitor_target_range = true\nmonitor_traversing_range = true\n");
  ASSERT_FALSE(read.problems.hasErrors()) << read.first();
  const io::AxisChannel& a = *read.axis();
  EXPECT_EQ(a.targetRange, 51);
  EXPECT_EQ(a.monitoringTime, 2001);
  EXPECT_EQ(a.highestSpeed, 10'000);
  EXPECT_EQ(a.creepSpeed, 500);
  EXPECT_EQ(a.cutOffDelay, 20);
  EXPECT_EQ(a.maxFrequency, 30u);
  EXPECT_EQ(a.accompanyingFrequency, 1u);
  EXPECT_EQ(a.analogControl, io::AnalogControl::WithDirection);
  EXPECT_EQ(a.lowLimit, -500);
  EXPECT_EQ(a.highLimit, 700);
  EXPECT_EQ(a.lengthEdges, io::LengthEdges::FallingRising);
  EXPECT_EQ(a.reference, -7);
  EXPECT_TRUE(a.referenceBelowSwitch);
  EXPECT_EQ(a.increments, 512);
  EXPECT_TRUE(a.inverted);
  EXPECT_TRUE(a.monitors.missingPulse && a.monitors.approach && a.monitors.targetRange);
  EXPECT_FALSE(a.monitors.workingRange || a.monitors.movement);
  EXPECT_TRUE(a.monitors.travel);
}

// POS-PARAM-11, POS-PARAM-17, POS-PARAM-31, POS-OPEN-09
TEST(AxisSettings, DigitalRotaryAxis) {
  const AxisRead read = digital("control_type = 3\naxis = \"rotary\"\nrotary_end = 3600\n");
  ASSERT_FALSE(read.problems.hasErrors()) << read.first();
  EXPECT_EQ(read.axis()->output, io::AxisOutput::Digital);
  EXPECT_EQ(read.axis()->digitalControl, 3);
  EXPECT_TRUE(read.axis()->rotary);
  EXPECT_EQ(read.axis()->rotaryEnd, 3600);
  EXPECT_FALSE(read.axis()->monitors.workingRange);
  EXPECT_FALSE(digital("axis = \"rotary\"\nrotary_end = 1000000000\n").problems.hasErrors());
}

struct WrongAxis {
  const char *keys, *message;
  bool digital = false;
};

// POS-PARAM-02, POS-PARAM-03, POS-PARAM-04, POS-PARAM-05, POS-PARAM-06, POS-PARAM-07, POS-PARAM-08,
// POS-PARAM-09, POS-PARAM-10, POS-PARAM-11, POS-PARAM-15, POS-PARAM-16, POS-PARAM-17, POS-PARAM-18,
// POS-PARAM-19, POS-PARAM-22, POS-PARAM-23, POS-PARAM-24, POS-PARAM-31: each refusal has its
// reason.
TEST(AxisSettings, Refusals) {
  const WrongAxis kWrong[] = {
      {"target_range = 200000001\n", "'target_range' must be a whole number from 0 to 200000000"},
      {"monitoring_time = \"101s\"\n", "'monitoring_time' must be"},
      {"max_speed = 9\n", "'max_speed' must be a whole number from 10 to 1000000"},
      {"creep_speed = 1001\n", "'creep_speed' must be at most max_speed, 1000"},
      {"max_speed = 50\n", "'max_speed' must be at least creep_speed, 100"},
      {"cut_off_delay = \"101s\"\n", "'cut_off_delay' must be"},
      {"max_frequency = \"20kHz\"\n", "valid: 60kHz, 30kHz, 10kHz, 5kHz, 2kHz, 1kHz"},
      {"switch_frequency = \"100kHz\"\n", "switch_frequency \"100kHz\" is not possible"},
      {"voltage = \"5V\"\n", "'voltage' must be one of"},
      {"control_type = 1\n", "'control_type' needs drive = \"digital\""},
      {"control_type = 5\n", "'control_type' must be a whole number from 1 to 4", true},
      {"max_speed = 1000\n", "'max_speed' needs drive = \"analog\"", true},
      {"creep_speed = 100\n", "'creep_speed' needs drive = \"analog\"", true},
      {"cut_off_delay = \"1s\"\n", "'cut_off_delay' needs drive = \"analog\"", true},
      {"voltage = \"0..10V\"\n", "'voltage' needs drive = \"analog\"", true},
      {"axis = \"round\"\n", "'axis' must be one of"},
      {"low_limit = 5\nhigh_limit = 5\n", "'high_limit' must be above low_limit"},
      {"high_limit = 500000001\n",
       "'high_limit' must be a whole number from -500000000 to 500000000"},
      {"rotary_end = 1000\n", "'rotary_end' needs axis = \"rotary\""},
      {"axis = \"rotary\"\nlow_limit = 0\n", "'low_limit' needs axis = \"linear\""},
      {"axis = \"rotary\"\nmonitor_working_range = true\n",
       "'monitor_working_range' needs axis = \"linear\""},
      {"axis = \"rotary\"\nrotary_end = 0\n",
       "'rotary_end' must be a whole number from 1 to 1000000000"},
      {"axis = \"rotary\"\nrotary_end = 100\ntarget_range = 101\n",
       "'target_range' must be at most rotary_end, 100"},
      {"axis = \"rotary\"\nrotary_end = 100\nreference_point = 100\n",
       "'reference_point' must be 0 to 99, below rotary_end"},
      {"low_limit = 0\nhigh_limit = 10\ntarget_range = 12\n",
       "'target_range' must be at most the range of the axis, 10"},
      {"high_limit = 10\nreference_point = 11\n",
       "'reference_point' must be -100000000 to 10, from low_limit to high_limit"},
      {"reference_location = \"left\"\n", "'reference_location' must be one of"},
      {"length_measurement = \"both\"\n", "'length_measurement' must be one of"},
      {"increments = 8388609\n", "'increments' must be a whole number from 1 to 8388608"},
      {"count_direction = \"left\"\n", "'count_direction' must be one of"},
      {"monitor_traversing_range = false\n", "it cannot be switched off"},
      {"monitor_actual_value = 1\n", "'monitor_actual_value' must be"},
      {"interrupts = \"process\"\n", "'interrupts' must be one of"},
      {"diagnostics = true\n", "interrupts = \"diagnostics\""},
      {"range = \"±10V\"\n", "has no"},
      {"speed = 7\n", "unknown key 'speed'"}};
  for (const WrongAxis& wrong : kWrong) {
    const AxisRead read = wrong.digital ? digital(wrong.keys) : analog(wrong.keys);
    EXPECT_TRUE(read.problems.hasErrors()) << wrong.keys;
    EXPECT_NE(read.first().find(wrong.message), std::string::npos) << wrong.keys << read.first();
  }
}

// What the reader accepts fits together for the CPU, too (POS-PARAM-29).
TEST(AxisSettings, WhatIsAcceptedIsSound) {
  for (const char* keys :
       {"", "target_range = 0\n", "low_limit = -1\nhigh_limit = 0\ntarget_range = 1\n",
        "axis = \"rotary\"\nrotary_end = 50\n", "creep_speed = 1000\n"}) {
    const AxisRead read = analog(keys);
    if (read.problems.hasErrors()) continue;
    EXPECT_EQ(positioning::flaw(*read.axis()), std::nullopt) << keys;
  }
}

// POS-OVW-07
TEST(AxisSettings, TheAnalogOutputMustBeOff) {
  const AxisRead on = readFile("[[module]]\nslot = \"2.5\"\ndrive = \"analog\"\n");
  EXPECT_NE(on.first().find("range = \"off\" of output 0 in slot 2.3"), std::string::npos)
      << on.first();
  EXPECT_FALSE(analog("").problems.hasErrors());
  EXPECT_FALSE(digital("").problems.hasErrors());
}

std::string counter(int number, const char* mode) {
  return "[[module]]\nslot = \"2.4\"\n[[module.channel]]\nnumber = " + std::to_string(number) +
         "\nmode = \"" + mode + "\"\n";
}
const std::string kDigital = "[[module]]\nslot = \"2.5\"\ndrive = \"digital\"\n";

// POS-OVW-05, POS-OVW-06, CNT-OVW-07
TEST(AxisSettings, CountersZeroAndOneAreTaken) {
  for (const int number : {0, 1}) {
    EXPECT_NE(readFile(counter(number, "endless") + kDigital).first().find("'drive' needs"),
              std::string::npos);
    EXPECT_NE(readFile(kDigital + counter(number, "endless")).first().find("'mode' needs"),
              std::string::npos);
    EXPECT_FALSE(readFile(kDigital + counter(number, "none")).problems.hasErrors());
  }
  for (const int number : {2, 3})
    EXPECT_FALSE(readFile(counter(number, "endless") + kDigital).problems.hasErrors());
  EXPECT_FALSE(
      readFile(counter(0, "endless") + "[[module]]\nslot = \"2.5\"\n").problems.hasErrors());
}

// POS-OVW-01: one axis, on the 314C-2 only.
TEST(AxisSettings, WhichCpuHasAnAxis) {
  for (const char* cpu : {"314C-2 PtP", "314C-2 DP", "314C-2 PN/DP"})
    EXPECT_FALSE(readFile(kDigital, cpu).problems.hasErrors()) << cpu;
  for (const char* cpu : {"312C", "313C", "313C-2 PtP", "313C-2 DP", "318-2"})
    EXPECT_NE(readFile(kDigital, cpu).first().find("has no sub-module 2.5"), std::string::npos)
        << cpu;
  EXPECT_NE(readFile(kDigital + kDigital).first().find("already occupied"), std::string::npos);
}

// POS-PARAM-27: the monitor, its switch and the interrupt selection; one alone is no interrupt.
TEST(AxisSettings, ReportsThatNeverCome) {
  const auto warned = [](const std::string& keys) {
    const AxisRead read = analog(keys);
    EXPECT_FALSE(read.problems.hasErrors()) << read.first();
    return read.first();
  };
  EXPECT_NE(warned("report_actual_value = true\n").find("interrupts is not \"diagnostics\""),
            std::string::npos);
  EXPECT_NE(warned("interrupts = \"diagnostics\"\nreport_target_range = true\n")
                .find("monitor_target_range is not true"),
            std::string::npos);
  EXPECT_EQ(warned("interrupts = \"diagnostics\"\nreport_actual_value = true\n"), "");
}

// POS-PARAM-28: one turn of the encoder and one of the axis are in an integer ratio.
TEST(AxisSettings, ZeroMarksThatWander) {
  const auto rotary = [](int end, int increments) {
    const AxisRead read = digital(
        fmt::format("axis = \"rotary\"\nrotary_end = {}\nincrements = {}\n", end, increments));
    EXPECT_FALSE(read.problems.hasErrors()) << read.first();
    return read.first();
  };
  EXPECT_EQ(rotary(4000, 1000), "");
  EXPECT_EQ(rotary(16'000, 1000), "");
  EXPECT_EQ(rotary(1000, 1000), "");
  EXPECT_NE(rotary(1001, 1000).find("rotary_end should be a multiple of 4000 pulses"),
            std::string::npos);
}

// POS-ENC-10: four counts each period of the encoder.
TEST(AxisSettings, SpeedsThatTheInputsCannotFollow) {
  const auto warned = [](const std::string& keys) {
    const AxisRead read = analog(keys);
    EXPECT_FALSE(read.problems.hasErrors()) << read.first();
    return read.first();
  };
  EXPECT_EQ(warned("max_speed = 240000\n"), "");
  EXPECT_NE(
      warned("max_speed = 240001\n").find("at 60 kHz the encoder inputs count at most 240000"),
      std::string::npos);
  EXPECT_EQ(warned("max_speed = 40000\nmax_frequency = \"10kHz\"\n"), "");
  EXPECT_NE(warned("max_speed = 40001\nmax_frequency = \"10kHz\"\n").find("10 kHz"),
            std::string::npos);
}

// Keys of an axis without one, and in another slot.
TEST(AxisSettings, KeysWithoutAnAxis) {
  const AxisRead none = readFile("[[module]]\nslot = \"2.5\"\nincrements = 500\n");
  EXPECT_NE(none.first().find("'increments' needs drive"), std::string::npos) << none.first();
  const AxisRead other = readFile("[[module]]\nslot = \"2.4\"\nincrements = 500\n");
  EXPECT_NE(other.first().find("unknown key 'increments'"), std::string::npos) << other.first();
  EXPECT_EQ(readFile("[[module]]\nslot = \"2.5\"\ndrive = \"none\"\n").axis(), nullptr);
}

// POS-PARAM-30, POS-OPEN-02: LADDR is the smaller address.
TEST(AxisSettings, AddressesCanBeSet) {
  const AxisRead read =
      readFile("[[module]]\nslot = \"2.5\"\ndrive = \"digital\"\ninput = 800\noutput = 816\n");
  ASSERT_FALSE(read.problems.hasErrors()) << read.first();
  const io::Module* module = read.settings.hardware->find("2.5");
  EXPECT_EQ(module->inputStart, 800u);
  EXPECT_EQ(module->outputStart, 816u);
  EXPECT_EQ(digital("").settings.hardware->find("2.5")->inputStart, 784u);
  EXPECT_EQ(readFile(kDigital, "314C-2 PN/DP").settings.hardware->find("2.5")->inputStart, 832u);
}

}  // namespace
}  // namespace merker::project
