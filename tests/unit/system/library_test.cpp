#include "system/library.h"

#include <gtest/gtest.h>

namespace merker::system {
namespace {

std::string parameterNames(const block::Program& program, BlockId id) {
  std::string names;
  for (const block::Variable* variable : block::parameters(program.at(id)))
    names += variable->name + " ";
  return names;
}

TEST(Library, HasTheBlocksOfTheTable) {
  const block::Program program = library(defaultCpuModel());
  for (const int sfc : {0,  1,  6,  20, 21, 22, 23, 24, 28, 29, 30, 31, 32, 33, 34,
                        36, 37, 38, 39, 40, 41, 42, 43, 44, 46, 47, 64, 79, 80, 81})
    EXPECT_TRUE(program.contains({BlockKind::SFC, static_cast<std::uint16_t>(sfc)})) << sfc;
  for (std::uint16_t sfb = 0; sfb <= 5; ++sfb) EXPECT_TRUE(program.contains({BlockKind::SFB, sfb}));
  for (const auto& [id, block] : program) {
    EXPECT_TRUE(block.code.empty()) << toString(id);
    for (const block::Variable& variable : block.variables)
      EXPECT_NE(variable.type, nullptr) << toString(id);
  }
}

// PID-USE-01
TEST(Library, ClosedLoopControlIsOnCompactCpus) {
  for (const char* name :
       {"313C", "313C-2 PtP", "313C-2 DP", "314C-2 PtP", "314C-2 DP", "314C-2 PN/DP", "generic"})
    for (const std::uint16_t sfb : {41, 42, 43})
      EXPECT_TRUE(library(*findCpuModel(name)).contains({BlockKind::SFB, sfb})) << name << sfb;
  for (const char* name : {"312C", "312 IFM", "318-2"})
    for (const std::uint16_t sfb : {41, 42, 43})
      EXPECT_FALSE(library(*findCpuModel(name)).contains({BlockKind::SFB, sfb})) << name << sfb;
}

TEST(Library, ListsParametersInOrder) {
  const block::Program program = library(defaultCpuModel());
  EXPECT_EQ(parameterNames(program, {BlockKind::SFC, 20}), "SRCBLK RET_VAL DSTBLK ");
  EXPECT_EQ(parameterNames(program, {BlockKind::FC, 105}), "IN HI_LIM LO_LIM BIPOLAR RET_VAL OUT ");
  EXPECT_EQ(parameterNames(program, {BlockKind::SFC, 46}), "");
  EXPECT_EQ(parameterNames(program, {BlockKind::SFC, 54}), "IOID LADDR RECNUM RET_VAL RECORD ");
  EXPECT_EQ(parameterNames(program, {BlockKind::FC, 34}), "DT1 DT2 RET_VAL ");
}

// The instances as the real blocks lay them out.
TEST(Library, InstancesHaveTheirLength) {
  const block::Program program = library(defaultCpuModel());
  EXPECT_EQ(program.at({BlockKind::SFB, 0}).instanceBytes, 10u);
  EXPECT_EQ(program.at({BlockKind::SFB, 4}).instanceBytes, 22u);
}

}  // namespace
}  // namespace merker::system
