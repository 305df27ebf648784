#include "block/block.h"

#include <gtest/gtest.h>

#include "make.h"

namespace merker::block {
namespace {

TEST(Block, FindsTheLineOfAnInstruction) {
  Block block;
  block.lines = {{0, 10, 7}, {4, 11, 7}, {10, 15, 7}};
  EXPECT_EQ(block.line(0), 10u);
  EXPECT_EQ(block.line(3), 10u);
  EXPECT_EQ(block.line(4), 11u);
  EXPECT_EQ(block.line(500), 15u);
  EXPECT_EQ(Block{}.line(0), 0u);
}

// As STEP 7 writes the list behind a call: IN, RETURN, OUT, IN_OUT, whatever the order of
// declaration; no local data.
TEST(Block, ParametersComeInTheOrderOfTheList) {
  Block block;
  for (const Section section : {Section::Return, Section::Temp, Section::InOut, Section::Output,
                                Section::Input, Section::Input})
    block.variables.push_back(var(TypeCode::Int, section));
  const auto list = parameters(block);
  ASSERT_EQ(list.size(), 5u);
  EXPECT_EQ(list[0], &block.variables[4]);
  EXPECT_EQ(list[1], &block.variables[5]);
  EXPECT_EQ(list[2]->section, Section::Return);
  EXPECT_EQ(list[3]->section, Section::Output);
  EXPECT_EQ(list[4]->section, Section::InOut);
}

}  // namespace
}  // namespace merker::block
