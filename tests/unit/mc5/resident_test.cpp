#include <gtest/gtest.h>

#include <map>
#include <string>

#include "mc5/resident_blocks.h"

namespace merker::mc5 {
namespace {

// S5-FM-02: the ten macros of the system program by number and name.
TEST(ResidentBlocks, NumbersAndNames) {
  std::map<unsigned, std::string> found;
  for (const Block& block : residentBlocks()) {
    EXPECT_EQ(block.id.type, BlockType::Fb);
    found[block.id.number] = block.name;
  }
  EXPECT_EQ(found, (std::map<unsigned, std::string>{{11, "EINR-DB"},
                                                    {56, "VORSCHUB"},
                                                    {57, "SCHLEPPA"},
                                                    {58, "SPINDIST"},
                                                    {60, "BLOCK-TR"},
                                                    {61, "NCD-LESE"},
                                                    {62, "NCD-SCHR"},
                                                    {65, "M STACK"},
                                                    {66, "STACK M"},
                                                    {190, "K-LEITPC"}}));
  EXPECT_EQ(findResident(61)->name, "NCD-LESE");
  EXPECT_EQ(findResident(63), nullptr);
}

}  // namespace
}  // namespace merker::mc5
