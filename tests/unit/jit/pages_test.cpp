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

std::uintptr_t place(const NativeCode& code) {
  return reinterpret_cast<std::uintptr_t>(code.entries()[0]);
}

// A thousand small blocks on a page each would be slower than the interpreter.
TEST(Pages, BlocksLieSideBySideAndGiveTheirRoomBack) {
  if (!available()) GTEST_SKIP() << "no compiler for this processor";
  const icode::Region region = twoBits();
  const Options options;
  const auto one = [&] {
    return compile(std::span(&region, 1), 2, {nullptr, 1}, defaultCpuModel(), options);
  };
  std::vector<std::unique_ptr<NativeCode>> blocks;
  for (int i = 0; i < 20; ++i) blocks.push_back(one());
  const std::uintptr_t first = place(*blocks[0]);
  for (std::size_t i = 1; i < blocks.size(); ++i) {
    const std::uintptr_t apart = place(*blocks[i]) - place(*blocks[i - 1]);
    EXPECT_GE(apart, blocks[i]->size());
    EXPECT_LT(apart, blocks[i]->size() + 64);
  }
  blocks.clear();
  EXPECT_EQ(place(*one()), first);
  for (int i = 0; i < 1'000; ++i) blocks.push_back(one());  // more than one lot of pages
  cpu::Machine m(defaultCpuModel());
  for (const auto& block : blocks) {
    m.horizon = m.clock + Duration{1'000};
    EXPECT_EQ(block->run(m, 0), reinterpret_cast<const void*>(1));
  }
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
