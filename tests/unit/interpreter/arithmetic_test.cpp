// Results and status bits of arithmetic, comparison and word logic (S7-STW-09 … -13).
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>

#include "rig.h"

namespace merker::interpreter::test {
namespace {

constexpr std::uint32_t kA0 = 0x40, kA1 = 0x80, kOv = 0x20, kOs = 0x10;
constexpr std::uint32_t kOverflow = kOv | kOs;

struct Row {
  Operation operation;
  std::uint32_t accu2, accu1, result, status;
};

void expectAll(std::initializer_list<Row> rows) {
  for (const Row& row : rows) {
    const cpu::Registers r = execute({row.operation, {}}, {.accu = {row.accu1, row.accu2}});
    const auto name = mc7::info(row.operation).de;
    EXPECT_EQ(r.accu[0], row.result) << name << std::hex << " " << row.accu2 << " " << row.accu1;
    EXPECT_EQ(r.status.word(), row.status)
        << name << std::hex << " " << row.accu2 << " " << row.accu1;
    EXPECT_EQ(r.accu[1], row.accu2) << name;
  }
}

std::uint32_t bits(float value) { return std::bit_cast<std::uint32_t>(value); }

// S7-INSTR-51 … -54, S7-STW-07, S7-STW-10
TEST(Integer, ResultsAndConditionCodes) {
  expectAll({
      {Operation::ADD_I, 32767, 1, 0x8000, kA0 | kOverflow},
      {Operation::ADD_I, 0x8000, 0x8000, 0, kOverflow},
      {Operation::ADD_I, 0x8000, 0xFFFF, 0x7FFF, kA1 | kOverflow},
      {Operation::ADD_I, 5, 0xFFFB, 0, 0},
      {Operation::ADD_I, 0x12340001, 0xABCD0001, 0xABCD0002, kA1},
      {Operation::SUB_I, 5, 7, 0xFFFE, kA0},
      {Operation::SUB_I, 0x8000, 1, 0x7FFF, kA1 | kOverflow},
      {Operation::SUB_I, 0x7FFF, 0xFFFF, 0x8000, kA0 | kOverflow},
      {Operation::MUL_I, 200, 200, 40000, kA1 | kOverflow},
      {Operation::MUL_I, 0xFF38, 200, static_cast<std::uint32_t>(-40000), kA0 | kOverflow},
      {Operation::MUL_I, 0xFFFF, 7, 0xFFFFFFF9, kA0},
      {Operation::MUL_I, 0, 7, 0, 0},
      {Operation::DIV_I, 13, 4, 0x00010003, kA1},
      {Operation::DIV_I, 0xFFF3, 4, 0xFFFFFFFD, kA0},
      {Operation::DIV_I, 1, 0, 0, kA0 | kA1 | kOverflow},
      {Operation::DIV_I, 0x8000, 0xFFFF, 0x00008000, kA1 | kOverflow},
      {Operation::DIV_I, 3, 4, 0x00030000, 0},
  });
}

// S7-INSTR-55 … -59
TEST(DoubleInteger, ResultsAndConditionCodes) {
  expectAll({
      {Operation::ADD_D, 0x7FFFFFFF, 1, 0x80000000, kA0 | kOverflow},
      {Operation::ADD_D, 0x80000000, 0x80000000, 0, kOverflow},
      {Operation::SUB_D, 0x80000000, 1, 0x7FFFFFFF, kA1 | kOverflow},
      {Operation::SUB_D, 7, 5, 2, kA1},
      {Operation::MUL_D, 100000, 100000, 0x540BE400, kA1 | kOverflow},
      {Operation::MUL_D, static_cast<std::uint32_t>(-100000), 100000, 0xABF41C00, kA0 | kOverflow},
      {Operation::MUL_D, 3, 0xFFFFFFFC, 0xFFFFFFF4, kA0},
      {Operation::DIV_D, 13, 4, 3, kA1},
      {Operation::DIV_D, 5, 0, 0, kA0 | kA1 | kOverflow},
      {Operation::DIV_D, 0x80000000, 0xFFFFFFFF, 0x80000000, kA1 | kOverflow},
      {Operation::MOD, 13, 4, 1, kA1},
      {Operation::MOD, static_cast<std::uint32_t>(-13), 4, 0xFFFFFFFF, kA0},
      {Operation::MOD, 13, 0, 0, kA0 | kA1 | kOverflow},
      {Operation::MOD, 0x80000000, 0xFFFFFFFF, 0, 0},
  });
}

// S7-INSTR-102 … -104
TEST(Complement, OneAndTwo) {
  expectAll({{Operation::NEGI, 0, 5, 0xFFFB, kA0},
             {Operation::NEGI, 0, 0, 0, 0},
             {Operation::NEGI, 0, 0xFFFFFFFF, 0xFFFF0001, kA1},
             {Operation::NEGI, 0, 0x8000, 0x8000, kA0 | kOverflow},
             {Operation::NEGD, 0, 0x80000000, 0x80000000, kA0 | kOverflow},
             {Operation::NEGD, 0, 1, 0xFFFFFFFF, kA0},
             {Operation::INVI, 0, 0x12340F0F, 0x1234F0F0, 0},
             {Operation::INVD, 0, 0x0F0F0F0F, 0xF0F0F0F0, 0}});
}

// S7-STW-06: OS stays, OV goes with the next good result.
TEST(Overflow, IsStored) {
  const cpu::Registers r = execute({Operation::ADD_I, {}}, {.accu = {1, 1}, .status = kOverflow});
  EXPECT_FALSE(r.status.ov);
  EXPECT_TRUE(r.status.os);
}

// S7-INSTR-60 … -63
TEST(Real, ResultsAndConditionCodes) {
  const float inf = std::numeric_limits<float>::infinity();
  const float tiny = std::numeric_limits<float>::min();
  constexpr std::uint32_t kNoNumber = 0xFFFFFFFF;
  expectAll({
      {Operation::ADD_R, bits(1.5f), bits(2.25f), bits(3.75f), kA1},
      {Operation::ADD_R, bits(3.4e38f), bits(3.4e38f), bits(inf), kA1 | kOverflow},
      {Operation::ADD_R, bits(-3.4e38f), bits(-3.4e38f), bits(-inf), kA0 | kOverflow},
      {Operation::ADD_R, bits(1.0f), bits(-1.0f), 0, 0},
      {Operation::SUB_R, bits(5.0f), bits(7.5f), bits(-2.5f), kA0},
      {Operation::MUL_R, bits(2.5f), bits(4.0f), bits(10.0f), kA1},
      {Operation::MUL_R, bits(tiny), bits(0.5f), bits(tiny * 0.5f), kOverflow},
      {Operation::MUL_R, bits(inf), bits(0.0f), kNoNumber, kA0 | kA1 | kOverflow},
      {Operation::DIV_R, bits(1.0f), bits(0.0f), bits(inf), kA1 | kOverflow},
      {Operation::DIV_R, bits(-1.0f), bits(0.0f), bits(-inf), kA0 | kOverflow},
      {Operation::DIV_R, 0, 0, kNoNumber, kA0 | kA1 | kOverflow},
      {Operation::DIV_R, bits(1.0f), bits(3.0f), 0x3EAAAAAB, kA1},
      {Operation::ADD_R, 0x7FC00000, bits(1.0f), kNoNumber, kA0 | kA1 | kOverflow},
      {Operation::NEGR, 0, bits(1.5f), bits(-1.5f), 0},
      {Operation::ABS, 0, bits(-1.5f), bits(1.5f), 0},
  });
}

// S7-INSTR-65 … -70
TEST(Real, Functions) {
  constexpr std::uint32_t kNoNumber = 0xFFFFFFFF, kInvalid = kA0 | kA1 | kOverflow;
  expectAll({{Operation::SQRT, 0, bits(-1.0f), kNoNumber, kInvalid},
             {Operation::SQRT, 0, bits(2.0f), 0x3FB504F3, kA1},
             {Operation::SQR, 0, bits(-3.0f), bits(9.0f), kA1},
             {Operation::LN, 0, bits(1.0f), 0, 0},
             {Operation::LN, 0, 0, kNoNumber, kInvalid},
             {Operation::EXP, 0, bits(1.0f), 0x402DF854, kA1},
             {Operation::EXP, 0, bits(200.0f), 0x7F800000, kA1 | kOverflow},
             {Operation::ASIN, 0, bits(2.0f), kNoNumber, kInvalid},
             {Operation::ACOS, 0, bits(-1.0f), 0x40490FDB, kA1},
             {Operation::ATAN, 0, bits(1.0f), 0x3F490FDB, kA1},
             {Operation::COS, 0, 0, bits(1.0f), kA1},
             {Operation::TAN, 0, 0, 0, 0}});
  const cpu::Registers sine = execute({Operation::SIN, {}}, {.accu = {bits(1.570796f)}});
  EXPECT_NEAR(std::bit_cast<float>(sine.accu[0]), 1.0f, 1e-6f);
}

// S7-INSTR-71
TEST(AddConstant, TouchesNothingElse) {
  const cpu::Registers low =
      execute({Operation::ADD_CONSTANT, mc7::constant(ConstantFormat::Integer, 1)},
              {.accu = {0x00037FFF, 9}, .status = 0x1F0});
  EXPECT_EQ(low.accu[0], 0x00038000u);
  EXPECT_EQ(low.status.word(), 0x1F0);
  const cpu::Registers wrap =
      execute({Operation::ADD_CONSTANT, mc7::constant(ConstantFormat::Integer, 0xFFFF)},
              {.accu = {0x00030000}});
  EXPECT_EQ(wrap.accu[0], 0x0003FFFFu);
  const cpu::Registers wide =
      execute({Operation::ADD_CONSTANT, mc7::constant(ConstantFormat::LongInteger, 0xFFFFFFFF)},
              {.accu = {0x00030000}});
  EXPECT_EQ(wide.accu[0], 0x0002FFFFu);
}

// S7-INSTR-72, S7-INSTR-73, S7-STW-11: six relations, three cases each.
TEST(Compare, Integers) {
  const Operation words[] = {Operation::EQ_I, Operation::NE_I, Operation::LT_I,
                             Operation::LE_I, Operation::GT_I, Operation::GE_I};
  const Operation doubles[] = {Operation::EQ_D, Operation::NE_D, Operation::LT_D,
                               Operation::LE_D, Operation::GT_D, Operation::GE_D};
  const struct {
    std::int32_t a, b;
    std::uint32_t codes;
    bool holds[6];
  } rows[] = {{5, 5, 0, {true, false, false, true, false, true}},
              {-7, 3, kA0, {false, true, true, true, false, false}},
              {3, -7, kA1, {false, true, false, false, true, true}}};
  for (const auto& row : rows)
    for (unsigned i = 0; i < 6; ++i)
      for (const Operation operation : {words[i], doubles[i]}) {
        const State before{{static_cast<std::uint32_t>(row.b), static_cast<std::uint32_t>(row.a)},
                           0x1F2};
        const cpu::Registers r = execute({operation, {}}, before);
        const std::uint32_t result = row.holds[i] ? 0x7u : 0x1u;  // VKE and STA, /ER
        EXPECT_EQ(r.status.word(), 0x110u | row.codes | result) << mc7::info(operation).de;
        EXPECT_EQ(r.accu, before.accu);
      }
}

// S7-INSTR-74, S7-OPEN-47
TEST(Compare, Reals) {
  expectAll({{Operation::EQ_R, 0x80000000, 0, 0, 0x7},
             {Operation::LT_R, bits(1.0f), bits(2.0f), bits(2.0f), kA0 | 0x7},
             {Operation::GE_R, bits(1.0f), bits(2.0f), bits(2.0f), kA0 | 0x1}});
  for (const Operation operation : {Operation::EQ_R, Operation::NE_R, Operation::LT_R,
                                    Operation::LE_R, Operation::GT_R, Operation::GE_R})
    expectAll({{operation, 0x7FC00000, bits(1.0f), bits(1.0f), kA0 | kA1 | kOverflow | 0x1}});
}

// S7-INSTR-12 … -17, S7-STW-13
TEST(WordLogic, FromAccumulatorAndConstant) {
  expectAll({{Operation::AND_W, 0x55AA, 0xFFFF0FF0, 0xFFFF05A0, kA1},
             {Operation::OR_W, 0x55AA, 0x0FF0, 0x5FFA, kA1},
             {Operation::XOR_W, 0x55AA, 0x55AA, 0, 0},
             {Operation::AND_D, 0xF0F0F0F0, 0xFFFF0000, 0xF0F00000, kA1},
             {Operation::OR_D, 0x0F000000, 0x1, 0x0F000001, kA1},
             {Operation::XOR_D, 0x12345678, 0x12345678, 0, 0}});
  const struct {
    Operation operation;
    Operand constant;
    std::uint32_t result;
  } rows[] = {{Operation::AND_W, word(0x0FF0), 0x123405A0},
              {Operation::OR_W, word(0x0FF0), 0x12345FFA},
              {Operation::XOR_W, word(0x55AA), 0x12340000},
              {Operation::AND_D, doubleWord(0xFFFF0000), 0x12340000},
              {Operation::OR_D, doubleWord(0x80000000), 0x923455AA},
              {Operation::XOR_D, doubleWord(0x123455AA), 0}};
  for (const auto& row : rows) {
    const cpu::Registers r =
        execute({row.operation, row.constant}, {.accu = {0x123455AA, 7}, .status = kOv});
    EXPECT_EQ(r.accu[0], row.result) << mc7::info(row.operation).de;
    EXPECT_FALSE(r.status.ov);
    EXPECT_FALSE(r.status.cc0);
  }
}

// Four accumulators: 3 and 4 move down.
TEST(FourAccumulators, ArithmeticDropsAnOperand) {
  const State before{{1, 2, 3, 4}, 0};
  const cpu::Registers r = execute({Operation::ADD_D, {}}, before, *findCpuModel("generic-4"));
  EXPECT_EQ(r.accu, (std::array<std::uint32_t, 4>{3, 3, 4, 4}));
  EXPECT_EQ(execute({Operation::AND_W, {}}, before, *findCpuModel("generic-4")).accu[1], 2u);
}

}  // namespace
}  // namespace merker::interpreter::test
