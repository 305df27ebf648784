#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "compilation/build.h"
#include "tags/address.h"
#include "tags/csv.h"
#include "tags/fuxa.h"
#include "tags/ignition.h"
#include "tags/kepware.h"
#include "tags/node_red.h"

namespace merker::tags {
namespace {

using compilation::Build;

Build program(const std::string& source, const std::string& symbols = "") {
  Build build = compilation::build(project::load("a.awl", {}, {{"a.awl", source}}, {}), false);
  EXPECT_TRUE(build.ok());
  source::readSymbols(source::SourceFile("a.sym", symbols), build.project.symbols, build.problems);
  return build;
}

const std::string kData =
    "DATA_BLOCK DB 10\nREAD_ONLY\nSTRUCT\n"
    "  on : BOOL ; // lamp\n  second : BOOL;\n  speed : INT;\n  long : DINT;\n  ratio : REAL;\n"
    "  step : ARRAY [1..2] OF STRUCT\n    run : BOOL;\n    t : S5TIME;\n  END_STRUCT;\n"
    "  name : STRING [6];\n  when : DATE_AND_TIME;\n"
    "END_STRUCT\nBEGIN\nEND_DATA_BLOCK\n";

Tag tag(TagArea area, TypeCode type, BitAddress at, std::uint16_t db = 0) {
  return {
      .path = {"x"}, .area = area, .db = db, .at = at, .type = type, .length = 20, .comment = {}};
}

std::vector<std::string> lines(const std::string& text) {
  std::vector<std::string> list;
  for (std::size_t begin = 0, end; (end = text.find('\n', begin)) != std::string::npos;
       begin = end + 1)
    list.push_back(text.substr(begin, end - begin));
  return list;
}

TEST(Tags, VariablesOfDataBlocksWithTheirPlaces) {
  const std::vector<std::string> expected = {
      "name,address,type,access,comment",       "DB10.on,DB10.DBX 0.0,BOOL,R,lamp",
      "DB10.second,DB10.DBX 0.1,BOOL,R,",       "DB10.speed,DB10.DBW 2,INT,R,",
      "DB10.long,DB10.DBD 4,DINT,R,",           "DB10.ratio,DB10.DBD 8,REAL,R,",
      "DB10.step[1].run,DB10.DBX 12.0,BOOL,R,", "DB10.step[1].t,DB10.DBW 14,S5TIME,R,",
      "DB10.step[2].run,DB10.DBX 16.0,BOOL,R,", "DB10.step[2].t,DB10.DBW 18,S5TIME,R,",
      "DB10.name,DB10.DBB 20,STRING[6],R,",     "DB10.when,DB10.DBB 28,DATE_AND_TIME,R,"};
  EXPECT_EQ(lines(csv(listTags(program(kData)), {}).text), expected);
}

// Declared by its number or by its symbol, a block has the name of the table; what nobody may read
// or only write says so.
TEST(Tags, NamesAndAccess) {
  const std::string head =
      "DATA_BLOCK DB 10\nSTRUCT\n n : INT;\nEND_STRUCT\nBEGIN\nEND_DATA_BLOCK\n";
  const std::string hidden =
      "DATA_BLOCK DB 11\nUNLINKED\nSTRUCT\n n : INT;\nEND_STRUCT\nBEGIN\nEND_DATA_BLOCK\n";
  const auto list = listTags(program(head + hidden, "Recipe DB 10 DB 10\nValve PAW 752 INT\n"));
  const std::vector<std::string> expected = {"name,address,type,access,comment",
                                             "Valve,PAW 752,INT,W,", "Recipe.n,DB10.DBW 0,INT,RW,"};
  EXPECT_EQ(lines(csv(list, {}).text), expected);
  EXPECT_EQ(nodeRed(list, {}).left, std::vector<std::string>{"Valve"});
  EXPECT_EQ(kepware(list, {}).left, std::vector<std::string>{"Valve"});
}

// A composite IN_OUT parameter is a POINTER of six bytes in the instance (S7-PAR-03).
TEST(Tags, ReferencesInInstancesAreOneValue) {
  const Build build = program(
      "FUNCTION_BLOCK FB 1\nVAR_IN_OUT\n  box : STRUCT\n    a : INT;\n    b : INT;\n"
      "  END_STRUCT;\nEND_VAR\nVAR\n  n : INT;\nEND_VAR\nVAR_TEMP\n  t : INT;\nEND_VAR\nBEGIN\n"
      "END_FUNCTION_BLOCK\nDATA_BLOCK DB 1\nFB 1\nBEGIN\nEND_DATA_BLOCK\n");
  const std::vector<std::string> expected = {"name,address,type,access,comment",
                                             "DB1.box,DB1.DBB 0,POINTER,RW,",
                                             "DB1.n,DB1.DBW 6,INT,RW,"};
  EXPECT_EQ(lines(csv(listTags(build), {}).text), expected);
  EXPECT_EQ(kepware(listTags(build), {}).left, std::vector<std::string>{"DB1.box"});
}

// The rows of the manuals that `address.h` names.
TEST(Tags, AddressesOfOtherTools) {
  struct Row {
    Tag tag;
    std::string nodeRed, kepware, ignition;  // empty: the tool has none
  };
  const Row rows[] = {
      {tag(TagArea::Input, TypeCode::Bool, 163), "I20.3", "IX20.3", "IX20.3"},
      {tag(TagArea::Output, TypeCode::Byte, 40), "QB5", "QB5", "QB5"},
      {tag(TagArea::Flag, TypeCode::Int, 112), "MI14", "MI14", "MI14"},
      {tag(TagArea::Flag, TypeCode::DInt, 208), "MDI26", "MDI26", "MDI26"},
      {tag(TagArea::Flag, TypeCode::Real, 304), "MR38", "MREAL38", "MREAL38"},
      {tag(TagArea::PeripheralInput, TypeCode::Word, 2048), "PIW256", "PIW256", ""},
      {tag(TagArea::PeripheralOutput, TypeCode::Word, 2048), "PQW256", "PQW256", ""},
      {tag(TagArea::Timer, TypeCode::Timer, 7), "T7", "T7", "T7"},
      {tag(TagArea::Counter, TypeCode::Counter, 3), "C3", "C3", "C3"},
      {tag(TagArea::Data, TypeCode::Bool, 1, 5), "DB5,X0.1", "DB5,X0.1", "DB5,X0.1"},
      {tag(TagArea::Data, TypeCode::DInt, 64, 500), "DB500,DINT8", "DB500,DI8", "DB500,DI8"},
      {tag(TagArea::Data, TypeCode::Time, 64, 1), "DB1,DINT8", "DB1,DI8", "DB1,DI8"},
      {tag(TagArea::Data, TypeCode::S5Time, 32, 57), "DB57,WORD4", "DB57,W4", "DB57,W4"},
      {tag(TagArea::Data, TypeCode::String, 56, 2), "DB2,S7.20", "DB2,STRING7.20",
       "DB2,STRING7.20"},
      {tag(TagArea::Data, TypeCode::DateAndTime, 0, 1), "DB1,DT0", "", "DB1,DT0"},
      {tag(TagArea::Data, TypeCode::Any, 0, 1), "", "", ""},
  };
  for (const Row& row : rows) {
    EXPECT_EQ(address(row.tag, kNodeRed).value_or(""), row.nodeRed);
    EXPECT_EQ(address(row.tag, kKepware).value_or(""), row.kepware);
    EXPECT_EQ(address(row.tag, kIgnition).value_or(""), row.ignition);
  }
}

TEST(Tags, AddressesOfStep7InBothLanguages) {
  const Tag in = tag(TagArea::PeripheralInput, TypeCode::Word, 2048);
  EXPECT_EQ(step7Address(in, Mnemonics::German), "PEW 256");
  EXPECT_EQ(step7Address(in, Mnemonics::International), "PIW 256");
  EXPECT_EQ(step7Address(tag(TagArea::Counter, TypeCode::Counter, 3), Mnemonics::German), "Z 3");
}

// Fields of CSV files with commas and quotes come back as they were (RFC 4180).
TEST(Tags, NamesThatOtherToolsDoNotTake) {
  std::vector<Tag> list = {tag(TagArea::Flag, TypeCode::Bool, 0),
                           tag(TagArea::Flag, TypeCode::Bool, 1),
                           tag(TagArea::Data, TypeCode::Int, 0, 1)};
  list[0].path = {"_Motor; \"1\", ein"};
  list[1].path = {"_motor; \"1\", EIN"};
  list[2].path = {"Rezept/Süß", "a[1,2]"};
  EXPECT_EQ(lines(csv(list, {}).text)[1], "\"_Motor; \"\"1\"\", ein\",M 0.0,BOOL,RW,");
  EXPECT_EQ(
      nodeRed(list, {}).text,
      "M0.0;_Motor_ \"1\", ein\r\nM0.1;_motor_ \"1\", EIN_2\r\nDB1,INT0;Rezept/Süß.a[1,2]\r\n");
  const auto rows = lines(kepware(list, {}).text);
  EXPECT_EQ(rows[1].substr(0, 41), "\"x_Motor; _1_, ein\",\"MX0.0\",Boolean,1,R/W");
  EXPECT_EQ(rows[3].substr(0, 39), "\"Rezept/Süß.a_1,2_\",\"DB1,I0\",Short,1,");
  const auto tags = nlohmann::json::parse(ignition(list, {}).text)["tags"];
  EXPECT_EQ(tags[0]["name"], "_Motor_ _1__ ein");
  EXPECT_EQ(tags[1]["name"], "_motor_ _1__ EIN_2");
  EXPECT_EQ(tags[2]["name"], "Rezept_Süß");
  EXPECT_EQ(tags[2]["tags"][0]["name"], "a_1_2_");
}

TEST(Tags, FoldersOfIgnition) {
  FormatOptions options;
  options.device = "Press";
  const Output output = ignition(listTags(program(kData)), options);
  EXPECT_EQ(output.left, std::vector<std::string>{});
  const auto block = nlohmann::json::parse(output.text)["tags"][0];
  EXPECT_EQ(block["name"], "DB10");
  EXPECT_EQ(block["tagType"], "Folder");
  ASSERT_EQ(block["tags"].size(), 9u);
  EXPECT_EQ(block["tags"][2]["opcItemPath"], "ns=1;s=[Press]DB10,I2");
  EXPECT_EQ(block["tags"][2]["dataType"], "Int2");
  EXPECT_EQ(block["tags"][2]["readOnly"], true);
  EXPECT_EQ(block["tags"][6]["name"], "step_2_");
  EXPECT_EQ(block["tags"][6]["tags"][1]["name"], "t");
}

TEST(Tags, DeviceOfFuxa) {
  const Build build = program(kData, "Start E 0.0 BOOL // Taster\nZeit T 1 TIMER\n");
  FormatOptions options;
  options.address = "10.0.0.9";
  const Output output = fuxa(listTags(build), options);
  const auto device = nlohmann::json::parse(output.text)[0];
  EXPECT_EQ(device["type"], "SiemensS7");
  EXPECT_EQ(device["property"]["address"], "10.0.0.9");
  EXPECT_EQ(device["property"]["slot"], 2);
  EXPECT_EQ(device["tags"]["t_Start"]["address"], "I0.0");
  EXPECT_EQ(device["tags"]["t_Start"]["type"], "Bool");
  EXPECT_EQ(device["tags"]["t_DB10.second"]["address"], "DB10.DBX0.1");
  EXPECT_EQ(device["tags"]["t_DB10.ratio"]["type"], "Real");
  EXPECT_EQ(output.left, (std::vector<std::string>{"Zeit", "DB10.name", "DB10.when"}));
}

// A symbol may have the name of a variable: neither takes the place of the other.
TEST(Tags, TheSameNameTwice) {
  std::vector<Tag> list = {tag(TagArea::Flag, TypeCode::Bool, 0),
                           tag(TagArea::Data, TypeCode::Int, 0, 1)};
  list[0].path = {"Recipe.speed"};
  list[1].path = {"Recipe", "speed"};
  const auto tags = nlohmann::json::parse(fuxa(list, {}).text)[0]["tags"];
  ASSERT_EQ(tags.size(), 2u);
  EXPECT_EQ(tags["t_Recipe.speed"]["address"], "M0.0");
  EXPECT_EQ(tags["t_Recipe.speed_2"]["address"], "DB1.DBW0");
  EXPECT_EQ(tags["t_Recipe.speed_2"]["name"], "Recipe.speed_2");
}

}  // namespace
}  // namespace merker::tags
