// Places and sizes of variables (S7-TYPES-19, -20, -21, -27, S7-PAR-03, -04).
#include "block/type.h"

#include <gtest/gtest.h>

#include "make.h"

namespace merker::block {
namespace {

std::vector<BitAddress> places(std::vector<Variable> variables, BitAddress start = 0) {
  layOut(variables, start, true);
  std::vector<BitAddress> result;
  for (const Variable& v : variables) result.push_back(v.address);
  return result;
}

// S7-TYPES-27: BOOL, BYTE, INT, BOOL, REAL lie at 0.0, 1.0, 2.0, 4.0, 6.0.
TEST(Layout, ElementaryTypes) {
  EXPECT_EQ(places({var(TypeCode::Bool), var(TypeCode::Byte), var(TypeCode::Int),
                    var(TypeCode::Bool), var(TypeCode::Real)}),
            (std::vector<BitAddress>{0, 8, 16, 32, 48}));
}

TEST(Layout, BitsFollowEachOtherBytesBeginAtTheNextByte) {
  EXPECT_EQ(places({var(TypeCode::Bool), var(TypeCode::Bool), var(TypeCode::Char),
                    var(TypeCode::Char), var(TypeCode::Bool), var(TypeCode::Byte)}),
            (std::vector<BitAddress>{0, 1, 8, 16, 24, 32}));
}

TEST(Layout, ReturnsTheFirstFreeBit) {
  std::vector<Variable> variables{var(TypeCode::Int), var(TypeCode::Bool)};
  EXPECT_EQ(layOut(variables, 0, false), 17u);
  EXPECT_EQ(layOut(variables, 0, true), 32u);
  EXPECT_EQ(layOut(variables, bitAddress(20), true), bitAddress(24));
  EXPECT_EQ(variables[0].address, bitAddress(20));
}

// S7-TYPES-21: STRUCT { BOOL; INT; BYTE } has 0.0, 2.0, 4.0 and 6 bytes.
TEST(Layout, StructuresBeginAndEndAtEvenBytes) {
  const TypePtr type = structType({var(TypeCode::Bool), var(TypeCode::Int), var(TypeCode::Byte)});
  EXPECT_EQ(type->members[1].address, bitAddress(2));
  EXPECT_EQ(type->members[2].address, bitAddress(4));
  EXPECT_EQ(sizeInBytes(*type), 6u);
  EXPECT_EQ(places({var(TypeCode::Bool), var(type), var(TypeCode::Bool)}),
            (std::vector<BitAddress>{0, 16, 64}));
}

// S7-TYPES-20: a[2,0] of ARRAY [1..3,0..7] OF INT lies at +16.
TEST(Layout, ArraysRunThroughTheLastIndexFirst) {
  const TypePtr type = arrayType({{1, 3}, {0, 7}}, elementaryType(TypeCode::Int));
  EXPECT_EQ(sizeInBytes(*type), 48u);
  EXPECT_EQ(elementOffset(*type, {2, 0}), bitAddress(16));
  EXPECT_EQ(elementOffset(*type, {3, 7}), bitAddress(46));
  EXPECT_EQ(elementOffset(*type, {1, 0}), 0u);
  EXPECT_EQ(elementOffsets(*type)[9], bitAddress(18));
}

// S7-TYPES-20: BOOL packed, each dimension from an even byte on; even length.
TEST(Layout, BitArraysArePackedRowByRow) {
  EXPECT_EQ(sizeInBytes(*arrayType({{0, 16}}, elementaryType(TypeCode::Bool))), 4u);
  EXPECT_EQ(sizeInBytes(*arrayType({{0, 0}}, elementaryType(TypeCode::Bool))), 2u);
  const TypePtr type = arrayType({{1, 2}, {1, 3}}, elementaryType(TypeCode::Bool));
  EXPECT_EQ(elementOffset(*type, {1, 3}), 2u);
  EXPECT_EQ(elementOffset(*type, {2, 1}), bitAddress(2));
  EXPECT_EQ(sizeInBytes(*type), 4u);
  EXPECT_EQ(elementOffsets(*type), (std::vector<BitAddress>{0, 1, 2, 16, 17, 18}));
}

TEST(Layout, ByteArraysArePackedThrough) {
  const TypePtr type = arrayType({{1, 2}, {1, 3}}, elementaryType(TypeCode::Byte));
  EXPECT_EQ(elementOffset(*type, {2, 1}), bitAddress(3));
  EXPECT_EQ(sizeInBytes(*type), 6u);
  EXPECT_EQ(sizeInBytes(*arrayType({{-1, 1}}, elementaryType(TypeCode::Char))), 4u);
}

// S7-TYPES-19: n + 2 bytes; what begins anywhere follows at once, array elements begin at even
// bytes.
TEST(Layout, Strings) {
  EXPECT_EQ(sizeInBytes(*stringType(254)), 256u);
  EXPECT_EQ(places({var(stringType(3)), var(TypeCode::Byte), var(TypeCode::Word)}),
            (std::vector<BitAddress>{0, bitAddress(5), bitAddress(6)}));
  EXPECT_EQ(elementOffset(*arrayType({{0, 1}}, stringType(3)), {1}), bitAddress(6));
}

// S7-PAR-03: POINTER 6, ANY 10, numbers of timers, counters and blocks 2 bytes.
TEST(Layout, ParameterTypes) {
  EXPECT_EQ(sizeInBytes(*elementaryType(TypeCode::Pointer)), 6u);
  EXPECT_EQ(sizeInBytes(*elementaryType(TypeCode::Any)), 10u);
  for (const TypeCode code : {TypeCode::Timer, TypeCode::Counter, TypeCode::BlockDb,
                              TypeCode::BlockFc, TypeCode::BlockFb, TypeCode::BlockSdb})
    EXPECT_EQ(sizeInBytes(*elementaryType(code)), 2u);
  EXPECT_EQ(sizeInBytes(*elementaryType(TypeCode::DateAndTime)), 8u);
}

// S7-PAR-03: a composite IN_OUT lies in the instance as a POINTER, others as they are.
TEST(Layout, CompositeInOutIsAPointer) {
  const TypePtr big = structType({var(TypeCode::Real), var(TypeCode::Real), var(TypeCode::Real)});
  EXPECT_EQ(places({var(big, Section::InOut), var(TypeCode::Int, Section::InOut), var(big),
                    var(TypeCode::Bool)}),
            (std::vector<BitAddress>{0, bitAddress(6), bitAddress(8), bitAddress(20)}));
}

TEST(Layout, EverySectionBeginsAtAnEvenByte) {
  EXPECT_EQ(places({var(TypeCode::Bool, Section::Input), var(TypeCode::Bool, Section::Input),
                    var(TypeCode::Bool, Section::Output), var(TypeCode::Bool, Section::Static)}),
            (std::vector<BitAddress>{0, 1, 16, 32}));
}

TEST(Layout, SizesDoNotWrapAround) {
  const TypePtr row =
      arrayType({{-32768, 32767}, {-32768, 32767}}, elementaryType(TypeCode::DWord));
  EXPECT_GT(sizeInBytes(*row), 0x10000u);
  std::vector<Variable> variables(20, var(row));
  EXPECT_GT(layOut(variables, 0, true), bitAddress(0x10000));
}

// S7-PAR-04: the exact same structure; names do not matter; STRING of any length.
TEST(SameStructure, ComparesTypesAndBounds) {
  const auto array = [](int low, int high) {
    return arrayType({{low, high}}, elementaryType(TypeCode::Int));
  };
  EXPECT_TRUE(sameStructure(*array(1, 4), *array(1, 4)));
  EXPECT_FALSE(sameStructure(*array(1, 4), *array(0, 3)));
  EXPECT_FALSE(sameStructure(*array(1, 4), *arrayType({{1, 4}}, elementaryType(TypeCode::Word))));
  EXPECT_TRUE(sameStructure(*stringType(20), *stringType(254)));
  Variable named = var(TypeCode::Int);
  named.name = "x";
  EXPECT_TRUE(sameStructure(*structType({named}), *structType({var(TypeCode::Int)})));
  EXPECT_FALSE(
      sameStructure(*structType({named}), *structType({var(TypeCode::Int), var(TypeCode::Int)})));
  EXPECT_FALSE(
      sameStructure(*structType({var(stringType(20))}), *structType({var(stringType(22))})));
}

TEST(TypeText, IsThatOfADeclaration) {
  EXPECT_EQ(toString(*elementaryType(TypeCode::Int)), "INT");
  EXPECT_EQ(toString(*arrayType({{1, 4}, {0, 1}}, elementaryType(TypeCode::Word))),
            "ARRAY [1..4,0..1] OF WORD");
  EXPECT_EQ(toString(*stringType(20)), "STRING [20]");
  EXPECT_EQ(toString(*structType({})), "STRUCT");
  EXPECT_EQ(toString(*instanceOf(10, {})), "FB 10");
  Type udt = *structType({});
  udt.udt = 3;
  EXPECT_EQ(toString(udt), "UDT 3");
}

}  // namespace
}  // namespace merker::block
