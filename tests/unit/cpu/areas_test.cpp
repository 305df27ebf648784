#include "cpu/areas.h"

#include <gtest/gtest.h>

#include "cpu/error.h"
#include "cpu/start_information.h"

namespace merker::cpu {
namespace {

// S7-CPU-18, S7-OPND-11: what answers without a hardware configuration.
TEST(Areas, PeripheryOfA314C) {
  const Areas areas(defaultCpuModel());
  EXPECT_TRUE(areas.answers(areas.inputPresent, 0, 4));
  EXPECT_TRUE(areas.answers(areas.inputPresent, 124, 3));
  EXPECT_TRUE(areas.answers(areas.inputPresent, 760, 2));
  EXPECT_FALSE(areas.answers(areas.inputPresent, 762, 2));
  EXPECT_TRUE(areas.answers(areas.outputPresent, 752, 4));
  EXPECT_FALSE(areas.answers(areas.outputPresent, 756, 2));
  EXPECT_FALSE(areas.answers(areas.inputPresent, 400, 2));
  EXPECT_FALSE(areas.answers(areas.inputPresent, 127, 2));
  EXPECT_FALSE(areas.answers(areas.inputPresent, 1023, 2));
}

TEST(Areas, TheGenericCpuAnswersEverywhere) {
  const Areas areas(*findCpuModel("generic"));
  EXPECT_TRUE(areas.answers(areas.inputPresent, 65'532, 4));
  EXPECT_FALSE(areas.answers(areas.inputPresent, 65'533, 4));
}

// S7-OPND-11: a configured byte follows its module, or is 0 while the module does not answer.
// Bytes of no module stay, also beside others and at the end of an image of odd length.
TEST(Areas, InputsAreReadByteByByte) {
  for (std::uint32_t length = 1; length <= 18; ++length) {
    Areas areas(defaultCpuModel());
    areas.imageBytes = length;
    areas.inputConfigured.assign(length, false);
    const auto before = [](std::uint32_t i) { return static_cast<std::uint8_t>(0x80 + i); };
    for (std::uint32_t i = 0; i < length + 2; ++i) {
      if (i < length) areas.inputConfigured[i] = i % 3 != 0;
      areas.inputPresent[i] = i % 4 != 1;
      areas.inputs[i] = static_cast<std::uint8_t>(0x11 + i);
      *areas.input(i) = before(i);
    }
    areas.readInputs();
    for (std::uint32_t i = 0; i < length + 2; ++i) {
      const bool module = i < length && i % 3 != 0;
      const std::uint8_t terminal = i % 4 != 1 ? areas.inputs[i] : 0;
      EXPECT_EQ(*areas.input(i), module ? terminal : before(i)) << i << " of " << length;
    }
  }
}

// S7-BLK-07 … -15
TEST(Priorities, FollowTheTable) {
  const struct {
    int ob, priority;
  } rows[] = {{1, 1},   {10, 2},  {17, 2},   {20, 3},   {23, 6},  {30, 7},
              {35, 12}, {38, 15}, {40, 16},  {47, 23},  {50, 24}, {60, 25},
              {80, 26}, {87, 26}, {100, 27}, {102, 27}, {2, 0},   {121, 0}};
  for (const auto& row : rows)
    EXPECT_EQ(priorityOf(static_cast<std::uint8_t>(row.ob)), row.priority) << row.ob;
}

// S7-OBI-13, S7-OBI-15
TEST(SyncErrors, HaveEventAndAccessByte) {
  const SyncError length{
      .code = ErrorCode::LengthRead, .area = Area::Flag, .width = Width::Word, .detail = 300};
  EXPECT_EQ(length.event(), 0x2522);
  EXPECT_EQ(length.accessByte(), 0x23);
  EXPECT_EQ(describe(length), "area length error when reading: MW 300");
  const SyncError access{.code = ErrorCode::PeripheralRead,
                         .area = Area::Peripheral,
                         .width = Width::Word,
                         .detail = 400};
  EXPECT_EQ(access.event(), 0x2942);
  EXPECT_EQ(access.accessByte(), 0x20);
  EXPECT_EQ(describe(access), "I/O access error when reading: PEW 400");
  SyncError writing = access;
  writing.code = ErrorCode::PeripheralWrite;
  EXPECT_EQ(describe(writing), "I/O access error when writing: PAW 400");
}

}  // namespace
}  // namespace merker::cpu
