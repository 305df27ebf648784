// Whole listings: parameter lists behind calls, words that are no instruction.
#include "mc7/disassembly.h"

#include <gtest/gtest.h>

#include <random>

#include "mc7/instruction.h"

namespace merker::mc7 {
namespace {

using Bytes = std::vector<std::uint8_t>;

std::string listing(const Bytes& code, Mnemonics mnemonics = Mnemonics::German) {
  std::string text;
  for (const Line& line : disassemble(code, mnemonics)) text += toString(line) + "\n";
  return text;
}

TEST(Disassembly, OneInstructionALine) {
  EXPECT_EQ(
      listing({0x00, 0x10, 0x00, 0x80, 0xD8, 0x84, 0x38, 0x07, 0x12, 0x34, 0x56, 0x78, 0x65, 0x00}),
      "0000: 00100080      U     E 128.0\n"
      "0004: D884          =     A 4.0\n"
      "0006: 380712345678  L     DW#16#12345678\n"
      "000C: 6500          BE\n");
}

// MC7 section 7.2: the list has (k - 2) / 2 entries.
const Bytes kCall{0x3D, 0x05, 0x70, 0x0B, 0x00, 0x0A,  // UC FC 5
                  0x87, 0x00, 0x00, 0x00,              // V 0.0
                  0x81, 0x00, 0x00, 0x09,              // E 1.1
                  0x84, 0x00, 0x00, 0x10,              // DBX 2.0
                  0x00, 0x07, 0x00, 0x00,              // a timer
                  0x65, 0x00};

TEST(Disassembly, ShowsTheParameterListOfACall) {
  EXPECT_EQ(listing(kCall),
            "0000: 3D05          UC    FC 5\n"
            "0002: 700B000A      SPA   10\n"
            "0006: 87000000            P#V 0.0\n"
            "000A: 81000009            P#E 1.1\n"
            "000E: 84000010            P#DBX 2.0\n"
            "0012: 00070000            7\n"
            "0016: 6500          BE\n");
}

// Neither a pointer nor a number: an area that there is none, bits that no pointer has.
TEST(Disassembly, OtherEntriesAreShownAsTheyAre) {
  const Bytes code{0x3D, 0x05, 0x70, 0x0B, 0x00, 0x06, 0x99, 0x00,
                   0x00, 0x01, 0x84, 0x80, 0x00, 0x10, 0x65, 0x00};
  const auto lines = disassemble(code, Mnemonics::German);
  ASSERT_EQ(lines.size(), 5u);
  EXPECT_EQ(lines[2].text, "      DW#16#99000001");
  EXPECT_EQ(lines[3].text, "      DW#16#84800010");
}

TEST(Disassembly, AreasFollowTheMnemonics) {
  const auto lines = disassemble(kCall, Mnemonics::International);
  EXPECT_EQ(lines[1].text, "JU    10");
  EXPECT_EQ(lines[3].text, "      P#I 1.1");
  EXPECT_EQ(lines[3].kind, LineKind::Parameter);
}

TEST(Disassembly, SystemFunctionsHaveAListFunctionBlocksHaveNone) {
  EXPECT_EQ(
      disassemble(Bytes{0xFB, 0x74, 0, 20, 0x70, 0x0B, 0, 4, 0x86, 0, 0, 0}, Mnemonics::German)[2]
          .text,
      "      P#L 0.0");
  EXPECT_EQ(
      disassemble(Bytes{0x75, 5, 0x70, 0x0B, 0, 4, 0x82, 0, 0x64, 1}, Mnemonics::German)[2].text,
      "U     M 0.2");
}

TEST(Disassembly, AListThatDoesNotFitIsCode) {
  // Longer than the code, shorter than the jump itself, odd.
  for (const std::uint8_t words : Bytes{0x40, 0x00, 0x05}) {
    const Bytes code{0x3D, 0x05, 0x70, 0x0B, 0x00, words, 0x65, 0x00, 0x65, 0x00};
    const auto lines = disassemble(code, Mnemonics::German);
    ASSERT_EQ(lines.size(), 4u);
    EXPECT_EQ(lines[2].text, "BE");
  }
}

// Command line contract: unknown words print as "illegal" and the rest goes on.
TEST(Disassembly, GoesOnAfterAnIllegalWord) {
  EXPECT_EQ(listing({0x03, 0x11, 0x65, 0x00, 0x30, 0x03, 0x00}),
            "0000: 0311          illegal\n"
            "0002: 6500          BE\n"
            "0004: 3003          illegal\n"
            "0006: 00            illegal\n");
}

TEST(Disassembly, CoversEveryByteOfAnyCode) {
  std::mt19937 random{7};
  for (int run = 0; run < 2000; ++run) {
    Bytes code(random() % 64);
    for (auto& byte : code) byte = static_cast<std::uint8_t>(random());
    std::size_t next = 0;
    for (const Line& line : disassemble(code, Mnemonics::International)) {
      ASSERT_EQ(line.offset, next);
      ASSERT_FALSE(line.bytes.empty());
      ASSERT_FALSE(line.text.empty());
      next += line.bytes.size();
    }
    ASSERT_EQ(next, code.size());
  }
}

TEST(Disassembly, FindsJumpsButNotThoseOverParameterLists) {
  Bytes code = kCall;
  code.insert(code.begin(), {0xFF, 0xF8, 0x00, 0x04});  // SPB 4
  code.insert(code.end(), {0x70, 0x09, 0x00, 0x01, 0x70, 0x0B, 0x00, 0x02, 0x70, 0x0B, 0x00, 0x02});
  EXPECT_EQ(jumpPositions(code), (std::vector<std::uint32_t>{0, 16, 18}));
}

// An entry of a parameter list is no call, whatever its bytes are.
TEST(Disassembly, FindsTheBlocksThatAreCalled) {
  Bytes code = kCall;
  code[6] = 0x3D;                                       // an entry that begins as UC FC 0
  code.insert(code.begin(), {0xFB, 0x74, 0x00, 0x41});  // UC SFC 65
  EXPECT_EQ(calledBlocks(code), (std::vector<BlockId>{{BlockKind::SFC, 65}, {BlockKind::FC, 5}}));
}

}  // namespace
}  // namespace merker::mc7
