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

// Several codes show the same text (aliases, long forms); assembling gives the preferred one.
TEST(Assemble, TextOfEveryRowComesBackAsTheSameInstruction) {
  for (const mc7::Encoding& row : mc7::encodings()) {
    const auto list = operands(row);
    EXPECT_FALSE(list.empty()) << row.pattern;
    for (const mc7::Operand& operand : list) {
      // A REAL that is no number has no notation.
      if (operand.format == ConstantFormat::Real && operand.kind == mc7::OperandKind::Constant)
        continue;
      for (const Mnemonics mnemonics : {Mnemonics::German, Mnemonics::International}) {
        const std::string text = mc7::text({row.operation, operand}, mnemonics);
        const auto parsed = parseInstruction(text, {"test", 1, 1, 1});
        const bool german =
            mnemonics == Mnemonics::German || row.operation != mc7::Operation::TIMER_SV;
        if (!parsed) {
          const bool shown = parsed.error().message.find("outside") != std::string::npos ||
                             parsed.error().message.find("no such") != std::string::npos ||
                             parsed.error().message.find("not a constant") != std::string::npos ||
                             parsed.error().message.find("written") != std::string::npos;
          EXPECT_TRUE(shown) << text << ": " << parsed.error().message;
          continue;
        }
        // International SE is the German SV; alone, SE counts as German.
        if (german) {
          EXPECT_EQ(mc7::text(*parsed, mnemonics), text);
        }
      }
    }
  }
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
