// Programs over several cycles: edges, timers, counters, direct periphery (chapter 9.3).
#include "listing_bench.h"

namespace merker::sinumerik {
namespace {

// Called every 20 ms.
struct FastBench : ListingBench {
  explicit FastBench(const std::string& body) : ListingBench("OB 1\n" + body + " BE\n") {
    data().setWord(2, 1);
    run(1);
  }
  void wait(double milliseconds) { plc().advanceTo(plc().now() + Duration{ms(milliseconds).ns}); }
  void cycle() { plc().advanceToCheckpoint(plc().now() + Duration::milliseconds(100)); }
  unsigned after(const char* input, unsigned value, const char* output) {
    write(input, value);
    cycle();
    return this->value(output);
  }
  // The output, looked at every 100 ms, as long as it keeps a value; in tenths of a second.
  int tenths(const char* operand, unsigned held, int most = 400) {
    int n = 0;
    for (; n < most && value(operand) == held; ++n) wait(100);
    return n;
  }
};

// S5-STORE-04: one pass after each rising edge.
TEST(Program, Pulse) {
  FastBench b(" U E 1.7\n UN M 4.0\n = M 2.0\n U M 2.0\n S M 4.0\n UN E 1.7\n R M 4.0\n");
  EXPECT_EQ(b.after("E 1.7", 1, "M 2.0"), 1u);
  for (int i = 0; i < 5; ++i) EXPECT_EQ(b.after("E 1.7", 1, "M 2.0"), 0u);
  EXPECT_EQ(b.after("E 1.7", 0, "M 2.0"), 0u);
  EXPECT_EQ(b.after("E 1.7", 1, "M 2.0"), 1u);
}

// S5-STORE-05: the manual's binary divider, its flags in MB 1 and MB 2 among them.
TEST(Program, BinaryDivider) {
  FastBench b(R"( U E 1.0
 UN M 1.0
 = M 1.1
 U M 1.1
 S M 1.0
 UN E 1.0
 R M 1.0
 U M 1.1
 U A 3.0
 = M 2.0
 U M 1.1
 UN A 3.0
 UN M 2.0
 S A 3.0
 U M 2.0
 R A 3.0
)");
  b.after("E 1.0", 0, "A 3.0");
  for (const unsigned expected : {1u, 0u, 1u, 0u}) {
    EXPECT_EQ(b.after("E 1.0", 1, "A 3.0"), expected);
    EXPECT_EQ(b.after("E 1.0", 1, "A 3.0"), expected);
    EXPECT_EQ(b.after("E 1.0", 0, "A 3.0"), expected);
  }
}

// S5-TIMER-02, S5-TIMER-04, S5-TIMER-05: pulses of 10 s.
TEST(Program, PulseTimers) {
  FastBench b(
      " U E 0.0\n L KT 10.2\n SI T 1\n T MW 100\n U T 1\n = A 0.0\n"
      " U E 0.1\n L KT 10.2\n SV T 2\n U T 2\n = A 0.1\n");
  EXPECT_EQ(b.after("E 0.0", 1, "A 0.0"), 1u);
  EXPECT_EQ(b.value("MW 100"), 0x2010u);  // AKKU 1 stays
  b.wait(3000);
  EXPECT_EQ(b.value("A 0.0"), 1u);
  EXPECT_EQ(b.after("E 0.0", 0, "A 0.0"), 0u);
  b.after("E 0.0", 1, "A 0.0");
  EXPECT_NEAR(b.tenths("A 0.0", 1), 100, 1);
  b.wait(500);
  EXPECT_EQ(b.value("A 0.0"), 0u);
  EXPECT_EQ(b.after("E 0.1", 1, "A 0.1"), 1u);
  EXPECT_EQ(b.after("E 0.1", 0, "A 0.1"), 1u);
  b.wait(4000);
  b.after("E 0.1", 1, "A 0.1");  // again while it runs
  b.after("E 0.1", 0, "A 0.1");
  EXPECT_NEAR(b.tenths("A 0.1", 1), 100, 1);
}

// S5-TIMER-06, S5-TIMER-07: delays of 9 s.
TEST(Program, OnDelays) {
  FastBench b(
      " U E 0.0\n L KT 9.2\n SE T 1\n U T 1\n = A 0.0\n"
      " U E 0.1\n L KT 9.2\n SS T 2\n U E 0.2\n R T 2\n U T 2\n = A 0.1\n");
  b.after("E 0.0", 1, "A 0.0");
  EXPECT_NEAR(b.tenths("A 0.0", 0), 90, 1);
  b.wait(6000);
  EXPECT_EQ(b.value("A 0.0"), 1u);
  EXPECT_EQ(b.after("E 0.0", 0, "A 0.0"), 0u);
  b.after("E 0.0", 1, "A 0.0");
  b.wait(5000);
  b.after("E 0.0", 0, "A 0.0");
  EXPECT_EQ(b.tenths("A 0.0", 0, 100), 100);
  b.after("E 0.1", 1, "A 0.1");
  b.after("E 0.1", 0, "A 0.1");
  EXPECT_NEAR(b.tenths("A 0.1", 0), 90, 1);
  b.wait(5000);
  EXPECT_EQ(b.value("A 0.1"), 1u);
  EXPECT_EQ(b.after("E 0.2", 1, "A 0.1"), 0u);
}

// S5-TIMER-08: the manual's listing: runs while E 3.4 is 1.
TEST(Program, OffDelay) {
  FastBench b(" UN E 3.4\n L MW113\n SA T 5\n U T 5\n = A 4.4\n");
  b.write("MW 113", 0x2005);
  EXPECT_EQ(b.after("E 3.4", 0, "A 4.4"), 1u);
  b.after("E 3.4", 1, "A 4.4");
  EXPECT_NEAR(b.tenths("A 4.4", 1), 50, 1);
  b.wait(5000);
  EXPECT_EQ(b.value("A 4.4"), 0u);
}

// S5-TIMER-01, S5-TIMER-13: beyond MD 6, and by a parameter beyond 31.
TEST(Program, TimersBeyondTheLast) {
  ListingBench b(
      "OB 1\n SPA FB 1\nNAME : B33\n BE\nFB 1\nNAME : B33\n L KB 33\n T MW 100\n"
      " U M 0.1\n L KT 5.2\n B MW 100\n SE T 0\n BE\n");
  b.run(10);
  EXPECT_TRUE(b.stopped(Alarm::TimerCounter));
  EXPECT_EQ(b.address(0xF004), 0x0033u);
}

// S5-TIMER-11: digits above nine count with their value.
TEST(Program, DigitsAboveNine) {
  FastBench b(" U M 0.1\n L KH 10AF\n SI T 1\n L T 1\n T MW 100\n");
  b.cycle();
  EXPECT_NEAR(b.value("MW 100"), 10 * 10 + 15, 1);
}

// S5-COUNTER-01 … S5-COUNTER-07: S5-COUNTER-02, S5-COUNTER-03, S5-COUNTER-04, S5-COUNTER-06.
TEST(Program, UpAndDown) {
  FastBench b(
      " U E 4.1\n ZV Z 1\n U E 4.3\n ZR Z 1\n U E 4.5\n L EW 20\n S Z 1\n U E 4.7\n R Z 1\n"
      " L Z 1\n T MW 100\n LC Z 1\n T MW 102\n U Z 1\n = A 0.0\n");
  b.cycle();
  EXPECT_EQ(b.value("A 0.0"), 0u);
  for (int i = 0; i < 3; ++i) {
    b.after("E 4.1", 1, "MW 100");
    b.after("E 4.1", 1, "MW 100");
    b.after("E 4.1", 0, "MW 100");
  }
  EXPECT_EQ(b.after("E 4.3", 1, "MW 100"), 2u);
  EXPECT_EQ(b.value("A 0.0"), 1u);
  b.write("EW 20", 0x0123);
  EXPECT_EQ(b.after("E 4.5", 1, "MW 100"), 123u);
  EXPECT_EQ(b.value("MW 102"), 0x0123u);
  b.write("EW 20", 0x0456);
  EXPECT_EQ(b.after("E 4.5", 1, "MW 100"), 123u);
  b.after("E 4.5", 0, "MW 100");
  EXPECT_EQ(b.after("E 4.5", 1, "MW 102"), 0x0456u);
  EXPECT_EQ(b.after("E 4.7", 1, "MW 100"), 0u);
  EXPECT_EQ(b.value("A 0.0"), 0u);
}

// S5-COUNTER-05: they stop at 0 and at 999.
TEST(Program, CountersDoNotWrap) {
  FastBench b(" U M 0.7\n U E 0.0\n L KZ 999\n S Z 31\n U E 0.1\n ZV Z 31\n U E 0.2\n ZR Z 0\n");
  EXPECT_EQ(b.after("E 0.2", 1, "Z 0"), 0u);
  b.write("Z 31", 0x0999);
  EXPECT_EQ(b.after("E 0.1", 1, "Z 31"), 0x0999u);
  EXPECT_EQ(b.plc().mode(), Mode::Run);
}

// S5-COUNTER-07: FR lets ZV count once more.
TEST(Program, EnablingACounter) {
  ListingBench b(
      "OB 1\n SPA FB 1\nNAME : FREI\n BE\nFB 1\nNAME : FREI\n U E 0.1\n FR Z 1\n"
      " U E 0.0\n ZV Z 1\n BE\n");
  b.run(1);
  b.write("E 0.0", 1);
  b.runTo(190);
  EXPECT_EQ(b.value("Z 1"), 1u);
  b.write("E 0.1", 1);
  b.runTo(400);
  EXPECT_EQ(b.value("Z 1"), 2u);
}

// S5-CODE-01, S5-LOAD-11: the printed listings of a timer box and of LC.
TEST(Program, TimerBox) {
  FastBench b(" U E 5.0\n L EW22\n SI T10\n L T10\n T AW64\n LC T10\n T AW50\n");
  b.write("EW 22", 0x1025);
  b.after("E 5.0", 1, "AW 64");
  EXPECT_EQ(b.value("AW 64"), 25u);
  EXPECT_EQ(b.value("AW 50"), 0x1025u);
}

// S5-LOAD-09: past the images; T PB tells the output image, too.
TEST(Program, DirectPeriphery) {
  ListingBench b("OB 1\n" + burn(4) +
                 " L PB 3\n T MB 100\n L EB 3\n T MB 101\n L KH 1234\n T PW 4\n L AW 4\n"
                 " T MW 102\n BE\n");
  b.run(62);  // in the second pass
  b.write("EB 3", 7);
  b.plc().settle();
  EXPECT_EQ(b.value("MB 100"), 7u);
  EXPECT_EQ(b.value("MB 101"), 0u);
  EXPECT_EQ(b.value("MW 102"), 0x1234u);
  EXPECT_EQ(b.value("PW 4"), 0x1234u);
  ListingBench missing("OB 1\n L KB 1\n T PB 70\n BE\n");
  missing.run(10);
  EXPECT_TRUE(missing.stopped(Alarm::NoAnswerPeriphery));
  EXPECT_EQ(missing.address(0xF003), 0x000Au);
  EXPECT_EQ(missing.address(0xF004), 0x0070u);
}

// S5-MISC-01: STP lets the cycle end, outputs go out.
TEST(Program, StpEndsTheCycle) {
  FastBench b(" STP\n L KB 1\n T MB 100\n");
  b.wait(100);
  EXPECT_TRUE(b.stopped(Alarm::Stp));
  EXPECT_EQ(b.value("MB 100"), 1u);
  EXPECT_TRUE(b.control(ControlBit::STP));
}

// S5-SUBST-08, S5-FB-15: the parameter word fits no kind.
TEST(Program, PatchedParameter) {
  ListingBench b(
      "OB 1\n SPA FB 1\nNAME : PATCH\nEIN : E 1.0\n BE\nFB 1\nNAME : PATCH\n"
      "BEZ : EIN  E/A/D/B/T/Z: E   BI/BY/W/D: BI\n U =EIN\n BE\n");
  b.options.program.at({mc5::BlockType::Ob, 1}).words[2] = 0x220F;
  b.run(10);
  EXPECT_TRUE(b.stopped(Alarm::Substitution));
  EXPECT_EQ(b.address(0xF002), 0x0701u);
  EXPECT_EQ(b.address(0xF003), 0x220Fu);
}

// S5-BLK-09: the header of a block that the directory shows.
TEST(Program, HeaderInMemory) {
  ListingBench b("PB 25\n BE\n");
  b.run(10);
  const auto& memory = b.plc().machine().blocks.program();
  EXPECT_EQ(memory[0], 0x7070u);
  EXPECT_EQ(memory[1] & 0xFF, 0x19);
  EXPECT_EQ(memory[4], 6u);
  EXPECT_EQ(memory[5], 0x6500u);
}

// S5-OPC-08: the COP interprets word instructions, which takes longer.
TEST(Program, WordInstructionsOfTheCop) {
  const auto runTime = [](mc5::Variant variant, const char* code) {
    ListingBench b(std::string("OB 1\n") + code + " BE\n");
    b.options.variant = variant;
    b.run(10);
    return b.plc().operatingSystem().runTimes().cycle.cyclic.ns;
  };
  EXPECT_GT(runTime(mc5::Variant::Cop, " L KB 1\n"), runTime(mc5::Variant::Acop, " L KB 1\n"));
}

}  // namespace
}  // namespace merker::sinumerik
