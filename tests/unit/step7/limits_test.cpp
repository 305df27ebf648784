// Small sources that would take for ever, or all the memory there is: each ends at a limit, with
// one clear problem.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "support.h"

namespace merker::step7 {
namespace {

using List = std::vector<std::string>;

std::string dataType(int number, const std::string& members) {
  return fmt::format("TYPE UDT {}\nSTRUCT\n{}\nEND_STRUCT;\nEND_TYPE\n", number, members);
}

std::string dataBlock(const std::string& members) {
  return fmt::format("DATA_BLOCK DB 1\nSTRUCT\n{}\nEND_STRUCT;\nBEGIN\nEND_DATA_BLOCK\n", members);
}

std::string repeated(std::string_view text, int times) {
  std::string all;
  for (int i = 0; i < times; ++i) all += text;
  return all;
}

bool has(const List& problems, std::string_view code) {
  return std::any_of(problems.begin(), problems.end(),
                     [&](const std::string& one) { return one.ends_with(code); });
}

// The only problem besides the consequences of it.
std::string first(const std::string& source) {
  const List problems = compileText(source, "generic").problems();
  return problems.empty() ? "" : problems.front();
}

// 9 to the power of 24 components of no size: their type is not known.
TEST(Limits, ATreeOfUnknownTypes) {
  std::string source = dataType(1, "x : XYZ;");
  for (int i = 2; i <= 25; ++i) {
    std::string members;
    for (int j = 0; j < 9; ++j) members += fmt::format("m{} : UDT {};\n", j, i - 1);
    source += dataType(i, members);
  }
  const List problems = compileText(source + dataBlock("a : UDT 25;")).problems();
  ASSERT_LT(problems.size(), 10u);
  EXPECT_TRUE(has(problems, "P0106"));
}

TEST(Limits, ArraysOfUnknownTypesWithinEachOther) {
  const std::string array = "ARRAY [0..32000] OF ";
  EXPECT_EQ(compileText(dataBlock("a : " + array + "STRUCT b : " + array + "STRUCT c : " + array +
                                  "XYZ; END_STRUCT; END_STRUCT;"))
                .problems()
                .size(),
            2u);
  EXPECT_EQ(first(dataType(1, "a : " + array + "STRUCT b : " + array + "BOOL; END_STRUCT;")),
            "3:5 P0427");
}

// The product of six dimensions has 96 bits.
TEST(Limits, SixLongDimensions) {
  const std::string range = "-32768..32767";
  EXPECT_EQ(
      first(dataBlock("a : ARRAY [" + range + repeated("," + range, 5) + "] OF INT := 5 (1);")),
      "3:5 P0427");
}

std::string instances(int blocks, int of) {
  std::string source = "FUNCTION_BLOCK FB 1\nVAR\n a : INT;\nEND_VAR\nBEGIN\nEND_FUNCTION_BLOCK\n";
  for (int i = 2; i <= blocks; ++i) {
    source += fmt::format("FUNCTION_BLOCK FB {}\nVAR\n", i);
    for (int j = 0; j < of; ++j) source += fmt::format(" m{} : FB {};\n", j, i - 1);
    source += "END_VAR\nBEGIN\nEND_FUNCTION_BLOCK\n";
  }
  return source + fmt::format("DATA_BLOCK DB 1\nFB {}\nBEGIN\nEND_DATA_BLOCK\n", blocks);
}

// What is nested too deep is in the program all the same.
TEST(Limits, InstancesInACircle) {
  std::string source = instances(50, 1);
  source.replace(source.find("a : INT"), 7, "a : FB 50");
  for (const std::string& problem : compileText(source, "generic").problems())
    EXPECT_TRUE(problem.ends_with("P0202") || problem.ends_with("P0421")) << problem;
}

// Whatever stands in a structure that is too deep is no member of the one around it.
TEST(Limits, StructuresWithinEachOther) {
  const auto nested = [](int count) {
    return dataBlock(repeated("a : STRUCT\n", count) + "a : INT;\nb : STRING := ';';\n" +
                     repeated("END_STRUCT;\n", count) + "z : INT;\n");
  };
  EXPECT_EQ(compileText(nested(30), "generic").problems(), List{});
  for (const int count : {32, 33, 60}) {
    const Compiled compiled = compileText(nested(count), "generic");
    EXPECT_EQ(compiled.problems().size(), 1u) << count;
    EXPECT_TRUE(compiled.problems().front().ends_with("P0202")) << compiled.problems().front();
  }
}

TEST(Limits, InstancesWithinEachOther) {
  EXPECT_EQ(compileText(instances(30, 1), "generic").problems(), List{});
  EXPECT_EQ(first(instances(40, 1)).substr(first(instances(40, 1)).find(' ')), " P0202");
  EXPECT_FALSE(compileText(instances(300, 3), "generic").result.ok());
}

// Whatever the order of their numbers: each one alone goes down one level only.
TEST(Limits, TypesWithinEachOther) {
  std::string source = dataType(1, "x : INT;");
  for (int i = 2; i <= 5000; ++i) source += dataType(i, fmt::format("a : UDT {};", i - 1));
  const Compiled compiled = compileText(source, "generic");
  EXPECT_FALSE(compiled.result.ok());
  EXPECT_EQ(compiled.problems().front(), "162:1 P0202");
}

TEST(Limits, ATypeOfManyMegabytes) {
  std::string source = dataType(1, "x : ARRAY [0..30000] OF WORD;");
  for (int i = 2; i <= 39; ++i)
    source += dataType(i, fmt::format("a : UDT {}; b : UDT {};", i - 1, i - 1));
  const Compiled compiled = compileText(source + dataBlock("a : UDT 39;"), "generic");
  EXPECT_FALSE(compiled.result.ok());
  EXPECT_TRUE(compiled.problems().front().ends_with("P0106")) << compiled.problems().front();
}

TEST(Limits, ADataBlockOfMoreThanEverything) {
  const std::string array = "x{0} : ARRAY [0..30000] OF WORD;\n";
  std::string members;
  for (int i = 0; i < 10; ++i) members += fmt::format(fmt::runtime(array), i);
  EXPECT_EQ(first(dataBlock(members)), "1:12 P0503");
}

// Few bytes and few variables, but each has 402,234 components: 24 such blocks are possible.
TEST(Limits, ComponentsOfAllDataBlocks) {
  std::string source;
  for (int level = 1; level <= 5; ++level) {
    std::string members;
    for (int i = 0; i < 13; ++i)
      members +=
          fmt::format("m{} : {};\n", i, level == 1 ? "BOOL" : fmt::format("UDT {}", level - 1));
    source += dataType(level, members);
  }
  for (int i = 1; i <= 40; ++i)
    source += fmt::format("DATA_BLOCK DB {}\nUDT 5\nBEGIN\nEND_DATA_BLOCK\n", i);
  const Compiled compiled = compileText(source, "generic");
  ASSERT_EQ(compiled.problems().size(), 1u);
  EXPECT_TRUE(has(compiled.problems(), "P0106"));
  EXPECT_FALSE(compiled.block(BlockKind::DB, 24).initialData.empty());
  EXPECT_TRUE(compiled.block(BlockKind::DB, 25).initialData.empty());
}

// Each name of a declaration had a copy of its type: 8 to the power of 28.
TEST(Limits, ManyNamesOfStructuresWithinEachOther) {
  const Compiled compiled = compileText(dataBlock(repeated("a,b,c,d,e,f,g,h : STRUCT\n", 28) +
                                                  "x : INT;\n" + repeated("END_STRUCT;\n", 28)));
  EXPECT_FALSE(compiled.result.ok());
  EXPECT_LT(compiled.problems().size(), 10u);
}

TEST(Limits, NamesOfOneDeclarationHaveOneType) {
  const Compiled compiled =
      compileText(dataBlock("a, b : STRUCT\n x : XYZ; y, z : INT := 7;\nEND_STRUCT;"));
  EXPECT_EQ(compiled.problems(), (List{"4:6 P0403"}));
  const Compiled good =
      compileText(dataBlock("a, b : STRUCT\n y, z : INT := 7;\nEND_STRUCT;\nc, d : BOOL;"));
  EXPECT_EQ(good.problems(), List{});
  EXPECT_EQ(good.block(BlockKind::DB, 1).actualData,
            (std::vector<std::uint8_t>{0, 7, 0, 7, 0, 7, 0, 7, 0, 0}));
}

TEST(Limits, MoreNamesThanABlockHas) {
  std::string names = "a0";
  for (int i = 1; i < 30'000; ++i) names += fmt::format(",a{}", i);
  EXPECT_TRUE(has(compileText(dataBlock(names + " : BOOL;")).problems(), "P0106"));
}

std::vector<std::uint8_t> bytes(const std::string& declaration) {
  const Compiled compiled = compileText(dataBlock(declaration), "generic");
  EXPECT_EQ(compiled.problems(), List{});
  return compiled.block(BlockKind::DB, 1).actualData;
}

// S7-SRC-04: repetition factors, also within each other.
TEST(Limits, WhatIsRepeatedIsReadOnce) {
  using Image = std::vector<std::uint8_t>;
  EXPECT_EQ(bytes("a : ARRAY [1..8] OF BYTE := 2 (1, 2 (2), 3);"), (Image{1, 2, 2, 3, 1, 2, 2, 3}));
  EXPECT_EQ(bytes("a : ARRAY [1..4] OF BYTE := 9, 3 (7);"), (Image{9, 7, 7, 7}));
  EXPECT_EQ(bytes("a : ARRAY [1..12] OF BOOL := TRUE, 5 (FALSE, TRUE);"), (Image{0x55, 0x05}));
  EXPECT_EQ(bytes("a : ARRAY [1..3] OF INT := 3 (-2);"), (Image{255, 254, 255, 254, 255, 254}));
  EXPECT_EQ(bytes("a : ARRAY [1..2] OF STRING [2] := 2 ('ab');"),
            (Image{2, 2, 'a', 'b', 2, 2, 'a', 'b'}));
  const std::string blanks(200'000, ' ');
  EXPECT_EQ(bytes("a : ARRAY [1..30000] OF BYTE := 30000 (" + blanks + "5);").back(), 5);
}

TEST(Limits, RepetitionsWithinEachOther) {
  const std::string array = "a : ARRAY [1..30000] OF BYTE := ";
  EXPECT_EQ(first(dataBlock(array + repeated("60000 (", 5) + "1" + repeated(")", 5) + ";")),
            "3:68 P0413");
  const std::string deep =
      first(dataBlock(array + repeated("1 (", 50'000) + "1" + repeated(")", 50'000) + ";"));
  EXPECT_TRUE(deep.ends_with("P0412")) << deep;
  EXPECT_TRUE(first(dataBlock("a : ARRAY [1..30000] OF XYZ := 60000 (1);")).ends_with("P0403"));
}

TEST(Limits, StartValuesOfManyMegabytes) {
  std::string source;
  for (int i = 1; i < 1500; ++i)
    source += fmt::format(
        "TYPE UDT {}\nSTRUCT\na : ARRAY [1..30000] OF WORD := 7;\nEND_STRUCT;\n"
        "END_TYPE\n",
        i);
  const List problems = compileText(source, "generic").problems();
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_TRUE(problems[0].ends_with("P0106")) << problems[0];
}

std::string function(const std::string& code) {
  return "FUNCTION FC 1 : VOID\nBEGIN\n" + code + "\nEND_FUNCTION\n";
}

// Each label was a call of its own.
TEST(Limits, ALineOfLabels) {
  std::string labels;
  for (int i = 0; i < 200'000; ++i) labels += fmt::format("{:x}:", i + 0xA0000);
  const Compiled compiled = compileText(function(labels + " U E 0.0;"), "generic");
  EXPECT_FALSE(compiled.result.ok());  // five characters
}

TEST(Limits, AJumpIntoABracket) {
  EXPECT_EQ(compileText(function("U(;\nM001: U E 0.0;\n);\n= A 0.0;\nSPA M001;")).problems(),
            (List{"4:1 P0333"}));
  EXPECT_EQ(compileText(function("U(;\nSPA M001;\nM001: U E 0.0;\n);\n= A 0.0;")).problems(),
            List{});
}

// What stands behind TITLE = is free, and only there.
TEST(Limits, ALineOfEqualsSigns) {
  EXPECT_FALSE(compileText(function(repeated("= ", 200'000)), "generic").result.ok());
  EXPECT_TRUE(compileText(function(repeated("TITLE =\n", 20'000)), "generic").result.ok());
  EXPECT_EQ(
      compileText(function("NETWORK\nTITLE = it's END_FUNCTION\n title= 'x\nU E 0.0;")).problems(),
      List{});
}

}  // namespace
}  // namespace merker::step7
