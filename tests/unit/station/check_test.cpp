#include <gtest/gtest.h>

#include "program.h"

namespace merker::station::test {
namespace {

// A check with one term, as the compiler makes it.
block::Check check(std::uint32_t offset, block::CheckValue left, block::Relation relation,
                   block::CheckValue right, std::string text) {
  block::Check result;
  result.offset = offset;
  result.terms.push_back({left, right, relation, std::move(text)});
  return result;
}

block::CheckValue constant(std::uint32_t bits, unsigned width) {
  block::CheckValue value;
  value.constant = bits;
  value.width = width;
  return value;
}

block::CheckValue reg(block::CheckRegister which) {
  block::CheckValue value;
  value.kind = block::CheckValue::Kind::Register;
  value.reg = which;
  return value;
}

block::CheckValue code(block::CheckValue::Kind kind, std::vector<std::uint8_t> bytes,
                       unsigned width) {
  block::CheckValue value;
  value.kind = kind;
  value.code = std::move(bytes);
  value.width = width;
  return value;
}

using block::Relation;
using Register = block::CheckRegister;
using Kind = block::CheckValue::Kind;

// Byte 0 L 32767, 4 L 1, 8 +I, 10 = M 0.0, 12 UC FC 1 + list, 18 BE.
std::shared_ptr<block::Program> program(std::vector<block::Check> checks) {
  auto result = std::make_shared<block::Program>();
  block::Block ob;
  ob.id = {BlockKind::OB, 1};
  ob.code = {0x30, 0x03, 0x7F, 0xFF, 0x30, 0x03, 0x00, 0x01, 0x79, 0x00,
             0x98, 0x00, 0x3D, 0x01, 0x70, 0x0B, 0x00, 0x02, 0x65, 0x00};
  ob.checks = std::move(checks);
  block::Block fc;
  fc.id = {BlockKind::FC, 1};
  fc.code = {0x30, 0x03, 0x00, 0x2A, 0x13, 0x0A, 0x65, 0x00};  // L 42; T MW 10; BE
  result->emplace(ob.id, ob);
  result->emplace(fc.id, fc);
  return result;
}

std::vector<CheckResult> run(std::vector<block::Check> checks) {
  static std::shared_ptr<block::Program> kept;  // results point into the program
  kept = program(std::move(checks));
  Station station({.program = kept});
  station.warmRestart();
  station.advanceCycles(2);
  EXPECT_EQ(station.mode(), Mode::Run);
  return station.checkResults();
}

TEST(Checks, PassAndFail) {
  const auto results = run(
      {check(8, reg(Register::AKKU1), Relation::Equal, constant(0x8000, 16), "AKKU1 = W#16#8000"),
       check(8, reg(Register::AKKU1), Relation::Equal, constant(0x7FFF, 16), "AKKU1 = W#16#7FFF"),
       check(8, reg(Register::OV), Relation::Equal, constant(0, 1), "OV = 0")});
  ASSERT_EQ(results.size(), 3u);
  EXPECT_EQ(results[0].reached, 2u);
  EXPECT_TRUE(results[0].failures.empty());
  ASSERT_FALSE(results[1].failures.empty());
  EXPECT_EQ(results[1].failures[0].text, "AKKU1 = W#16#7FFF: is W#16#8000");
  EXPECT_EQ(results[2].failures[0].text, "OV = 0: is 1");
}

// After a call: when the called block has returned; snippets look at operands and change nothing.
TEST(Checks, AfterCallAndWithOperands) {
  const std::vector<std::uint8_t> loadMw10{0x12, 0x0A}, queryM00{0x80, 0x00},
      loadPew400{0x7E, 0x02, 0x01, 0x90};
  const auto results = run(
      {check(12, code(Kind::ValueCode, loadMw10, 16), Relation::Equal, constant(42, 16),
             "MW 10 = 42"),
       check(10, code(Kind::BitCode, queryM00, 1), Relation::Equal, constant(0, 1), "M 0.0 = 0"),
       check(12, reg(Register::AKKU1), Relation::Equal, constant(42, 16), "AKKU1 = 42"),
       check(18, reg(Register::AKKU1), Relation::Equal, constant(42, 16), "AKKU1 = 42"),
       check(8, code(Kind::ValueCode, loadPew400, 16), Relation::Equal, constant(0, 16),
             "PEW 400 = 0")});
  ASSERT_EQ(results.size(), 5u);
  for (const CheckResult& result : results) {
    EXPECT_EQ(result.reached, 2u);
    if (result.check->offset == 8)
      EXPECT_NE(result.failures.at(0).text.find("cannot be read"), std::string::npos);
    else
      EXPECT_TRUE(result.failures.empty()) << result.failures[0].text;
  }
}

TEST(Checks, Relations) {
  const struct {
    Relation relation;
    std::uint32_t constant;
    bool passes;
  } rows[] = {{Relation::NotEqual, 5, true},         {Relation::Less, 0x8001, true},
              {Relation::Less, 0x8000, false},       {Relation::LessEqual, 0x8000, true},
              {Relation::Greater, 0x7FFF, true},     {Relation::Greater, 0x8000, false},
              {Relation::GreaterEqual, 0x8000, true}};
  for (const auto& row : rows) {
    const auto results =
        run({check(8, reg(Register::AKKU1), row.relation, constant(row.constant, 16), "")});
    EXPECT_EQ(results[0].failures.empty(), row.passes) << static_cast<int>(row.relation);
  }
  const auto about =
      run({check(0, constant(0x3F800000, 32), Relation::About, constant(0x3F800004, 32), ""),
           check(0, constant(0x3F800000, 32), Relation::About, constant(0x3F801000, 32), ""),
           check(0, constant(0x7F800000, 32), Relation::About, constant(0x7F800000, 32), "")});
  EXPECT_TRUE(about[0].failures.empty());
  EXPECT_FALSE(about[1].failures.empty());
  EXPECT_TRUE(about[2].failures.empty());  // infinite, as in scenarios
}

// The compiler's comments, end to end.
TEST(Checks, FromComments) {
  Plc plc(
      "L 32767;\nL 1;\n+I;  //= AKKU1 = W#16#8000, A1 = 0, A0 = 1, OV = 1, OS = 1\nT MW 10; //= MW "
      "10 = W#16#8000\n");
  plc.cycles(2);
  ASSERT_EQ(plc->checkResults().size(), 2u);
  for (const CheckResult& result : plc->checkResults()) {
    EXPECT_EQ(result.reached, 2u);
    EXPECT_TRUE(result.failures.empty()) << result.failures[0].text;
  }
}

}  // namespace
}  // namespace merker::station::test
