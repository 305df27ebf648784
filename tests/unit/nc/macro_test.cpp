// The macros as a whole: their headers, their errors, calls in raw machine code.
#include "mc5/resident_blocks.h"
#include "rig.h"
#include "step5/compiler.h"

namespace merker::nc {
namespace {

// S5-FM-02, S5-FM-24: the programmer sees what runs; FB 61 and FB 62 have eleven parameters.
TEST(Macros, HeadersBelongToWhatRuns) {
  const FunctionMacros macros;
  for (const mc5::Block& block : mc5::residentBlocks()) EXPECT_TRUE(macros.has(block.id.number));
  const char* const names[] = {"LESE", "NSBY", "ANZ",  "DTY1", "DTY2", "DTY3",
                               "WER1", "WER2", "WER3", "ZFPN", "ZIEL"};
  const mc5::Block* const reading = mc5::findResident(61);
  ASSERT_EQ(reading->parameters.size(), std::size(names));
  for (std::size_t i = 0; i < std::size(names); ++i)
    EXPECT_EQ(reading->parameters[i].name, names[i]);
  EXPECT_EQ(mc5::findResident(62)->parameters.front().name, "SCHR");
  EXPECT_EQ(mc5::findResident(62)->parameters.back().name, "QUEL");
}

// S5-FM-03: a project that has nothing of the macro but its call knows the parameters.
TEST(Macros, ParametersWithoutTheBlock) {
  std::vector<source::SourceFile> files;
  files.emplace_back("t.s5",
                     "OB 1\n:SPA FB 11\nNAME :EINR-DB\nDBAN : KY 100,3\nDWNR : KF 9\n:BE\n");
  const auto compiled = step5::compile(files, false);
  ASSERT_TRUE(compiled.ok());
  EXPECT_EQ(compiled.program.at({mc5::BlockType::Ob, 1}).words,
            (std::vector<std::uint16_t>{0x3D0B, 0x2D03, 0x6403, 9, 0x6500}));
}

// S5-FM-05: what the accumulators show has a text.
TEST(Macros, ErrorsHaveTexts) {
  ASSERT_NE(findMacroError(60, 2), nullptr);
  EXPECT_EQ(findMacroError(60, 2)->english, "number of data words is 0");
  EXPECT_EQ(findMacroError(61, 0x1F03)->german, "Datentyp unzulässig");
  EXPECT_EQ(findMacroError(11, 1), nullptr);  // not used
  EXPECT_EQ(findMacroError(190, 1), nullptr);
  EXPECT_EQ(macroErrors().size(), 37u);
}

// S5-FM-05: the alarm with its words.
TEST(Macros, AlarmWords) {
  Rig rig;
  ASSERT_TRUE(rig.start("OB 1\n:SPA FB 66\n:BE\n"));
  rig.cycles(1);
  const auto& fine = rig.plc->operatingSystem().record().fineCode();
  EXPECT_EQ(fine.number, 0x6114u);
  EXPECT_EQ(fine.words, (std::array<std::uint16_t, 3>{0, 1, 0x0066}));
}

// Machine code without the parameter list, or with a list that no programmer writes, is a wrong
// substitution; nothing outside the PLC fails.
TEST(Macros, CallsWithoutTheirList) {
  FunctionMacros macros;
  sinumerik::Machine machine(100, 100);
  machine.levels.push_back({});
  machine.levels.back().frames.push_back({});
  const std::vector<std::uint16_t> list(11, 0xFFFF);
  for (const mc5::Block& block : mc5::residentBlocks()) {
    if (block.parameters.empty()) continue;
    const auto trap = macros.call(block.id.number, machine, std::span(list).first(1));
    ASSERT_TRUE(trap.has_value());
    EXPECT_EQ(trap->alarm, sinumerik::Alarm::Substitution);
  }
  for (std::uint16_t macro : {std::uint16_t{61}, std::uint16_t{62}, std::uint16_t{190}})
    EXPECT_EQ(macros.call(macro, machine, list)->alarm, sinumerik::Alarm::Substitution);
}

// Any parameter list does no worse than stop the PLC.
TEST(Macros, RandomLists) {
  FunctionMacros macros;
  sinumerik::Machine machine(100, 1000);
  machine.levels.push_back({});
  machine.levels.back().frames.push_back({});
  machine.blocks.createData(36, 33);
  machine.blocks.createData(10, 100);
  std::uint32_t seed = 1;
  const auto random = [&seed] { return (seed = seed * 1664525 + 1013904223) >> 16; };
  const std::uint16_t usual[] = {0x8164, 0x2200, 1, 0x5250, 0x4E43, 0x2020,
                                 1,      50,     0, 0x4630, 0x0A00};
  std::uint16_t macro = 0;
  for (int i = 0; i < 200'000; ++i) {
    std::vector<std::uint16_t> list(std::begin(usual), std::end(usual));
    for (auto& word : list)
      if (random() % 4 == 0) word = static_cast<std::uint16_t>(random());
    for (auto& flag : machine.flags) flag = static_cast<std::uint8_t>(random());
    do macro = static_cast<std::uint16_t>(random() % 256);
    while (!macros.has(macro));
    macros.call(macro, machine, list);
    machine.clock = machine.clock + Duration::milliseconds(7);
    macros.advance(machine, machine.clock);
    macros.cycleBegins();
  }
  EXPECT_GT(machine.blocks.dataUsed(), 143u);  // FB 11 has created blocks
}

}  // namespace
}  // namespace merker::nc
