#include <gtest/gtest.h>

#include <bit>

#include "rig.h"

namespace merker::interpreter::test {
namespace {

std::uint32_t bits(float value) { return std::bit_cast<std::uint32_t>(value); }

struct Row {
  Operation operation;
  std::uint32_t before, after, status;
};

constexpr std::uint32_t kOverflow = 0x30;

void expectAll(std::initializer_list<Row> rows, std::uint32_t status = 0) {
  for (const Row& row : rows) {
    const cpu::Registers r = execute({row.operation, {}}, {{row.before, 77}, status});
    EXPECT_EQ(r.accu[0], row.after) << mc7::info(row.operation).de << std::hex << " " << row.before;
    EXPECT_EQ(r.accu[1], 77u);
    EXPECT_EQ(r.status.word(), row.status)
        << mc7::info(row.operation).de << std::hex << " " << row.before;
  }
}

// S7-INSTR-92 … -97
TEST(Convert, BcdAndIntegers) {
  expectAll({{Operation::BTI, 0x8123, static_cast<std::uint16_t>(-123), 0},
             {Operation::BTI, 0xABCD0999, 0xABCD03E7, 0},
             {Operation::BTI, 0x7000, 0, 0},
             {Operation::BTD, 0x81234567, static_cast<std::uint32_t>(-1234567), 0},
             {Operation::ITB, static_cast<std::uint16_t>(-413), 0xF413, 0},
             {Operation::ITB, 0xABCD0019, 0xABCD0025, 0},
             {Operation::ITB, 1000, 1000, kOverflow},
             {Operation::ITB, 0x8000, 0x8000, kOverflow},
             {Operation::DTB, static_cast<std::uint32_t>(-701), 0xF0000701, 0},
             {Operation::DTB, 9999999, 0x09999999, 0},
             {Operation::DTB, 10000000, 10000000, kOverflow},
             {Operation::DTB, 0x80000000, 0x80000000, kOverflow},
             {Operation::ITD, 0x1234FFF6, 0xFFFFFFF6, 0},
             {Operation::DTR, 500, bits(500.0f), 0},
             {Operation::DTR, 16777217, bits(16777216.0f), 0}});
}

// OV goes, OS stays.
TEST(Convert, GoodResultsTakeOvBack) { expectAll({{Operation::ITB, 5, 5, 0x10}}, kOverflow); }

// S7-INSTR-92, S7-INSTR-93, S7-OBI-14
TEST(Convert, RefusesWhatIsNoBcd) {
  for (const Operation operation : {Operation::BTI, Operation::BTD}) {
    Rig rig({{operation, {}}});
    rig.start();
    rig.registers().accu[0] = 0x000A;
    rig.finish();
    EXPECT_EQ(rig.stopEvent(), 0x4562u);
    EXPECT_EQ(rig.accu1(), 0x000Au);
  }
}

// S7-INSTR-98 … -101
TEST(Round, FourWays) {
  const struct {
    float value;
    std::int32_t nearest, down, up, cut;
  } rows[] = {{100.5f, 100, 100, 101, 100},
              {101.5f, 102, 101, 102, 101},
              {-100.5f, -100, -101, -100, -100},
              {-101.5f, -102, -102, -101, -101},
              {0.4f, 0, 0, 1, 0},
              {-0.6f, -1, -1, 0, 0},
              {2147483520.0f, 2147483520, 2147483520, 2147483520, 2147483520}};
  for (const auto& row : rows) {
    const auto result = [&](Operation operation) {
      return static_cast<std::int32_t>(execute({operation, {}}, {{bits(row.value)}, 0}).accu[0]);
    };
    EXPECT_EQ(result(Operation::RND), row.nearest) << row.value;
    EXPECT_EQ(result(Operation::RND_MINUS), row.down) << row.value;
    EXPECT_EQ(result(Operation::RND_PLUS), row.up) << row.value;
    EXPECT_EQ(result(Operation::TRUNC), row.cut) << row.value;
  }
}

TEST(Round, OutOfRangeLeavesTheAccumulator) {
  for (const Operation operation :
       {Operation::RND, Operation::RND_MINUS, Operation::RND_PLUS, Operation::TRUNC})
    expectAll({{operation, bits(2147483648.0f), bits(2147483648.0f), kOverflow},
               {operation, bits(-2147483904.0f), bits(-2147483904.0f), kOverflow},
               {operation, 0x7FC00000, 0x7FC00000, kOverflow},
               {operation, bits(-2147483648.0f), 0x80000000, 0}});
}

}  // namespace
}  // namespace merker::interpreter::test
