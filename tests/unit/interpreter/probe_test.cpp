#include <gtest/gtest.h>

#include <string>

#include "rig.h"

namespace merker::interpreter::test {
namespace {

// Writes down what it sees; leaves the program at one place.
struct Witness : cpu::Probe {
  bool before(cpu::Machine& m, std::uint32_t offset) override {
    if (offset == leaveAt && !left) return left = true;
    seen += "b" + std::to_string(offset) + "/" + std::to_string(m.frames.size() - 1) + " ";
    return false;
  }
  void after(cpu::Machine& m, const cpu::Code& code, std::uint32_t offset) override {
    seen += "a" + toString(code.source->id) + "." + std::to_string(offset) + "=" +
            std::to_string(m.registers.accu[0]) + " ";
  }
  std::string seen;
  std::uint32_t leaveAt = 9999;
  bool left = false;
};

std::vector<Instruction> loads() {
  return {{Operation::LOAD, word(5)},
          {Operation::UC, mc7::blockOperand(BlockKind::FC, 1)},
          {Operation::TRANSFER, flagWord(0)}};
}
block::Block function() {
  return codeBlock(BlockKind::FC, 1, {{Operation::LOAD, word(7)}, {Operation::BE, {}}});
}

// S7-STATE-07: what a breakpoint needs. A call is followed by the next instruction of its frame.
TEST(Probe, SeesEachInstructionOfItsBlock) {
  Rig rig(loads(), {function()});
  Witness ob, fc;
  EXPECT_TRUE(rig.cpu().loadMemory().probe({BlockKind::OB, 1}, &ob));
  EXPECT_TRUE(rig.cpu().loadMemory().probe({BlockKind::FC, 1}, &fc));
  EXPECT_FALSE(rig.cpu().loadMemory().probe({BlockKind::FC, 2}, &fc));
  rig.start();
  rig.finish();
  EXPECT_EQ(ob.seen, "b0/1 aOB 1.0=5 b4/1 b6/1 aOB 1.6=7 b8/1 aOB 1.8=7 ");
  EXPECT_EQ(fc.seen, "b0/2 aFC 1.0=7 b4/2 aFC 1.4=7 ");
}

// S7-STATE-07
TEST(Probe, LeavesTheProgramBeforeAnInstruction) {
  Rig rig(loads(), {function()});
  Witness ob;
  ob.leaveAt = 6;
  rig.cpu().loadMemory().probe({BlockKind::OB, 1}, &ob);
  rig.start();
  rig.cpu().step(Instant::never());
  EXPECT_TRUE(ob.left);
  EXPECT_EQ(rig.cpu().offset(*rig.machine().top), 6u);
  EXPECT_EQ(rig.accu1(), 7u);
  EXPECT_EQ(rig.machine().image[rig.machine().areas.flagBase + 1], 0);
  rig.finish();
  EXPECT_EQ(rig.machine().image[rig.machine().areas.flagBase + 1], 7);
}

// Neither time nor the count of instructions shows whether somebody looked.
TEST(Probe, ChangesNothing) {
  Rig plain(loads(), {function()}), watched(loads(), {function()}), freed(loads(), {function()});
  Witness ob;
  ob.leaveAt = 6;
  watched.cpu().loadMemory().probe({BlockKind::OB, 1}, &ob);
  freed.cpu().loadMemory().probe({BlockKind::OB, 1}, &ob);
  freed.cpu().loadMemory().probe({BlockKind::OB, 1}, nullptr);
  for (Rig* rig : {&plain, &watched, &freed}) {
    rig->start();
    rig->finish();
    EXPECT_EQ(rig->machine().clock, plain.machine().clock);
    EXPECT_EQ(rig->machine().instructions, plain.machine().instructions);
  }
  EXPECT_EQ(ob.seen.substr(0, 5), "b0/1 ");
  EXPECT_EQ(ob.seen.find("b0/1", 4), std::string::npos);  // `freed` showed it nothing
}

}  // namespace
}  // namespace merker::interpreter::test
