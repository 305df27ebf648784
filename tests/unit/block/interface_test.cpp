// The interface part of a container (MC7 section 8), bytes literal.
#include <gtest/gtest.h>

#include "block/interface_part.h"
#include "make.h"

namespace merker::block {
namespace {

using Bytes = std::vector<std::uint8_t>;

Block functionBlock(std::vector<Variable> variables) {
  Block block;
  block.id = {BlockKind::FB, 0x0102};
  block.variables = std::move(variables);
  return block;
}

TEST(Interface, CodesSectionsAndTypes) {
  EXPECT_EQ(writeInterface(functionBlock(
                {var(TypeCode::Bool, Section::Input), var(TypeCode::Int, Section::Output),
                 var(TypeCode::Any, Section::InOut), var(TypeCode::Timer, Section::Input),
                 var(stringType(20)), var(TypeCode::Real, Section::Temp)})),
            (Bytes{0x01, 0x02, 0x01, 13,   0,    0,    0,  //
                   0x01, 0x01, 0x05, 0x02, 0x16, 0x03, 0x1D, 0x01, 0x13, 0x04, 20, 0x08, 0x05}));
}

TEST(Interface, StartValuesAreLittleEndian) {
  EXPECT_EQ(
      writeInterface(functionBlock({var(TypeCode::Int, Section::Input, {0x12, 0x34}),
                                    var(TypeCode::Int), var(TypeCode::Bool, Section::Static, {1}),
                                    var(stringType(4), Section::Static, {4, 2, 'A', 'B', 0, 0}),
                                    var(TypeCode::DWord, Section::Static, {1, 2, 3, 4})})),
      (Bytes{0x01, 0x02, 0x01, 11,   0,    11,   0,                          //
             0x05, 0x09, 0x05, 0x04, 0x01, 0x0C, 0x13, 0x0C, 4, 0x06, 0x0C,  //
             0x34, 0x12, 1,    4,    2,    'A',  'B',  4,    3, 2,    1,    0}));
}

// S7-SRC-04: values of a user-defined type stay out of where no source can have them.
TEST(Interface, StartValuesAreOfStoredDataAlone) {
  const auto typed = [](Section section) {
    return var(structType({var(TypeCode::Int, Section::Static, {0, 5})}), section);
  };
  const Block fb =
      functionBlock({typed(Section::Input), typed(Section::InOut),
                     var(TypeCode::Int, Section::InOut, {0, 6}), typed(Section::Temp)});
  const Bytes written = writeInterface(fb);
  EXPECT_EQ(written, (Bytes{0x01, 0x02, 0x01, 17,   0,    4,    0,     //
                            0x11, 0x01, 1,    0x05, 0x09,              //
                            0x11, 0x03, 1,    0x05, 0x03, 0x05, 0x0B,  //
                            0x11, 0x05, 1,    0x05, 0x05,              //
                            5,    0,    6,    0}));
}

// Values stored there by others are passed over; those behind them come right.
TEST(Interface, ForeignStartValuesArePassedOver) {
  const Bytes bytes{1, 2,    0,    12, 0, 4, 0, 0x11, 3, 1, 5, 0x0B,
                    5, 0x0C, 0x11, 4,  1, 5, 4, 5,    0, 6, 0};
  Block fb = functionBlock({});
  ASSERT_TRUE(readInterface(bytes, fb));
  ASSERT_EQ(fb.variables.size(), 3u);
  EXPECT_FALSE(fb.variables[0].type->members[0].hasInitial);
  EXPECT_EQ(fb.variables[1].initial, (Bytes{0, 6}));
  Block fc;
  fc.id = {BlockKind::FC, 1};
  ASSERT_TRUE(readInterface(Bytes{1, 1, 0, 2, 0, 2, 0, 5, 9, 5, 0}, fc));
  EXPECT_FALSE(fc.variables[0].hasInitial);
}

TEST(Interface, ArraysStructuresAndInstances) {
  const TypePtr array = arrayType({{-1, 2}}, elementaryType(TypeCode::Byte));
  const TypePtr instance =
      instanceOf(10, {var(TypeCode::Bool, Section::Input), var(TypeCode::Int, Section::Output)});
  EXPECT_EQ(writeInterface(
                functionBlock({var(array), var(structType({var(TypeCode::Word)})), var(instance)})),
            (Bytes{0x01, 0x02, 0x01, 24,   0,    0, 0,                 //
                   0x10, 0x04, 1,    0xFF, 0xFF, 2, 0,    0x02, 0x04,  //
                   0x11, 0x04, 1,    0x04, 0x04,                       //
                   0x15, 10,   0,    0x11, 0x04, 2, 0x01, 0x01, 0x05, 0x02, 0}));
}

// An instance and the STRUCT of its data are two of the members of the STRUCT around them.
TEST(Interface, InstancesInsideAnInstanceCountTwice) {
  const TypePtr inner = instanceOf(11, {var(TypeCode::Bool)});
  const TypePtr outer =
      instanceOf(10, {var(TypeCode::Int, Section::Input), var(inner), var(TypeCode::Int)});
  const Bytes written = writeInterface(functionBlock({var(outer), var(TypeCode::Word)}));
  EXPECT_EQ(written, (Bytes{0x01, 0x02, 0x01, 20,   0,    0, 0,                 //
                            0x15, 10,   0,    0x11, 0x04, 4, 0x05, 0x01,        //
                            0x15, 11,   0,    0x11, 0x04, 1, 0x01, 0x04, 0x05,  //
                            0x04, 0x04, 0x04, 0}));
  Block read;
  ASSERT_TRUE(readInterface(written, read));
  ASSERT_EQ(read.variables.size(), 2u);
  const std::vector<Variable>& members = read.variables[0].type->members;
  ASSERT_EQ(members.size(), 3u);
  EXPECT_EQ(members[1].type->length, 11);
  EXPECT_EQ(members[1].type->members.size(), 1u);
  EXPECT_EQ(members[2].type->code, TypeCode::Int);
  EXPECT_EQ(read.variables[1].type->code, TypeCode::Word);
}

TEST(Interface, ManyInstancesInsideAnInstanceComeBack) {
  for (const std::size_t count : {127u, 128u, 200u}) {
    const TypePtr inner = instanceOf(11, {var(TypeCode::Int)});
    const Block written =
        functionBlock({var(instanceOf(10, std::vector<Variable>(count, var(inner))))});
    Block read;
    ASSERT_TRUE(readInterface(writeInterface(written), read));
    EXPECT_EQ(read.variables[0].type->members.size(), count);
  }
}

TEST(Interface, DataBlocksNameTheirFunctionBlock) {
  Block db;
  db.id = {BlockKind::DB, 7};
  EXPECT_EQ(writeInterface(db), (Bytes{0x05, 7, 0, 0, 0, 0, 0, 0}));
  db.instanceOf = 0x0203;
  EXPECT_EQ(writeInterface(db), (Bytes{0x0A, 3, 2, 0, 0, 0, 0, 0}));
  db.instanceOfSystemBlock = true;
  EXPECT_EQ(writeInterface(db), (Bytes{0x0B, 3, 2, 0, 0, 0, 0, 0}));
}

// A structure of 255 members or more counts them in a word behind FF.
TEST(Interface, LargeStructuresComeBack) {
  for (const std::size_t count : {254u, 255u, 300u}) {
    const Block written =
        functionBlock({var(structType(std::vector<Variable>(count, var(TypeCode::Bool))))});
    Block read;
    ASSERT_TRUE(readInterface(writeInterface(written), read));
    EXPECT_EQ(read.variables[0].type->members.size(), count);
    EXPECT_EQ(read.variables[0].type->bits, written.variables[0].type->bits);
  }
}

TEST(Interface, VariablesGetTheNamesOfTheirSection) {
  Block read;
  ASSERT_TRUE(readInterface(Bytes{1, 2, 0, 12, 0, 0, 0, 1, 1, 1, 1, 5, 2, 5, 4, 5, 5, 4, 6}, read));
  ASSERT_EQ(read.variables.size(), 6u);
  EXPECT_EQ(read.variables[1].name, "IN1");
  EXPECT_EQ(read.variables[2].name, "OUT0");
  EXPECT_EQ(read.variables[3].name, "STAT0");
  EXPECT_EQ(read.variables[4].name, "RET_VAL");
  EXPECT_EQ(read.variables[5].name, "TEMP0");
  EXPECT_EQ(read.variables[5].address, 0u);
  EXPECT_EQ(read.returnType->code, TypeCode::Word);
}

TEST(Interface, TheExtendedFormHasOneMoreByte) {
  Block read;
  ASSERT_TRUE(readInterface(Bytes{1, 2, 0, 6, 0, 0, 0, 0x05, 0x11, 0x77, 0x13, 0x04, 9}, read));
  EXPECT_EQ(read.variables[0].section, Section::Input);
  EXPECT_EQ(read.variables[1].type->length, 9);
}

TEST(Interface, RefusesWhatNoBlockCanHold) {
  const auto refused = [](Bytes declarations) {
    Bytes bytes{1, 2, 0, static_cast<std::uint8_t>(declarations.size()), 0, 0, 0};
    bytes.insert(bytes.end(), declarations.begin(), declarations.end());
    Block block;
    return !readInterface(bytes, block);
  };
  EXPECT_FALSE(refused({0x05, 0x04}));
  EXPECT_TRUE(refused({0x05}));                                            // cut off
  EXPECT_TRUE(refused({0x05, 0x00}));                                      // no section
  EXPECT_TRUE(refused({0x05, 0x07}));                                      //
  EXPECT_TRUE(refused({0x0D, 0x04}));                                      // no such type
  EXPECT_TRUE(refused({0x10, 0x04, 0, 0x05, 0x04}));                       // no dimension
  EXPECT_TRUE(refused({0x10, 0x04, 1, 2, 0, 1, 0, 0x05, 0x04}));           // 2..1
  EXPECT_TRUE(refused({0x10, 0x04, 1, 0, 0x80, 0xFF, 0x7F, 0x06, 0x04}));  // 256 KB
  EXPECT_TRUE(refused({0x10, 0x04, 1, 0, 0, 1, 0, 0x11, 0x04, 0}));        // elements of no size
  EXPECT_TRUE(refused({0x11, 0x04, 2, 0x05, 0x04}));                       // a member is missing
  EXPECT_TRUE(refused({0x11, 0x04, 1, 0x15, 1, 0, 0x11, 0x04, 1, 0x01, 0x04}));  // half an instance
  EXPECT_TRUE(refused({0x05, 0x0C}));  // start value missing
  Bytes deep;
  for (int i = 0; i < 40; ++i) deep.insert(deep.end(), {0x11, 0x04, 1});
  EXPECT_TRUE(refused(deep));
}

}  // namespace
}  // namespace merker::block
