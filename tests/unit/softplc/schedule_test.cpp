// Load limits, chopping, watchdog, diagnosis DB, timers in the raster (chapters 1.3.4, 9.3.4).
#include "listing_bench.h"

namespace merker::sinumerik {
namespace {

std::string cyclic(double milliseconds) {
  return "OB 1\n L MW 100\n L KF +1\n +F\n T MW 100\n" + burn(milliseconds) + " BE\n";
}

// S5-SCHED-05, S5-MD-04, S5-ERR-01, S5-ERR-02: 15 % of 60 ms; the standard setting stops.
TEST(Schedule, RunTimeOfOb1) {
  ListingBench within(cyclic(8.8));
  within.run(500);
  EXPECT_EQ(within.plc().mode(), Mode::Run) << within.plc().stopReason();
  ListingBench stop(cyclic(10));
  stop.run(500);
  EXPECT_TRUE(stop.stopped(Alarm::CyclicRunTime));
  EXPECT_TRUE(stop.control(ControlBit::WECKFE));
  ListingBench message(cyclic(10));
  message.set(2003, 1, false);
  message.run(500);
  EXPECT_EQ(message.plc().mode(), Mode::Run);
  EXPECT_TRUE(message.pending(6159));
  EXPECT_EQ(message.value("DB1.D 8.8"), 1u);
  EXPECT_EQ(message.value("M 8.0"), 1u);
  ListingBench wider(cyclic(10));
  wider.data().setWord(1, 20);
  wider.run(500);
  EXPECT_EQ(wider.plc().mode(), Mode::Run);
}

// S5-ERR-03, S5-FLAG-08, S5-SCHED-18: the program resets the fault bits, nobody else.
TEST(Schedule, FaultBitsStay) {
  ListingBench b(
      "OB 1\n U E 1.0\n SPB PB 1\n L MW 100\n L KF +1\n +F\n T MW 100\n A DB 1\n U D 8.8\n"
      " = M 110.0\n U E 1.1\n R D 8.8\n R M 8.0\n BE\nPB 1\n" +
      burn(10) + " BE\n");
  b.set(2003, 1, false);
  b.run(70);
  b.write("E 1.0", 1);
  b.runTo(130);
  b.write("E 1.0", 0);
  b.runTo(130 + 100 * 60);
  EXPECT_GT(b.value("MW 100"), 100u);
  EXPECT_EQ(b.value("M 110.0"), 1u);
  EXPECT_EQ(b.value("M 8.0"), 1u);
  b.write("E 1.1", 1);
  b.runTo(6300);
  EXPECT_EQ(b.value("DB1.D 8.8"), 0u);
  EXPECT_EQ(b.value("M 8.0"), 0u);
}

// S5-SCHED-06: 8 ms in slices of 3, 3 and 2 ms in the thirds of the raster.
TEST(Schedule, ChoppingCutsOb1) {
  ListingBench b(cyclic(8));
  b.set(2003, 6);
  b.run();
  const auto used = [&b](double until) {
    b.runTo(until);
    return static_cast<double>(b.plc().operatingSystem().runTimes().cycle.cyclic.ns) / 1e6;
  };
  EXPECT_NEAR(used(2), 2, 0.25);
  EXPECT_NEAR(used(19.9), 3, 0.25);
  EXPECT_NEAR(used(22), 5, 0.25);
  EXPECT_NEAR(used(39.9), 6, 0.25);
  EXPECT_NEAR(used(59.9), 8, 0.25);
  EXPECT_EQ(b.plc().cycles(), 1u);
  b.runTo(600);
  EXPECT_EQ(b.plc().mode(), Mode::Run);
  EXPECT_EQ(b.plc().cycles(), 10u);
}

// S5-SCHED-07, S5-SCHED-08: the manual's 25 ms: 15 % with chopping, 41.7 % without.
TEST(Schedule, LoadOfALongProgram) {
  const auto load = [](bool chopping) {
    ListingBench b(cyclic(25));
    b.set(2003, 6, chopping);
    b.set(2003, 1, false);
    b.data().setWord(5, 320);
    b.run(12'010);
    EXPECT_EQ(b.plc().mode(), Mode::Run) << b.plc().stopReason();
    return b.plc().loadPerMille();
  };
  EXPECT_NEAR(load(true), 154, 1);  // of an endless program: an instruction may overrun each slice
  EXPECT_NEAR(load(false), 417, 1);
}

// S5-SCHED-09: what is not ready in one raster goes on and begins anew at once.
TEST(Schedule, LongerThanTheRaster) {
  ListingBench b(cyclic(70));
  b.set(2003, 1, false);
  b.data().setWord(5, 320);
  b.run();
  b.plc().advanceToCheckpoint(ms(1000));
  const double first = static_cast<double>(b.plc().now().ns) / 1e6;
  b.plc().advanceToCheckpoint(ms(1000));
  EXPECT_NEAR(first, 70, 0.5);
  EXPECT_NEAR(static_cast<double>(b.plc().now().ns) / 1e6, 2 * first, 0.1);
}

// S5-SCHED-10: runs of OB 2 add up over 4 samplings; the other level does not count.
TEST(Schedule, RunTimeOfOb2) {
  for (const bool stops : {true, false}) {
    ListingBench b(cyclic(5) + "OB 2\n" + burn(1.1) + " BE\n");
    b.set(2003, 0, stops);
    b.run(70);
    b.write("EB 7", 1);
    b.runTo(100);
    EXPECT_FALSE(b.pending(6160));
    b.write("EB 7", 3);
    b.runTo(105.5);
    b.write("EB 7", 7);
    b.runTo(130);
    EXPECT_TRUE(b.pending(6160));
    EXPECT_EQ(b.plc().mode(), stops ? Mode::Stop : Mode::Run);
    EXPECT_EQ(b.value("DB1.D 8.9"), stops ? 0u : 1u);
  }
}

// S5-SCHED-11, S5-OB-18: an endless loop ends after MD 5, always with STOP.
TEST(Schedule, CycleWatchdog) {
  for (const unsigned limit : {70u, 200u}) {
    ListingBench b(
        "OB 1\n SPA FB 1\nNAME : SCHLEIFE\n BE\nFB 1\nNAME : SCHLEIFE\n"
        "M1 : SPA =M1\n BE\n");
    b.data().setWord(5, static_cast<std::uint16_t>(limit));
    b.set(2003, 1, false);
    b.run();
    b.plc().advanceToCheckpoint(ms(1000));
    EXPECT_TRUE(b.stopped(Alarm::CycleTime));
    EXPECT_TRUE(b.plc().operatingSystem().record().picture().interrupt.causes.test(Cause::ZYK));
    const auto& entry = b.plc().diagnostics().back();
    EXPECT_NEAR(static_cast<double>(entry.time.ns) / 1e6, limit, 0.1);
  }
}

// S5-SCHED-14, S5-SCHED-15, S5-OB-17: one-shot trigger, values of the cycle before.
TEST(Schedule, DiagnosisOnce) {
  ListingBench b(cyclic(4) + "OB 2\n" + burn(1) + " BE\n");
  b.set(2003, 7);
  b.run(70);
  b.write("EB 7", 1);
  b.runTo(110);
  EXPECT_EQ(b.value("DB1.DW 0"), 0u);
  b.write("DB1.DW 9", 0x8000);
  b.runTo(125);
  EXPECT_EQ(b.value("DB1.DW 9"), 0u);
  EXPECT_EQ(b.value("DB1.DW 0"), 60u);
  EXPECT_NEAR(b.value("DB1.DW 2"), 21 * 193 + 25, 1);  // +G, and the instructions around them
  EXPECT_NEAR(b.value("DB1.DW 3"), 6 * 193 + 22, 1);
  EXPECT_EQ(b.value("DB1.DW 1"), b.value("DB1.DW 2") + b.value("DB1.DW 3"));
  EXPECT_EQ(b.value("DB1.DW 4"), 1u);
  const unsigned before = b.value("DB1.DW 3");
  b.runTo(300);
  EXPECT_EQ(b.value("DB1.DW 3"), before);  // nobody asked again
}

TEST(Schedule, DiagnosisIsOffWithoutItsBit) {
  ListingBench b(cyclic(4));
  b.run(10);
  b.write("DB1.DW 9", 0x8000);
  b.runTo(200);
  EXPECT_EQ(b.value("DB1.DW 9"), 0x8000u);
  EXPECT_EQ(b.value("DB1.DW 0"), 0u);
}

// S5-SCHED-16, S5-SCHED-17: periodic trigger; values above 32767 are unsigned.
TEST(Schedule, DiagnosisEachCycle) {
  ListingBench b("OB 1\n A DB 1\n U M 0.1\n = D 9.15\n U E 1.0\n SPB PB 1\n BE\nPB 1\n" + burn(40) +
                 " BE\n");
  b.set(2003, 7);
  b.set(2003, 1, false);
  b.run(130);
  EXPECT_LT(b.value("DB1.DW 2"), 100u);
  b.write("E 1.0", 1);
  b.runTo(250);
  EXPECT_NEAR(b.value("DB1.DW 2"), 40'000, 500);
  EXPECT_GT(b.value("DB1.DW 2"), 0x7FFFu);
}

// S5-SCHED-12: what others do with the processor is not in it.
TEST(Schedule, RunTimesAreThoseOfTheLevel) {
  ListingBench quiet(cyclic(4)), busy(cyclic(4) + "OB 2\n" + burn(1) + " BE\n");
  for (ListingBench* b : {&quiet, &busy}) {
    b->set(2003, 7);
    b->run(130);
  }
  busy.write("EB 7", 1);
  for (ListingBench* b : {&quiet, &busy}) {
    b->runTo(170);
    b->write("DB1.DW 9", 0x8000);
    b->runTo(190);
  }
  EXPECT_EQ(quiet.value("DB1.DW 3"), 0u);
  EXPECT_GT(busy.value("DB1.DW 3"), 900u);
  EXPECT_EQ(busy.value("DB1.DW 2"), quiet.value("DB1.DW 2"));
}

double lasting(std::uint8_t samplingCode, Software software, TimerKind kind, std::uint16_t time) {
  const Raster raster = makeRaster(samplingCode, 3, mc5::Variant::Acop, software);
  Timer timer;
  timer.start(kind, true, time, {}, raster.timeBases);
  Instant now;
  while (timer.output()) {
    now = now + raster.sampling;
    timer.count(now, raster.timeBases);
  }
  return static_cast<double>(now.ns) / 1e9;
}

// S5-SCHED-19: the table of deviations.
TEST(Schedule, TimersFollowTheRaster) {
  constexpr auto kOld = Software::Sw1, kNew = Software::Sw2;
  constexpr auto kPulse = TimerKind::SI;
  EXPECT_NEAR(lasting(0, kOld, kPulse, 0x1010), 0.80, 0.01);  // KT 10.1
  EXPECT_NEAR(lasting(1, kOld, kPulse, 0x1010), 0.90, 0.01);
  EXPECT_NEAR(lasting(2, kOld, kPulse, 0x1010), 1.00, 0.01);
  EXPECT_NEAR(lasting(3, kOld, kPulse, 0x1010), 1.10, 0.01);
  EXPECT_NEAR(lasting(0, kNew, kPulse, 0x1100), 10.0, 0.02);  // KT 100.1
  EXPECT_NEAR(lasting(1, kNew, kPulse, 0x1100), 9.90, 0.02);
  EXPECT_NEAR(lasting(2, kNew, kPulse, 0x1100), 10.0, 0.02);
  EXPECT_NEAR(lasting(3, kNew, kPulse, 0x1100), 9.80, 0.02);
  EXPECT_NEAR(lasting(0, kNew, kPulse, 0x2100), 95.0, 0.1);  // KT 100.2
  EXPECT_NEAR(lasting(1, kNew, kPulse, 0x2100), 99.0, 0.1);
  EXPECT_NEAR(lasting(3, kNew, kPulse, 0x2100), 99.0, 0.1);
  EXPECT_NEAR(lasting(1, kNew, kPulse, 0x3010), 100.0, 1.0);  // KT 10.3
}

// S5-SCHED-20: MD 155 ends at 5.
TEST(Schedule, IllegalSamplingTime) {
  ListingBench b(cyclic(1));
  b.data().samplingCode = 6;
  b.run(10);
  EXPECT_TRUE(b.stopped(Alarm::SamplingTime));
}

// S5-SCHED-04: PLC-MD 1 ends at 20.
TEST(Schedule, IllegalLoad) {
  ListingBench b(cyclic(1));
  b.data().setWord(1, 21);
  b.run(10);
  EXPECT_TRUE(b.stopped(Alarm::LoadNumber));
}

}  // namespace
}  // namespace merker::sinumerik
