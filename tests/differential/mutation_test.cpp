// The proof of the proof: whichever emitter gives wrong code, the random programs find it. Wrong
// code may also end the process, so each runs in one of its own.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>

#include "case.h"
#include "jit/native.h"

namespace merker::differential {
namespace {

using icode::Opcode;

constexpr std::uint32_t kPrograms = 20'000;
#ifdef NDEBUG
constexpr bool kOptimised = true;
#else
constexpr bool kOptimised = false;
#endif
constexpr int kNothingFound = 0, kFound = 1;

// Constants are written by those who use them.
constexpr Opcode kWithoutEmitter[] = {Opcode::Constant};

std::vector<Opcode> emitters() {
  std::vector<Opcode> all;
#define ICODE(id, text, result, arguments, effect) all.push_back(Opcode::id);
#include "icode/icode.inc"
#undef ICODE
  for (const Opcode none : kWithoutEmitter) std::erase(all, none);
  return all;
}

[[noreturn]] void search(Opcode broken) {
  if (!difference(nestingCase(), broken).empty()) _exit(kFound);  // comes by chance too seldom
  for (std::uint32_t seed = 1; seed <= kPrograms; ++seed)
    if (!difference(randomCase(seed), broken).empty()) _exit(kFound);
  _exit(kNothingFound);
}

bool foundOrKilled(int status) {
  return WIFSIGNALED(status) || (WIFEXITED(status) && WEXITSTATUS(status) == kFound);
}

class EachEmitter : public testing::TestWithParam<Opcode> {};

TEST_P(EachEmitter, IsFoundIfBroken) {
  if (!jit::available()) GTEST_SKIP() << "no compiler for this processor";
  // A broken emitter is found or not, with sanitizers as without, where it takes ten times as long.
  if (!kOptimised) GTEST_SKIP() << "the release build shows it";
  EXPECT_EXIT(search(GetParam()), foundOrKilled, "") << icode::info(GetParam()).text;
}

INSTANTIATE_TEST_SUITE_P(Mutation, EachEmitter, testing::ValuesIn(emitters()),
                         [](const auto& test) {
                           return std::string(icode::info(test.param).text);
                         });

}  // namespace
}  // namespace merker::differential
