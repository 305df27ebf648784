// Probes: what they see of a block (probe.h).
#include "listing_bench.h"
#include "watcher.h"

namespace merker::sinumerik {
namespace {

constexpr const char* kCaller =
    "OB 1\n L KB 1\n SPA PB 1\n L KB 2\n BE\nPB 1\n L KB 7\n A DB 10\n BE\nDB 10\n0: KH = 0000\n";

TEST(S5Probe, seesEachInstructionOfItsBlock) {
  ListingBench b(kCaller);
  Watcher watcher;
  EXPECT_TRUE(b.plc().probe(kIsOb1, &watcher));
  EXPECT_FALSE(b.plc().probe({mc5::BlockType::Pb, 9}, &watcher));
  EXPECT_FALSE(b.plc().probe({mc5::BlockType::Db, 10}, &watcher));  // another segment
  b.run(1);
  EXPECT_EQ(watcher.offsets, (Offsets{0, 1, 2, 3}));
  EXPECT_EQ(watcher.afterOffsets(), (Offsets{0, 2, 3}));  // the call opened a block
  EXPECT_EQ(watcher.done[0].registers.akku1, 1u);
  EXPECT_EQ(watcher.done[1].registers.akku2, 7u);
  const Watcher::Seen& last = watcher.done[2];
  EXPECT_TRUE(last.blockEnded && last.levelEnded && !last.trapped);
  EXPECT_EQ(last.registers.akku1, 2u);
  b.plc().probe(kIsOb1, nullptr);
  b.runTo(200);
  EXPECT_EQ(watcher.offsets.size(), 4u);
}

// Depth, open data block and registers can be read in front of and behind each instruction.
TEST(S5Probe, seesTheState) {
  ListingBench b(kCaller);
  Watcher watcher;
  b.plc().probe(kIsPb1, &watcher);
  std::vector<bool> open;
  watcher.wanted = [&](const Machine& m, const CodePlace& place) {
    EXPECT_EQ(place.block, kIsPb1);
    EXPECT_EQ(place.levels, 1u);
    EXPECT_EQ(place.frames, 2u);
    open.push_back(m.levels.back().frames.back().data.open);
    return false;
  };
  b.run(1);
  EXPECT_EQ(open, (std::vector<bool>{false, false, true}));
  const Watcher::Seen& end = watcher.done.back();
  EXPECT_TRUE(end.blockEnded);
  EXPECT_FALSE(end.levelEnded);
  EXPECT_EQ(end.registers.akku1, 7u);
}

TEST(S5Probe, stepsOn) {
  ListingBench b(kCaller);
  Watcher watcher;
  std::optional<CodePlace> stood;
  watcher.wanted = [&](const Machine&, const CodePlace& place) {
    const bool again = stood == place;
    stood = place;
    return !again;
  };
  for (const auto block : {kIsOb1, kIsPb1}) b.plc().probe(block, &watcher);
  b.run();
  std::vector<CodePlace> places;
  for (int i = 0; i < 7; ++i) {
    b.plc().runTo(ms(10));
    ASSERT_EQ(b.plc().mode(), Mode::Halt) << i;
    places.push_back(*b.plc().place());
    EXPECT_EQ(b.plc().instructions(), static_cast<unsigned>(i));
    EXPECT_TRUE(b.plc().resume());
  }
  EXPECT_EQ(places, (std::vector<CodePlace>{{kIsOb1, 0, 1, 1},
                                            {kIsOb1, 1, 1, 1},
                                            {kIsPb1, 0, 1, 2},
                                            {kIsPb1, 1, 1, 2},
                                            {kIsPb1, 2, 1, 2},
                                            {kIsOb1, 2, 1, 1},
                                            {kIsOb1, 3, 1, 1}}));
  EXPECT_EQ(watcher.afterOffsets(), (Offsets{0, 0, 1, 2, 2}));
}

// S5-PROC-09, S5-FB-06: B with what it processes, a call with the jump over its list.
TEST(S5Probe, takesOneStatementAsOne) {
  ListingBench b(R"(OB 1
 SPA FB 1
NAME : OBEN
 BE
FB 1
NAME : OBEN
 SPA FB 2
NAME : UNTEN
WERT : KF +2
 L KF +110
 T MW 100
 L KB 3
 B MW 100
 T MB 30
 U M 0.0
 SPB FB 2
NAME : UNTEN
WERT : KF +2
 BE
FB 2
NAME : UNTEN
BEZ  : WERT  E/A/D/B/T/Z: D   KM/KH/KY/KC/KT/KZ/KF/KG: KF
 LW =WERT
 BE
)");
  Watcher watcher;
  b.plc().probe(kIsFb1, &watcher);
  b.run(1);
  //                                   SPA L  T  L  B  U   SPB BE
  EXPECT_EQ(watcher.offsets, (Offsets{0, 3, 5, 6, 7, 9, 10, 13}));
  EXPECT_EQ(watcher.afterOffsets(), (Offsets{3, 5, 6, 7, 9, 10, 13}));
  EXPECT_EQ(b.value("MB 110"), 3u);
}

TEST(S5Probe, seesWhatStopsThePlc) {
  ListingBench b("OB 1\n L KB 5\n T DW 9\n BE\n");
  Watcher watcher;
  b.plc().probe(kIsOb1, &watcher);
  b.run(1);
  EXPECT_TRUE(b.stopped(Alarm::TransferToMissingDb));
  ASSERT_EQ(watcher.done.size(), 2u);
  EXPECT_TRUE(watcher.done[1].trapped);
  EXPECT_EQ(watcher.done[1].registers.akku1, 5u);
}

TEST(S5Probe, holdsInOb20AndOb2) {
  ListingBench b("OB 20\n L KB 1\n BE\nOB 1\n SPA PB 1\n BE\nPB 1\n" + burn(8) +
                 " BE\nOB 2\n L KB 2\n BE\n");
  Watcher start, alarm;
  b.plc().probe(kIsOb20, &start);
  b.plc().probe(kIsOb2, &alarm);
  start.holdAt(1);
  b.run(10);
  EXPECT_EQ(b.plc().mode(), Mode::Halt);
  EXPECT_EQ(b.plc().place(), (CodePlace{kIsOb20, 1, 1, 1}));
  EXPECT_TRUE(b.control(ControlBit::OBWIED));
  EXPECT_TRUE(b.plc().resume());
  EXPECT_EQ(b.plc().mode(), Mode::Startup);
  b.plc().runToCheckpoint(ms(20));
  EXPECT_EQ(b.plc().mode(), Mode::Run);
  alarm.holdAt(0);
  b.runTo(69);
  b.write("EB 7", 1);
  b.plc().runTo(ms(100));
  ASSERT_EQ(b.plc().mode(), Mode::Halt);
  EXPECT_EQ(b.plc().place(), (CodePlace{kIsOb2, 0, 2, 3}));
  b.plc().resume();
  b.plc().settle();
  EXPECT_EQ(alarm.done.size(), 2u);
  EXPECT_TRUE(alarm.done[1].levelEnded);
  EXPECT_EQ(alarm.done[1].registers.akku1, 2u);
}

// A jump out of the running block leads into the code of another one.
TEST(S5Probe, knowsTheBlockByItsCode) {
  ListingBench b("OB 1\n L KB 0\n BE\nPB 1\n L KB 1\n L KB 2\n BE\n");
  constexpr std::uint16_t kJump = 0x2D00, kToPb1 = 2 + mc5::kHeaderWords;
  b.options.program.at(kIsOb1).words.front() = kJump | kToPb1;
  Watcher watcher;
  b.plc().probe(kIsPb1, &watcher);
  watcher.holdAt(1);
  b.run(1);
  ASSERT_EQ(b.plc().mode(), Mode::Halt);
  EXPECT_EQ(b.plc().place(), (CodePlace{kIsPb1, 1, 1, 1}));
  b.plc().resume();
  b.plc().settle();
  EXPECT_EQ(watcher.offsets, (Offsets{0, 1, 2}));
  EXPECT_TRUE(watcher.done.back().levelEnded);
}

// A block that is loaded again, at another place, keeps its probe.
TEST(S5Probe, staysAtItsBlock) {
  ListingBench b(kCaller);
  Watcher watcher;
  b.plc().probe(kIsPb1, &watcher);
  b.run(70);
  const std::size_t before = watcher.offsets.size();
  mc5::Block longer = b.options.program.at(kIsOb1);
  longer.words.insert(longer.words.begin(), {0x2801, 0x2801});
  EXPECT_EQ(b.plc().programmer().load(longer), "");
  b.runTo(130);
  EXPECT_EQ(watcher.offsets.size(), before + 3);
  EXPECT_EQ(watcher.offsets.back(), 2u);
  EXPECT_EQ(watcher.done.back().place.frames, 2u);
}

}  // namespace
}  // namespace merker::sinumerik
