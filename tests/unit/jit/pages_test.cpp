// No page is writable and executable at once.
#include <gtest/gtest.h>

#include <fstream>
#include <string>

#include "icode/builder.h"
#include "jit/native.h"

namespace merker::jit {
namespace {

icode::Region twoBits() {
  icode::Region region;
  icode::Builder builder(region);
  builder.begin(0, 100);
  builder.set(icode::Item::Rlo, builder.get(icode::Item::Er));
  builder.leave(1);
  icode::optimise(region);
  return region;
}

TEST(Pages, NeverWritableAndExecutable) {
  if (!available()) GTEST_SKIP() << "no compiler for this processor";
  const icode::Region region = twoBits();
  const auto code = compile(std::span(&region, 1), 2, {nullptr, 1}, defaultCpuModel());
  ASSERT_NE(code, nullptr);
  int executable = 0;
  std::ifstream maps("/proc/self/maps");
  for (std::string line; std::getline(maps, line);) {
    const std::string access = line.substr(line.find(' ') + 1, 3);
    EXPECT_NE(access, "rwx") << line;
    executable += access == "r-x" ? 1 : 0;
  }
  EXPECT_GT(executable, 0);
}

TEST(Native, LeavesClockCountAndStateBehind) {
  if (!available()) GTEST_SKIP() << "no compiler for this processor";
  const icode::Region region = twoBits();
  const auto code = compile(std::span(&region, 1), 2, {nullptr, 1}, defaultCpuModel());
  cpu::Machine m(defaultCpuModel());
  m.horizon = Instant{1000};
  m.registers.status.er = true;
  EXPECT_EQ(code->run(m, 0), reinterpret_cast<const void*>(1));
  EXPECT_EQ(m.clock.ns, 100);
  EXPECT_EQ(m.instructions, 1u);
  EXPECT_TRUE(m.registers.status.rlo);
  m.horizon = m.clock;
  EXPECT_EQ(code->run(m, 0), nullptr) << "the horizon is reached: nothing is done";
  EXPECT_EQ(m.instructions, 1u);
}

}  // namespace
}  // namespace merker::jit
