// The status column of the instruction table is the oracle: '-' never changes, '0' and '1' always
// hold, over random states of every operation (S7-INSTR-01).
#include <gtest/gtest.h>

#include <map>
#include <random>

#include "rig.h"

namespace merker::interpreter::test {
namespace {

constexpr std::string_view kOrder[] = {"BIE", "A1", "A0", "OV", "OS", "OR", "STA", "VKE", "/ER"};

Operand timer() { return mc7::number(OperandKind::Timer, 1); }
Operand counter() { return mc7::number(OperandKind::Counter, 1); }

// An operand that suits the operation; none where it needs none.
Operand sample(Operation operation) {
  static const std::map<Operation, Operand> special = {
      {Operation::LOAD_STW, mc7::number(OperandKind::StatusWord, 0)},
      {Operation::TRANSFER_STW, mc7::number(OperandKind::StatusWord, 0)},
      {Operation::LOAD, flagWord(20)},
      {Operation::TRANSFER, flagWord(20)},
      {Operation::LOAD_BCD, timer()},
      {Operation::ENABLE, timer()},
      {Operation::COUNT_UP, counter()},
      {Operation::COUNT_DOWN, counter()},
      {Operation::OPEN, mc7::blockOperand(BlockKind::DB, 1)},
      {Operation::ADD_CONSTANT, mc7::constant(ConstantFormat::Integer, 5)},
      {Operation::UC, mc7::blockOperand(BlockKind::FB, 1)},
      {Operation::CC, mc7::blockOperand(BlockKind::FB, 1)},
      {Operation::SPL, mc7::number(OperandKind::JumpList, 1)},
      {Operation::INC, shiftBy(1)},
      {Operation::DEC, shiftBy(1)},
      {Operation::BLD, shiftBy(1)}};
  if (const auto found = special.find(operation); found != special.end()) return found->second;
  const bool bits = operation <= Operation::XOR_NOT ||
                    (operation >= Operation::EDGE_POSITIVE && operation <= Operation::ASSIGN);
  if (bits) return flag(10, 3);
  if (operation >= Operation::TIMER_SI && operation <= Operation::TIMER_SA) return timer();
  if (operation >= Operation::SLW && operation <= Operation::RRD) return shiftBy(3);
  if (operation >= Operation::SPA && operation <= Operation::LOOP) return jump(2);
  return {};
}

bool bitAt(std::uint32_t word, std::size_t column) { return (word >> (8 - column) & 1) != 0; }

// Registers at random; accumulators are BCD so that conversions and timers find a number.
void randomize(Rig& rig, std::mt19937& random) {
  cpu::Machine& m = rig.machine();
  for (std::uint32_t& accu : m.registers.accu)
    accu = static_cast<std::uint32_t>(random()) & 0x77777777;
  m.registers.status = cpu::StatusWord::fromWord(static_cast<std::uint32_t>(random()));
  *m.areas.flag(10) = static_cast<std::uint8_t>(random());
}

class EveryOperation : public testing::TestWithParam<int> {};

TEST_P(EveryOperation, KeepsItsStatusColumn) {
  const auto operation = static_cast<Operation>(GetParam());
  const mc7::OperationInfo& row = mc7::info(operation);
  std::vector<Instruction> program;
  if (operation == Operation::CLOSE) program.push_back({Operation::AND_OPEN, {}});
  if (operation == Operation::MCR_CLOSE) program.push_back({Operation::MCR_OPEN, {}});
  const auto prelude = static_cast<unsigned>(program.size());
  program.push_back({operation, sample(operation)});
  for (int i = 0; i < 4; ++i) program.push_back({Operation::SPA, jump(2)});
  std::mt19937 random(static_cast<unsigned>(GetParam()) + 7);
  for (int round = 0; round < 64; ++round) {
    Rig rig(program, {codeBlock(BlockKind::FB, 1, {{Operation::BE, {}}}), dataBlock(1, 10)},
            *findCpuModel("generic-4"));
    rig.start();
    rig.step(prelude);
    randomize(rig, random);
    const std::uint32_t before = rig.status().word();
    const std::uint64_t count = rig.machine().instructions;
    rig.step();
    ASSERT_EQ(rig.machine().instructions, count + 1);
    ASSERT_FALSE(rig.stopped()) << rig.cpu().state().stopEvent().text;
    const std::uint32_t after = rig.status().word();
    for (std::size_t column = 0; column < row.status.size(); ++column) {
      const char rule = row.status[column];
      if (rule == 'x') continue;
      const bool expected = rule == '-' ? bitAt(before, column) : rule == '1';
      ASSERT_EQ(bitAt(after, column), expected)
          << row.de << ": " << kOrder[column] << ", status before " << std::hex << before;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Rows, EveryOperation,
                         testing::Range(0, static_cast<int>(mc7::operations().size())),
                         [](const auto& test) {
                           return std::string(
                               mc7::operations()[static_cast<std::size_t>(test.param)].id);
                         });

// S7-CPU-04: each instruction costs the time of its class.
TEST(Time, IsThatOfTheClass) {
  const CpuModel& model = defaultCpuModel();
  Rig rig({{Operation::AND, flag(0, 0)},
           {Operation::LOAD, flagWord(0)},
           {Operation::ADD_I, {}},
           {Operation::ADD_R, {}},
           {Operation::BLD, shiftBy(1)}});
  rig.start();
  const std::uint32_t costs[] = {model.bitTime, model.wordTime, model.fixedTime, model.realTime, 0};
  for (const std::uint32_t cost : costs) {
    const Instant before = rig.machine().clock;
    rig.step();
    EXPECT_EQ((rig.machine().clock - before).ns, cost);
  }
}

}  // namespace
}  // namespace merker::interpreter::test
