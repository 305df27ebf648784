#include "scenario/duration.h"

#include <gtest/gtest.h>

namespace merker::simulator {
namespace {

std::int64_t ns(std::string_view text) {
  const auto duration = parseDuration(text);
  return duration ? duration->ns : -1;
}

TEST(Duration, UnitsAsTheCommandLineWritesThem) {
  EXPECT_EQ(ns("250ms"), 250'000'000);
  EXPECT_EQ(ns("7.5s"), 7'500'000'000);
  EXPECT_EQ(ns("2m"), 120'000'000'000);
  EXPECT_EQ(ns("1h"), 3'600'000'000'000);
  EXPECT_EQ(ns("0.1ms"), 100'000);
  EXPECT_EQ(ns("100US"), 100'000);
  EXPECT_EQ(ns("0s"), 0);
}

TEST(Duration, SumsOfUnits) {
  EXPECT_EQ(ns("1m30s"), 90'000'000'000);
  EXPECT_EQ(ns(" 1h 0.5s "), 3'600'500'000'000);
}

TEST(Duration, TimeConstants) {
  EXPECT_EQ(ns("S5T#7S"), 7'000'000'000);
  EXPECT_EQ(ns("T#1S500MS"), 1'500'000'000);
  EXPECT_EQ(ns("S5TIME#2H46M30S"), 9'990'000'000'000);
}

TEST(Duration, WhatIsNoLengthOfTime) {
  for (const char* text : {"", "5", "ms", "-5s", "5x", "1.s", "s5", "W#16#5", "T#-1S", "5 5",
                           "1e3s", "99999999999999999999s", "9999999999h", "."})
    EXPECT_EQ(ns(text), -1) << text;
}

TEST(Duration, FractionsAreExact) {
  EXPECT_EQ(ns("0.123456789s"), 123'456'789);
  EXPECT_EQ(ns("0.3333333333333s"), 333'333'333);
  EXPECT_EQ(ns("0.000000001h"), 3'600);
}

TEST(Duration, Seconds) {
  EXPECT_EQ(formatSeconds(7'350'000'000, 3), "7.350");
  EXPECT_EQ(formatSeconds(99'999, 4), "0.0000");
  EXPECT_EQ(formatSeconds(100, 7), "0.0000001");
}

TEST(Duration, TimesInMessagesKeepThreeDecimals) {
  EXPECT_EQ(formatTime({6'800'000'000}), "6.800 s");
  EXPECT_EQ(formatTime({6'800'010'000}), "6.80001 s");
  EXPECT_EQ(formatTime({0}), "0.000 s");
}

}  // namespace
}  // namespace merker::simulator
