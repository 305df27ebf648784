// No page is writable and executable at once.
#include <gtest/gtest.h>

#include <cstddef>
#include <fstream>
#include <string>

#include "clock/instant.h"
#include "icode/builder.h"
#include "jit/native.h"

namespace merker::jit {
namespace {

// The smallest state there can be: compiled code knows of it what the layout says.
struct State {
  Instant horizon{1'000}, clock{};
  std::uint64_t instructions = 0;
  void* image = nullptr;
  bool rlo = false, er = false;
};

Layout layout() {
  Layout layout{.clock = offsetof(State, clock),
                .horizon = offsetof(State, horizon),
                .instructions = offsetof(State, instructions),
                .image = offsetof(State, image)};
  layout.items[static_cast<std::size_t>(icode::Item::Rlo)] = offsetof(State, rlo);
  layout.items[static_cast<std::size_t>(icode::Item::Er)] = offsetof(State, er);
  return layout;
}

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
  const auto code = compile(std::span(&region, 1), 2, {nullptr, 1}, layout());
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
    return compile(std::span(&region, 1), 2, {nullptr, 1}, layout(), options);
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
  State state;
  for (const auto& block : blocks) {
    state.horizon = state.clock + Duration{1'000};
    EXPECT_EQ(block->run(&state, 0), reinterpret_cast<const void*>(1));
  }
}

TEST(Native, LeavesClockCountAndStateBehind) {
  if (!available()) GTEST_SKIP() << "no compiler for this processor";
  const icode::Region region = twoBits();
  const auto code = compile(std::span(&region, 1), 2, {nullptr, 1}, layout());
  State state{.er = true};
  EXPECT_EQ(code->run(&state, 0), reinterpret_cast<const void*>(1));
  EXPECT_EQ(state.clock.ns, 100);
  EXPECT_EQ(state.instructions, 1u);
  EXPECT_TRUE(state.rlo);
  state.horizon = state.clock;
  EXPECT_EQ(code->run(&state, 0), nullptr) << "the horizon is reached: nothing is done";
  EXPECT_EQ(state.instructions, 1u);
}

}  // namespace
}  // namespace merker::jit
