// STEP 5: cycles that are passed over against cycles that are computed. Every row of the
// instruction tables between loads and a look at what it left, and random programs, on both
// engines.
#include <gtest/gtest.h>

#include <iostream>

#include "case.h"
#include "jit/native.h"
#include "mc5/encoding.h"

namespace merker::differential5 {
namespace {

#ifdef NDEBUG
constexpr std::uint32_t kPerRow = 12, kPrograms = 2'000;
#else
constexpr std::uint32_t kPerRow = 2, kPrograms = 100;
#endif

class Step5Quiet : public testing::Test {
 protected:
  // False: enough was found.
  bool check(const Case& c, std::string_view name, bool compiled) {
    const Outcome outcome = runQuiet(c, compiled && jit::available());
    cycles_ += outcome.cycles;
    passed_ += outcome.passed;
    if (outcome.difference.empty()) return true;
    ADD_FAILURE() << name << ", seed " << c.seed << " (first passes over)\n"
                  << outcome.difference << listing(c);
    return ++found_ < 3;
  }
  void TearDown() override {
    std::cout << passed_ << " of " << cycles_ << " cycles passed over\n";
    EXPECT_GT(passed_, cycles_ / 10) << "nothing is tested";
  }

 private:
  int found_ = 0;
  std::uint64_t cycles_ = 0, passed_ = 0;
};

TEST_F(Step5Quiet, EveryRow) {
  for (std::size_t row = 0; row < mc5::encodings().size(); ++row)
    for (std::uint32_t i = 0; i < kPerRow; ++i) {
      const Case c = rowCase(row, static_cast<std::uint32_t>(row) * 1000 + i);
      if (!check(c, mc5::encodings()[row].pattern, i % 2 != 0)) return;
    }
}

TEST_F(Step5Quiet, RandomPrograms) {
  for (std::uint32_t seed = 1; seed <= kPrograms; ++seed)
    if (!check(randomCase(seed), "random program", seed % 2 != 0)) return;
}

}  // namespace
}  // namespace merker::differential5
