// [module.serial] of the sub-module 2.1 and [serial]: defaults, and each wrong parameter is one
// problem with its place (technology manual 6.3).
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "project/settings.h"
#include "serial/parameters.h"

namespace merker::project {
namespace {

using serial::Connection;

struct SerialRead {
  std::string problem;  // "line code: words", the first one
  std::size_t problems = 0;
  serial::Parameters p;
  bool has = false, diagnostics = false;
  std::uint32_t address = 0;
  std::string name;
  std::optional<Connection> connection;
};

// The interface's keys begin in line 5.
SerialRead readSerial(std::string_view keys, std::string_view model = "314C-2 PtP",
                      std::string_view module = "", std::string_view root = "") {
  const std::string text =
      fmt::format("cpu.model = \"{}\"\n{}[[module]]\nslot = \"2.1\"\n{}[module.serial]\n{}", model,
                  root, module, keys);
  Problems problems;
  const Settings settings = readSettings(source::SourceFile("merker.toml", text), problems);
  SerialRead result;
  result.problems = problems.size();
  if (!problems.empty()) {
    const Problem& first = problems.list()[0];
    result.problem = fmt::format("{} {}: {}", first.position.line, first.name(), first.message);
  }
  result.connection = settings.serial;
  if (!settings.hardware) return result;
  const io::Module* found = settings.hardware->find("2.1");
  if (found == nullptr || !found->parameters.serial) return result;
  result.has = true;
  result.p = *found->parameters.serial;
  result.diagnostics = found->parameters.diagnosticInterrupt;
  result.address = found->inputStart.value_or(0);
  result.name = found->name;
  return result;
}

// PTP-OVW-01, PTP-OVW-02, PTP-PARAM-01, PTP-PARAM-07, PTP-PARAM-08, PTP-PARAM-13, PTP-SFBG-11
TEST(SerialSettings, DefaultsAreThoseOfTheManual) {
  const SerialRead ascii = readSerial("");
  EXPECT_EQ(ascii.problem, "");
  ASSERT_TRUE(ascii.has);
  EXPECT_EQ(ascii.p.protocol, serial::Protocol::Ascii);
  EXPECT_EQ(ascii.p.line.baud, 9600U);
  EXPECT_EQ(ascii.p.line.frame, (serial::Frame{8, serial::Parity::Even, 1}));
  EXPECT_EQ(ascii.p.line.preset, serial::Preset::Break);
  EXPECT_EQ(ascii.p.ascii.delay, Duration::milliseconds(4));
  EXPECT_FALSE(ascii.diagnostics);
  EXPECT_EQ(ascii.address, 1023U);
  EXPECT_EQ(ascii.name, "X27");
  EXPECT_EQ(readSerial("", "314C-2 PtP", "input = 336\ndiagnostics = true\n").address, 336U);
  EXPECT_TRUE(readSerial("", "314C-2 PtP", "diagnostics = true\n").diagnostics);
}

// PTP-PARAM-24, PTP-PARAM-25, PTP-PARAM-33
TEST(SerialSettings, ThePresetFollowsTheMode) {
  using serial::Preset;
  EXPECT_EQ(readSerial("mode = \"RS485\"").p.line.preset, Preset::Idle);
  EXPECT_EQ(readSerial("mode = \"RS422 master\"").p.line.preset, Preset::Idle);
  EXPECT_EQ(readSerial("mode = \"RS485\"\npreset = \"none\"").p.line.preset, Preset::None);
  EXPECT_EQ(readSerial("protocol = \"3964R\"").p.line.preset, Preset::Break);
  EXPECT_EQ(readSerial("protocol = \"3964R\"\npreset = \"idle\"").p.line.preset, Preset::Idle);
  EXPECT_NE(readSerial("mode = \"RS485\"\npreset = \"break\"").problem, "");
}

// PTP-PARAM-28, PTP-PARAM-29, PTP-PARAM-27, PTP-PARAM-32
TEST(SerialSettings, ThreeNineSixFourWithAndWithoutBlockCheck) {
  const SerialRead with = readSerial("protocol = \"3964R\"");
  EXPECT_TRUE(with.p.procedure.blockCheck);
  EXPECT_TRUE(with.p.procedure.highPriority);
  EXPECT_EQ(with.p.procedure.acknowledgeDelay, Duration::milliseconds(2'000));
  const SerialRead without =
      readSerial("protocol = \"3964\"\npriority = \"low\"\nsetup_attempts = 2");
  EXPECT_EQ(without.problem, "");
  EXPECT_FALSE(without.p.procedure.blockCheck);
  EXPECT_FALSE(without.p.procedure.highPriority);
  EXPECT_EQ(without.p.procedure.setups, 2);
  EXPECT_EQ(without.p.procedure.characterDelay, Duration::milliseconds(220));
  EXPECT_EQ(without.p.procedure.acknowledgeDelay, Duration::milliseconds(550));
  EXPECT_EQ(readSerial("protocol = \"3964\"\nsetup_attempts = 0").problem,
            "6 P0704: 'setup_attempts' must be a whole number from 1 to 255");
}

// PTP-OVW-01, PTP-OPEN-28, PTP-PARAM-34, PTP-PARAM-35
TEST(SerialSettings, RK512IsForOneCpuAndHasNoBuffer) {
  EXPECT_EQ(readSerial("protocol = \"RK512\"").p.protocol, serial::Protocol::ComputerLink);
  EXPECT_EQ(readSerial("protocol = \"RK512\"", "313C-2 PtP").problem,
            "5 P0737: protocol \"RK512\" is not possible with CPU 313C-2 PtP; valid: ASCII, 3964, "
            "3964R");
  EXPECT_NE(readSerial("protocol = \"RK512\"\ntelegrams = 5").problem, "");
  EXPECT_EQ(readSerial("protocol = \"RK512\"\ndata_bits = 7").problem,
            "6 P0769: the serial interface cannot be set so: RK 512 has 8 data bits");
  EXPECT_FALSE(readSerial("protocol = \"RK512\"\nblock_check = false").p.procedure.blockCheck);
}

// PTP-OVW-01
TEST(SerialSettings, OtherCpusHaveNoSuchSubModule) {
  for (const char* model : {"312C", "313C", "314C-2 DP", "313C-2 DP", "314C-2 PN/DP", "318-2"})
    EXPECT_NE(readSerial("", model).problem.find("P0743"), std::string::npos) << model;
}

// PTP-PARAM-13, PTP-PARAM-36, PTP-PARAM-37, PTP-OPEN-22
TEST(SerialSettings, TimesFollowTheRateAndTheGrid) {
  EXPECT_EQ(readSerial("baud = 300").p.ascii.delay, Duration::milliseconds(130));
  EXPECT_EQ(readSerial("baud = 300\nprotocol = \"3964R\"").p.procedure.characterDelay,
            Duration::milliseconds(220));
  EXPECT_EQ(readSerial("baud = 300\ncharacter_delay = \"129ms\"").problem,
            "6 P0769: the serial interface cannot be set so: character delay time must be 130 to "
            "65535 ms in steps of 1 ms at 300 baud; 130ms is possible");
  EXPECT_EQ(readSerial("protocol = \"3964R\"\ncharacter_delay = \"225ms\"").problem,
            "6 P0769: the serial interface cannot be set so: character delay time must be 20 to "
            "65530 ms in steps of 10 ms at 9600 baud; 230ms is possible");
  EXPECT_EQ(readSerial("baud = 300\ncharacter_delay = \"130ms\"").problem, "");
  EXPECT_EQ(readSerial("flow_control = \"XON/XOFF\"\nxon_wait = \"25ms\"").problem,
            "6 P0769: the serial interface cannot be set so: waiting time for XON must be 20 to "
            "65530 ms in steps of 10 ms; 30ms is possible");
}

// PTP-OVW-04, PTP-OPEN-27, PTP-PARAM-07
TEST(SerialSettings, TheHighestRateWarnsOnFourWires) {
  EXPECT_EQ(readSerial("baud = 38400").problem.substr(0, 7), "5 P0771");
  EXPECT_EQ(readSerial("baud = 38400\nmode = \"RS485\"").problem, "");
  EXPECT_EQ(readSerial("baud = 38400\nprotocol = \"3964R\"").problem, "");
  EXPECT_EQ(readSerial("baud = 57600").problem.substr(0, 7), "5 P0769");
}

// PTP-PHY-07, PTP-PHY-08, PTP-PHY-09, PTP-PHY-12, PTP-PARAM-08, PTP-PARAM-09, PTP-PARAM-10
TEST(SerialSettings, WhatTheManualRefusesIsRefused) {
  const char* refused[] = {"data_bits = 7\nparity = \"none\"",
                           "data_bits = 9",
                           "stop_bits = 3",
                           "parity = \"mark\"",
                           "mode = \"RS485\"\nflow_control = \"XON/XOFF\"",
                           "mode = \"RS422 master\"\nflow_control = \"XON/XOFF\"",
                           "flow_control = \"XON/XOFF\"\nxon = 0x13",
                           "flow_control = \"XON/XOFF\"\nxon_wait = \"25ms\"",
                           "flow_control = \"XON/XOFF\"\ndata_bits = 7\nxon = 0x80",
                           "flow_control = \"XON/XOFF\"\nend = \"characters\"\n"
                           "end_characters = [13, 0x11]",
                           "protocol = \"3964R\"\nmode = \"RS485\"",
                           "protocol = \"3964R\"\nflow_control = \"none\"",
                           "protocol = \"X\"",
                           "baud = \"fast\""};
  for (const char* keys : refused) EXPECT_EQ(readSerial(keys).problems, 1U) << keys;
}

// PTP-PARAM-12, PTP-PARAM-14, PTP-PARAM-15, PTP-PARAM-16, PTP-PARAM-17, PTP-PARAM-18, PTP-PARAM-19
TEST(SerialSettings, EndsOfTelegrams) {
  using End = serial::AsciiParameters::End;
  using Sending = serial::AsciiParameters::Sending;
  const auto count = readSerial("end = \"count\"\nlength = 8\npause = false").p.ascii;
  EXPECT_EQ(count.end, End::Count);
  EXPECT_EQ(count.length, 8);
  EXPECT_FALSE(count.pause);
  EXPECT_EQ(readSerial("end = \"count\"\nlength = 1025").problems, 1U);
  EXPECT_EQ(readSerial("end = \"count\"\nlength = 0").problems, 1U);
  const auto two = readSerial(
                       "end = \"characters\"\nend_characters = [13, 10]\ncheck_characters = 2\n"
                       "sending = \"append\"")
                       .p.ascii;
  EXPECT_EQ(two.end, End::Characters);
  EXPECT_EQ(two.endCharacters, 2);
  EXPECT_EQ(two.end1, 13);
  EXPECT_EQ(two.end2, 10);
  EXPECT_EQ(two.checkCharacters, 2);
  EXPECT_EQ(two.sending, Sending::Append);
  const std::string marked = "end = \"characters\"\n";
  EXPECT_EQ(readSerial(marked + "end_characters = [1, 2, 3]").problems, 1U);
  EXPECT_EQ(readSerial(marked + "end_characters = [256]").problems, 1U);
  EXPECT_EQ(readSerial("end = \"characters\"\ndata_bits = 7\nend_characters = [0x80]").problems,
            1U);
}

// PTP-PARAM-11, PTP-PARAM-14 to -18, PTP-PARAM-23: what means nothing with the choice is no slip of
// the pen that stays unseen.
TEST(SerialSettings, WhatTheChoiceMakesMeaninglessIsRefused) {
  constexpr std::pair<const char*, const char*> kRefused[] = {
      {"length = 10", "'length' needs end = \"count\""},
      {"end = \"characters\"\npause = false", "'pause' needs end = \"count\""},
      {"end_characters = [13]", "'end_characters' needs end = \"characters\""},
      {"end = \"count\"\ncheck_characters = 2", "'check_characters' needs end = \"characters\""},
      {"sending = \"append\"", "'sending' needs end = \"characters\""},
      {"xon = 2", "'xon' needs flow_control = \"XON/XOFF\""},
      {"xoff = 2", "'xoff' needs flow_control = \"XON/XOFF\""},
      {"xon_wait = \"5s\"", "'xon_wait' needs flow_control = \"XON/XOFF\""},
      {"telegrams = 5", "'telegrams' needs whole_buffer = false"}};
  for (const auto& [keys, text] : kRefused) {
    const auto read = readSerial(keys);
    EXPECT_EQ(read.problems, 1U) << keys;
    EXPECT_NE(read.problem.find(text), std::string::npos) << read.problem;
  }
}

// PTP-PARAM-20, PTP-PARAM-21, PTP-PARAM-22, PTP-PARAM-23, PTP-PARAM-02
TEST(SerialSettings, TheReceiveBuffer) {
  const auto p = readSerial(
                     "whole_buffer = false\ntelegrams = 1\nprevent_overwriting = false\n"
                     "clear_at_start = true\ncpu_stop = \"stop\"")
                     .p;
  EXPECT_FALSE(p.mailbox.wholeBuffer);
  EXPECT_EQ(p.mailbox.telegrams, 1);
  EXPECT_FALSE(p.mailbox.preventOverwriting);
  EXPECT_TRUE(p.mailbox.clearAtStart);
  EXPECT_TRUE(p.discardInStop);
  EXPECT_EQ(readSerial("telegrams = 5").problem.substr(0, 7), "5 P0744");
  EXPECT_EQ(readSerial("whole_buffer = false\ntelegrams = 11").problems, 1U);
}

TEST(SerialSettings, OnlyTheSubModuleHasThem) {
  Problems problems;
  readSettings(source::SourceFile("merker.toml",
                                  "[[module]]\nslot = \"2.2\"\n[module.serial]\nbaud = 9600\n"),
               problems);
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_EQ(problems.list()[0].name(), "P0735");
}

// PTP-LINE-12
TEST(SerialSettings, WhatItIsConnectedToIsASettingOfTheSimulator) {
  const auto connection = [](std::string_view text) {
    return readSerial("", "314C-2 PtP", "", fmt::format("[serial]\nX27 = \"{}\"\n", text));
  };
  using Kind = Connection::Kind;
  EXPECT_EQ(connection("pty:/tmp/x").connection, (Connection{Kind::Pty, "/tmp/x", 0}));
  EXPECT_EQ(connection("listen:4000").connection, (Connection{Kind::Listen, "", 4000}));
  EXPECT_EQ(connection("connect:[::1]:4000").connection, (Connection{Kind::Connect, "::1", 4000}));
  EXPECT_EQ(connection("partner").connection, Connection{});
  EXPECT_EQ(readSerial("").connection, std::nullopt);
  for (const char* wrong : {"", "pty:", "listen:", "listen:70000", "connect:4000", "usb:1"})
    EXPECT_NE(connection(wrong).problem.find("P0770"), std::string::npos) << wrong;
}

}  // namespace
}  // namespace merker::project
