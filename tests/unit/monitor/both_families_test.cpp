// What the monitor promises of every machine.
#include "plc.h"
#include "step5_plc.h"

namespace merker::monitor::test {
namespace {

template <typename Harness>
struct EveryMachine : ::testing::Test {
  static std::string program() {
    if constexpr (std::is_same_v<Harness, Plc>)
      return "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\n U E 0.0;\n = M 100.0;\n S A 0.0;\n"
             "END_ORGANIZATION_BLOCK\n";
    else
      return "OB 1\n : U E 0.0\n : = M 100.0\n : S A 0.0\n : BE\n";
  }
  controller::Controller& machine() { return plc->plc(); }
  Harness plc{program()};
};
using Families = ::testing::Types<Plc, SinumerikPlc>;
TYPED_TEST_SUITE(EveryMachine, Families, );

// S7-SIM-12, P1217, P1219
TYPED_TEST(EveryMachine, ForcesNoBitTwice) {
  Monitor& monitor = *this->plc;
  EXPECT_EQ(name(monitor.force("E 0.0", "1")), "good");
  EXPECT_EQ(name(monitor.force("EB 0", "0")), "P1219");
  EXPECT_EQ(name(monitor.force({{"A 0.0", "1"}, {"AW 0", "1"}})), "P1219");
  EXPECT_EQ(name(monitor.force({{"A 0.1", "1"}, {"T 1", "S5T#1S"}})), "P1211");
  EXPECT_EQ(monitor.forces().size(), 1u);
  EXPECT_EQ(name(monitor.force("E 0.0", "0")), "good");  // its new value
  EXPECT_EQ(name(monitor.force("A 0.0", "0")), "good");
  EXPECT_EQ(monitor.forces().size(), 2u);
  EXPECT_EQ(name(monitor.write("AB 0", "1")), "P1217");
  EXPECT_EQ(name(monitor.write("E 0.0", "1")), "good");  // at its terminal, where it waits
}

TYPED_TEST(EveryMachine, HoldsForcesUntilTheyAreTakenAway) {
  Monitor& monitor = *this->plc;
  this->plc.start();
  EXPECT_EQ(name(monitor.force({{"E 0.0", "1"}, {"A 0.0", "0"}})), "good");
  this->machine().advanceCycles(3);
  EXPECT_EQ(this->plc.read("M 100.0"), "1");
  EXPECT_EQ(this->plc.read("A 0.0"), "0");
  EXPECT_EQ(name(monitor.unforce("A 0.0")), "good");
  EXPECT_EQ(name(monitor.unforce("A 0.0")), "P1214");
  this->machine().advanceCycles(3);
  EXPECT_EQ(this->plc.read("A 0.0"), "1");
  monitor.unforceAll();
  this->machine().advanceCycles(3);
  EXPECT_EQ(this->plc.read("M 100.0"), "0");
}

TYPED_TEST(EveryMachine, ForgetsForcesAtAMemoryReset) {
  Monitor& monitor = *this->plc;
  EXPECT_EQ(name(monitor.force("E 0.0", "1")), "good");
  this->machine().stop();
  this->machine().memoryReset();
  EXPECT_TRUE(monitor.forces().empty());
  EXPECT_EQ(name(monitor.force("EB 0", "1")), "good");
}

// Breakpoints are the debugger's, not the machine's.
TYPED_TEST(EveryMachine, KeepsBreakpointsAtAMemoryReset) {
  this->plc.breakAt("OB 1");
  this->plc.start();
  EXPECT_EQ(this->plc.run().why, Pause::Why::Breakpoint);
  this->machine().stop();
  this->machine().memoryReset();
  EXPECT_EQ(this->plc.where(), "between cycles");
  this->plc.start();
  EXPECT_EQ(this->plc.run().why, Pause::Why::Breakpoint);
  EXPECT_EQ(this->plc.debugger().breakpoints().front().hits, 2u);
}

// Whoever else starts it: the first cycle holds, too, and M 100.0 is not written yet.
TYPED_TEST(EveryMachine, HoldsInTheFirstCycleAfterAStopInHalt) {
  const auto restarted = [&] {
    this->machine().stop();
    EXPECT_TRUE(this->machine().start());
    EXPECT_EQ(name(this->plc->write("M 100.0", "1")), "good");
    this->machine().advanceTo(this->plc.soon());
    EXPECT_EQ(this->machine().mode(), controller::Mode::Halt);
    EXPECT_EQ(this->plc.read("M 100.0"), "1");
  };
  this->plc.breakAt("OB 1");
  this->plc.start();
  EXPECT_EQ(this->plc.run().why, Pause::Why::Breakpoint);
  restarted();
  this->plc.debugger().run(this->machine().now());  // out of HALT, no time for an instruction
  EXPECT_EQ(this->machine().mode(), controller::Mode::Run);
  restarted();
  this->machine().powerOff();
  this->machine().powerOn();
  if (this->machine().mode() == controller::Mode::Stop) this->plc.start();
  this->machine().advanceTo(this->plc.soon());
  EXPECT_EQ(this->plc.debugger().breakpoints().front().hits, 4u);
}

TYPED_TEST(EveryMachine, StopsAsAProgrammingDevice) {
  this->plc.start();
  this->machine().advanceCycles(2);
  this->plc->stop();
  EXPECT_EQ(this->machine().mode(), controller::Mode::Stop);
  EXPECT_FALSE(this->machine().stoppedByFault());
  EXPECT_TRUE(this->plc->stacks().empty());  // between two cycles
  EXPECT_EQ(this->plc.read("#x"), "P1216");
}

// S7-SIM-12: at the beginning of the cycle an input is in the image before the program, its
// terminal stays as it is; at its end an output goes out as it was modified; what the program wrote
// is seen there.
TYPED_TEST(EveryMachine, ModifiesAndMonitorsAtPointsOfTheCycle) {
  Monitor& monitor = *this->plc;
  EXPECT_TRUE(monitor.can(Feature::CyclePoints));
  VariableTable& begin = monitor.addTable();
  VariableTable& end = monitor.addTable();
  VariableTable& seen = monitor.addTable();
  EXPECT_EQ(name(begin.add("E 0.0")), "good");
  EXPECT_EQ(name(begin.setModify(0, "1")), "good");
  EXPECT_EQ(name(end.add("A 0.0")), "good");
  EXPECT_EQ(name(end.setModify(0, "0")), "good");
  EXPECT_EQ(name(seen.add("M 100.0")), "good");
  begin.modify(Trigger{CyclePoint::Begin, true});
  end.modify(Trigger{CyclePoint::End, true});
  seen.monitor(Trigger{CyclePoint::End, true});
  this->plc.start();
  this->machine().advanceCycles(1);
  EXPECT_EQ(seen.text(0), "1");
  EXPECT_EQ(this->plc.read("M 100.0"), "1");
  EXPECT_EQ(this->plc.read("A 0.0"), "0");
  EXPECT_FALSE(begin.modifying());  // once
  this->machine().advanceCycles(2);
  EXPECT_EQ(this->plc.read("M 100.0"), "0");  // the terminal never was 1
}

TYPED_TEST(EveryMachine, ModifiesAtTheTransitionToStop) {
  Monitor& monitor = *this->plc;
  VariableTable& table = monitor.addTable();
  EXPECT_EQ(name(table.add("MW 110", DisplayFormat::Hex)), "good");
  EXPECT_EQ(name(table.setModify(0, "AFFE")), "good");
  this->plc.start();
  table.modify(Trigger{CyclePoint::Stop, true});
  this->machine().advanceCycles(2);
  EXPECT_TRUE(table.modifying());
  monitor.stop();
  this->machine().settle();
  EXPECT_EQ(this->machine().read(*monitor.operand("MW 110")), 0xAFFEu);
  EXPECT_FALSE(table.modifying());
}

}  // namespace
}  // namespace merker::monitor::test
