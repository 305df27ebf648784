#include "scenario/comparison.h"

#include <gtest/gtest.h>

#include "operands.h"

namespace merker::simulator {
namespace {

using block::Relation;

struct Outcome {
  bool holds;
  std::string actual;
};

// One value for every operand; of timers and counters the status bit is `status`.
Outcome check(std::uint32_t bits, const char* left, Relation relation, const char* right,
              std::uint32_t status = 0) {
  const Reader read = [&](const address::Reference& reference) -> std::optional<std::uint32_t> {
    const bool memory = reference.operand.kind == address::OperandKind::Memory;
    return !memory && reference.operand.width == Width::Bit ? status : bits;
  };
  return {holds(term(left), relation, term(right), read),
          actualValue(term(left), term(right), read)};
}

bool equal(std::uint32_t bits, const char* left, const char* right, std::uint32_t status = 0) {
  return check(bits, left, Relation::Equal, right, status).holds;
}

TEST(Comparison, TheNarrowerSideIsFilledUpWithZeros) {
  EXPECT_TRUE(equal(5, "MW 10", "B#16#05"));
  EXPECT_TRUE(equal(0xFFFB, "MW 10", "-5"));
  EXPECT_TRUE(equal(0xFFFFFFFB, "MD 4", "-5"));
  EXPECT_FALSE(equal(0x0000FFFB, "MD 4", "-5"));
  EXPECT_TRUE(equal(0xFFFFFFFB, "MD 4", "L#-5"));
  EXPECT_TRUE(equal(1, "M 1.0", "TRUE"));
}

TEST(Comparison, RawBitsAreUnsigned) {
  EXPECT_TRUE(check(0xFFFB, "MW 10", Relation::Greater, "W#16#5").holds);
  EXPECT_FALSE(check(0xFFFB, "MW 10", Relation::Less, "W#16#5").holds);
  EXPECT_TRUE(check(0xFFFFFFFB, "MD 4", Relation::Greater, "DW#16#5").holds);
}

// What fails says the number that was compared.
TEST(Comparison, BesideAnIntegerTheSignCounts) {
  EXPECT_TRUE(check(0xFFFB, "MW 10", Relation::Less, "5").holds);
  EXPECT_TRUE(check(0xFFFFFFFB, "MD 4", Relation::Less, "5").holds);
  EXPECT_TRUE(check(0xFFFFFFFB, "MD 4", Relation::LessEqual, "-5").holds);
  EXPECT_TRUE(equal(0xFFFB, "MW 10", "L#-5"));
  EXPECT_EQ(check(0xFFFB, "MW 10", Relation::Greater, "5").actual, "-5");
  EXPECT_EQ(check(0xFFFB, "MW 10", Relation::Greater, "L#5").actual, "-5");
  EXPECT_EQ(check(0xFFFFFFFA, "MD 4", Relation::Equal, "-5").actual, "L#-6");
  // no place with sign: L#40000 in a word, 200 in a byte
  EXPECT_TRUE(equal(40000, "MW 10", "L#40000"));
  EXPECT_TRUE(check(0xFFFF, "MW 10", Relation::Greater, "L#40000").holds);
  EXPECT_TRUE(equal(200, "MB 3", "200"));
  EXPECT_TRUE(check(200, "MB 3", Relation::Greater, "5").holds);
  EXPECT_TRUE(equal(0xFF, "MB 3", "-1"));
  EXPECT_TRUE(check(0xFFFB, "5", Relation::Greater, "MW 10").holds);
  EXPECT_TRUE(equal(1, "M 1.0", "1"));
}

TEST(Comparison, TypedVariablesAreOrderedAsTheirType) {
  EXPECT_TRUE(check(0xFFFB, "int", Relation::Less, "5").holds);
  EXPECT_TRUE(check(0xFFFFFFFB, "dint", Relation::Less, "L#5").holds);
  EXPECT_TRUE(check(0xFFFFFFFB, "dint", Relation::Equal, "-5").holds);
  EXPECT_TRUE(check(0xC0000000, "real", Relation::Less, "-1.5").holds);
  EXPECT_TRUE(check(0x40A00000, "real", Relation::Equal, "5").holds);
  EXPECT_TRUE(check(500, "time", Relation::GreaterEqual, "T#500MS").holds);
}

TEST(Comparison, EveryRelation) {
  EXPECT_TRUE(check(5, "MW 10", Relation::NotEqual, "6").holds);
  EXPECT_FALSE(check(5, "MW 10", Relation::NotEqual, "5").holds);
  EXPECT_TRUE(check(5, "MW 10", Relation::LessEqual, "5").holds);
  EXPECT_TRUE(check(5, "MW 10", Relation::GreaterEqual, "5").holds);
  EXPECT_FALSE(check(5, "MW 10", Relation::Greater, "5").holds);
  EXPECT_FALSE(check(5, "MW 10", Relation::Less, "5").holds);
}

TEST(Comparison, RealCountsWithItsPatternAndAboutWithinAMillionth) {
  EXPECT_TRUE(equal(0x3FC00000, "MD 4", "1.5"));
  EXPECT_FALSE(equal(0x3FC00001, "MD 4", "1.5"));
  EXPECT_TRUE(check(0x3FC00001, "MD 4", Relation::About, "1.5").holds);
  EXPECT_FALSE(check(0x3FC00020, "MD 4", Relation::About, "1.5").holds);  // 2.5e-6 away
  EXPECT_TRUE(check(0x80000000, "MD 4", Relation::About, "0.0").holds);
  EXPECT_FALSE(check(0x7FC00000, "MD 4", Relation::About, "1.0").holds);  // not a number
}

TEST(Comparison, ATimerIsItsStatusBitBesideZeroAndOne) {
  EXPECT_TRUE(equal(0x2005, "T 1", "1", 1));
  EXPECT_TRUE(equal(0x2005, "T 1", "TRUE", 1));
  EXPECT_TRUE(equal(0x2005, "T 1", "0", 0));
  EXPECT_FALSE(equal(0x2005, "T 1", "FALSE", 1));
}

TEST(Comparison, ATimerIsItsCodedValueBesideS5TimeAndItsNumberElse) {
  EXPECT_TRUE(equal(0x2005, "T 1", "S5T#5S", 1));  // counted in seconds, as S5T#1000S was
  EXPECT_TRUE(equal(0x0500, "T 1", "S5T#5S", 1));
  EXPECT_FALSE(equal(0x1005, "T 1", "S5T#5S", 1));
  EXPECT_TRUE(check(0x2005, "T 1", Relation::Less, "S5T#5S10MS", 1).holds);
  EXPECT_TRUE(equal(0x2125, "T 1", "125", 1));
  EXPECT_TRUE(check(0x2125, "T 1", Relation::LessEqual, "W#16#7D", 1).holds);
}

TEST(Comparison, ACounterIsItsCount) {
  EXPECT_TRUE(equal(0x0123, "Z 1", "123", 1));
  EXPECT_TRUE(equal(0x0001, "Z 1", "1", 1));
  EXPECT_FALSE(equal(0x0002, "Z 1", "1", 1));
  EXPECT_TRUE(equal(0x0123, "Z 1", "C#123", 1));
  EXPECT_TRUE(equal(0x0123, "Z 1", "TRUE", 1));
  EXPECT_TRUE(equal(0x0000, "Z 1", "FALSE", 0));
}

TEST(Comparison, TheActualValueIsWrittenLikeTheExpectedOne) {
  EXPECT_EQ(check(0x10, "MW 10", Relation::Equal, "5").actual, "16");
  EXPECT_EQ(check(0x10, "MW 10", Relation::Equal, "W#16#5").actual, "W#16#0010");
  EXPECT_EQ(check(0x12345, "MD 4", Relation::Equal, "5").actual, "L#74565");
  EXPECT_EQ(check(0x1234, "MW 10", Relation::Equal, "B#16#05").actual, "W#16#1234");
  EXPECT_EQ(check(1, "M 1.0", Relation::Equal, "FALSE").actual, "1");
  EXPECT_EQ(check(0x2005, "T 1", Relation::Equal, "S5T#2S").actual, "S5T#5S");
  EXPECT_EQ(check(0x2005, "T 1", Relation::Equal, "0", 1).actual, "1");
  EXPECT_EQ(check(7, "MW 10", Relation::Less, "MB 3").actual, "W#16#0007, MB 3 is B#16#07");
}

TEST(Comparison, WhatDoesNotExistHoldsNever) {
  const Reader nothing = [](const address::Reference&) -> std::optional<std::uint32_t> {
    return std::nullopt;
  };
  EXPECT_FALSE(holds(term("MW 10"), Relation::NotEqual, term("5"), nothing));
  EXPECT_EQ(actualValue(term("MW 10"), term("5"), nothing), "not there: MW 10 does not exist");
}

}  // namespace
}  // namespace merker::simulator
