// Breakpoints of a programming device (S7-STATE-07), in bytes.
#include "served/breakpoint_task.h"

#include "block/container.h"
#include "station/block_cpu.h"
#include "test_line.h"

namespace merker::served {
namespace {

constexpr unsigned kSetBreakpoint = 0x0A, kExitHold = 0x0B, kEnableIt = 0x0E, kDeleteIt = 0x0F;

// 0000 L 5, 0004 T MW 10, 0006 L 7, 000A T MW 12, 000C BE.
constexpr std::string_view kFourInstructions =
    "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\n L 5;\n T MW 10;\n L 7;\n T MW 12;\n"
    "END_ORGANIZATION_BLOCK\n";

// Of OB 1.
std::string breakAt(std::string_view address, std::string_view block = "00 08 00 01") {
  return "00 00 00 00 00 00 00 26 00 01 00 01 00 01 00 01 00 01 06 00 " + std::string(block) + ' ' +
         std::string(address);
}

class Breakpoints : public ::testing::Test {
 protected:
  Breakpoints() { plc.cycles(1); }
  // While no cycle ends.
  std::string look() {
    for (int i = 0; i < 3; ++i) {
      plc.plc().advanceTo(plc.plc().now() + Duration::milliseconds(100));
      plc.look();
    }
    return line.heard();
  }
  bool isHeld() { return plc.plc().mode() == controller::Mode::Halt; }

  ServedPlc plc = ServedPlc::station(std::string(kFourInstructions));
  TestLine line{plc};
};

TEST_F(Breakpoints, theRegistersAreToldInHalt) {
  line.send(kSetBreakpoint, breakAt("00 06"), "00 00");
  plc.cycles(1);
  EXPECT_EQ(line.heard(), "answer 0A 01 00 00");
  EXPECT_EQ(look(),
            "says 0A 01 00 00: 00 08 00 01 00 06 00 08 00 01 00 06 00 00 00 00 00 00 00 05 "
            "00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00");
  EXPECT_TRUE(isHeld());
  EXPECT_EQ(look(), "");
  line.send(kExitHold, "00 00 00 00", "01 00");
  EXPECT_EQ(look(),
            "answer 0B 02 00 00 | says 0A 01 00 00: 00 08 00 01 00 0A 00 08 00 01 00 06 00 00 "
            "00 00 00 00 00 07 00 00 00 05 00 00 00 00 00 00 00 00 00 00 00 00 00 00");
  line.send(kExitHold, "00 00 00 00", "00 00");
  EXPECT_TRUE(look().starts_with("answer 0B 03 00 00 | says 0A 01 00 00: 00 08 00 01 00 06 "));
  EXPECT_TRUE(isHeld());
  line.send(kDeleteIt, words(0, 1, 0), "00 01 0A 01");
  line.send(kExitHold, "00 00 00 00", "00 00");
  EXPECT_EQ(look(), "answer 0F 04 00 00 | answer 0B 05 00 00");
  EXPECT_FALSE(isHeld());
  EXPECT_TRUE(plc.monitor().debugger().breakpoints().empty());
}

// A block as it was downloaded, or lies on a card: every instruction can hold.
TEST_F(Breakpoints, ofABlockWithoutSource) {
  auto* const cpu = controller::capability<station::BlockCpu>(plc.plc());
  auto program = std::make_shared<block::Program>(cpu->program());
  block::Block& ob1 = program->at({BlockKind::OB, 1});
  ob1 = *block::readContainer(block::writeContainer(ob1), {});
  ASSERT_TRUE(ob1.lines.empty());
  EXPECT_EQ(cpu->download(program, {}), "");
  plc.cycles(2);
  EXPECT_EQ(line.ask(kSetBreakpoint, breakAt("00 05"), "00 00"), "answer 0A 01 D0 12");
  EXPECT_EQ(line.ask(kSetBreakpoint, breakAt("00 0E"), "00 00"), "answer 0A 02 D0 12");
  line.send(kSetBreakpoint, breakAt("00 06"), "00 00");
  plc.cycles(1);
  EXPECT_EQ(line.heard(), "answer 0A 03 00 00");
  EXPECT_TRUE(look().starts_with("says 0A 03 00 00: 00 08 00 01 00 06 00 08 00 01 00 06 "));
  EXPECT_TRUE(isHeld());
}

TEST_F(Breakpoints, oneWaitsUntilItIsEnabled) {
  std::string job = breakAt("00 06");
  job.replace(6, 5, "00 01");
  line.send(kSetBreakpoint, job, "00 00");
  plc.cycles(3);
  EXPECT_FALSE(isHeld());
  line.send(kEnableIt, words(0, 1, 0), "0A 01");
  plc.cycles(1);
  look();
  EXPECT_TRUE(isHeld());
}

TEST_F(Breakpoints, whatIsRefused) {
  EXPECT_EQ(line.ask(kSetBreakpoint, breakAt("00 02"), "00 00"), "answer 0A 01 D0 12");
  EXPECT_EQ(line.ask(kSetBreakpoint, breakAt("00 06", "00 0C 00 01"), "00 00"),
            "answer 0A 02 D0 11");
  EXPECT_EQ(line.ask(kSetBreakpoint, "00 00 00 00", "00 00"), "answer 0A 00 D0 33");
  EXPECT_EQ(line.ask(kExitHold, "00 00 00 00", "00 00"), "answer 0B 03 D0 81");
  EXPECT_TRUE(plc.monitor().debugger().breakpoints().empty());
}

// SZL 0132, INDEX 2.
TEST_F(Breakpoints, jobsAreCounted) {
  const auto jobs = [this] {
    std::uint8_t count = 0xFF;
    plc.exchange.status(0x0132, 2,
                        [&](const s7comm::StatusList& list) { count = list.data.at(3); });
    plc.cycles(1);
    return count;
  };
  EXPECT_EQ(jobs(), 0);
  std::string job = breakAt("00 06");
  job.replace(6, 5, "00 01");
  line.ask(kSetBreakpoint, job, "00 00");
  EXPECT_EQ(jobs(), 1);
  line.ask(kDeleteIt, words(0, 1, 0), "00 01 0A 01");
  EXPECT_EQ(jobs(), 0);
}

// Whoever set it has gone: nothing holds the CPU any more.
TEST_F(Breakpoints, theyGoWithTheirConnection) {
  {
    TestLine other(plc);
    other.send(kSetBreakpoint, breakAt("00 06"), "00 00");
    plc.cycles(1);
    EXPECT_EQ(plc.monitor().debugger().breakpoints().size(), 1u);
  }
  plc.look();
  plc.look();
  EXPECT_TRUE(plc.monitor().debugger().breakpoints().empty());
}

}  // namespace
}  // namespace merker::served
