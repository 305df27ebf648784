// Every row of the machine code table as text and back: what the disassembler prints, the assembler
// takes.
#include <gtest/gtest.h>

#include <random>

#include "mc7/encoding.h"
#include "step7/compiler.h"

namespace merker::step7 {
namespace {

// Some codes that fit the row: all fields at their limits and at random.
std::vector<mc7::Operand> operands(const mc7::Encoding& row) {
  std::vector<mc7::Operand> list;
  std::mt19937_64 random(1);
  for (int i = 0; i < 400 && list.size() < 12; ++i) {
    const std::uint64_t fill = i == 0 ? 0 : i == 1 ? ~0ull : random();
    const std::uint64_t code = ((fill & ~row.mask) | row.bits) & 0xFFFF'FFFF'FFFF;
    if (const auto operand = mc7::decodeOperand(row, code)) list.push_back(*operand);
  }
  return list;
}

const Position kPlace{"test", 1, 1, 1};

// Values that a constant cannot have are shown as they are, and refused.
bool isOutOfRange(const Problem& problem) {
  for (const char* words : {"outside", "no such", "not a constant", "written"})
    if (problem.message.find(words) != std::string::npos) return true;
  return false;
}

void expectSame(const mc7::Instruction& instruction, Mnemonics mnemonics) {
  const std::string text = mc7::text(instruction, mnemonics);
  const auto parsed = parseInstruction(text, kPlace, mnemonics);
  if (!parsed)
    EXPECT_TRUE(isOutOfRange(parsed.error())) << text << ": " << parsed.error().message;
  else
    EXPECT_EQ(mc7::text(*parsed, mnemonics), text);
  // International SE is the German SV; without a setting, SE counts as German.
  const bool german =
      mnemonics == Mnemonics::German || instruction.operation != mc7::Operation::TIMER_SV;
  const auto either = parseInstruction(text, kPlace);
  EXPECT_EQ(bool(either), bool(parsed)) << text;
  if (either && german) {
    EXPECT_EQ(mc7::text(*either, mnemonics), text);
  }
}

// Several codes show the same text (aliases, long forms); assembling gives the preferred one.
TEST(Assemble, TextOfEveryRowComesBackAsTheSameInstruction) {
  for (const mc7::Encoding& row : mc7::encodings()) {
    const auto list = operands(row);
    EXPECT_FALSE(list.empty()) << row.pattern;
    for (const mc7::Operand& operand : list) {
      // A REAL that is no number has no notation.
      if (operand.format == ConstantFormat::Real && operand.kind == mc7::OperandKind::Constant)
        continue;
      for (const Mnemonics mnemonics : {Mnemonics::German, Mnemonics::International})
        expectSame({row.operation, operand}, mnemonics);
    }
  }
}

// S7-MNE-03: SE is an on-delay in German mnemonics and an extended pulse in international ones.
TEST(Assemble, TheSettingDecidesWordsOfBoth) {
  const auto operation = [](std::optional<Mnemonics> setting) {
    const auto parsed = parseInstruction("SE T 1", kPlace, setting);
    return parsed ? parsed->operation : mc7::Operation::NOP0;
  };
  EXPECT_EQ(operation({}), mc7::Operation::TIMER_SE);
  EXPECT_EQ(operation(Mnemonics::German), mc7::Operation::TIMER_SE);
  EXPECT_EQ(operation(Mnemonics::International), mc7::Operation::TIMER_SV);
  const auto code = [](std::string_view text, std::optional<Mnemonics> setting) {
    return parseInstruction(text, kPlace, setting)
               ? ""
               : std::string(parseInstruction(text, kPlace, setting).error().name());
  };
  EXPECT_EQ(code("A I 0.0", {}), "");
  EXPECT_EQ(code("A I 0.0", Mnemonics::German), "P0314");
  EXPECT_EQ(code("U E 0.0", Mnemonics::International), "P0315");
  EXPECT_EQ(code("A E 0.0", Mnemonics::International), "P0315");
}

// "3:7 P0352": the place of the word, not of the line.
TEST(Assemble, ProblemsStandAtTheirWord) {
  const auto problem = [](std::string_view text) {
    const auto parsed = parseInstruction(text, {"test", 3, 2, 1});
    if (parsed) return std::string("none");
    const Problem& error = parsed.error();
    return fmt::format("{}:{}+{} {}", error.position.line, error.position.column,
                       error.position.length, error.name());
  };
  EXPECT_EQ(problem("SPA   99999"), "3:8+5 P0352");
  EXPECT_EQ(problem("SPA   xyz"), "3:8+3 P0346");
  EXPECT_EQ(problem("XYZ 5"), "3:2+3 P0334");
  EXPECT_EQ(problem("U X 1.0"), "3:4+1 P0317");
  EXPECT_EQ(problem("A X 1.0"), "3:4+1 P0317");
  EXPECT_EQ(problem("L MW 4 5"), "3:9+1 P0302");
  EXPECT_EQ(problem("U MW 4"), "3:4+4 P0311");
  EXPECT_EQ(problem("SLW 16"), "3:6+2 P0311");
  EXPECT_EQ(problem("L"), "3:3+1 P0316");
}

TEST(Assemble, RefusesWhatIsNoInstruction) {
  for (const char* text :
       {"", "XYZ", "U", "U MW 4", "L M 0.0", "T PEB 0 1", "SLW 16", "SPA", "U E 0.8"}) {
    const auto parsed = parseInstruction(text, {"test", 1, 1, 1});
    std::vector<std::uint8_t> code;
    EXPECT_FALSE(parsed && mc7::encode(*parsed, code)) << text;
  }
}

}  // namespace
}  // namespace merker::step7
