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

TYPED_TEST(EveryMachine, StopsAsAProgrammingDevice) {
  this->plc.start();
  this->machine().advanceCycles(2);
  this->plc->stop();
  EXPECT_EQ(this->machine().mode(), controller::Mode::Stop);
  EXPECT_FALSE(this->machine().stoppedByFault());
  EXPECT_TRUE(this->plc->stacks().empty());  // between two cycles
  EXPECT_EQ(this->plc.read("#x"), "P1216");
}

}  // namespace
}  // namespace merker::monitor::test
