// Numbers at the edges of their ranges: what random programs seldom meet. Each result and its
// status bits are folded into a sum that both engines must agree on.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>

#include "comparison.h"
#include "jit/native.h"
#include "source.h"
#include "stand.h"

namespace merker::differential {
namespace {

// Of 16 bits, of 32 bits, BCD, REAL.
constexpr std::uint32_t kEdges[] = {
    0,          1,          2,          16,         99,         100,        255,        999,
    1000,       1001,       0x7FFE,     0x7FFF,     0x8000,     0x8001,     0xFC18,     0xFC19,
    0xFFFF,     0x10000,    0xFFFE7961, 0x0098967F, 0x00989680, 0xFF676981, 0xFF676980, 0x7FFFFFFF,
    0x80000000, 0x80000001, 0xFFFFFFFE, 0xFFFFFFFF, 0x0999,     0xF999,     0xF413,     0x099A,
    0x09999999, 0xF9999999, 0x00000009, 0x3F800000, 0xBF800000, 0x3F000000, 0x40200000, 0xC0200000,
    0x4EFFFFFF, 0x4F000000, 0xCF000000, 0xCF000001, 0x7F7FFFFF, 0x00800000, 0x00000001, 0x7F800000,
    0xFF800000, 0x7FC00000, 0x4B000001};

constexpr const char* kPairs[] = {
    "+I",  "-I",  "*I",  "/I",  "+D",  "-D",  "*D",  "/D",  "MOD", "==I", "<>I", ">I",
    "<I",  ">=I", "<=I", "==D", "<>D", ">D",  "<D",  ">=D", "<=D", "==R", "<>R", ">R",
    "<R",  ">=R", "<=R", "+R",  "-R",  "*R",  "/R",  "UW",  "OW",  "XOW", "UD",  "OD",
    "XOD", "SLW", "SRW", "SLD", "SRD", "SSI", "SSD", "RLD", "RRD", "TAK"};
constexpr const char* kSingles[] = {"ITB",           "BTI",
                                    "DTB",           "BTD",
                                    "ITD",           "DTR",
                                    "INVI",          "INVD",
                                    "NEGI",          "NEGD",
                                    "NEGR",          "ABS",
                                    "RND",           "RND+",
                                    "RND-",          "TRUNC",
                                    "SQR",           "SQRT",
                                    "TAW",           "TAD",
                                    "RLDA",          "RRDA",
                                    "SLW 1",         "SLW 0",
                                    "SLW 15",        "SRW 1",
                                    "SRW 15",        "SSI 1",
                                    "SSI 15",        "SLD 1",
                                    "SLD 31",        "SLD 32",
                                    "SRD 31",        "SRD 8",
                                    "SSD 1",         "SSD 31",
                                    "SSD 32",        "RLD 1",
                                    "RLD 31",        "RRD 1",
                                    "RRD 31",        "INC 1",
                                    "DEC 1",         "INC 255",
                                    "+ 1",           "+ -1",
                                    "+ 32767",       "+ L#-1",
                                    "UW W#16#8000",  "OW W#16#0",
                                    "XOW W#16#FFFF", "UD DW#16#80000000",
                                    "OD DW#16#0",    "XOD DW#16#FFFFFFFF"};

std::string table() {
  std::string text =
      "DATA_BLOCK DB 1\nSTRUCT\n sums : ARRAY [0..99] OF DWORD;\n edges : ARRAY [1..";
  text += fmt::format("{}] OF DWORD;\nEND_STRUCT;\nBEGIN\n", std::size(kEdges));
  for (std::size_t i = 0; i < std::size(kEdges); ++i)
    text += fmt::format(" edges[{}] := DW#16#{:X};\n", i + 1, kEdges[i]);
  return text + "END_DATA_BLOCK\n";
}

// AKKU 1, A1, A0, OV, OS, VKE into the sum at MD 16.
constexpr const char* kFold =
    "FUNCTION FC 1 : VOID\nBEGIN\nNETWORK\n L MW 12; UW W#16#F2; L MD 8; XOD; L DBD [MD 16]; RLD "
    "5; XOD;\n"
    " T DBD [MD 16]; L MD 16; L P#4.0; +D; T MD 16;\nEND_FUNCTION\n";

// One loop: MD 4 the place of the operand, MD 0 that of the other one.
std::string program(std::string_view operations, bool pairs) {
  const std::size_t first = 100 * 4 * 8, end = first + std::size(kEdges) * 32;
  std::string text = table() + kFold +
                     "ORGANIZATION_BLOCK OB 121\nBEGIN\nNETWORK\n NOP 0;\nEND_ORGANIZATION_BLOCK\n"
                     "FUNCTION FC 2 : VOID\nBEGIN\nNETWORK\n";
  text += operations;
  text += "END_FUNCTION\nORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\n AUF DB 1;\n";
  text += fmt::format(" L {}; T MD 0;\nnext: L {}; T MD 4;\n", fmt::format("DW#16#{:X}", first),
                      fmt::format("DW#16#{:X}", first));
  text += "all: CALL SFC 43; L L#0; T MD 16; UC FC 2;\n L MD 4; L L#32; +D; T MD 4;\n";
  text += fmt::format(" L DW#16#{:X}; <D; SPB all;\n", end);
  if (pairs) text += fmt::format(" L MD 0; L L#32; +D; T MD 0; L DW#16#{:X}; <D; SPB next;\n", end);
  return text + " CALL SFC 46;\nEND_ORGANIZATION_BLOCK\n";
}

std::string one(std::string_view loads, std::string_view operation) {
  return fmt::format(" L 0; T STW; {} {}; T MD 8; L STW; T MW 12; UC FC 1;\n", loads, operation);
}

// Both engines run it to its own STOP.
void agree(const std::string& text) {
  const std::string model = "314C-2 PtP";
  const auto program = std::make_shared<block::Program>(compiledText(text, *findModel(model)));
  ASSERT_TRUE(program->contains({BlockKind::OB, 1})) << text;
  const CpuParameters parameters = CpuParameters::of(*findModel(model));
  cpu::Cpu& interpreted = stand({.model = model, .compiled = false}).load(program, parameters);
  cpu::Cpu& compiled = stand({.model = model}).load(program, parameters);
  for (cpu::Cpu* cpu : {&interpreted, &compiled}) {
    cpu->restart(cpu::Restart::ManualWarm);
    const Instant latest = cpu->machine().clock + Duration::seconds(60);
    while (executes(cpu->mode()) && cpu->machine().clock < latest) cpu->step(latest);
    ASSERT_EQ(cpu->state().stopEvent().event, 0x457F) << cpu->state().stopEvent().text;  // SFC 46
  }
  EXPECT_EQ(compare(interpreted, compiled), "");
}

class Edges : public testing::Test {
 protected:
  void SetUp() override {
    if (!jit::available()) GTEST_SKIP() << "no compiler for this processor";
  }
};

// S7-INSTR-51 to S7-INSTR-84, S7-INSTR-12 to S7-INSTR-17
TEST_F(Edges, PairsOfNumbers) {
  std::string operations;
  for (const char* operation : kPairs) operations += one("L DBD [MD 0]; L DBD [MD 4];", operation);
  agree(program(operations, true));
}

// S7-INSTR-92 to S7-INSTR-104
TEST_F(Edges, SingleNumbers) {
  std::string operations;
  for (const char* operation : kSingles) operations += one("L DBD [MD 4];", operation);
  agree(program(operations, false));
}

}  // namespace
}  // namespace merker::differential
