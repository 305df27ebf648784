// Outcomes on their way between processes; quantiles.
#include <gtest/gtest.h>

#include "campaign/quantile.h"
#include "campaign/wire.h"

namespace merker::campaign {
namespace {

TEST(Wire, AnOutcomeArrivesAsItWas) {
  const Outcome outcome{false, "fill.scn:3: expected A 1.0", 0.1, 7, {0.1, std::nullopt, -1e300}};
  std::string line = encode(41, outcome);
  ASSERT_EQ(line.back(), '\n');
  line.pop_back();
  const auto arrived = decode(line);
  ASSERT_TRUE(arrived);
  EXPECT_EQ(arrived->number, 41u);
  EXPECT_EQ(arrived->outcome, outcome);
}

TEST(Wire, ALineIsShortAndOneLine) {
  Outcome outcome{false, "a\nb\t" + std::string(10'000, 'c'), 1, 1, {}};
  outcome.measures.assign(kMostMeasures, -1.2345678901234567e-300);
  const std::string line = encode(999'999, outcome);
  EXPECT_LT(line.size(), 4096u);
  EXPECT_EQ(line.find('\n'), line.size() - 1);
  EXPECT_EQ(decode(line.substr(0, line.size() - 1))->outcome.message.substr(0, 5), "a b c");
}

TEST(Wire, ACutMessageEndsWithAWholeCharacter) {
  const Outcome outcome{false, std::string(999, 'a') + "äöü", 1, 1, {}};
  EXPECT_EQ(decode(encode(0, outcome))->outcome.message.substr(990, 9), "aaaaaaaaa");
  EXPECT_EQ(decode(encode(0, outcome))->outcome.message.find('\xC3'), std::string::npos);
}

TEST(Wire, WhatIsNoOutcomeIsNone) {
  for (const char* line : {"", "1", "1\t1\t1\t1\t2\t0.5", "x\t1\t1\t1\t0\t", "1\t1\t1\t1\t65\t"})
    EXPECT_FALSE(decode(line)) << line;
}

TEST(Quantile, LiesBetweenTwoValues) {
  const std::vector<double> values{1, 2, 4, 8};
  EXPECT_EQ(quantile(values, 0), 1);
  EXPECT_EQ(quantile(values, 0.5), 3);
  EXPECT_EQ(quantile(values, 0.25), 1.75);  // numpy.quantile([1, 2, 4, 8], 0.25)
  EXPECT_EQ(quantile(values, 1), 8);
  EXPECT_EQ(quantile({5}, 0.95), 5);
}

}  // namespace
}  // namespace merker::campaign
