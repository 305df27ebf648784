#include "scenario/self_check.h"

#include <gtest/gtest.h>

#include "machine.h"

namespace merker::simulator {
namespace {

TestResult run(const std::string& instructions) {
  const Machine machine(
      "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\n" + instructions + "END_ORGANIZATION_BLOCK\n",
      true);
  station::Station station = machine.station();
  return runSelfChecks("test.awl", station);
}

constexpr const char* kStop = "CALL SFC 46\n";

TEST(SelfCheck, WhetherASourceHasChecks) {
  EXPECT_TRUE(hasChecks("      +I     //= AKKU1 = 5\n"));
  EXPECT_FALSE(hasChecks("      +I     // = 5\n"));
}

TEST(SelfCheck, PassesWhenAllTermsHoldAndStopsAtOnce) {
  const TestResult result =
      run(std::string("L 32767\nL 1\n+I //= AKKU1 = W#16#8000, A1 = 0, A0 = 1, OV = 1, OS = 1\n") +
          kStop);
  EXPECT_TRUE(result.passed()) << result.failures[0].message;
  EXPECT_LT(result.end, Instant{1'000'000'000});
}

TEST(SelfCheck, AFailedTermNamesLineAndValues) {
  const TestResult result = run(std::string("L 5\nL 1\n+I //= AKKU1 = 7\n") + kStop);
  ASSERT_EQ(result.failures.size(), 1u);
  EXPECT_EQ(result.failures[0].position.line, 6u);
  EXPECT_NE(result.failures[0].message.find("AKKU1 = 7"), std::string::npos)
      << result.failures[0].message;
}

TEST(SelfCheck, AFailureHasTheTimeOfItsJudgement) {
  const TestResult result = run("L 5 //= AKKU1 = 6\n");
  ASSERT_FALSE(result.failures.empty());
  EXPECT_GE(result.end, Instant{10'000'000'000});
  EXPECT_LT(result.failures[0].time, Instant{100'000'000});
}

TEST(SelfCheck, ALineThatIsNeverReachedFails) {
  const TestResult result = run(std::string("SPA over\nL 5 //= AKKU1 = 5\nover: NOP 0\n") + kStop);
  ASSERT_EQ(result.failures.size(), 1u);
  EXPECT_EQ(result.failures[0].position.line, 5u);
  EXPECT_EQ(result.failures[0].message, "the check was never reached");
}

TEST(SelfCheck, AProgramThatDoesNotStopRunsTenSeconds) {
  const TestResult result = run("L 5 //= AKKU1 = 5\n");
  EXPECT_TRUE(result.passed());
  EXPECT_GE(result.end, Instant{10'000'000'000});
}

TEST(SelfCheck, AFaultFails) {
  const TestResult result = run("L W#16#FFFF //= AKKU1 = W#16#FFFF\nBTI\n");
  ASSERT_EQ(result.failures.size(), 1u);
  EXPECT_TRUE(result.failures[0].message.starts_with("the CPU went to STOP: "))
      << result.failures[0].message;
}

}  // namespace
}  // namespace merker::simulator
