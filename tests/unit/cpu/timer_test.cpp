// The diagrams of chapter 16, in virtual time.
#include <gtest/gtest.h>

#include "cpu/s5_timer.h"

namespace merker::cpu {
namespace {

using Kind = S5Timer::Kind;
constexpr std::uint16_t kFiveSeconds = 0x0500;  // S5T#5S, base 10 ms

constexpr Instant at(double seconds) { return {static_cast<std::int64_t>(seconds * 1e9)}; }

struct Diagram {
  Kind kind;
  S5Timer timer{};
  void start(double t, bool rlo, std::uint16_t value = kFiveSeconds) {
    EXPECT_TRUE(timer.start(kind, rlo, value, at(t)));
  }
  bool q(double t) const { return timer.status(at(t)); }
};

// S7-SIM-03, S7-SIM-13: a programming device gives a timer another rest, or resets it.
TEST(S5Timer, IsModified) {
  S5Timer timer{};
  timer.start(Kind::OnDelay, true, 0x2007, Instant{});  // 7 s
  EXPECT_TRUE(timer.modify(0x2003, Instant{} + Duration::seconds(1)));
  EXPECT_FALSE(timer.status(Instant{} + Duration::milliseconds(3999)));
  EXPECT_TRUE(timer.status(Instant{} + Duration::seconds(4)));
  EXPECT_FALSE(timer.modify(0x200A, Instant{} + Duration::seconds(4)));
  EXPECT_TRUE(timer.modify(0, Instant{} + Duration::seconds(4)));
  EXPECT_FALSE(timer.status(Instant{} + Duration::seconds(4)));
  EXPECT_EQ(timer.units(Instant{} + Duration::seconds(4)), 0);
}

// S7-TMR-10, S7-TMR-11, S7-INSTR-26
TEST(S5Timer, PulseLastsTheTimeOrTheStart) {
  Diagram longStart{Kind::Pulse};
  longStart.start(0, true);
  EXPECT_TRUE(longStart.q(0));
  EXPECT_TRUE(longStart.q(4.999));
  EXPECT_FALSE(longStart.q(5));
  longStart.start(8, true);
  EXPECT_FALSE(longStart.q(8));

  Diagram shortStart{Kind::Pulse};
  shortStart.start(0, true);
  EXPECT_TRUE(shortStart.q(1.999));
  shortStart.start(2, false);
  EXPECT_FALSE(shortStart.q(2));
}

// S7-TMR-11, S7-TMR-06
TEST(S5Timer, PulseResetDoesNotRunAgainWhileStartIsOne) {
  Diagram run{Kind::Pulse};
  run.start(0, true);
  run.timer.reset(true);
  EXPECT_FALSE(run.q(1));
  EXPECT_EQ(run.timer.s5time(at(1)), 0);
  run.start(1, true);
  EXPECT_FALSE(run.q(1));
  run.start(2, false);
  run.start(3, true);
  EXPECT_TRUE(run.q(3));
}

// S7-TMR-12, S7-INSTR-27
TEST(S5Timer, ExtendedPulseOutlastsItsStart) {
  Diagram run{Kind::ExtendedPulse};
  run.start(0, true);
  run.start(1, false);
  EXPECT_TRUE(run.q(4.999));
  EXPECT_FALSE(run.q(5));
}

// S7-TMR-13
TEST(S5Timer, ExtendedPulseStartsAnew) {
  Diagram run{Kind::ExtendedPulse};
  run.start(0, true);
  run.start(1, false);
  run.start(3, true);
  EXPECT_TRUE(run.q(7.999));
  EXPECT_FALSE(run.q(8));
  run.start(9, false);
  run.start(10, true);
  run.timer.reset(true);
  EXPECT_FALSE(run.q(11));
}

// S7-TMR-14, S7-TMR-15, S7-INSTR-28
TEST(S5Timer, OnDelayNeedsItsStart) {
  Diagram run{Kind::OnDelay};
  run.start(0, true);
  EXPECT_FALSE(run.q(4.999));
  EXPECT_TRUE(run.q(5));
  run.start(8, false);
  EXPECT_FALSE(run.q(8));

  Diagram early{Kind::OnDelay};
  early.start(0, true);
  early.start(4, false);
  EXPECT_FALSE(early.q(5));
  EXPECT_FALSE(early.q(20));
}

// S7-TMR-15: R takes the status back until the next edge.
TEST(S5Timer, OnDelayReset) {
  Diagram run{Kind::OnDelay};
  run.start(0, true);
  run.timer.reset(true);
  run.start(7, true);
  EXPECT_FALSE(run.q(20));
  run.start(21, false);
  run.start(22, true);
  EXPECT_TRUE(run.q(27));
}

// S7-TMR-16, S7-TMR-17, S7-INSTR-29, S7-OPEN-24
TEST(S5Timer, StoredOnDelayComesByItselfAndStays) {
  Diagram run{Kind::StoredOnDelay};
  run.start(0, true);
  run.start(1, false);
  EXPECT_FALSE(run.q(4.999));
  EXPECT_TRUE(run.q(5));
  EXPECT_TRUE(run.q(500));
  run.timer.reset(true);
  EXPECT_FALSE(run.q(501));

  Diagram again{Kind::StoredOnDelay};
  again.start(0, true);
  again.start(1, false);
  again.start(3, true);
  EXPECT_FALSE(again.q(7.999));
  EXPECT_TRUE(again.q(8));
}

// S7-TMR-17: whatever the start does once the time is over.
TEST(S5Timer, StoredOnDelayStaysWhenItStartsAgainAfterItsTime) {
  Diagram run{Kind::StoredOnDelay};
  run.start(0, true);
  run.start(6, false);
  run.start(7, true);
  EXPECT_TRUE(run.q(7));
  EXPECT_EQ(run.timer.units(at(8)), 400);  // the time runs again
  EXPECT_TRUE(run.q(12));
  run.timer.reset(true);
  EXPECT_FALSE(run.q(12));
  EXPECT_FALSE(run.q(30));
  run.start(31, false);
  run.start(32, true);
  EXPECT_FALSE(run.q(36.999));
  EXPECT_TRUE(run.q(37));
}

// S7-TMR-04: a start with a bad value leaves the timer as it is.
TEST(S5Timer, RefusedStartChangesNothing) {
  Diagram run{Kind::ExtendedPulse};
  run.start(0, true);
  run.timer.start(Kind::ExtendedPulse, false, kFiveSeconds, at(1));
  EXPECT_FALSE(run.timer.start(Kind::StoredOnDelay, true, 0x0ABC, at(2)));
  EXPECT_TRUE(run.q(4.999));
  EXPECT_FALSE(run.q(5));
}

// S7-TMR-18, S7-TMR-05, S7-INSTR-30, S7-OPEN-11
TEST(S5Timer, OffDelayRunsWhenStartEnds) {
  Diagram run{Kind::OffDelay};
  EXPECT_FALSE(run.q(0));
  run.start(0, true);
  EXPECT_TRUE(run.q(1));
  run.start(2, false);
  EXPECT_TRUE(run.q(6.999));
  EXPECT_FALSE(run.q(7));
  run.start(9, false);
  EXPECT_FALSE(run.q(9));
}

// S7-TMR-19
TEST(S5Timer, OffDelayStartAgainAndReset) {
  Diagram run{Kind::OffDelay};
  run.start(0, true);
  run.start(2, false);
  run.start(4, true);  // stops the time, status stays
  EXPECT_TRUE(run.q(20));
  EXPECT_EQ(run.timer.units(at(20)), 0);
  run.start(21, false);
  EXPECT_TRUE(run.q(25.999));
  EXPECT_FALSE(run.q(26));

  Diagram reset{Kind::OffDelay};
  reset.start(0, true);
  reset.start(2, false);
  reset.timer.reset(true);
  EXPECT_FALSE(reset.q(3));

  Diagram held{Kind::OffDelay};
  held.start(0, true);
  held.timer.reset(true);  // start still 1
  EXPECT_FALSE(held.q(1));
  held.start(2, false);
  EXPECT_FALSE(held.q(2));
  held.start(3, true);
  EXPECT_TRUE(held.q(3));
}

// S7-TMR-21, S7-INSTR-31
TEST(S5Timer, EnableStartsAgainWithoutAnEdge) {
  Diagram run{Kind::OnDelay};
  run.start(0, true);
  run.timer.enable(true);
  run.start(3, true);
  EXPECT_FALSE(run.q(7.999));
  EXPECT_TRUE(run.q(8));
  run.timer.enable(true);  // no edge of its own
  run.start(9, true);
  EXPECT_TRUE(run.q(9));
}

TEST(S5Timer, EnableDoesNotHoldAnOffDelay) {
  Diagram run{Kind::OffDelay};
  run.start(0, true);
  run.timer.enable(true);
  run.start(1, false);
  EXPECT_TRUE(run.q(5.999));
  EXPECT_FALSE(run.q(6));
}

// S7-TMR-04: only with an edge.
TEST(S5Timer, RefusesWhatIsNoBcd) {
  S5Timer timer;
  EXPECT_TRUE(timer.start(Kind::OnDelay, false, 0x0ABC, at(0)));
  EXPECT_FALSE(timer.start(Kind::OnDelay, true, 0x0ABC, at(0)));
  EXPECT_TRUE(timer.start(Kind::OnDelay, true, 0x0ABC, at(1)));
}

// S7-TMR-07, S7-TMR-02: 7.3 s left of S5T#10S.
TEST(S5Timer, ShowsWhatIsLeft) {
  S5Timer timer;
  timer.start(Kind::OnDelay, true, 0x1100, at(0));
  EXPECT_EQ(timer.units(at(2.7)), 73);
  EXPECT_EQ(timer.s5time(at(2.7)), 0x1073);
  EXPECT_EQ(timer.units(at(2.75)), 73);  // a begun unit counts
  EXPECT_EQ(timer.units(at(10)), 0);
}

// S7-INSTR-32
TEST(S5Timer, ResetClearsValueAndBase) {
  S5Timer timer;
  timer.start(Kind::ExtendedPulse, true, 0x2100, at(0));
  timer.reset(false);
  EXPECT_EQ(timer.s5time(at(1)), 0x2099);
  timer.reset(true);
  EXPECT_EQ(timer.s5time(at(1)), 0);
}

// S7-CPU-06, S7-TYPES-10: each base.
TEST(S5Timer, KnowsFourBases) {
  const struct {
    std::uint16_t value;
    double seconds;
  } rows[] = {{0x0001, 0.01}, {0x1001, 0.1}, {0x2001, 1}, {0x3999, 9990}};
  for (const auto& row : rows) {
    S5Timer timer;
    timer.start(Kind::ExtendedPulse, true, row.value, at(0));
    EXPECT_TRUE(timer.status(at(row.seconds - 0.001)));
    EXPECT_FALSE(timer.status(at(row.seconds)));
  }
}

// S7-TMR-20: no drift however often it is looked at.
TEST(S5Timer, ExpiresExactly) {
  S5Timer timer;
  timer.start(Kind::OnDelay, true, 0x1010, Instant{123'456'789});
  EXPECT_FALSE(timer.status(Instant{1'123'456'788}));
  EXPECT_TRUE(timer.status(Instant{1'123'456'789}));
}

}  // namespace
}  // namespace merker::cpu
