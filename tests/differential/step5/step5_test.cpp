// STEP 5: the processor against compiled code. Every row of the instruction tables, random programs
// with alarm levels, and the proof that a broken emitter is found.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>

#include "../edges.h"
#include "case.h"
#include "jit/native.h"
#include "mc5/encoding.h"
#include "step5/compiler.h"

namespace merker::differential5 {
namespace {

using icode::Opcode;

constexpr std::uint32_t kSearched = 1'000, kParts = 6;
#ifdef NDEBUG
constexpr bool kOptimised = true;
constexpr std::uint32_t kPerRow = 12, kPrograms = 6'000;
#else  // with sanitizers each takes ten times as long
constexpr bool kOptimised = false;
constexpr std::uint32_t kPerRow = 4, kPrograms = 600;
#endif

struct Seeds {
  std::uint32_t first = 1, count = kPrograms;
};
// MERKER_DIFFERENTIAL=<first seed>:<count> runs other random programs.
Seeds seeds() {
  Seeds s;
  char colon = 0;
  if (const char* text = std::getenv("MERKER_DIFFERENTIAL"))
    std::istringstream(text) >> s.first >> colon >> s.count;
  return s;
}

class Step5Differential : public testing::Test {
 protected:
  void SetUp() override {
    if (!jit::available()) GTEST_SKIP() << "no compiler for this processor";
  }
};

TEST_F(Step5Differential, EveryRow) {
  int found = 0;
  for (std::size_t row = 0; row < mc5::encodings().size(); ++row)
    for (std::uint32_t i = 0; i < kPerRow; ++i) {
      const Case c = rowCase(row, static_cast<std::uint32_t>(row) * 1000 + i);
      const Outcome outcome = run(c);
      if (outcome.difference.empty()) continue;
      ADD_FAILURE() << mc5::encodings()[row].pattern << '\n' << outcome.difference << listing(c);
      if (++found == 3) return;
      break;
    }
}

TEST_F(Step5Differential, EdgesOfNumbers) {
  for (std::size_t row = 0; row < mc5::encodings().size(); ++row)
    for (std::size_t edge = 0; edge < std::size(differential::kEdges); edge += 4) {
      const Case c = rowCase(row, static_cast<std::uint32_t>(row), edge);
      ASSERT_EQ(run(c).difference, "") << mc5::encodings()[row].pattern << '\n' << listing(c);
    }
}

std::vector<std::string> listings() {
  std::vector<std::string> paths;
  for (const char* folder : {"/tests/conformance", "/examples"})
    for (const auto& entry :
         std::filesystem::recursive_directory_iterator(MERKER_SOURCE_DIR + std::string(folder)))
      if (entry.path().extension() == ".s5" &&
          entry.path().string().find("rejected") == std::string::npos)
        paths.push_back(entry.path().string());
  std::sort(paths.begin(), paths.end());
  return paths;
}

// As people write them, without their checks; their terminals change.
TEST_F(Step5Differential, ConformanceAndExamples) {
  int compared = 0;
  for (const std::string& path : listings()) {
    std::stringstream text;
    text << std::ifstream(path).rdbuf();
    std::vector<source::SourceFile> files;
    files.emplace_back(path, text.str());
    step5::Compilation compiled = step5::compile(files, false);
    if (!compiled.ok()) continue;  // needs its project's other files
    for (const std::uint32_t seed : {1u, 2u, 3u, 4u})
      EXPECT_EQ(run({.seed = seed, .program = compiled.program}).difference, "") << path;
    ++compared;
  }
  EXPECT_GT(compared, 30);
}

// S5-SYS-02: what was written is executed, not what was compiled.
TEST_F(Step5Differential, CodeThatWritesCode) {
  for (std::uint32_t seed = 1; seed <= 30; ++seed)
    EXPECT_EQ(run(writingCase(seed)).difference, "") << seed;
}

// From block to block without the processor: but for the end of OB 1 and what the engine was off.
TEST_F(Step5Differential, CallsStayCompiled) {
  std::uint64_t instructions = 0, compiled = 0;
  for (std::uint32_t seed = 1; seed <= 30; ++seed) {
    const Outcome outcome = run(callingCase(seed));
    EXPECT_EQ(outcome.difference, "") << seed;
    instructions += outcome.instructions;
    compiled += outcome.compiled;
  }
  EXPECT_GT(compiled * 100, instructions * 80) << compiled << " of " << instructions;
}

// In parts, for those who share the work (GTEST_TOTAL_SHARDS).
class Step5Part : public Step5Differential, public testing::WithParamInterface<std::uint32_t> {};
INSTANTIATE_TEST_SUITE_P(Random, Step5Part, testing::Range(0u, kParts));

TEST_P(Step5Part, RandomPrograms) {
  const Seeds s = seeds();
  const std::uint32_t size = s.count / kParts;
  std::uint64_t instructions = 0, compiled = 0;
  for (std::uint32_t i = size * GetParam(); i < size * (GetParam() + 1); ++i) {
    Case c = randomCase(s.first + i);
    c.watched = (s.first + i) % 4 == 0;
    const Outcome outcome = run(c);
    instructions += outcome.instructions;
    compiled += outcome.compiled;
    ASSERT_EQ(outcome.difference, "") << "seed " << c.seed << '\n' << listing(c);
  }
  std::cout << compiled << " of " << instructions << " instructions ran compiled\n";
  EXPECT_GT(compiled * 2, instructions);
}

// What compiled STEP 5 uses of the intermediate code; but for SwapBytes, of which the lowest bit,
// the one that is broken, is cut off, and Limit: no number of a word leads to the end of segment 6.
// CanCall and CanReturn are the looks at the block stack in front of an exit that calls or returns.
constexpr Opcode kUsed[] = {
    Opcode::Get,       Opcode::Base,       Opcode::Load8,    Opcode::Load16,   Opcode::Load32,
    Opcode::Store8,    Opcode::Store16,    Opcode::Store32,  Opcode::BitOf,    Opcode::Insert,
    Opcode::SetWhere,  Opcode::ClearWhere, Opcode::AndBit,   Opcode::OrBit,    Opcode::XorBit,
    Opcode::NotBit,    Opcode::ToWord,     Opcode::Equal,    Opcode::NotEqual, Opcode::Less,
    Opcode::LessEqual, Opcode::Below,      Opcode::Add,      Opcode::Sub,      Opcode::Mul,
    Opcode::And,       Opcode::Or,         Opcode::Xor,      Opcode::Div,      Opcode::Mod,
    Opcode::Neg,       Opcode::Not,        Opcode::Shl,      Opcode::Shr,      Opcode::Sar,
    Opcode::Sext16,    Opcode::Zext16,     Opcode::Zext8,    Opcode::LowFrom,  Opcode::ByteFrom,
    Opcode::Guard,     Opcode::BranchIf,   Opcode::Leave,    Opcode::Index,    Opcode::WriteLimit,
    Opcode::Open,      Opcode::CanCall,    Opcode::CanReturn};
constexpr int kNothingFound = 0, kFound = 1;

[[noreturn]] void search(Opcode broken) {
  for (std::uint32_t i = 0; i < kPerRow; ++i)
    for (std::size_t row = 0; row < mc5::encodings().size(); ++row)
      if (!run(rowCase(row, i), broken).difference.empty()) _exit(kFound);
  for (std::uint32_t seed = 1; seed <= kSearched; ++seed)
    if (!run(randomCase(seed), broken).difference.empty()) _exit(kFound);
  _exit(kNothingFound);
}

bool foundOrKilled(int status) {
  return WIFSIGNALED(status) || (WIFEXITED(status) && WEXITSTATUS(status) == kFound);
}

class Step5Emitter : public testing::TestWithParam<Opcode> {};

TEST_P(Step5Emitter, IsFoundIfBroken) {
  if (!jit::available()) GTEST_SKIP() << "no compiler for this processor";
  // A broken emitter is found or not, with sanitizers as without, where it takes ten times as long.
  if (!kOptimised) GTEST_SKIP() << "the release build shows it";
  EXPECT_EXIT(search(GetParam()), foundOrKilled, "") << icode::info(GetParam()).text;
}

INSTANTIATE_TEST_SUITE_P(Mutation, Step5Emitter, testing::ValuesIn(kUsed), [](const auto& test) {
  return std::string(icode::info(test.param).text);
});

}  // namespace
}  // namespace merker::differential5
