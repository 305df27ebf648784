#include "served/values.h"

#include "served_plc.h"

namespace merker::served {
namespace {

class EachValue : public EachFamily {};
INSTANTIATE_TEST_SUITE_P(Families, EachValue, ::testing::Values(Family::Station, Family::Control));

Range data(std::uint16_t block, std::uint32_t begin, std::uint32_t octets) {
  return {.memory = Memory::DataBlock, .block = block, .begin = begin, .octets = octets};
}
Range bit(Memory memory, std::uint32_t byte, std::uint8_t number) {
  return {.memory = memory, .begin = byte, .octets = 1, .bit = number, .oneBit = true};
}

TEST_P(EachValue, dataBlocksAreBytes) {
  plc.exchange.opened();
  plc.cycles(1);
  EXPECT_EQ(plc.read(data(5, 0, 4))->octets, (Bytes{1, 2, 3, 4}));
  EXPECT_EQ(plc.read(data(5, 1, 2))->octets, (Bytes{2, 3}));
  EXPECT_EQ(plc.writeNow(data(5, 1, 2), {0xAA, 0xBB}), ItemCode::Done);
  EXPECT_EQ(plc.read(data(5, 0, 4))->octets, (Bytes{1, 0xAA, 0xBB, 4}));
}

TEST_P(EachValue, whatIsNotThereHasACode) {
  plc.exchange.opened();
  plc.cycles(1);
  EXPECT_EQ(plc.read(data(6, 0, 1))->code, ItemCode::Missing);
  EXPECT_EQ(plc.read(data(5, 3, 2))->code, ItemCode::OutOfRange);
  EXPECT_EQ(plc.read(flags(0xFFFF, 1))->code, ItemCode::OutOfRange);
  EXPECT_EQ(plc.writeNow(data(6, 0, 1), {1}), ItemCode::Missing);
  EXPECT_EQ(plc.writeNow(data(5, 3, 2), {9, 9}), ItemCode::OutOfRange);
  EXPECT_EQ(plc.read(data(5, 3, 1))->octets, Bytes{4});  // nothing of it
}

TEST_P(EachValue, bitsLeaveTheirNeighbours) {
  plc.exchange.opened();
  plc.cycles(1);
  EXPECT_EQ(plc.writeNow(flags(120, 1), {0xF0}), ItemCode::Done);
  EXPECT_EQ(plc.writeNow(bit(Memory::Flag, 120, 1), {1}), ItemCode::Done);
  EXPECT_EQ(plc.writeNow(bit(Memory::Flag, 120, 7), {0}), ItemCode::Done);
  EXPECT_EQ(plc.read(flags(120, 1))->octets, Bytes{0x72});
  EXPECT_EQ(plc.read(bit(Memory::Flag, 120, 1))->octets, Bytes{1});
  EXPECT_EQ(plc.read(bit(Memory::Flag, 120, 7))->octets, Bytes{0});
}

// From its terminal the program sees it in the next cycle (S7-VIS-03).
TEST_P(EachValue, anInputIsSetAtItsTerminal) {
  plc.exchange.opened();
  plc.cycles(1);
  EXPECT_EQ(plc.writeNow(bit(Memory::Input, 0, 0), {1}), ItemCode::Done);
  plc.cycles(2);
  EXPECT_EQ(plc.read(bit(Memory::Input, 0, 0))->octets, Bytes{1});
  EXPECT_EQ(plc.read(bit(Memory::Output, 0, 0))->octets, Bytes{1});
}

// As LC loads them: base and three digits.
TEST_P(EachValue, timersAndCountersAreCoded) {
  plc.exchange.opened();
  plc.cycles(1);
  const Range timer{.memory = Memory::Timer, .begin = 3, .octets = 2};
  const Range counter{.memory = Memory::Counter, .begin = 2, .octets = 2};
  EXPECT_EQ(plc.writeNow(counter, {0x01, 0x23}), ItemCode::Done);
  EXPECT_EQ(plc.read(counter)->octets, (Bytes{0x01, 0x23}));
  EXPECT_EQ(plc.writeNow(timer, {0x20, 0x55}), ItemCode::Done);  // 55 s
  const auto value = plc.read(timer)->octets;
  EXPECT_EQ(value[0], 0x20);
  EXPECT_TRUE(value[1] == 0x55 || value[1] == 0x54) << unsigned{value[1]};
  EXPECT_EQ(plc.writeNow(counter, {0xFF, 0xFF}), ItemCode::AccessDenied);
  EXPECT_EQ(plc.writeNow({.memory = Memory::Counter, .begin = 9999, .octets = 2}, {0, 1}),
            ItemCode::OutOfRange);
}

TEST_P(EachValue, aForcedOutputStays) {
  plc.exchange.opened();
  plc.cycles(1);
  EXPECT_FALSE(plc.monitor().force("A 0.3", "1"));
  EXPECT_EQ(plc.writeNow({.memory = Memory::Output, .begin = 0, .octets = 1}, {0}),
            ItemCode::AccessDenied);
  EXPECT_EQ(plc.writeNow({.memory = Memory::Output, .begin = 1, .octets = 1}, {5}), ItemCode::Done);
}

// The periphery is read by the PLC itself, at the end of a cycle.
TEST(Values, thePeripheryIsRead) {
  ServedPlc plc = ServedPlc::station();
  plc.exchange.opened();
  plc.cycles(1);
  const Range inputs{.memory = Memory::Peripheral, .begin = 0, .octets = 2};
  plc.writeNow({.memory = Memory::Input, .begin = 0, .octets = 2}, {0x12, 0x34});
  EXPECT_FALSE(plc.read(inputs));
  plc.cycles(1);
  EXPECT_EQ((*plc.waiting)->octets, (Bytes{0x12, 0x34}));
  EXPECT_EQ(plc.writeNow({.memory = Memory::Peripheral, .begin = 4, .octets = 1}, {0x77}),
            ItemCode::Done);
  EXPECT_EQ(plc.read({.memory = Memory::Output, .begin = 4, .octets = 1})->octets, Bytes{0x77});
}

// Only the first read of a range waits for the end of a cycle; one that nobody asks for any more is
// not copied.
TEST(Values, thePeripheryIsCopiedWhileItIsAskedFor) {
  ServedPlc plc = ServedPlc::station();
  plc.exchange.opened();
  const Range inputs{.memory = Memory::Peripheral, .begin = 0, .octets = 2};
  plc.read(inputs);
  plc.cycles(1);
  plc.writeNow({.memory = Memory::Input, .begin = 0, .octets = 2}, {0x12, 0x34});
  ASSERT_TRUE(plc.read(inputs));
  EXPECT_EQ(plc.read(inputs)->octets, (Bytes{0x12, 0x34}));
  EXPECT_FALSE(plc.read({.memory = Memory::Peripheral, .begin = 1, .octets = 1}))
      << "another range";
  plc.plc().advanceTo(plc.plc().now() + PeripheryWatch::kKept + Duration::seconds(1));
  EXPECT_FALSE(plc.read(inputs));
}

TEST(Values, aReadOnlyDataBlockIsNotWritten) {
  ServedPlc plc = ServedPlc::station(
      "DATA_BLOCK DB 5\nREAD_ONLY\nSTRUCT\n a : DWORD := "
      "DW#16#01020304;\nEND_STRUCT\nBEGIN\nEND_DATA_BLOCK\n"
      "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\n NOP 0;\nEND_ORGANIZATION_BLOCK\n");
  plc.exchange.opened();
  plc.cycles(1);
  const Range word{.memory = Memory::DataBlock, .block = 5, .begin = 0, .octets = 2};
  EXPECT_EQ(plc.writeNow(word, {0, 0}), ItemCode::AccessDenied);
  EXPECT_EQ(plc.read(word)->octets, (Bytes{1, 2}));
}

}  // namespace
}  // namespace merker::served
