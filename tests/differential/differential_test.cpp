// Interpreter against compiled code: every row of the instruction tables, random programs with
// interrupts, and each difference that was ever found. MERKER_DIFFERENTIAL=<first seed>:<count>
// runs other random programs and says how far it is (tools/differential).
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>

#include "case.h"
#include "jit/native.h"
#include "mc7/encoding.h"

namespace merker::differential {
namespace {

constexpr std::uint32_t kProgress = 100'000, kParts = 8;
#ifdef NDEBUG
constexpr std::uint32_t kPerRow = 12, kPrograms = 24'000, kNested = 1'200;
#else
constexpr std::uint32_t kPerRow = 4, kPrograms = 1'000,
                        kNested = 100;  // with sanitizers each takes ten times as long
#endif

std::string report(const Case& c) {
  const Case small = shrink(c);
  return toText(small) + listing(small) + difference(small);
}

struct Seeds {
  std::uint32_t first = 1, count = kPrograms;
  bool wished = false;
};
Seeds seeds() {
  Seeds s;
  if (const char* text = std::getenv("MERKER_DIFFERENTIAL")) {
    char colon = 0;
    std::istringstream(text) >> s.first >> colon >> s.count;
    s.wished = true;
  }
  return s;
}

// Where a part begins.
std::uint32_t share(std::uint32_t count, std::uint32_t part) {
  return static_cast<std::uint32_t>(std::uint64_t{count} * part / kParts);
}

class Differential : public testing::Test {
 protected:
  void SetUp() override {
    if (!jit::available()) GTEST_SKIP() << "no compiler for this processor";
  }
};

TEST_F(Differential, EveryRow) {
  int found = 0;
  for (std::size_t row = 0; row < mc7::encodings().size(); ++row)
    for (std::uint32_t i = 0; i < kPerRow; ++i) {
      const Case c = rowCase(row, static_cast<std::uint32_t>(row) * 1000 + i);
      if (difference(c).empty()) continue;
      ADD_FAILURE() << report(c);
      if (++found == 3) return;
      break;
    }
}

// S7-INSTR-92 to S7-INSTR-95 among them: ITB of 1000 sets OV and OS and leaves ACCU 1.
TEST_F(Differential, EdgesOfNumbers) {
  int found = 0, cases = 0;
  for (std::size_t row = 0; row < mc7::encodings().size(); ++row)
    for (const std::uint32_t distance : {0u, 1u, 2u, 7u, 13u})
      for (const bool known : {false, true}) {
        const auto c = edgeCase(row, distance, known);
        if (!c) continue;
        ++cases;
        if (const std::string difference = differential::difference(*c); !difference.empty()) {
          ADD_FAILURE() << mc7::encodings()[row].pattern << '\n' << difference;
          if (++found == 3) return;
        }
      }
  EXPECT_GT(cases, 1'000);
}

TEST_F(Differential, TimersThatEndAtAnInstruction) {
  constexpr std::uint32_t kCases = 600;
  for (std::uint32_t seed = 1; seed <= kCases; ++seed)
    ASSERT_EQ(difference(timerCase(seed)), "") << "seed " << seed << '\n'
                                               << listing(timerCase(seed));
}

TEST_F(Differential, ExchangedBlocksHaveEachOthersLengths) {
  for (std::uint32_t seed = 1; seed <= 400; ++seed)
    ASSERT_EQ(difference(swapCase(seed)), "") << "seed " << seed << '\n' << listing(swapCase(seed));
}

TEST_F(Differential, BlocksNestToTheSameDepth) { ASSERT_EQ(difference(nestingCase()), ""); }

// A block copied into its caller's region gives back what its caller had, wherever it is left.
TEST_F(Differential, CallsInCallsGiveBackRegisters) {
  const Seeds s = seeds();
  const std::uint32_t end = s.first + (s.wished ? s.count : kNested);
  int found = 0;
  for (std::uint32_t seed = s.first; seed < end && found < 3; ++seed) {
    const Case c = nestedCase(seed);
    ASSERT_TRUE(c.blocks.contains({BlockKind::OB, 1})) << "seed " << seed << " does not compile";
    if (difference(c).empty()) continue;
    ADD_FAILURE() << "seed " << seed << '\n' << report(c);
    ++found;
  }
}

// In parts, for those who share the work (GTEST_TOTAL_SHARDS).
class DifferentialPart : public Differential, public testing::WithParamInterface<std::uint32_t> {};

TEST_P(DifferentialPart, RandomPrograms) {
  const Seeds s = seeds();
  int found = 0;
  for (std::uint32_t i = share(s.count, GetParam()); i < share(s.count, GetParam() + 1); ++i) {
    const Case c = randomCase(s.first + i);
    if (s.wished && i % kProgress == 0) std::cout << i << " of " << s.count << std::endl;
    if (difference(c).empty()) continue;
    ADD_FAILURE() << "seed " << s.first + i << '\n' << report(c);
    if (++found == 3) return;
  }
}

INSTANTIATE_TEST_SUITE_P(Random, DifferentialPart, testing::Range(0u, kParts));

// So few that most blocks only compile with short regions.
TEST_F(Differential, FewSlots) {
  constexpr std::uint32_t kCases = 3'000, kSlots = 2;
  for (std::uint32_t seed = 1; seed <= kCases; ++seed)
    ASSERT_EQ(difference(randomCase(seed), {}, kSlots), "") << "seed " << seed;
}

TEST_F(Differential, CasesFoundBefore) {
  const std::filesystem::path folder = MERKER_SOURCE_DIR "/tests/differential/cases";
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() != ".case") continue;
    std::stringstream text;
    text << std::ifstream(entry.path()).rdbuf();
    const auto c = fromText(text.str());
    ASSERT_TRUE(c) << entry.path();
    EXPECT_EQ(difference(*c), "") << entry.path() << '\n' << listing(*c);
  }
}

}  // namespace
}  // namespace merker::differential
