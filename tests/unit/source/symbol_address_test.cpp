#include <gtest/gtest.h>

#include "source/symbol_table.h"

namespace merker::source {
namespace {

using Kind = SymbolAddress::Kind;

SymbolAddress memory(Area area, Width width, BitAddress address, bool output = false) {
  SymbolAddress result;
  result.area = area;
  result.width = width;
  result.address = address;
  result.peripheralOutput = output;
  return result;
}

std::string problem(std::string_view text) {
  const auto address = parseSymbolAddress(text, {});
  return address ? "accepted" : std::string(address.error().name());
}

// S7-SYM-09 to -12, both mnemonics (S7-MNE-11).
TEST(SymbolAddress, memoryInBothMnemonics) {
  struct Case {
    std::string_view german, international;
    SymbolAddress address;
  };
  const Case cases[] = {{"E30.2", "I 30.2", memory(Area::Input, Width::Bit, 242)},
                        {"EB 2", "ib2", memory(Area::Input, Width::Byte, 16)},
                        {"EW 10", "IW 10", memory(Area::Input, Width::Word, 80)},
                        {"ED 20", "ID 20", memory(Area::Input, Width::DWord, 160)},
                        {"A 10.1", "Q 10.1", memory(Area::Output, Width::Bit, 81)},
                        {"AB 2", "QB 2", memory(Area::Output, Width::Byte, 16)},
                        {"AW 6", "QW 6", memory(Area::Output, Width::Word, 48)},
                        {"AD 8", "QD 8", memory(Area::Output, Width::DWord, 64)},
                        {"M 2.1", "m2.1", memory(Area::Flag, Width::Bit, 17)},
                        {"MB 3", "MB   3", memory(Area::Flag, Width::Byte, 24)},
                        {"MW 10", "MW10", memory(Area::Flag, Width::Word, 80)},
                        {"MD 18", "MD 18", memory(Area::Flag, Width::DWord, 144)},
                        {"PEB 20", "PIB 20", memory(Area::Peripheral, Width::Byte, 160)},
                        {"PEW 40", "PIW 40", memory(Area::Peripheral, Width::Word, 320)},
                        {"PED 26", "PID 26", memory(Area::Peripheral, Width::DWord, 208)},
                        {"PAB 20", "PQB 20", memory(Area::Peripheral, Width::Byte, 160, true)},
                        {"PAW 40", "PQW 40", memory(Area::Peripheral, Width::Word, 320, true)},
                        {"PAD 26", "PQD 26", memory(Area::Peripheral, Width::DWord, 208, true)}};
  for (const Case& c : cases) {
    EXPECT_EQ(*parseSymbolAddress(c.german, {}), c.address) << c.german;
    EXPECT_EQ(*parseSymbolAddress(c.international, {}), c.address) << c.international;
  }
}

// S7-SYM-13
TEST(SymbolAddress, timersAndCounters) {
  EXPECT_EQ(parseSymbolAddress("T 1", {})->kind, Kind::Timer);
  EXPECT_EQ(parseSymbolAddress("T 1", {})->number, 1);
  EXPECT_EQ(parseSymbolAddress("Z 2", {})->kind, Kind::Counter);
  EXPECT_EQ(*parseSymbolAddress("C 2", {}), *parseSymbolAddress("Z 2", {}));
}

// S7-SYM-14, -16
TEST(SymbolAddress, blocks) {
  const std::pair<std::string_view, BlockId> cases[] = {
      {"FB 3", {BlockKind::FB, 3}},     {"FC 5", {BlockKind::FC, 5}},
      {"OB 10", {BlockKind::OB, 10}},   {"DB 1", {BlockKind::DB, 1}},
      {"SFB 10", {BlockKind::SFB, 10}}, {"SFC 20", {BlockKind::SFC, 20}},
      {"UDT   7", {BlockKind::UDT, 7}}};
  for (const auto& [text, id] : cases) {
    EXPECT_EQ(parseSymbolAddress(text, {})->kind, Kind::Block) << text;
    EXPECT_EQ(parseSymbolAddress(text, {})->block, id) << text;
  }
  EXPECT_EQ(parseSymbolAddress("VAT 1", {})->kind, Kind::VariableTable);
}

// S7-SYM-06, S7-SYM-15, S7-OPND-08
TEST(SymbolAddress, refusedOperands) {
  for (const std::string_view text :
       {"LW 2", "L 0.0", "LB 1", "DBX 0.0", "DBW 10", "DB100.DBW10", "DIX 0.0", "DID 4", "W#16#5",
        "5", "", "PE 0.0", "PA 0.0", "SDB 0", "AR1", "V 0.0"})
    EXPECT_NE(problem(text), "accepted") << text;
  EXPECT_EQ(problem("LW 2"), "P0804");
  EXPECT_EQ(problem("DB100.DBW10"), "P0804");
}

// S7-ADDR-02
TEST(SymbolAddress, bitNumbers) {
  EXPECT_EQ(problem("E 0.7"), "accepted");
  for (const std::string_view text : {"E 0.8", "M 0", "M 0.", "M .1", "MW 10.0", "MW", "MW 1x",
                                      "E 0.0.0", "T 1.0", "MW -1", "MW 65536", "M 1 .0 x"})
    EXPECT_EQ(problem(text), "P0805") << text;
}

}  // namespace
}  // namespace merker::source
