// Block containers: the worked example of docs/formats/block.md, round trips, damaged containers.
#include "block/container.h"

#include <gtest/gtest.h>

#include <random>

#include "make.h"

namespace merker::block {
namespace {

using Bytes = std::vector<std::uint8_t>;

// FC 2 of docs/formats/block.md.
Block example() {
  Block block;
  block.id = {BlockKind::FC, 2};
  block.attributes.author = "EXAMPLE";
  block.attributes.family = "DEMO";
  block.attributes.name = "MOTOR";
  block.variables = {var(TypeCode::Bool, Section::Input), var(TypeCode::Bool, Section::Output)};
  layOut(block.variables, 0, true);
  block.code = {0xFB, 0x80, 0x00, 0x02, 0xFB, 0x92, 0x00, 0x04, 0x65, 0x00};
  block.networks = {{0, {}}};
  return block;
}

const Bytes kExample{
    0x70, 0x70, 0x01, 0x01, 0x01, 0x0C, 0x00, 0x02, 0x00, 0x00, 0x00, 0x64,  // header
    0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00,              //
    0x00, 0x00, 0x00, 0x00, 0x00, 0x00,                                      //
    0x00, 0x0C, 0x00, 0x06, 0x00, 0x00, 0x00, 0x0A,                          //
    0xFB, 0x80, 0x00, 0x02, 0xFB, 0x92, 0x00, 0x04, 0x65, 0x00,              // code
    0x01, 0x02, 0x00, 0x04, 0x00, 0x00, 0x00, 0x01, 0x01, 0x01, 0x02, 0x00,  // interface
    0x01, 0x00, 0x08, 0x00, 0x00, 0x00,                                      // segment table
    'E',  'X',  'A',  'M',  'P',  'L',  'E',  0,    'D',  'E',  'M',  'O',   // trailer
    0,    0,    0,    0,    'M',  'O',  'T',  'O',  'R',  0,    0,    0,     //
    0x01, 0x00, 0x2B, 0x33, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00};

// Long division of 08 00 02 65 00 and 16 zero bits by 1 1001 0000 0000 0011.
TEST(Checksum, OfAnEmptyBlock) {
  Block block;
  block.id = {BlockKind::OB, 1};
  block.code = {0x65, 0x00};
  EXPECT_EQ(checksum(block), 0xF475);
}

// The same rule over 0A 00 02 00 05: kind, length, actual values.
TEST(Checksum, OfADataBlock) {
  Block db;
  db.id = {BlockKind::DB, 1};
  db.initialData = {0, 0};
  db.actualData = {0, 5};
  EXPECT_EQ(checksum(db), 0x7960);
}

TEST(Container, IsThatOfTheDocument) { EXPECT_EQ(writeContainer(example()), kExample); }

TEST(Container, TheDocumentComesBack) {
  const auto read = readContainer(kExample, {});
  ASSERT_TRUE(read);
  EXPECT_EQ(read->id, (BlockId{BlockKind::FC, 2}));
  EXPECT_EQ(read->attributes.author, "EXAMPLE");
  EXPECT_EQ(read->attributes.family, "DEMO");
  EXPECT_EQ(read->attributes.name, "MOTOR");
  EXPECT_EQ(read->attributes.version, 0x01);
  EXPECT_EQ(read->code, example().code);
  EXPECT_EQ(read->language, Language::Awl);
  ASSERT_EQ(read->variables.size(), 2u);
  EXPECT_EQ(read->variables[1].section, Section::Output);
  EXPECT_EQ(writeContainer(*read), kExample);
}

Block largeFunctionBlock() {
  const TypePtr array = arrayType({{0, 1}, {1, 9}}, elementaryType(TypeCode::Bool));
  Block block;
  block.id = {BlockKind::FB, 300};
  block.variables = {
      var(TypeCode::Bool, Section::Input, {1}),
      var(array, Section::Input, {0xFF, 0x01, 0x02, 0x00}),
      var(stringType(5), Section::Output),
      var(array, Section::InOut),
      var(TypeCode::Int, Section::InOut),
      var(instanceOf(4,
                     {var(TypeCode::Bool, Section::Input), var(TypeCode::Bool, Section::Output)})),
      var(TypeCode::DateAndTime, Section::Static, {0x98, 4, 0x14, 0x17, 0x53, 0x17, 0x33, 0x33}),
      var(structType({var(TypeCode::Real, Section::Static, {0x41, 0x44, 0xCC, 0xCD})})),
      var(TypeCode::Word, Section::Temp)};
  block.instanceBytes = 52;
  block.localBytes = 2;
  block.code = {0x00, 0x00, 0x70, 0x0B, 0x00, 0x02, 0x65, 0x00};
  block.networks = {{0, {}}, {2, {}}};
  block.jumps = {1};
  block.attributes.knowHowProtect = true;
  block.attributes.version = 0x21;
  return block;
}

TEST(Container, AFunctionBlockKeepsItsLayoutAndStartValues) {
  Block block = largeFunctionBlock();
  std::vector<Variable> frame(block.variables.begin(), block.variables.end() - 1);
  const std::uint32_t bytes = layOut(frame, 0, true) / 8;
  const auto read = readContainer(writeContainer(block), {});
  ASSERT_TRUE(read);
  ASSERT_EQ(read->variables.size(), block.variables.size());
  for (std::size_t i = 0; i < frame.size(); ++i) {
    EXPECT_EQ(read->variables[i].address, frame[i].address) << i;
    EXPECT_EQ(read->variables[i].initial, frame[i].initial) << i;
    EXPECT_EQ(toString(*read->variables[i].type), toString(*frame[i].type)) << i;
  }
  EXPECT_EQ(read->instanceBytes, bytes);
  EXPECT_EQ(read->variables[7].type->members[0].initial, (Bytes{0x41, 0x44, 0xCC, 0xCD}));
  EXPECT_EQ(read->variables[5].type->members[1].address, bitAddress(2));
  EXPECT_EQ(read->localBytes, 2u);
  EXPECT_EQ(read->networks.size(), 2u);
  EXPECT_EQ(read->networks[1].offset, 2u);
  EXPECT_EQ(read->jumps, block.jumps);
  EXPECT_TRUE(read->attributes.knowHowProtect);
  EXPECT_EQ(read->attributes.version, 0x21);
}

TEST(Container, ADataBlockKeepsStartAndActualValues) {
  Block db;
  db.id = {BlockKind::DB, 10};
  db.language = Language::Db;
  db.variables = {var(TypeCode::Int, Section::Static, {0, 5}), var(stringType(4))};
  layOut(db.variables, 0, true);
  db.initialData = {0, 5, 4, 0, 0, 0, 0, 0};
  db.actualData = {0, 9, 4, 1, 'x', 0, 0, 0};
  db.instanceOf = 300;
  db.attributes.nonRetain = db.attributes.unlinked = true;
  const auto read = readContainer(writeContainer(db), {});
  ASSERT_TRUE(read);
  EXPECT_EQ(read->initialData, db.initialData);
  EXPECT_EQ(read->actualData, db.actualData);
  EXPECT_EQ(read->instanceOf, 300);
  EXPECT_TRUE(read->attributes.nonRetain);
  EXPECT_TRUE(read->attributes.unlinked);
  EXPECT_EQ(read->language, Language::Db);
}

// A CPU hands data blocks over without a checksum; a wrong one is refused as that of code.
// Whoever loads a block finds it again as it was: its security word and its time stamps.
TEST(Container, WhatOthersWroteIntoTheHeadStays) {
  std::vector<std::uint8_t> container = writeContainer(example());
  for (std::size_t at = 16; at < 28; ++at) container[at] = static_cast<std::uint8_t>(at);
  container[15] = 1;
  const auto read = readContainer(container, {});
  ASSERT_TRUE(read);
  EXPECT_EQ(writeContainer(*read), container);
}

TEST(Container, ADataBlockMayHaveNoChecksum) {
  Block db;
  db.id = {BlockKind::DB, 1};
  db.actualData = {0, 5};
  std::vector<std::uint8_t> bytes = writeContainer(db);
  std::uint8_t* const sum = &bytes[bytes.size() - 10];
  ASSERT_EQ(sum[0], 0x79);
  sum[0] = 0x78;
  EXPECT_FALSE(readContainer(bytes, {}));
  sum[0] = sum[1] = 0;
  ASSERT_TRUE(readContainer(bytes, {}));
  EXPECT_EQ(readContainer(bytes, {})->actualData, db.actualData);
}

// Local data behind the 20 bytes of start information keep their place.
TEST(Container, LocalDataOfAnOrganizationBlockKeepTheirPlace) {
  Block ob;
  ob.id = {BlockKind::OB, 1};
  ob.variables = {var(TypeCode::Word, Section::Temp)};
  layOut(ob.variables, bitAddress(20), true);
  ob.code = {0x65, 0x00};
  const auto read = readContainer(writeContainer(ob), {});
  ASSERT_TRUE(read);
  EXPECT_EQ(read->variables.back().address, bitAddress(20));
}

TEST(Container, WhatIsNoContainerHasNone) {
  Block udt;
  udt.id = {BlockKind::UDT, 1};
  EXPECT_TRUE(writeContainer(udt).empty());
  Block large = example();
  large.code.assign(0x10000, 0);
  EXPECT_TRUE(writeContainer(large).empty());
}

ProblemCode problemOf(Bytes bytes) {
  const auto read = readContainer(bytes, {"x.bin"});
  EXPECT_FALSE(read);
  return read ? ProblemCode::P0101 : read.error().code;
}

TEST(Container, DamageIsNamed) {
  const auto with = [](std::size_t at, std::uint8_t value) {
    Bytes bytes = kExample;
    bytes[at] = value;
    return bytes;
  };
  EXPECT_EQ(problemOf({}), ProblemCode::P0601);
  EXPECT_EQ(problemOf(Bytes(100)), ProblemCode::P0601);
  EXPECT_EQ(problemOf(with(2, 9)), ProblemCode::P0601);
  EXPECT_EQ(problemOf(with(5, 0)), ProblemCode::P0601);
  EXPECT_EQ(problemOf(with(35, 0x0B)), ProblemCode::P0602);
  EXPECT_EQ(problemOf(Bytes(kExample.begin(), kExample.end() - 1)), ProblemCode::P0602);
  EXPECT_EQ(problemOf(with(39, 0x04)), ProblemCode::P0603);  // a bit of the code
  EXPECT_EQ(problemOf(with(53, 0x3F)), ProblemCode::P0604);  // type of a variable
}

// Whatever the bytes are: a block or a problem, and a block can be written again.
TEST(Container, AnyBytesAreReadWithoutHarm) {
  std::mt19937 random{42};
  const std::vector<Bytes> seeds{kExample, writeContainer(largeFunctionBlock())};
  int good = 0;
  for (int run = 0; run < 30000; ++run) {
    Bytes bytes = seeds[random() % seeds.size()];
    for (unsigned i = random() % 4; i-- > 0;)
      bytes[random() % bytes.size()] = static_cast<std::uint8_t>(random());
    if (random() % 8 == 0) bytes.resize(random() % bytes.size());
    const auto read = readContainer(bytes, {});
    if (!read) continue;
    ++good;
    const Bytes again = writeContainer(*read);
    ASSERT_TRUE(readContainer(again, {}));
  }
  EXPECT_GT(good, 1000);
}

}  // namespace
}  // namespace merker::block
