// A control as it looks from outside: its modules, its partner, its data, what its battery keeps.
#include <gtest/gtest.h>

#include "control/buffered.h"
#include "control/fault.h"
#include "control/reference.h"

namespace merker::cnc {
namespace {

address::Reference flagByte(std::uint16_t number, bool partner = false) {
  address::Reference reference;
  reference.text = "MB";
  reference.operand = address::memory(Area::Flag, Width::Byte, bitAddress(number));
  reference.partner = partner;
  return reference;
}

Options withModules() {
  Options options;
  auto& modules = options.plc.surroundings.modules;
  modules = {{.output = true, .first = 4, .bytes = 2}, {.output = false, .first = 4, .bytes = 4}};
  return options;
}

// S5-ERR-02: EB 4 is the input module, AB 4 the output module of the same bytes.
TEST(Fault, namesAModuleByItsBytes) {
  Cnc control(withModules());
  const auto& modules = control.plc().surroundings().modules;
  EXPECT_EQ(setFault(control, "EB 7", "removed", true), "");
  EXPECT_TRUE(modules[0].fitted);
  EXPECT_FALSE(modules[1].fitted);
  EXPECT_EQ(setFault(control, "QB 5", "removed", true), "");
  EXPECT_FALSE(modules[0].fitted);
  EXPECT_EQ(setFault(control, "IB 4", "removed", false), "");
  EXPECT_TRUE(modules[1].fitted);
  for (const char* nothing : {"MB 4", "AB 6", "EB 8", "EB 3", "EB", "EB 4x"})
    EXPECT_NE(setFault(control, nothing, "removed", true), "") << nothing;
}

TEST(Fault, comesAndGoes) {
  Cnc control(Options{});
  const auto& around = control.plc().surroundings();
  EXPECT_EQ(setFault(control, "jumpers", "wrong", true), "");
  EXPECT_FALSE(around.jumpersRight);
  EXPECT_EQ(setFault(control, "jumpers", "wrong", false), "");
  EXPECT_TRUE(around.jumpersRight);
}

std::span<const std::uint8_t> digits(std::string_view text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

std::string numberOf(const Cnc& control, const address::Reference& datum) {
  const auto read = control.readBytes(datum);
  return read ? std::string(read->begin(), read->end()) : "none";
}

// Data of the NC outlast a start, not a memory reset.
TEST(Coupled, aMemoryResetIsOneOfBoth) {
  Cnc control(Options{});
  control.couple(std::make_unique<Cnc>(Options{}), nc::Side::Control);
  const address::Reference own = *datumReference("nc.R 50");
  address::Reference others = own;
  others.partner = true;
  EXPECT_TRUE(control.write(flagByte(100), 1));
  EXPECT_TRUE(control.write(flagByte(100, true), 2));
  EXPECT_EQ(control.read(flagByte(100)), 1u);
  EXPECT_EQ(control.read(flagByte(100, true)), 2u);
  EXPECT_TRUE(control.writeBytes(own, digits("1.5")));
  EXPECT_TRUE(control.writeBytes(others, digits("2.5")));
  EXPECT_EQ(numberOf(control, own), "1.5");
  EXPECT_EQ(numberOf(control, others), "2.5");
  control.memoryReset();
  EXPECT_EQ(control.read(flagByte(100)), 0u);
  EXPECT_EQ(control.read(flagByte(100, true)), 0u);
  EXPECT_EQ(numberOf(control, own), "0");
  EXPECT_EQ(numberOf(control, others), "0");
}

TEST(Data, takeOnlyWhatTheyCanHold) {
  Cnc control(Options{});
  const address::Reference offset = *datumReference("nc.R 50");
  EXPECT_TRUE(control.writeBytes(offset, digits("1.5")));
  EXPECT_FALSE(control.writeBytes(offset, digits("1.5.5")));
  EXPECT_FALSE(control.writeBytes(flagByte(1), digits("1")));
  const address::Reference whole = *datumReference("nc.md 155");
  EXPECT_TRUE(control.writeBytes(whole, digits("3")));
  EXPECT_FALSE(control.writeBytes(whole, digits("1.5")));
  EXPECT_EQ(numberOf(control, whole), "3");
}

TEST(Missing, saysWhy) {
  Cnc control(Options{});
  EXPECT_EQ(control.whyMissing(flagByte(300)), "it is outside the areas of this PLC");
  address::Reference word = flagByte(2);
  word.operand.area = Area::DataBlock;
  word.db = 20;
  EXPECT_EQ(control.whyMissing(word), "there is no DB 20");
}

// The battery keeps segments of at most 32 kwords; a longer one on a card is damage.
TEST(Battery, keepsSegmentsOfASize) {
  Cnc control(Options{});
  Keeper keeper;
  block::RetentiveData data = keeper.look(control);
  ASSERT_EQ(data.dataBlocks.size(), 2u);
  Cnc other(Options{});
  EXPECT_TRUE(restore(other, data));
  for (auto& segment : data.dataBlocks) {
    const auto before = segment.bytes;
    segment.bytes.assign(0x10000, 0);
    EXPECT_TRUE(restore(other, data));
    segment.bytes.assign(0x10002, 0);
    EXPECT_FALSE(restore(other, data));
    segment.bytes.assign(3, 0);
    EXPECT_FALSE(restore(other, data));
    segment.bytes = before;
  }
  data.flags.pop_back();
  EXPECT_FALSE(restore(other, data));
}

}  // namespace
}  // namespace merker::cnc
