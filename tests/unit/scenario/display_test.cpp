#include "scenario/display.h"

#include <gtest/gtest.h>

#include "operands.h"

namespace merker::simulator {
namespace {

address::Reference timer() { return {"T 1", address::timer(1)}; }
address::Reference counter() { return {"Z 1", address::counter(1)}; }

TEST(Display, PlainOperandsInHexadecimal) {
  EXPECT_EQ(formatOperand(flag(Width::Bit, 0), 1), "1");
  EXPECT_EQ(formatOperand(flag(Width::Bit, 0, TypeCode::Bool), 0), "0");
  EXPECT_EQ(formatOperand(flag(Width::Byte, 0), 5), "B#16#05");
  EXPECT_EQ(formatOperand(flag(Width::Word, 0), 5), "W#16#0005");
  EXPECT_EQ(formatOperand(flag(Width::DWord, 0), 5), "DW#16#00000005");
}

TEST(Display, TypedVariablesInTheirOwnNotation) {
  EXPECT_EQ(formatOperand(flag(Width::Word, 0, TypeCode::Int), 0xFFFB), "-5");
  EXPECT_EQ(formatOperand(flag(Width::DWord, 0, TypeCode::Time), 5000), "T#5S");
  EXPECT_EQ(formatOperand(flag(Width::DWord, 0, TypeCode::Real), 0x3FC00000), "1.500000e+000");
}

TEST(Display, TimersAndCounters) {
  EXPECT_EQ(formatOperand(timer(), 0x2005), "S5T#5S");
  EXPECT_EQ(formatOperand(counter(), 0x0123), "C#123");
}

TEST(Display, Numbers) {
  using Value = std::variant<bool, std::int64_t, double>;
  EXPECT_EQ(numericValue(flag(Width::Bit, 0), 1), Value(true));
  EXPECT_EQ(numericValue(flag(Width::Word, 0), 0xFFFB), Value(std::int64_t{65531}));
  EXPECT_EQ(numericValue(flag(Width::Word, 0, TypeCode::Int), 0xFFFB), Value(std::int64_t{-5}));
  EXPECT_EQ(numericValue(flag(Width::DWord, 0, TypeCode::DInt), 0xFFFFFFFB),
            Value(std::int64_t{-5}));
  EXPECT_EQ(numericValue(flag(Width::DWord, 0, TypeCode::Real), 0x3FC00000), Value(1.5));
  EXPECT_EQ(numericValue(timer(), 0x2005), Value(std::int64_t{5000}));
  EXPECT_EQ(numericValue(counter(), 0x0123), Value(std::int64_t{123}));
}

}  // namespace
}  // namespace merker::simulator
