#include <gtest/gtest.h>

#include "io/terminal_address.h"
#include "make.h"

namespace merker::io {
namespace {

const CpuModel& generic() { return *findCpuModel("generic"); }

// The course's table, chapter 3.5 (S7-HW-22 to S7-HW-25): first row digital, second analog.
struct Row {
  std::uint32_t digital[8], analog[8];
};
constexpr Row kTable[4] = {
    {{0, 4, 8, 12, 16, 20, 24, 28}, {256, 272, 288, 304, 320, 336, 352, 368}},
    {{32, 36, 40, 44, 48, 52, 56, 60}, {384, 400, 416, 432, 448, 464, 480, 496}},
    {{64, 68, 72, 76, 80, 84, 88, 92}, {512, 528, 544, 560, 576, 592, 608, 624}},
    {{96, 100, 104, 108, 112, 116, 120, 124}, {640, 656, 672, 688, 704, 720, 736, 752}}};

// All four racks full of one type of module, rack 0 first.
std::vector<Module> full(std::string_view type) {
  std::vector<Module> modules{make(0, 3, "IM 360")};
  for (std::uint32_t rack = 0; rack < 4; ++rack) {
    if (rack > 0) modules.push_back(make(rack, 3, "IM 361"));
    for (std::uint32_t slot = 4; slot <= 11; ++slot) modules.push_back(make(rack, slot, type));
  }
  return modules;
}

void expectTable(std::string_view type, bool analog) {
  const Configuration configuration = good(full(type), generic());
  for (const Module& module : configuration.modules) {
    if (!module.type->signalModule()) continue;
    const Row& row = kTable[module.rack];
    EXPECT_EQ(module.inputStart, (analog ? row.analog : row.digital)[module.slot - 4])
        << module.slotText();
  }
}

// S7-HW-20, S7-HW-22, S7-HW-23, S7-HW-24, S7-HW-25
TEST(Addresses, digitalSlots) { expectTable("SM 321 DI32xDC24V", false); }
// S7-HW-21, S7-HW-22, S7-HW-23, S7-HW-24, S7-HW-25
TEST(Addresses, analogSlots) { expectTable("6ES7 331-7KF02-0AB0", true); }

// S7-HW-26: 8 channels in rack 0 slot 4 are PEW 256 to PEW 270
TEST(Addresses, eightAnalogChannelsFillTheSlot) {
  const Configuration configuration = good({make(0, 4, "6ES7 331-7KF02-0AB0")});
  EXPECT_TRUE(configuration.hasInput(256));
  EXPECT_TRUE(configuration.hasInput(271));
  EXPECT_FALSE(configuration.hasInput(272));
}

// S7-HW-27: two bytes in slot 4, E 2.0 has no module behind it
TEST(Addresses, unusedBytesOfASlot) {
  const Configuration configuration =
      good({make(0, 4, "SM 321 DI16xDC24V"), make(0, 5, "SM 321 DI16xDC24V")});
  EXPECT_TRUE(configuration.hasInput(1));
  EXPECT_FALSE(configuration.hasInput(2));
  EXPECT_TRUE(configuration.hasInput(4));
  EXPECT_FALSE(configuration.hasOutput(0));
}

Module addressed(std::uint32_t slot, std::string_view type, std::uint32_t start) {
  Module module = make(0, slot, type);
  module.inputStart = start;
  return module;
}

// S7-HW-28: 2 is free behind a module at 0, 1 is not
TEST(Addresses, freeAddresses) {
  const auto second = [](std::uint32_t start) {
    return std::vector<Module>{make(0, 4, "SM 321 DI16xDC24V"),
                               addressed(5, "SM 321 DI16xDC24V", start)};
  };
  EXPECT_TRUE(good(second(2)).hasInput(3));
  EXPECT_EQ(problemsOf(second(1)), std::vector<std::string>{"P0733"});
}

// S7-CPU-11: 1022 is the last word
TEST(Addresses, endOfTheArea) {
  EXPECT_TRUE(good({addressed(4, "SM 321 DI16xDC24V", 1022)}).hasInput(1023));
  EXPECT_EQ(problemsOf({addressed(4, "SM 321 DI16xDC24V", 1023)}),
            std::vector<std::string>{"P0734"});
}

// S7-CPU-18, S7-HWCFG-02
TEST(Addresses, onBoard) {
  const Configuration configuration = good({});
  ASSERT_EQ(configuration.modules.size(), 4u);
  EXPECT_EQ(configuration.find("2.2")->inputStart, 124u);
  EXPECT_EQ(configuration.find("2.2")->inputEnd(), 126u);
  EXPECT_EQ(configuration.find("2.2")->outputStart, 124u);
  EXPECT_EQ(configuration.find("2.2")->outputEnd(), 125u);
  EXPECT_EQ(configuration.find("2.3")->inputStart, 752u);
  EXPECT_EQ(configuration.find("2.3")->inputEnd(), 761u);
  EXPECT_EQ(configuration.find("2.3")->outputEnd(), 755u);
  EXPECT_EQ(configuration.find("2.4")->inputStart, 768u);
  EXPECT_EQ(configuration.find("2.5")->outputEnd(), 799u);
}

// S7-CPU-18, S7-HWCFG-03, S7-OPEN-33: all changeable
TEST(Addresses, onBoardMoved) {
  Module module = onBoard(2);
  module.inputStart = 0;
  module.outputStart = 0;
  const Configuration configuration = good({module});
  EXPECT_TRUE(configuration.hasInput(2));
  EXPECT_FALSE(configuration.hasInput(124));
}

// S7-HW-34, S7-OPEN-34: rack 3 slot 11 meets the on-board addresses until one of them is changed
TEST(Addresses, lastSlotOfACompactCpu) {
  std::vector<Module> modules = full("SM 321 DI16xDC24V");
  EXPECT_EQ(problemsOf(modules), std::vector<std::string>{"P0733"});
  modules.pop_back();
  good(modules);
}

TEST(Addresses, modulesAreFoundByNameAndSlot) {
  Module module = make(0, 4, "SM 321 DI16xDC24V");
  module.name = "Conveyor";
  const Configuration configuration = good({module});
  EXPECT_EQ(configuration.find("conveyor"), configuration.find("4"));
  EXPECT_EQ(configuration.find("0/4"), configuration.find("4"));
  EXPECT_EQ(configuration.find("5"), nullptr);
}

// S7-HW-20, S7-HW-21: the terminal at an address, in either language; nothing where none lies.
TEST(Addresses, terminalsBehindThem) {
  const Configuration configuration =
      good({make(0, 4, "SM 321 DI16xDC24V"), make(0, 5, "6ES7 331-7KF02-0AB0")});
  const auto at = [&](std::string_view text) -> std::optional<Terminal> {
    const auto address = parseTerminalAddress(text);
    return address ? terminalAt(configuration, *address) : std::nullopt;
  };
  const auto input = at("E 1.3"), analog = at("PEW 274");
  ASSERT_TRUE(input && analog);
  EXPECT_EQ(*input, (Terminal{input->module, Side::DigitalInput, 11}));
  EXPECT_EQ(*analog, (Terminal{analog->module, Side::AnalogInput, 1}));
  EXPECT_EQ(configuration.modules[input->module].slot, 4u);
  EXPECT_EQ(at("i 1.3"), input);
  EXPECT_EQ(at("PIW 274"), analog);
  EXPECT_EQ(at("EW 274"), analog);
  for (const char* none : {"E 2.0", "A 1.3", "PEW 275", "PEW 288", "EW 0"}) EXPECT_FALSE(at(none));
  for (const char* wrong :
       {"E 1.8", "E 1", "PEW 274.0", "M 1.3", "E1.3", "E x.3", "E 1.3 ", "4.DI0"})
    EXPECT_EQ(parseTerminalAddress(wrong).has_value(), std::string_view(wrong) == "E 1.3 ");
}

}  // namespace
}  // namespace merker::io
