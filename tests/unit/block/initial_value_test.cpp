// Start values in the bytes of a frame.
#include <gtest/gtest.h>

#include "make.h"

namespace merker::block {
namespace {

using Bytes = std::vector<std::uint8_t>;

Bytes frame(std::vector<Variable> variables) {
  Bytes image(layOut(variables, 0, true) / 8);
  for (const Variable& v : variables) writeInitial(v, v.address, image);
  return image;
}

TEST(InitialValue, BitsAndNumbersLieWhereTheVariableLies) {
  EXPECT_EQ(frame({var(TypeCode::Bool), var(TypeCode::Bool, Section::Static, {1}),
                   var(TypeCode::Int, Section::Static, {0x12, 0x34}), var(TypeCode::Byte)}),
            (Bytes{0x02, 0, 0x12, 0x34, 0, 0}));
}

// S7-TYPES-19: STRING[4] := 'AB' is 04 02 41 42 00 00; without a value 04 00.
TEST(InitialValue, StringsBringTheirLengths) {
  EXPECT_EQ(
      frame({var(stringType(4), Section::Static, {4, 2, 'A', 'B', 0, 0}), var(stringType(4))}),
      (Bytes{4, 2, 'A', 'B', 0, 0, 4, 0, 0, 0, 0, 0}));
}

// As a container may have it: said to be there, but without a byte.
TEST(InitialValue, AnEmptyOneIsTheDefault) {
  Variable text = var(stringType(4));
  text.hasInitial = true;
  text.initial.clear();
  EXPECT_EQ(frame({text}), (Bytes{4, 0, 0, 0, 0, 0}));
  text.hasInitial = false;
  text.initial = {4, 1, 'A', 0, 0, 0};
  EXPECT_EQ(frame({text}), (Bytes{4, 0, 0, 0, 0, 0}));
}

// S7-TYPES-18: DT#1990-01-01-00:00:00.000, a Monday (2).
TEST(InitialValue, DateAndTimeBeginsIn1990) {
  EXPECT_EQ(frame({var(TypeCode::DateAndTime)}), (Bytes{0x90, 0x01, 0x01, 0, 0, 0, 0, 0x02}));
}

TEST(InitialValue, ReachesIntoArraysAndStructures) {
  const TypePtr inner = structType({var(TypeCode::Byte, Section::Static, {7}), var(stringType(2))});
  EXPECT_EQ(frame({var(TypeCode::Int), var(arrayType({{1, 2}}, inner))}),
            (Bytes{0, 0, 7, 0, 2, 0, 0, 0, 7, 0, 2, 0, 0, 0}));
}

TEST(InitialValue, AnArrayIsWrittenAsAWhole) {
  EXPECT_EQ(
      frame({var(arrayType({{0, 2}}, elementaryType(TypeCode::Bool)), Section::Static, {0x05, 0})}),
      (Bytes{0x05, 0}));
}

TEST(InitialValue, PointersOfInOutParametersAreZero) {
  EXPECT_EQ(frame({var(stringType(10), Section::InOut)}), Bytes(6));
}

TEST(InitialValue, TheImageGrowsWhereItIsTooShort) {
  Bytes image;
  writeInitial(var(TypeCode::Word, Section::Static, {1, 2}), bitAddress(4), image);
  EXPECT_EQ(image, (Bytes{0, 0, 0, 0, 1, 2}));
}

}  // namespace
}  // namespace merker::block
