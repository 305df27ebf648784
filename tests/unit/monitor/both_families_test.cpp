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

// One list forces a bit once.
TYPED_TEST(EveryMachine, ForcesNoBitTwiceInOneList) {
  Monitor& monitor = *this->plc;
  EXPECT_EQ(name(monitor.force({{"A 0.1", "1"}, {"A 0.1", "0"}})), "P0988");
  EXPECT_TRUE(monitor.forces().empty());
}

// S7-SIM-03, S5-TIMER-11: three BCD digits, a timer with its base; the reason says so. Nothing of
// the list is done.
TYPED_TEST(EveryMachine, RefusesWhatNoTimerOrCounterHolds) {
  using enum DisplayFormat;
  Monitor& monitor = *this->plc;
  this->plc.start();
  for (const Wish& wish :
       {Wish{"T 1", "W#16#FFFF"}, Wish{"T 1", "FFFF", Hex}, Wish{"T 1", "1000", Dec},
        Wish{"T 1", "W#16#4000"}, Wish{"Z 1", "W#16#FFFF"}, Wish{"Z 1", "FFFF", Hex},
        Wish{"Z 1", "W#16#1000"}, Wish{"Z 1", "W#16#FFFF", Char}}) {
    const auto problem = monitor.write({{"MW 110", "5"}, wish});
    EXPECT_EQ(name(problem), "P0988") << wish.operand << ' ' << wish.value;
    EXPECT_NE(problem->message.find(": it takes "), std::string::npos) << problem->message;
    EXPECT_EQ(
        name(monitor.inCycle(wish) ? std::nullopt : std::optional(monitor.inCycle(wish).error())),
        "P0988");
  }
  EXPECT_EQ(name(monitor.write("Z 1", "1000")), "P1210");
  EXPECT_EQ(this->machine().read(*monitor.operand("MW 110")), 0u);
  EXPECT_EQ(this->machine().read(*monitor.operand("Z 1")), 0u);
  EXPECT_EQ(name(monitor.write({{"Z 1", "W#16#0123"}, {"T 1", "W#16#2050"}})), "good");
  EXPECT_EQ(this->machine().read(*monitor.operand("Z 1")), 0x123u);
  EXPECT_EQ(name(monitor.write("Z 1", "12")), "good");
  EXPECT_EQ(this->machine().read(*monitor.operand("Z 1")), 0x12u);
}

// compatibility.md, "Forces": a force holds at a point of the cycle as well, whichever came first.
TYPED_TEST(EveryMachine, ModifiesNothingThatIsForced) {
  Monitor& monitor = *this->plc;
  VariableTable& begin = monitor.addTable();
  VariableTable& end = monitor.addTable();
  EXPECT_EQ(name(begin.add("E 0.0")), "good");
  EXPECT_EQ(name(begin.setModify(0, "1")), "good");
  EXPECT_EQ(name(end.add("A 0.0")), "good");
  EXPECT_EQ(name(end.setModify(0, "1")), "good");
  begin.modify(Trigger{CyclePoint::Begin, false});
  end.modify(Trigger{CyclePoint::End, false});
  EXPECT_TRUE(monitor.inCycle({"E 0.0", "1"}));
  EXPECT_EQ(name(monitor.force({{"E 0.0", "0"}, {"A 0.0", "0"}})), "good");
  for (const char* operand : {"E 0.0", "EB 0", "A 0.0"}) {
    const auto refused = monitor.inCycle({operand, "1"});
    ASSERT_FALSE(refused) << operand;
    EXPECT_EQ(refused.error().name(), "P1217") << operand;
  }
  this->plc.start();
  this->machine().advanceCycles(3);
  EXPECT_EQ(this->plc.read("E 0.0") + this->plc.read("M 100.0") + this->plc.read("A 0.0"), "000");
  monitor.unforce("E 0.0");
  this->machine().advanceCycles(3);
  EXPECT_EQ(this->plc.read("M 100.0") + this->plc.read("A 0.0"), "10");
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
