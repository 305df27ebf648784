#include "s7comm/item.h"

#include <gtest/gtest.h>

#include "line.h"

namespace merker::s7comm {
namespace {

Wanted item(std::string_view text) {
  const Bytes bytes = hex(text);
  View view = bytes;
  return readItem(view).value_or(Wanted{.code = ItemCode::HardwareFault});
}

TEST(Item, anAddressIsByteAndBit) {
  const Wanted bit = item("12 0A 10 01 00 01 00 00 83 00 00 53");  // M 10.3
  EXPECT_EQ(bit.ranges, (std::vector<Range>{{.begin = 10, .octets = 1, .bit = 3, .oneBit = true}}));
  const Wanted words = item("12 0A 10 04 00 03 00 07 84 00 01 20");  // three words from DB7.DBW36
  EXPECT_EQ(
      words.ranges,
      (std::vector<Range>{{.memory = Memory::DataBlock, .block = 7, .begin = 36, .octets = 6}}));
  EXPECT_EQ(words.unit, DataUnit::Byte);
}

TEST(Item, aTimerIsANumber) {
  EXPECT_EQ(item("12 0A 10 1D 00 02 00 00 1D 00 00 05").ranges,
            (std::vector<Range>{{.memory = Memory::Timer, .begin = 5, .octets = 4}}));
  EXPECT_EQ(item("12 0A 10 04 00 01 00 00 1D 00 00 05").code, ItemCode::TypeNotSupported);
  EXPECT_EQ(item("12 0A 10 1D 00 01 00 00 83 00 00 05").code, ItemCode::TypeNotSupported);
}

TEST(Item, eachTypeHasItsSizeAndItsAnswer) {
  struct Row {
    const char* code;
    unsigned bytes, unit;
  };
  for (const Row& row : {Row{"02", 1, 4},
                         {"03", 1, 9},
                         {"04", 2, 4},
                         {"05", 2, 5},
                         {"06", 4, 4},
                         {"07", 4, 5},
                         {"08", 4, 7},
                         {"09", 2, 4},
                         {"0A", 4, 4},
                         {"0B", 4, 4},
                         {"0C", 2, 4},
                         {"0F", 8, 9}}) {
    const Wanted wanted = item(std::string("12 0A 10 ") + row.code + " 00 01 00 00 83 00 00 00");
    EXPECT_EQ(wanted.octets(), row.bytes) << row.code;
    EXPECT_EQ(static_cast<unsigned>(wanted.unit), row.unit) << row.code;
  }
}

TEST(Item, whatNoS7300KnowsIsRefused) {
  const auto code = [](std::string_view text) { return item(text).code; };
  EXPECT_EQ(code("12 0A 10 20 00 01 00 00 83 00 00 00"), ItemCode::TypeNotSupported);
  EXPECT_EQ(code("12 0A 10 02 00 01 00 00 86 00 00 00"), ItemCode::TypeNotSupported);  // L
  EXPECT_EQ(code("12 0A 10 02 00 01 00 00 06 00 00 00"), ItemCode::TypeNotSupported);  // S7-200
  EXPECT_EQ(code("12 0A B2 02 00 01 00 00 83 00 00 00"), ItemCode::TypeNotSupported);
  EXPECT_EQ(code("12 0A 10 01 00 02 00 00 83 00 00 00"), ItemCode::TypeMismatch);  // two bits
  EXPECT_EQ(code("12 0A 10 02 00 01 00 00 83 00 00 01"), ItemCode::OutOfRange);    // not a byte
  EXPECT_EQ(code("12 0A 10 02 00 00 00 00 83 00 00 00"), ItemCode::OutOfRange);    // none
}

TEST(Item, countsAreMultipliedWithoutOverflow) {
  const auto code = [](std::string_view text) { return item(text).code; };
  EXPECT_EQ(code("12 0A 10 02 FF FF 00 01 84 00 00 00"), ItemCode::Done);
  EXPECT_EQ(code("12 0A 10 02 FF FF 00 01 84 00 00 10"), ItemCode::OutOfRange);
  EXPECT_EQ(code("12 0A 10 0F FF FF 00 01 84 00 00 00"), ItemCode::OutOfRange);
  EXPECT_EQ(code("12 0A 10 06 40 01 00 01 84 00 00 00"), ItemCode::OutOfRange);
  EXPECT_EQ(code("12 0A 10 02 00 01 00 01 84 FF FF F8"), ItemCode::OutOfRange);
  EXPECT_EQ(code("12 0A 10 1D FF FF 00 00 1D FF FF FF"), ItemCode::OutOfRange);
}

TEST(Item, anItemThatGoesBeyondTheParametersIsNone) {
  for (const auto text : {"", "12", "12 00", "12 0A", "12 0A 10 02 00 01 00 00 83 00 00",
                          "11 0A 10 02 00 01 00 00 83 00 00 00"})
    EXPECT_EQ(item(text).code, ItemCode::HardwareFault) << text;
}

TEST(Item, dbReadHasManyAreas) {
  const Wanted two = item("12 0C B0 02 04 00 01 00 00 02 00 07 00 0A");
  EXPECT_EQ(two.ranges, (std::vector<Range>{
                            {.memory = Memory::DataBlock, .block = 1, .begin = 0, .octets = 4},
                            {.memory = Memory::DataBlock, .block = 7, .begin = 10, .octets = 2}}));
  EXPECT_EQ(item("12 07 B0 02 04 00 01 00 00").code, ItemCode::TypeNotSupported);
  EXPECT_EQ(item("12 02 B0 00").code, ItemCode::TypeNotSupported);
  EXPECT_EQ(item("12 01 B0").code, ItemCode::TypeNotSupported);
}

}  // namespace
}  // namespace merker::s7comm
