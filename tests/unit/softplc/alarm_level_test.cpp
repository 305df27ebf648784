// OB 2: edges of the alarm byte, interruption, processing delay, reaction time (chapters 1.3.4, 5).
#include "listing_bench.h"

namespace merker::sinumerik {
namespace {

// Counts its runs in MW 100 and keeps what it sees.
constexpr const char* kOb2 = R"(OB 2
 L  MB 12
 T  MB 112
 L  MB 16
 T  MB 116
 L  EB 7
 T  MB 107
 L  MW 100
 L  KF +1
 +F
 T  MW 100
 BE
)";
constexpr const char* kOb1 = "OB 1\n BE\n";

// S5-OB-06, S5-OB-07, S5-OB-08, S5-FLAG-09: once per change, before the image has it.
TEST(AlarmLevel, EdgesOfTheAlarmByte) {
  ListingBench b(std::string(kOb1) + kOb2);
  b.run(70);
  EXPECT_EQ(b.value("MW 100"), 0u);
  b.write("E 7.3", 1);
  b.runTo(80);
  EXPECT_EQ(b.value("MW 100"), 1u);
  EXPECT_EQ(b.value("MB 116"), 0x08u);
  EXPECT_EQ(b.value("MB 112"), 0u);
  EXPECT_EQ(b.value("MB 107"), 0u);  // the image is old still
  EXPECT_EQ(b.value("MB 12") | b.value("MB 16"), 0u);
  b.write("EB 7", 0x41);  // 7.3 falls, 7.6 and 7.0 rise
  b.runTo(200);
  EXPECT_EQ(b.value("MW 100"), 2u);
  EXPECT_EQ(b.value("MB 112"), 0x08u);
  EXPECT_EQ(b.value("MB 116"), 0x41u);
  EXPECT_EQ(b.value("EB 7"), 0x41u);
}

// S5-OB-06: MD 2002 bit 0 switches the level off; MD 0 chooses the byte.
TEST(AlarmLevel, MachineDataChooseTheByte) {
  ListingBench off(std::string(kOb1) + kOb2);
  off.set(2002, 0);
  off.run(10);
  off.write("EB 7", 0xFF);
  off.runTo(100);
  EXPECT_EQ(off.value("MW 100"), 0u);
  ListingBench other(std::string(kOb1) + kOb2);
  other.data().setWord(0, 3);
  other.run(10);
  other.write("EB 7", 0xFF);
  other.runTo(50);
  EXPECT_EQ(other.value("MW 100"), 0u);
  other.write("EB 3", 0xFF);
  other.runTo(100);
  EXPECT_EQ(other.value("MW 100"), 1u);
}

// A loop that checks that its accumulators, its data block and its chain stay its own.
const std::string kSteadyOb1 = R"(OB 1
 A   DB 10
 SPA FB 1
NAME : PRUEF
 BE
FB 1
NAME : PRUEF
M01 : L   KH 1234
 L   KH 5678
 U   M 0.1
 U   M 0.1
 =   M 120.0
 T   DW 1
 TAK
 T   DW 0
 L   DW 0
 L   KH 1234
 ><F
 S   M 121.0
 L   DW 1
 L   KH 5678
 ><F
 S   M 121.0
 UN  M 120.0
 S   M 121.0
 L   MW 122
 L   KF +1
 +F
 T   MW 122
 L   KF +500
 <F
 SPB =M01
 L   KF +0
 T   MW 122
 BE
DB 10
0: KH = 0000
1: KH = 0000
DB 11
0: KH = 0000
1: KH = 0000
)";

// S5-OB-10, S5-DB-09, S5-SCHED-03: OB 2 comes between any two instructions and gives all back.
TEST(AlarmLevel, InterruptionIsNotNoticed) {
  ListingBench b(kSteadyOb1 + R"(OB 2
 A   DB 11
 L   KH FFFF
 L   KH FFFF
 T   DW 0
 UN  M 0.1
 L   MW 100
 L   KF +1
 +F
 T   MW 100
 BE
)");
  b.data().setWord(3, 2500);
  b.set(2003, 1, false);
  b.run();
  unsigned inside = 0;
  for (int i = 1; i < 400; ++i) {
    b.runTo(i * 7.3);
    ASSERT_EQ(b.plc().mode(), Mode::Run) << b.plc().stopReason();
    b.write("EB 7", static_cast<unsigned>(i) & 0xFF);
    if (!b.plc().operatingSystem().betweenCycles()) ++inside;
  }
  b.plc().settle();
  EXPECT_GT(b.value("MW 100"), 350u);
  EXPECT_GT(inside, 20u);
  EXPECT_EQ(b.value("M 121.0"), 0u);
  EXPECT_EQ(b.value("DB11.DW 0"), 0xFFFFu);
  EXPECT_EQ(b.value("DB10.DW 0"), 0x1234u);
}

// S5-PROC-09: B and what it processes are one instruction for OB 2.
TEST(AlarmLevel, ProcessedInstructionsAreNotTornApart) {
  ListingBench b(R"(OB 1
 SPA FB 1
NAME : KOPIE
 BE
FB 1
NAME : KOPIE
M01 : L KF +130
 T   MW 124
 L   KB 7
 B   MW 124
 T   MB 0
 L   MB 130
 L   KB 7
 ><F
 S   M 121.0
 L   KB 0
 T   MB 130
 L   MW 122
 L   KF +1
 +F
 T   MW 122
 L   KF +500
 <F
 SPB =M01
 L   KF +0
 T   MW 122
 BE
OB 2
 L   MW 100
 L   KF +1
 +F
 T   MW 100
 BE
)");
  b.set(2003, 1, false);
  b.run();
  for (int i = 1; i < 1000; ++i) {
    b.runTo(i * 5.0007);
    b.write("EB 7", static_cast<unsigned>(i) & 0xFF);
  }
  EXPECT_EQ(b.plc().mode(), Mode::Run) << b.plc().stopReason();
  EXPECT_GT(b.value("MW 100"), 900u);
  EXPECT_EQ(b.value("M 121.0"), 0u);
}

// S5-OB-11: OB 1 waits for the end of OB 2.
TEST(AlarmLevel, Ob1WaitsForOb2) {
  ListingBench b("OB 1\n L MB 101\n T MB 103\n L KB 1\n T MB 102\n BE\nOB 2\n" + burn(4) +
                 " L KB 1\n T MB 101\n BE\n");
  b.data().setWord(3, 2500);
  b.set(2003, 0, false);
  b.run(116);
  b.write("MB 102", 0);
  b.write("E 7.0", 1);  // the sampling at 120 ms begins OB 2 and calls OB 1
  b.runTo(121);
  EXPECT_EQ(b.value("MB 101"), 0u);
  b.runTo(123);
  EXPECT_EQ(b.value("MB 102"), 0u);
  b.plc().advanceTo(ms(127));
  EXPECT_EQ(b.value("MB 102"), 1u);
  EXPECT_EQ(b.value("MB 103"), 1u);
}

// OB 2 longer than a sampling, an edge in each.
void provokeDelay(ListingBench& b, bool stops) {
  b.set(2003, 0, stops);
  b.set(2003, 1, stops);
  b.run(70);
  for (int i = 0; i < 4; ++i) {
    b.runTo(70 + 5 * i);
    b.write("EB 7", i % 2 == 0 ? 0xFF : 0x00);
  }
  b.runTo(150);
}
const std::string kLongOb2 =
    std::string(kOb1) + "OB 2\n" + burn(6) + " L MW 100\n L KF +1\n +F\n T MW 100\n BE\n";

// S5-OB-12, S5-FLAG-06, S5-ERR-15: the standard setting stops; M 6.2 stays 0.
TEST(AlarmLevel, ProcessingDelayStops) {
  ListingBench b(kLongOb2);
  provokeDelay(b, true);
  EXPECT_TRUE(b.stopped(Alarm::ProcessingDelay));
  EXPECT_EQ(b.value("M 6.2"), 0u);
  EXPECT_EQ(b.address(0xF005), 1u);
  EXPECT_EQ(b.address(0xF002), 2u);
  EXPECT_TRUE(b.control(ControlBit::WECKFE));
}

// S5-OB-12, S5-FLAG-06, S5-ERR-15: as a message M 6.2 shows it, and the request is not lost.
TEST(AlarmLevel, ProcessingDelayIsReported) {
  ListingBench b(kLongOb2);
  provokeDelay(b, false);
  EXPECT_EQ(b.plc().mode(), Mode::Run);
  EXPECT_TRUE(b.pending(6162));
  EXPECT_EQ(b.value("M 6.2"), 1u);
  EXPECT_GE(b.address(0xF005), 1u);
  EXPECT_EQ(b.address(0xF001), 0x6162u);
  EXPECT_EQ(b.address(0xF000), 0u);
  EXPECT_EQ(b.address(0xF002), 2u);
  EXPECT_GE(b.value("MW 100"), 3u);
  b.plc().coldStart();
  EXPECT_EQ(b.value("M 6.2"), 0u);
  EXPECT_EQ(b.address(0xF002), 0u);
  EXPECT_EQ(b.address(0xF005), 0u);
}

// S5-OB-13: the image goes out behind OB 1; T PB at once.
TEST(AlarmLevel, OutputsOfOb2) {
  ListingBench b("OB 1\n BE\nOB 2\n L KB 5\n T AB 8\n T PB 9\n BE\n");
  b.run(70);
  b.write("E 7.0", 1);
  b.runTo(90);
  EXPECT_EQ(b.value("PB 8"), 0u);
  EXPECT_EQ(b.value("PB 9"), 5u);
  EXPECT_EQ(b.value("AB 9"), 5u);
  b.runTo(125);
  EXPECT_EQ(b.value("PB 8"), 5u);
  EXPECT_EQ(b.value("PB 9"), 5u);
}

// S5-OB-14: AB 90 and AB 99 go to the NC in each IPO clock.
TEST(AlarmLevel, ProgramControlOfTheChannels) {
  ListingBench b("OB 1\n BE\nOB 2\n L KB 5\n T AB 90\n T AB 99\n T AB 91\n BE\n");
  b.run(61);
  b.write("E 7.0", 1);
  b.runTo(79);
  EXPECT_EQ(b.value("AB 90"), 5u);
  EXPECT_EQ(b.value("PB 90"), 0u);
  b.runTo(81);
  EXPECT_EQ(b.value("PB 90"), 5u);
  EXPECT_EQ(b.value("PB 99"), 5u);
  EXPECT_EQ(b.value("PB 91"), 0u);
}

// S5-OB-15, S5-SCHED-01: 2 to 7.5 ms for a central byte, 3.5 to 9 ms for one of the distributed
// unit.
TEST(AlarmLevel, ReactionTime) {
  for (const bool distributed : {false, true}) {
    ListingBench b("OB 1\n BE\nOB 2\n L MW 100\n L KF +1\n +F\n T MW 100\n BE\n");
    if (distributed) {
      b.options.surroundings.modules = {{.first = 0, .bytes = 64, .distributed = true},
                                        {.output = true, .first = 0, .bytes = 64}};
      b.set(2002, 4);
    }
    b.run(100);
    const double low = distributed ? 3.5 : 2, high = distributed ? 9 : 7.5;
    double shortest = 100, longest = 0;
    for (unsigned i = 1; i < 200; ++i) {
      const double start = 100 + i * 20.113;
      b.runTo(start);
      const unsigned before = b.value("MW 100");
      b.write("EB 7", i & 0xFF);
      while (b.value("MW 100") == before && b.plc().now() < ms(start + 20))
        b.plc().advanceTo(b.plc().now() + Duration::microseconds(20));
      const double reaction = static_cast<double>((b.plc().now() - ms(start)).ns) / 1e6;
      shortest = std::min(shortest, reaction);
      longest = std::max(longest, reaction);
    }
    EXPECT_GE(shortest, low);
    EXPECT_LE(longest, high);
    EXPECT_GT(longest - shortest, 4);  // the sampling is in it
  }
}

}  // namespace
}  // namespace merker::sinumerik
