// MB 0 to MB 24 (chapter 7.1).
#include "listing_bench.h"

namespace merker::sinumerik {
namespace {

// Each level keeps what it finds: MB 0..3, M 6.2, MB 24.
std::string keeps(unsigned to) {
  std::string text;
  for (unsigned byte : {0, 1, 2, 3})
    text += " L MB " + std::to_string(byte) + "\n T MB " + std::to_string(to + byte) + "\n";
  return text;
}
const std::string kAllLevels =
    "OB 20\n" + keeps(120) + " BE\nOB 1\n" + keeps(140) + " BE\nOB 2\n" + keeps(160) + " BE\n";

// S5-FLAG-01, S5-FLAG-03, S5-FLAG-13: constants and number of the level.
TEST(TransferFlags, ConstantsAndLevel) {
  ListingBench b(kAllLevels);
  b.run(70);
  b.write("M 0.1", 0);
  b.write("M 0.0", 1);
  b.write("E 7.0", 1);
  b.runTo(190);
  for (const char* flags : {"MB 120", "MB 140", "MB 160"}) EXPECT_EQ(b.value(flags) & 3, 2u);
  EXPECT_EQ(b.value("MB 121"), 20u);
  EXPECT_EQ(b.value("MB 141"), 1u);
  EXPECT_EQ(b.value("MB 161"), 2u);
}

// S5-FLAG-03: the level that goes on after an interruption has its number again.
TEST(TransferFlags, NumberComesBack) {
  ListingBench b("OB 1\n" + burn(7) + " L MB 1\n T MB 140\n BE\nOB 2\n L MB 1\n T MB 160\n BE\n");
  b.run(59);
  b.write("E 7.0", 1);
  b.plc().settle();
  b.runTo(70);
  EXPECT_EQ(b.value("MB 160"), 2u);
  EXPECT_EQ(b.value("MB 140"), 1u);
}

// S5-FLAG-02: 50 IPO clocks bright, 50 dark.
TEST(TransferFlags, BlinkClock) {
  for (const auto& [code, half] : {std::pair{2, 1.0}, std::pair{0, 0.8}}) {
    ListingBench b("OB 1\n BE\n");
    b.data().samplingCode = static_cast<std::uint8_t>(code);
    b.run();
    std::vector<double> changes;
    unsigned before = b.value("M 0.7");
    for (int i = 1; i < 5000; ++i) {
      b.runTo(i);
      if (b.value("M 0.7") != before) changes.push_back(i / 1000.0);
      before = b.value("M 0.7");
    }
    ASSERT_GE(changes.size(), 4u);
    EXPECT_GE(changes[0], half);
    EXPECT_LE(changes[0], half + 0.002);
    for (std::size_t i = 1; i < changes.size(); ++i)
      EXPECT_NEAR(changes[i] - changes[i - 1], half, 0.002);
  }
}

// S5-FLAG-04, S5-FLAG-05: the first complete pass of each level after a cold start.
TEST(TransferFlags, FirstPassOfEachLevel) {
  ListingBench b(kAllLevels);
  b.run(30);
  EXPECT_EQ(b.value("MB 123") & 1, 1u);
  EXPECT_EQ(b.value("MB 142"), 0x06u);
  EXPECT_EQ(b.value("MB 143") & 6, 0x06u);
  b.runTo(130);
  EXPECT_EQ(b.value("MB 142"), 0x04u);  // OB 2 still to come
  EXPECT_EQ(b.value("MB 143") & 6, 0x04u);
  b.write("E 7.0", 1);
  b.runTo(150);
  EXPECT_EQ(b.value("MB 162"), 0x04u);
  EXPECT_EQ(b.value("MB 163") & 6, 0x04u);
  b.write("E 7.1", 1);
  b.runTo(250);
  EXPECT_EQ(b.value("MB 162"), 0u);
  EXPECT_EQ(b.value("MB 163") & 6, 0u);
  EXPECT_EQ(b.value("MB 142"), 0u);
  b.plc().stop();
  b.plc().warmStart();
  b.runTo(300);
  EXPECT_EQ(b.value("MB 142"), 0u);
  EXPECT_EQ(b.value("MB 123") & 1, 0u);
}

// S5-FLAG-07: MB 7 has no bits.
TEST(TransferFlags, ReadinessHasNoBits) {
  ListingBench b("OB 1\n L MB 7\n T MB 107\n BE\n");
  b.run(10);
  b.write("MB 7", 0xFF);
  b.runTo(70);
  EXPECT_EQ(b.value("MB 107"), 0u);
}

// S5-FLAG-10: reloading block by block, as the NC has it.
TEST(TransferFlags, Reloading) {
  ListingBench b("OB 1\n L MB 17\n T MB 117\n BE\n");
  b.options.surroundings.nc = {
      .reloading = 3, .blocks1 = 0x1234, .blocks2 = 0xABCD, .ringFull = true, .serialRuns = true};
  b.run(70);
  EXPECT_EQ(b.value("MB 117"), 3u);
  EXPECT_EQ(b.value("MW 19"), 0x1234u);
  EXPECT_EQ(b.value("MW 21"), 0xABCDu);
  EXPECT_EQ(b.value("MB 23"), 0x81u);
  b.plc().surroundings().nc.ringFull = false;
  b.plc().surroundings().nc.ringEmpty = true;
  b.runTo(130);
  EXPECT_EQ(b.value("MB 23"), 0x41u);
}

// S5-FLAG-11: probes, alarms of the NC, battery.
TEST(TransferFlags, Monitoring) {
  ListingBench b("OB 1\n BE\n");
  b.run(70);
  EXPECT_EQ(b.value("MB 24"), 0x04u);
  struct Case {
    NcSide nc;
    bool battery;
    unsigned flags;
  };
  double time = 70;
  for (const Case& c : {Case{{.probe2 = true}, true, 0x84}, Case{{.probe1 = true}, true, 0x44},
                        Case{{.machiningStop = true}, true, 0x0C}, Case{{}, false, 0x06},
                        Case{{.alarm = true}, true, 0x05}}) {
    b.plc().surroundings().nc = c.nc;
    b.plc().surroundings().batteryGood = c.battery;
    b.runTo(time += 60);
    EXPECT_EQ(b.value("MB 24"), c.flags);
  }
}

// S5-FLAG-08: the group fault bit with a fine bit.
TEST(TransferFlags, GroupFault) {
  ListingBench b("OB 1\n BE\n");
  b.run(70);
  EXPECT_EQ(b.value("M 8.0"), 0u);
  b.plc().surroundings().masterPlcRuns = false;
  b.runTo(130);
  EXPECT_EQ(b.value("M 8.0"), 1u);
  EXPECT_EQ(b.value("DB1.D 8.11"), 1u);
}

}  // namespace
}  // namespace merker::sinumerik
