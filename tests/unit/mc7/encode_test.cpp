// What encode refuses, and codes that another one stands for.
#include <gtest/gtest.h>

#include "mc7/encoding.h"

namespace merker::mc7 {
namespace {

using Bytes = std::vector<std::uint8_t>;

Bytes codeOf(Operation operation, const Operand& operand) {
  Bytes out;
  return encode(Instruction{operation, operand}, out) ? out : Bytes{};
}

// MC7 section 10: the limits of the short forms.
TEST(Encode, TakesTheShortFormAsFarAsItReaches) {
  EXPECT_EQ(codeOf(Operation::AND, memory(Area::Flag, Width::Bit, bitAddress(255, 7))),
            (Bytes{0x87, 0xFF}));
  EXPECT_EQ(codeOf(Operation::AND, memory(Area::Flag, Width::Bit, bitAddress(256))),
            (Bytes{0x00, 0x30, 0x01, 0x00}));
  EXPECT_EQ(codeOf(Operation::ASSIGN, memory(Area::Output, Width::Bit, bitAddress(127, 7))),
            (Bytes{0xDF, 0xFF}));
  EXPECT_EQ(codeOf(Operation::ASSIGN, memory(Area::Output, Width::Bit, bitAddress(128))),
            (Bytes{0x41, 0x20, 0x00, 0x80}));
  EXPECT_EQ(codeOf(Operation::LOAD, memory(Area::Input, Width::Word, bitAddress(127))),
            (Bytes{0x52, 0x7F}));
  EXPECT_EQ(codeOf(Operation::LOAD, number(OperandKind::Timer, 255)), (Bytes{0x02, 0xFF}));
  EXPECT_EQ(codeOf(Operation::LOAD, number(OperandKind::Timer, 256)),
            (Bytes{0xFB, 0xE6, 0x01, 0x00}));
  EXPECT_EQ(codeOf(Operation::OPEN, blockOperand(BlockKind::DB, 255)), (Bytes{0x20, 0xFF}));
  EXPECT_EQ(codeOf(Operation::OPEN, blockOperand(BlockKind::DB, 255, true)),
            (Bytes{0xFB, 0x79, 0x00, 0xFF}));
}

TEST(Encode, RefusesWhatHasNoCode) {
  const auto refused = [](Operation operation, const Operand& operand) {
    return codeOf(operation, operand).empty();
  };
  // Bits of the periphery do not exist (S7-ADDR), nor does V outside of a parameter list.
  EXPECT_TRUE(refused(Operation::AND, memory(Area::Peripheral, Width::Bit, 0)));
  EXPECT_TRUE(refused(Operation::AND, memory(Area::CallerLocal, Width::Bit, 0)));
  EXPECT_TRUE(refused(Operation::LOAD, memory(Area::None, Width::Word, 0)));
  EXPECT_TRUE(refused(Operation::LOAD, memory(Area::Flag, Width::Bit, 0)));
  // Addresses beyond 16 bits and words that do not begin at a byte.
  EXPECT_TRUE(refused(Operation::LOAD, memory(Area::Flag, Width::Word, bitAddress(65536))));
  EXPECT_TRUE(refused(Operation::LOAD, memory(Area::Flag, Width::Word, 3)));
  EXPECT_TRUE(refused(Operation::LOAD, memoryIndirect(Area::Flag, Width::Word, Area::Input, 0)));
  EXPECT_TRUE(refused(Operation::LOAD, memoryIndirect(Area::Flag, Width::Word, Area::Flag, 65536)));
  EXPECT_TRUE(refused(Operation::LOAD, registerIndirect(Area::Flag, Width::Word, 3, 0)));
  EXPECT_TRUE(refused(Operation::LOAD, registerCrossing(Width::Word, 1, 65536)));
  // Operations that do not take the operand.
  EXPECT_TRUE(refused(Operation::TRANSFER, constant(ConstantFormat::Integer, 5)));
  EXPECT_TRUE(refused(Operation::COUNT_UP, number(OperandKind::Timer, 5)));
  EXPECT_TRUE(refused(Operation::TIMER_SE, number(OperandKind::Counter, 5)));
  EXPECT_TRUE(refused(Operation::AND, {}));
  EXPECT_TRUE(refused(Operation::LAR1, memory(Area::Input, Width::DWord, 0)));
  EXPECT_TRUE(refused(Operation::CC, blockOperand(BlockKind::SFC, 20)));
  EXPECT_TRUE(refused(Operation::SRD, number(OperandKind::ShiftCount, 33)));
  EXPECT_TRUE(refused(Operation::SLW, number(OperandKind::ShiftCount, 16)));
  EXPECT_TRUE(refused(Operation::SPA, number(OperandKind::Jump, 32768)));
  EXPECT_TRUE(refused(Operation::AND, number(OperandKind::StatusBit, 3)));
}

TEST(Encode, LeavesTheOutputAsItWasWhenItRefuses) {
  Bytes out{0x12};
  EXPECT_FALSE(encode({Operation::AND, {}}, out));
  EXPECT_EQ(out, Bytes{0x12});
  EXPECT_TRUE(encode({Operation::BE, {}}, out));
  EXPECT_EQ(out, (Bytes{0x12, 0x65, 0x00}));
}

TEST(Encode, JumpsGoBothWays) {
  EXPECT_EQ(codeOf(Operation::SPA, number(OperandKind::Jump, static_cast<std::uint32_t>(-2))),
            (Bytes{0x70, 0x0B, 0xFF, 0xFE}));
  EXPECT_EQ(codeOf(Operation::SPA, number(OperandKind::Jump, 32767)),
            (Bytes{0x70, 0x0B, 0x7F, 0xFF}));
}

// A code that is shown like another one keeps its own row (FB CA; MC7 section 5).
TEST(Encode, AliasesComeBackThroughTheirOwnRow) {
  for (const Bytes& code : {Bytes{0xFB, 0xCA, 0x00, 0x02}}) {
    const auto decoded = decode(code);
    ASSERT_TRUE(decoded);
    Bytes same, preferred;
    EXPECT_TRUE(encode(*decoded->encoding, decoded->instruction.operand, same));
    EXPECT_EQ(same, code);
    EXPECT_TRUE(encode(decoded->instruction, preferred));
    EXPECT_NE(preferred, code);
    EXPECT_EQ(decode(preferred)->instruction, decoded->instruction);
  }
}

// What STEP 7 writes in every block: L P##p is FB CB, the first word of an ANY is 30 00 (MC7
// sections 3 and 5).
TEST(Encode, CodesOfStep7) {
  EXPECT_EQ(codeOf(Operation::LOAD, number(OperandKind::ParameterAddress, 0)),
            (Bytes{0xFB, 0xCB, 0x00, 0x02}));
  EXPECT_EQ(codeOf(Operation::LOAD, anyHeader(0x1002)), (Bytes{0x30, 0x00, 0x10, 0x02}));
  EXPECT_EQ(codeOf(Operation::LOAD, constant(ConstantFormat::Word, 0x1002)),
            (Bytes{0x30, 0x07, 0x10, 0x02}));
}

// MC7 section 9: free codes and values that no field allows.
TEST(Decode, FreeCodesAreIllegal) {
  for (const Bytes& code : {Bytes{0x03, 0x00},
                            Bytes{0x40, 0x00},
                            Bytes{0xFA, 0x00},
                            Bytes{0x00, 0x01},
                            Bytes{0x00, 0x70, 0, 0},
                            Bytes{0x00, 0x18, 0, 0},
                            Bytes{0x51, 0x20, 0, 0},
                            Bytes{0x51, 0x30, 0, 0},
                            Bytes{0x59, 0xB1, 0, 0},
                            Bytes{0x79, 0x16, 0, 0},
                            Bytes{0xFF, 0x30},
                            Bytes{0xFF, 0xF0},
                            Bytes{0xBF, 0x37, 0, 0},
                            Bytes{0xBF, 0xBC, 0, 0},
                            Bytes{0xBA, 0x38, 0, 0},
                            Bytes{0x7E, 0x00, 0, 0},
                            Bytes{0x7E, 0x04, 0, 0},
                            Bytes{0xFB, 0x80, 0, 0},
                            Bytes{0xFB, 0x80, 0, 3},
                            Bytes{0xFE, 0xE1},
                            Bytes{0x30, 0x01, 0, 0},
                            Bytes{0xFB, 0x68},
                            Bytes{0x65},
                            Bytes{}})
    EXPECT_FALSE(decode(code)) << ::testing::PrintToString(code);
}

}  // namespace
}  // namespace merker::mc7
