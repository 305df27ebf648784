#include <gtest/gtest.h>

#include "rig.h"

namespace merker::interpreter::test {
namespace {

constexpr std::uint32_t kA1 = 0x80, kDirty = 0x1F0;  // OV, A0 and A1 set before

struct Row {
  Operation operation;
  std::uint32_t count, before, after;
  bool last;
};

// Counts of the instruction and of AKKU2-LL give the same.
void expectAll(std::initializer_list<Row> rows) {
  for (const Row& row : rows) {
    const auto name = mc7::info(row.operation).de;
    const std::uint32_t status = 0x110u | (row.last ? kA1 : 0u);
    const cpu::Registers fromAccu = execute({row.operation, {}}, {{row.before, row.count}, kDirty});
    EXPECT_EQ(fromAccu.accu[0], row.after) << name << " " << row.count;
    EXPECT_EQ(fromAccu.status.word(), status) << name << " " << row.count;
    if (row.count > 15) continue;
    const cpu::Registers direct =
        execute({row.operation, shiftBy(row.count)}, {{row.before, 9}, kDirty});
    EXPECT_EQ(direct.accu[0], row.after) << name << " " << row.count;
    EXPECT_EQ(direct.status.word(), status) << name << " " << row.count;
  }
}

// S7-INSTR-75, S7-INSTR-77, S7-STW-12
TEST(Shift, Words) {
  expectAll({{Operation::SLW, 1, 0xABCD8001, 0xABCD0002, true},
             {Operation::SLW, 15, 0x0003, 0x8000, true},
             {Operation::SLW, 16, 0x0001, 0x0000, true},
             {Operation::SLW, 17, 0xFFFF, 0x0000, false},
             {Operation::SLW, 255, 0xFFFF, 0x0000, false},
             {Operation::SRW, 1, 0xABCD8001, 0xABCD4000, true},
             {Operation::SRW, 15, 0x8000, 0x0001, false},
             {Operation::SRW, 16, 0x8000, 0x0000, true},
             {Operation::SRW, 17, 0xFFFF, 0x0000, false}});
}

// S7-INSTR-76, S7-INSTR-78
TEST(Shift, DoubleWords) {
  expectAll({{Operation::SLD, 1, 0x80000001, 0x00000002, true},
             {Operation::SLD, 31, 0x00000003, 0x80000000, true},
             {Operation::SLD, 32, 0x00000001, 0, true},
             {Operation::SLD, 33, 0xFFFFFFFF, 0, false},
             {Operation::SLD, 255, 0xFFFFFFFF, 0, false},
             {Operation::SRD, 1, 0x80000001, 0x40000000, true},
             {Operation::SRD, 32, 0x80000000, 0, true},
             {Operation::SRD, 33, 0xFFFFFFFF, 0, false}});
}

// S7-INSTR-79, S7-INSTR-80
TEST(Shift, Signed) {
  expectAll({{Operation::SSI, 4, 0x12348000, 0x1234F800, false},
             {Operation::SSI, 1, 0x0003, 0x0001, true},
             {Operation::SSI, 16, 0x8000, 0xFFFF, true},
             {Operation::SSI, 200, 0x8000, 0xFFFF, true},
             {Operation::SSI, 200, 0x7FFF, 0x0000, false},
             {Operation::SSD, 4, 0x80000000, 0xF8000000, false},
             {Operation::SSD, 32, 0x80000000, 0xFFFFFFFF, true},
             {Operation::SSD, 200, 0x7FFFFFFF, 0, false}});
}

// S7-INSTR-81, S7-INSTR-82, S7-OPEN-49
TEST(Rotate, DoubleWords) {
  expectAll({{Operation::RLD, 1, 0x80000001, 0x00000003, true},
             {Operation::RLD, 32, 0x80000001, 0x80000001, true},
             {Operation::RLD, 33, 0x80000001, 0x00000003, true},
             {Operation::RRD, 1, 0x00000001, 0x80000000, true},
             {Operation::RRD, 4, 0x00000010, 0x00000001, false},
             {Operation::RRD, 33, 0x00000001, 0x80000000, true}});
}

// Count 0: not even the status word changes (S7-INSTR-75, S7-INSTR-81).
TEST(Shift, ByZeroDoesNothing) {
  for (const Operation operation :
       {Operation::SLW, Operation::SLD, Operation::SRW, Operation::SRD, Operation::SSI,
        Operation::SSD, Operation::RLD, Operation::RRD}) {
    for (const Operand& operand : {Operand{}, shiftBy(0)}) {
      const cpu::Registers r = execute({operation, operand}, {{0x12345678, 0}, kDirty});
      EXPECT_EQ(r.accu[0], 0x12345678u);
      EXPECT_EQ(r.status.word(), kDirty);
    }
  }
}

// S7-INSTR-83, S7-INSTR-84: a ring of 33 bits.
TEST(Rotate, ThroughA1) {
  for (const Operation operation : {Operation::RLDA, Operation::RRDA}) {
    State state{{0x9ABCDEF1}, 0x80};
    for (int i = 0; i < 33; ++i) {
      const cpu::Registers r = execute({operation, {}}, state);
      state.accu = r.accu;
      state.status = r.status.word();
      if (i == 0 && operation == Operation::RLDA) {
        EXPECT_EQ(r.accu[0], 0x3579BDE3u);
      }
    }
    EXPECT_EQ(state.accu[0], 0x9ABCDEF1u);
    EXPECT_EQ(state.status, 0x80u);
  }
}

}  // namespace
}  // namespace merker::interpreter::test
