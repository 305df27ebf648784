// HALT of the PLC: the program stands, time moves (halt.cpp).
#include "listing_bench.h"
#include "watcher.h"

namespace merker::sinumerik {
namespace {

// Timers of several bases, an alarm level, an output, work that takes a while, and the values of
// each cycle in DB 1 (S5-SCHED-14).
const std::string& plant() {
  static const std::string listing =
      "OB 1\n L MW 100\n L KF +1\n +F\n T MW 100\n U M 0.0\n UN M 0.0\n SPB PB 1\n UN T 1\n"
      " L KT 030.0\n SE T 1\n U M 0.1\n L KT 007.1\n SE T 2\n U T 2\n = M 110.0\n"
      " SPA PB 1\n L KB 5\n T AB 0\n A DB 1\n U M 0.1\n = D 9.15\n BE\nPB 1\n LC T 2\n T MW 112\n" +
      burn(4) + " BE\nOB 2\n L MW 102\n L KF +1\n +F\n T MW 102\n BE\n";
  return listing;
}

constexpr std::uint32_t kNever = 9999;

// Stands at this word of a block when it comes there for the first time.
struct Held : ListingBench {
  Held(const std::string& listing, mc5::BlockId block, std::uint32_t offset)
      : ListingBench(listing) {
    plc().probe(block, &watcher);
    watcher.holdAt(offset);
  }
  double stood() { return static_cast<double>((plc().now() - *plc().heldSince()).ns) / 1e6; }
  Watcher watcher;
};

std::string picture(ListingBench& b) {
  std::string text = b.plc().stopReason();
  const auto add = [&text](std::uint64_t value) { text += ' ' + std::to_string(value); };
  add(b.plc().cycles());
  add(b.plc().instructions());
  add(static_cast<std::uint64_t>(b.plc().operatingSystem().runTimes().cycle.cyclic.ns));
  for (unsigned word = 0; word < 10; ++word) add(b.value("DB1.DW " + std::to_string(word)));
  for (const std::uint8_t byte : b.plc().machine().flags) add(byte);
  for (const Timer& timer : b.plc().machine().timers) add(timer.word());
  return text;
}

// A hold is a time that did not pass: everything is as without it, so much later.
TEST(S5Halt, isATimeThatDidNotPass) {
  for (const mc5::BlockId block : {kIsOb1, kIsPb1, kIsOb2}) {
    ListingBench quiet(plant());
    Held held(plant(), block, kNever);
    for (ListingBench* b : {&quiet, static_cast<ListingBench*>(&held)}) {
      b->plc().machineData().setBit(data_bit::kDiagnosis, true);
      b->run(130);
      b->write("EB 7", 1);
    }
    held.watcher.holdAt(3);
    held.runTo(12'345.6);
    quiet.runTo(130.5);
    ASSERT_EQ(held.plc().mode(), Mode::Halt);
    const double stood = held.stood();
    held.plc().resume();
    for (const double at : {190.0, 333.3, 640.0, 1000.0}) {
      quiet.runTo(at);
      held.runTo(at + stood);
      EXPECT_EQ(picture(held), picture(quiet)) << toString(block) << ' ' << at;
    }
    EXPECT_EQ(held.plc().mode(), Mode::Run) << held.plc().stopReason();
    EXPECT_EQ(held.value("MW 102"), 1u);
  }
}

TEST(S5Halt, nothingMoves) {
  Held b(plant(), kIsPb1, 1);
  b.run(400);
  ASSERT_EQ(b.plc().mode(), Mode::Halt);
  const std::string before = picture(b);
  const std::size_t entries = b.plc().diagnostics().size();
  b.runTo(60'000);
  EXPECT_EQ(picture(b), before);
  EXPECT_EQ(b.plc().now(), ms(60'000));
  EXPECT_EQ(b.plc().diagnostics().size(), entries);
  EXPECT_FALSE(b.pending(6159) || b.pending(6161) || b.pending(6162));
}

// An edge that comes while the PLC stands is found by the next sampling.
TEST(S5Halt, anAlarmWaits) {
  Held b(plant(), kIsPb1, 1);
  b.run(100);
  b.write("EB 7", 1);
  b.runTo(500);
  EXPECT_EQ(b.value("MW 102"), 0u);
  b.plc().resume();
  b.runTo(510);
  EXPECT_EQ(b.value("MW 102"), 1u);
}

TEST(S5Halt, disablesTheOutputs) {
  ListingBench b(plant());
  b.run(70);
  Reference terminal;
  terminal.operand = address::memory(merker::Area::Peripheral, merker::Width::Byte, 0);
  EXPECT_EQ(b.plc().read(terminal), 5u);
  EXPECT_TRUE(b.plc().hold());
  EXPECT_FALSE(b.plc().hold());
  EXPECT_EQ(b.plc().read(terminal), 0u);
  EXPECT_EQ(b.value("AB 0"), 5u);
  EXPECT_TRUE(b.plc().resume());
  EXPECT_FALSE(b.plc().resume());
  EXPECT_EQ(b.plc().read(terminal), 5u);
}

TEST(S5Halt, nobodyWaitsForIt) {
  Held b(plant(), kIsPb1, 1);
  b.run(1);
  const Instant before = b.plc().now();
  EXPECT_TRUE(b.plc().settle());
  b.plc().advanceCycles(3);
  b.plc().runToCheckpoint(ms(40));
  EXPECT_EQ(b.plc().now(), before);
  EXPECT_FALSE(b.plc().advanceToCheckpoint(ms(50)));
  EXPECT_EQ(b.plc().now(), ms(50));
  b.plc().resume();
  EXPECT_TRUE(b.plc().settle());
  EXPECT_EQ(b.plc().cycles(), 1u);
}

// S5-PG-03: the interrupt stack shows where it stood.
TEST(S5Halt, canEndInStop) {
  Held b(plant(), kIsPb1, 1);
  b.run(5000);
  b.plc().stop();
  EXPECT_TRUE(b.stopped(Alarm::ProgrammerStop));
  EXPECT_FALSE(b.plc().stoppedByFault());
  const InterruptStack& stack = b.plc().operatingSystem().record().picture().interrupt;
  EXPECT_EQ(stack.block, kIsPb1);
  EXPECT_EQ(stack.relativeStep, 1u);
  EXPECT_TRUE(b.control(ControlBit::UAFEHL));
  EXPECT_FALSE(b.plc().resume());
  EXPECT_TRUE(b.plc().coldStart());
  b.runTo(5100);
  EXPECT_EQ(b.plc().mode(), Mode::Run);
  EXPECT_EQ(b.plc().cycles(), 2u);
}

TEST(S5Halt, ofTheStartUpEndsInStop) {
  Held b("OB 20\n L KB 1\n BE\nOB 1\n BE\n", kIsOb20, 1);
  b.run(5000);
  EXPECT_TRUE(b.plc().settle());
  b.plc().stop();
  EXPECT_TRUE(b.stopped(Alarm::ProgrammerStop));
  EXPECT_TRUE(b.control(ControlBit::MAFEHL));
}

// The 200 ms that a start-up is waited for are its own.
TEST(S5Halt, ofTheStartUpTakesNoTime) {
  Held b("OB 20\n L KB 1\n BE\nOB 1\n BE\n", kIsOb20, 1);
  b.run(5000);
  b.plc().resume();
  EXPECT_TRUE(b.plc().settle());
  EXPECT_EQ(b.plc().mode(), Mode::Run);
}

TEST(S5Halt, canBeginAnew) {
  Held b(plant(), kIsPb1, 1);
  b.run(5000);
  EXPECT_TRUE(b.plc().coldStart());
  EXPECT_EQ(b.plc().mode(), Mode::Run);
  EXPECT_EQ(b.value("MW 100"), 0u);
  b.runTo(5130);
  EXPECT_EQ(b.plc().cycles(), 3u);
}

TEST(S5Halt, endsWithoutPower) {
  Held b(plant(), kIsPb1, 1);
  EXPECT_TRUE(b.plc().machineData().setBit(data_bit::kWarmRestart, true));
  b.run(5000);
  b.plc().powerOff();
  EXPECT_EQ(b.plc().mode(), Mode::Off);
  b.runTo(6000);
  b.plc().powerOn();
  b.runTo(6130);
  EXPECT_EQ(b.plc().mode(), Mode::Run);
  EXPECT_TRUE(b.control(ControlBit::WIEDAN));
}

// Timers outlast a warm restart: those of a PLC that stood have not run meanwhile.
TEST(S5Halt, isNoTimeOfAWarmRestart) {
  Held b("OB 1\n UN T 1\n L KT 100.1\n SE T 1\n SPA PB 1\n BE\nPB 1\n LC T 1\n BE\n", kIsPb1, 1);
  b.plc().machineData().setBit(data_bit::kWarmRestart, true);
  b.run(5000);
  ASSERT_EQ(b.value("T 1"), 0x1100u);
  EXPECT_TRUE(b.plc().warmStart());
  b.runTo(6050);
  EXPECT_EQ(b.value("T 1"), 0x1090u);
}

// A message leaves the PLC standing, an alarm that stops it does not.
TEST(S5Halt, alarmsFromOutside) {
  Held b(plant(), kIsPb1, 1);
  b.run(100);
  b.plc().raise({Alarm::Jumpers, {}});
  EXPECT_TRUE(b.pending(6122));
  EXPECT_EQ(b.plc().mode(), Mode::Halt);
  b.plc().raise({Alarm::NoAnswerCoupling, {}});
  EXPECT_TRUE(b.stopped(Alarm::NoAnswerCoupling));
}

// What a programmer loads comes between two cycles.
TEST(S5Halt, aLoadedBlockWaits) {
  Held b(plant(), kIsPb1, 1);
  b.run(10);
  const mc5::Block& old = b.options.program.at(kIsPb1);
  mc5::Block empty = old;
  empty.words = {0x6500};
  EXPECT_EQ(b.plc().programmer().load(empty), "");
  EXPECT_EQ(b.plc().programmer().read(kIsPb1)->words, old.words);
  b.plc().resume();
  b.plc().settle();
  EXPECT_EQ(b.plc().programmer().read(kIsPb1)->words, empty.words);
}

}  // namespace
}  // namespace merker::sinumerik
