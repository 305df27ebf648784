#include <gtest/gtest.h>

#include <functional>
#include <random>

#include "rig.h"

namespace merker::interpreter::test {
namespace {

constexpr Operation kQueries[] = {Operation::AND,    Operation::AND_NOT, Operation::OR,
                                  Operation::OR_NOT, Operation::XOR,     Operation::XOR_NOT};
constexpr Operation kOpenings[] = {Operation::AND_OPEN, Operation::AND_NOT_OPEN,
                                   Operation::OR_OPEN,  Operation::OR_NOT_OPEN,
                                   Operation::XOR_OPEN, Operation::XOR_NOT_OPEN};

// A random chain of queries and brackets, with what it means. The model knows nothing of the status
// word: the first term starts the chain, each further one combines.
struct Expression {
  std::vector<Instruction> code;
  bool value = false;
};

bool combined(unsigned kind, bool first, bool before, bool term) {
  const bool operand = kind % 2 == 0 ? term : !term;
  if (first) return operand;
  switch (kind / 2) {
    case 0:
      return before && operand;
    case 1:
      return before || operand;
    default:
      return before != operand;
  }
}

Expression chain(std::mt19937& random, std::uint8_t flags, unsigned depth) {
  Expression result;
  const auto terms = static_cast<unsigned>(1 + random() % 4);
  for (unsigned i = 0; i < terms; ++i) {
    const auto kind = static_cast<unsigned>(random() % 6);
    bool term = false;
    if (depth > 0 && random() % 3 == 0) {
      const Expression inner = chain(random, flags, depth - 1);
      result.code.push_back({kOpenings[kind], {}});
      result.code.insert(result.code.end(), inner.code.begin(), inner.code.end());
      result.code.push_back({Operation::CLOSE, {}});
      term = inner.value;
    } else {
      const auto bit = static_cast<unsigned>(random() % 8);
      result.code.push_back({kQueries[kind], flag(0, bit)});
      term = (flags >> bit & 1) != 0;
    }
    result.value = combined(kind, i == 0, result.value, term);
  }
  return result;
}

// S7-INSTR-08, S7-INSTR-09, S7-BRACKET-04 … -08
TEST(Brackets, RandomExpressionsMeanWhatTheyMean) {
  std::mt19937 random(11);
  for (int round = 0; round < 300; ++round) {
    const auto flags = static_cast<std::uint8_t>(random());
    Expression expression = chain(random, flags, 7);
    expression.code.push_back({Operation::ASSIGN, flag(1, 0)});
    Rig rig(expression.code);
    rig.start();
    *rig.machine().areas.flag(0) = flags;
    rig.finish();
    ASSERT_FALSE(rig.stopped());
    ASSERT_EQ(*rig.machine().areas.flag(1) != 0, expression.value) << "round " << round;
  }
}

// S7-INSTR-10, S7-BRACKET-09, S7-BRACKET-11: groups of ANDs joined by O.
TEST(Brackets, AndBeforeOr) {
  for (unsigned flags = 0; flags < 64; ++flags) {
    Rig rig({{Operation::AND, flag(0, 0)},
             {Operation::AND, flag(0, 1)},
             {Operation::AND_BEFORE_OR, {}},
             {Operation::AND, flag(0, 2)},
             {Operation::AND_NOT, flag(0, 3)},
             {Operation::AND_BEFORE_OR, {}},
             {Operation::AND, flag(0, 4)},
             {Operation::AND, flag(0, 5)},
             {Operation::ASSIGN, flag(1, 0)}});
    rig.start();
    *rig.machine().areas.flag(0) = static_cast<std::uint8_t>(flags);
    rig.finish();
    const auto bit = [&](unsigned n) { return (flags >> n & 1) != 0; };
    const bool expected = (bit(0) && bit(1)) || (bit(2) && !bit(3)) || (bit(4) && bit(5));
    EXPECT_EQ(*rig.machine().areas.flag(1) != 0, expected) << flags;
  }
}

// The AND chain before a bracket is an OR term, and O inside a bracket stays inside.
TEST(Brackets, AndBeforeOrWithBrackets) {
  for (unsigned flags = 0; flags < 32; ++flags) {
    Rig rig({{Operation::AND, flag(0, 0)},
             {Operation::AND_BEFORE_OR, {}},
             {Operation::AND, flag(0, 1)},
             {Operation::AND_OPEN, {}},
             {Operation::AND, flag(0, 2)},
             {Operation::AND_BEFORE_OR, {}},
             {Operation::AND, flag(0, 3)},
             {Operation::CLOSE, {}},
             {Operation::AND, flag(0, 4)},
             {Operation::ASSIGN, flag(1, 0)}});
    rig.start();
    *rig.machine().areas.flag(0) = static_cast<std::uint8_t>(flags);
    rig.finish();
    const auto bit = [&](unsigned n) { return (flags >> n & 1) != 0; };
    const bool expected = bit(0) || (bit(1) && (bit(2) || bit(3)) && bit(4));
    EXPECT_EQ(*rig.machine().areas.flag(1) != 0, expected) << flags;
  }
}

// S7-CPU-27, S7-DIAG-03
TEST(Brackets, DepthIsThatOfTheModel) {
  Rig seven(std::vector<Instruction>(7, {Operation::OR_OPEN, {}}));
  seven.start();
  seven.finish();
  EXPECT_FALSE(seven.stopped());
  Rig eight(std::vector<Instruction>(8, {Operation::OR_OPEN, {}}));
  eight.start();
  eight.finish();
  EXPECT_EQ(eight.stopEvent(), 0x4571u);
  Rig unopened({{Operation::CLOSE, {}}});
  unopened.start();
  unopened.finish();
  EXPECT_EQ(unopened.stopEvent(), 0x4571u);
}

}  // namespace
}  // namespace merker::interpreter::test
