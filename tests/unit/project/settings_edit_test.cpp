#include "project/settings_edit.h"

#include <gtest/gtest.h>

namespace merker::project {
namespace {

constexpr const char* kText = R"([project]
name = "Plant"  # of the course

[cpu]
model = "314C-2 PtP"

# the panel
[[module]]
slot = 4          # beside the CPU
type = "SM 321 DI16xDC24V"
rising_edge = [0,
  1]  # both buttons

# transmitters
[[module]]
slot = 5
type = "6ES7 331-7KF02-0AB0"

[[module.channel]]
input = 0
range = "±5V"  # 0 to 10 bar

# what it controls
[[plant]]
name = "Oven"
)";

SettingsEdit edit(const char* text = kText) { return {"merker.toml", text}; }

// The text with one piece replaced: everything else stays.
std::string with(std::string_view old, std::string_view fresh) {
  std::string text = kText;
  const auto at = text.find(old);
  EXPECT_NE(at, std::string::npos) << old;
  return text.replace(at, old.size(), fresh);
}

// S7-HWCFG-03
TEST(SettingsEdit, AKeyChangesAndItsCommentStays) {
  SettingsEdit one = edit();
  one.set({0, "4"}, "rising_edge", "[3]");
  EXPECT_EQ(one.text(), with("[0,\n  1]  #", "[3]  #"));
  SettingsEdit two = edit();
  two.setChannel({0, "5"}, "input", 0, "range", "\"±10V\"");
  EXPECT_EQ(two.text(), with("\"±5V\"  #", "\"±10V\"  #"));
}

TEST(SettingsEdit, ANewKeyStandsBehindTheOthersOfItsTable) {
  SettingsEdit one = edit();
  one.set({0, "5"}, "input", "300");
  EXPECT_EQ(one.text(), with("0AB0\"\n", "0AB0\"\ninput = 300\n"));
  SettingsEdit two = edit();
  two.setChannel({0, "5"}, "input", 2, "range", "\"off\"");
  EXPECT_EQ(two.text(),
            with("bar\n\n", "bar\n\n[[module.channel]]\ninput = 2\nrange = \"off\"\n\n"));
  SettingsEdit three = edit();
  three.setIn("cpu", "mpi_address", "3");
  EXPECT_EQ(three.text(), with("PtP\"\n", "PtP\"\nmpi_address = 3\n"));
  SettingsEdit four = edit();
  four.setIn("cpu.OB35", "interval", "\"50ms\"");
  EXPECT_EQ(four.text(), with("PtP\"\n", "PtP\"\n\n[cpu.OB35]\ninterval = \"50ms\"\n"));
}

// The table below a module comes with its first key, changes, and goes with its module.
TEST(SettingsEdit, TheTableBelowAModule) {
  SettingsEdit one = edit();
  one.add({0, "2.1"}, "");
  one.set({0, "2.1"}, "serial.baud", "19200");
  one.set({0, "2.1"}, "serial.protocol", "\"3964R\"");
  one.set({0, "2.1"}, "diagnostics", "true");
  one.set({0, "2.1"}, "serial.baud", "4800");
  EXPECT_EQ(one.text(), with("bar\n\n",
                             "bar\n\n[[module]]\nslot = \"2.1\"\ndiagnostics = true\n\n"
                             "[module.serial]\nbaud = 4800\nprotocol = \"3964R\"\n\n"));
  const ModuleLines serial = one.modules().back();
  EXPECT_EQ(serial.place, (ModulePlace{0, "2.1"}));
  EXPECT_EQ(serial.behind - serial.first, 8U);
  one.set({0, "2.1"}, "serial.baud", std::nullopt);
  EXPECT_EQ(one.text().find("baud"), std::string::npos);
  one.remove({0, "2.1"});
  EXPECT_EQ(one.text(), kText);
}

TEST(SettingsEdit, AKeyGoesWithItsLines) {
  SettingsEdit one = edit();
  one.set({0, "4"}, "rising_edge", std::nullopt);
  EXPECT_EQ(one.text(), with("rising_edge = [0,\n  1]  # both buttons\n", ""));
  one.set({0, "4"}, "falling_edge", std::nullopt);
  EXPECT_EQ(one.text(), with("rising_edge = [0,\n  1]  # both buttons\n", ""));
}

// S7-HWCFG-01
TEST(SettingsEdit, ModulesComeGoAndMove) {
  SettingsEdit one = edit();
  one.add({1, "4"}, "SM 322 DO16xDC24V/0.5A");
  EXPECT_EQ(one.text(), with("bar\n\n",
                             "bar\n\n[[module]]\nrack = 1\nslot = 4\n"
                             "type = \"SM 322 DO16xDC24V/0.5A\"\n\n"));
  SettingsEdit two = edit();
  two.remove({0, "5"});
  EXPECT_EQ(two.text(),
            with("# transmitters\n[[module]]\nslot = 5\ntype = \"6ES7 331-7KF02-0AB0\"\n\n"
                 "[[module.channel]]\ninput = 0\nrange = \"±5V\"  # 0 to 10 bar\n\n",
                 ""));
  SettingsEdit three = edit();
  three.move({0, "4"}, {1, "6"});
  EXPECT_EQ(
      three.text(),
      with("slot = 4          # beside the CPU\ntype = \"SM 321 DI16xDC24V\"\nrising_edge = [0,\n"
           "  1]  # both buttons\n",
           "slot = 6          # beside the CPU\ntype = \"SM 321 DI16xDC24V\"\nrising_edge = [0,\n"
           "  1]  # both buttons\nrack = 1\n"));
  three.move({1, "6"}, {0, "4"});
  EXPECT_EQ(three.text(), kText);
}

TEST(SettingsEdit, TheFirstModuleOfAFile) {
  SettingsEdit one = edit("[project]\r\nname = \"A\"\r\n");
  one.add({0, "2.2"}, "");
  EXPECT_EQ(one.text(), "[project]\r\nname = \"A\"\r\n\r\n[[module]]\r\nslot = \"2.2\"\r\n");
  EXPECT_TRUE(one.has({0, "2.2"}));
  EXPECT_FALSE(one.has({0, "4"}));
  EXPECT_EQ(SettingsEdit("merker.toml", "a = 1").text(), "a = 1");
}

TEST(SettingsEdit, FilesOfTheProgramKeepTheirPlace) {
  const char* text =
      "[program]\nsources = [ # in this order\n  \"a.awl\",  # first\n  \"lib/*.awl\" ]\n";
  SettingsEdit one = edit(text);
  one.renameFile("a.awl", "b.awl");
  EXPECT_EQ(one.text(),
            "[program]\nsources = [ # in this order\n  \"b.awl\",  # first\n  \"lib/*.awl\" ]\n");
  SettingsEdit two = edit(text);
  two.renameFile("lib/x.awl", "x.awl");
  EXPECT_EQ(two.text(),
            "[program]\nsources = [ # in this order\n  \"a.awl\",  # first\n  \"lib/*.awl\", "
            "\"x.awl\" ]\n");
  two.renameFile("lib/x.awl", "lib/y.awl");
  two.removeFile("a.awl");
  EXPECT_EQ(two.text(), "[program]\nsources = [\"lib/*.awl\", \"x.awl\"]\n");
  SettingsEdit three = edit();
  three.renameFile("a.awl", "b.awl");
  three.removeFile("a.awl");
  EXPECT_EQ(three.text(), kText);
}

TEST(SettingsEdit, NewFilesAreListedWhereFilesAreListed) {
  SettingsEdit one = edit(
      "# plant\n[program]\nsources = [ # in this order\n  \"a.awl\",  # first\n  \"lib/*.awl\" ]  "
      "# "
      "end\nsymbols = []\n");
  EXPECT_TRUE(one.addFile("b.awl"));
  EXPECT_FALSE(one.addFile("B.AWL"));      // it is there
  EXPECT_FALSE(one.addFile("lib/c.awl"));  // a pattern finds it
  EXPECT_TRUE(one.addFile("FC1.mc7"));
  EXPECT_TRUE(one.addFile("names.sdf"));
  EXPECT_FALSE(one.addFile("letter.txt"));
  EXPECT_EQ(
      one.text(),
      "# plant\n[program]\nsources = [ # in this order\n  \"a.awl\",  # first\n  \"lib/*.awl\", "
      "\"b.awl\", \"FC1.mc7\" ]  # end\nsymbols = [\"names.sdf\"]\n");
  SettingsEdit two = edit();
  EXPECT_FALSE(two.addFile("b.awl"));  // no list: all are sources
  EXPECT_EQ(two.text(), kText);
}

TEST(SettingsEdit, LinesBelongToModules) {
  const std::vector<ModuleLines> modules = edit().modules();
  const auto at = [&](std::uint32_t line) -> std::optional<ModulePlace> {
    for (const ModuleLines& one : modules)
      if (line >= one.first && line < one.behind) return one.place;
    return std::nullopt;
  };
  EXPECT_EQ(at(9), (ModulePlace{0, "4"}));
  EXPECT_EQ(at(21), (ModulePlace{0, "5"}));
  EXPECT_EQ(at(5), std::nullopt);
  EXPECT_EQ(at(25), std::nullopt);
}

TEST(SettingsEdit, APlantComesLast) {
  SettingsEdit one = edit("[cpu]\nmodel = \"314C-2 PtP\"  # ours\n");
  one.addPlant("\"Axis\"", "\"axis\"", {{"speed", "2000"}}, {{"A", "\"2.2.DI0\""}});
  EXPECT_EQ(one.text(),
            "[cpu]\nmodel = \"314C-2 PtP\"  # ours\n\n[[plant]]\nname = \"Axis\"\nkind = \"axis\"\n"
            "speed = 2000\n\n[plant.wire]\nA = \"2.2.DI0\"\n");
  one.addPlant("\"Tank\"", "\"tank\"", {}, {});
  EXPECT_TRUE(one.text().ends_with("\n\n[[plant]]\nname = \"Tank\"\nkind = \"tank\"\n"));
}

TEST(SettingsEdit, WhatItCannotChangeItSays) {
  EXPECT_EQ(edit("a = = 1").problem()->name(), "P0702");
  EXPECT_EQ(edit("module = [{slot = 4}]").problem()->name(), "P1308");
  EXPECT_EQ(edit("module = 1").problem()->name(), "P1308");
  EXPECT_EQ(edit("[[module]]\nslot = 4\nserial.baud = 300\n").problem()->name(), "P1308");
  EXPECT_EQ(edit("[[module]]\nslot = 4\nserial = {baud = 300}\n").problem()->name(), "P1308");
  EXPECT_FALSE(edit().problem());
  std::string deep = "[a";
  for (int i = 0; i < 300'000; ++i) deep += ".a";
  deep += "]";
  EXPECT_EQ(edit(deep.c_str()).problem()->name(), "P0202");
}

}  // namespace
}  // namespace merker::project
