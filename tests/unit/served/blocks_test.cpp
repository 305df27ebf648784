#include "served/blocks.h"

#include <algorithm>

#include "block/container.h"
#include "served_plc.h"

namespace merker::served {
namespace {

using s7comm::BlockType;
using s7comm::Error;

block::Block uploaded(ServedPlc& plc, BlockType type, std::uint16_t number) {
  const Uploaded block = upload(plc.plc(), {}, {type, number});
  EXPECT_EQ(block.error, Error::None);
  auto read = block::readContainer(block.container, {});
  EXPECT_TRUE(read);
  return read ? *read : block::Block{};
}

TEST(Blocks, theDirectoryHasWhatWasLoaded) {
  ServedPlc plc = ServedPlc::station();
  const auto all = blocksOf(plc.plc());
  ASSERT_TRUE(all);
  ASSERT_GT(all->size(), 2u);
  EXPECT_EQ(all->at(0).type, BlockType::Ob);
  EXPECT_EQ(all->at(1).type, BlockType::Db);
  EXPECT_EQ(all->at(1).number, 5);
  EXPECT_EQ(all->at(1).language, 5);
}

// MC7 of OB 1; DB 5 with the values that it has now.
TEST(Blocks, anUploadIsAContainer) {
  ServedPlc plc = ServedPlc::station();
  plc.exchange.opened();
  plc.cycles(1);
  EXPECT_FALSE(uploaded(plc, BlockType::Ob, 1).code.empty());
  EXPECT_EQ(uploaded(plc, BlockType::Db, 5).actualData, (Bytes{1, 2, 3, 4}));
  plc.writeNow({.memory = Memory::DataBlock, .block = 5, .begin = 0, .octets = 1}, {9});
  EXPECT_EQ(uploaded(plc, BlockType::Db, 5).actualData, (Bytes{9, 2, 3, 4}));
}

// What the CPU brings is listed and described beside the program, and stays in it.
TEST(Blocks, systemFunctionsAreBlocks) {
  ServedPlc plc = ServedPlc::station();
  const auto all = blocksOf(plc.plc());
  ASSERT_TRUE(all);
  const auto has = [&](BlockType type, std::uint16_t number) {
    return std::ranges::any_of(
        *all, [=](const auto& one) { return one.type == type && one.number == number; });
  };
  EXPECT_TRUE(has(BlockType::Sfc, 51));
  EXPECT_TRUE(has(BlockType::Sfb, 4));
  EXPECT_FALSE(has(BlockType::Sfc, 26));  // of larger CPUs
  EXPECT_FALSE(has(BlockType::Fc, 1));    // of the library
  const Uploaded head = blockOf(plc.plc(), {}, {BlockType::Sfc, 51});
  ASSERT_EQ(head.error, Error::None);
  const auto block = block::readContainer(head.container, {});
  ASSERT_TRUE(block);
  EXPECT_EQ(block->id.number, 51);
  EXPECT_EQ(block->attributes.author, "SIMATIC");
  EXPECT_EQ(upload(plc.plc(), {}, {BlockType::Sfc, 51}).error, Error::NoSuchBlock);
  EXPECT_EQ(blockOf(plc.plc(), {}, {BlockType::Sfc, 26}).error, Error::NoSuchBlock);
}

TEST(Blocks, whatIsNotThere) {
  ServedPlc plc = ServedPlc::station();
  EXPECT_EQ(upload(plc.plc(), {}, {BlockType::Fc, 1}).error, Error::NoSuchBlock);
  EXPECT_EQ(upload(plc.plc(), {}, {BlockType::Ob, 0}).error, Error::NotForUpload);
  ServedPlc control = ServedPlc::control();
  EXPECT_FALSE(blocksOf(control.plc()));
  EXPECT_EQ(upload(control.plc(), {}, {BlockType::Db, 5}).error, Error::FunctionNotAvailable);
}

}  // namespace
}  // namespace merker::served
