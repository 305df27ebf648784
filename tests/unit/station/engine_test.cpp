// Both engines behind one station, changed while it works.
#include <gtest/gtest.h>

#include "program.h"

namespace merker::station::test {
namespace {

constexpr std::string_view kProgram = R"(
      L     MW 10
      L     1
      +I
      T     MW 10
      UN    M 20.0
      =     M 20.0
)";

TEST(Engine, ChangesWhileTheProgramRuns) {
  Plc changing(kProgram), reference(kProgram);
  changing.cycles(3);
  reference.cycles(9);
  if (!changing->setEngine(Engine::Compiled)) GTEST_SKIP() << "no compiler for this processor";
  EXPECT_EQ(changing->engine(), Engine::Compiled);
  EXPECT_GT(changing->compiledBytes(), 0u);
  changing->advanceCycles(3);
  EXPECT_TRUE(changing->setEngine(Engine::Interpreter));
  EXPECT_EQ(changing->compiledBytes(), 0u);
  changing->advanceCycles(3);
  EXPECT_EQ(changing.read("MW 10"), 9u);
  EXPECT_EQ(changing->now(), reference->now());
  EXPECT_EQ(changing->instructions(), reference->instructions());
}

}  // namespace
}  // namespace merker::station::test
