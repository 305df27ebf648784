// Sending with 3964(R): each transition of its machine.
#include "stations.h"

namespace merker::serial {
namespace {

ProcedureParameters attempts(std::uint8_t setups, std::uint8_t transmissions) {
  ProcedureParameters parameters;
  parameters.setups = setups;
  parameters.transmissions = transmissions;
  return parameters;
}

// PTP-P3964-11, PTP-P3964-12, PTP-P3964-19
TEST(ProcedureSend, FromSetupToEnd) {
  Scripted s;
  s.partner.expect("02").wait(1'900).send("10").expect("41 10 10 10 03 52").wait(1'900).send("10");
  s.send(hex("41 10"));
  s.lines.run(3'850);
  EXPECT_EQ(s.end(), "0000");
  EXPECT_TRUE(s.partner.done());
}

// PTP-PARAM-32, PTP-P3964-13, PTP-P3964-14
TEST(ProcedureSend, CountsSetupAttempts) {
  for (const unsigned setups : {1U, 6U, 255U}) {
    ProcedureParameters parameters = attempts(static_cast<std::uint8_t>(setups), 6);
    parameters.acknowledgeDelay = Duration::milliseconds(20);
    Scripted s(parameters);
    s.send(hex("41"));
    s.lines.run(6'000);
    EXPECT_EQ(s.lines.seen.size(), setups + 1);
    EXPECT_EQ(s.end(), "0703");
  }
}

// PTP-P3964-10, PTP-P3964-23, PTP-PARAM-32
TEST(ProcedureSend, CountsTransmissionAttempts) {
  for (const unsigned blocks : {1U, 3U, 6U}) {
    Scripted s(attempts(2, static_cast<std::uint8_t>(blocks)));
    std::string expected;
    for (unsigned i = 0; i < blocks; ++i) {
      s.partner.expect("02").send("10").expect("41 10 03 52").send("15");
      expected += "A 02 | B 10 | A 41 10 03 52 | B 15 | ";
    }
    s.send(hex("41"));
    s.lines.run(1'000);
    EXPECT_EQ(s.lines.trace(), expected + "A 15");
    EXPECT_EQ(s.end(), "0706");
    EXPECT_EQ(number(s.cpu.outbox().takeWarning()), blocks > 1 ? "0701" : "0000");
  }
}

// PTP-P3964-23, PTP-ERR-27
TEST(ProcedureSend, AnotherCharacterInPlaceOfTheLastDle) {
  for (const char* answer : {"41", "02", "15"}) {
    Scripted s;
    s.partner.expect("02").send("10").expect("41 10 03 52").send(answer);
    s.partner.expect("02").send("10").expect("41 10 03 52").send("10");
    s.send(hex("41"));
    s.lines.run(1'000);
    EXPECT_EQ(s.end(), "0000");
    EXPECT_TRUE(s.partner.done());
  }
}

// PTP-P3964-13, PTP-P3964-23
TEST(ProcedureSend, FaultyCharactersAreNoAnswers) {
  Scripted s(attempts(6, 2));
  s.partner.expect("02").send("10").expect("02").send("10").expect("41 10 03 52").send("10");
  s.partner.expect("02").send("10").expect("41 10 03 52").send("15");
  s.lines.line.port(1).disturb(0, {Fault::Kind::Parity});
  s.lines.line.port(1).disturb(2, {Fault::Kind::Parity});
  s.send(hex("41"));
  s.lines.run(1'000);
  EXPECT_EQ(s.end(), "0702");
}

// PTP-P3964-24, PTP-ERR-28
TEST(ProcedureSend, PartnerIsSilentAfterTheBlock) {
  Scripted s(attempts(6, 3));
  for (unsigned i = 0; i < 3; ++i) s.partner.expect("02").send("10").expect("41 10 03 52");
  s.send(hex("41"));
  s.lines.run(6'200);
  EXPECT_EQ(s.end(), "0707");
  EXPECT_EQ(s.lines.seen.back().value, Procedure::kNak);
  std::vector<Instant> setups;
  for (const Sighting& seen : s.lines.seen)
    if (seen.value == Procedure::kStx && seen.port == 0) setups.push_back(seen.start);
  ASSERT_EQ(setups.size(), 3U);
  EXPECT_NEAR(static_cast<double>((setups[1] - setups[0]).ns), 2'000e6 + 6 * 1.1458e6, 1e4);
}

// PTP-P3964-20, PTP-ERR-26
TEST(ProcedureSend, NakWhileSending) {
  Scripted s;
  s.partner.expect("02").send("10").expect("41 42 43").wait(1).send("15");
  s.partner.expect("44 45 02").send("10").expect("41 42 43 44 45 46 47 48 10 03 1B").send("10");
  s.send(hex("41 42 43 44 45 46 47 48"));
  s.lines.run(1'000);
  EXPECT_EQ(s.end(), "0000");
  EXPECT_EQ(number(s.cpu.outbox().takeWarning()), "0701");
  Scripted always(attempts(6, 2));
  for (unsigned i = 0; i < 2; ++i)
    always.partner.expect("02").send("10").expect("41").wait(1).send("15").expect("42 43");
  always.partner.expect("15");
  always.send(hex("41 42 43"));
  always.lines.run(1'000);
  EXPECT_EQ(always.end(), "0705");
  EXPECT_TRUE(always.partner.done());
}

// PTP-P3964-21, PTP-ERR-25
TEST(ProcedureSend, AnotherCharacterWhileSending) {
  Scripted s;
  s.partner.expect("02").send("10").expect("41 42 43").wait(1).send("41").expect("44 45 15 02");
  s.partner.send("10").expect("41 42 43 44 45 46 47 48 10 03 1B").send("10");
  s.send(hex("41 42 43 44 45 46 47 48"));
  s.lines.run(1'000);
  EXPECT_EQ(s.end(), "0000");
  const auto stray = std::find_if(s.lines.seen.begin(), s.lines.seen.end(),
                                  [](const Sighting& c) { return c.port == 1 && c.value == 0x41; });
  const auto nak = std::find_if(s.lines.seen.begin(), s.lines.seen.end(),
                                [](const Sighting& c) { return c.value == Procedure::kNak; });
  EXPECT_EQ(nak->start, stray->end + Duration::milliseconds(220));
  EXPECT_EQ((nak + 1)->start, nak->end);
}

// PTP-P3964-21
TEST(ProcedureSend, OneNakAfterTheLastDisturbedAttempt) {
  Scripted s(attempts(6, 2));
  for (unsigned i = 0; i < 2; ++i)
    s.partner.expect("02").send("10").expect("41").wait(1).send("41").expect("42 43 15");
  s.send(hex("41 42 43"));
  s.lines.run(1'000);
  EXPECT_EQ(s.end(), "0704");
  EXPECT_EQ(s.lines.seen.back().value, Procedure::kNak);
  EXPECT_TRUE(s.partner.done());
}

// PTP-P3964-25, PTP-ERR-27
TEST(ProcedureSend, AcknowledgedTooEarly) {
  Scripted s(attempts(6, 1));
  s.partner.expect("02").send("10").expect("41 10").wait(1).send("10");
  s.send(hex("41"));
  s.lines.run(1'000);
  EXPECT_EQ(s.end(), "0706");
}

// PTP-P3964-26, PTP-ERR-43
TEST(ProcedureSend, BreakEndsTheJobAtOnce) {
  Scripted s;
  s.partner.expect("02").send("10");
  s.send(Bytes(100, 0x41));
  s.lines.run(50);
  s.lines.line.cut(0, true, s.lines.now);
  s.lines.run(1'000);
  EXPECT_EQ(s.end(), "080D");
  const std::size_t sent = s.lines.seen.size();
  s.lines.run(10'000);
  EXPECT_EQ(s.lines.seen.size(), sent);
  s.send(hex("41"));  // while the line is open
  s.lines.run(1'000);
  EXPECT_EQ(s.end(), "080D");
  s.lines.line.cut(0, false, s.lines.now);
  s.send(hex("41"));
  s.lines.run(1'000);
  EXPECT_EQ(s.lines.seen.back().value, Procedure::kStx);
}

// PTP-P3964-27, PTP-ERR-10, PTP-ERR-03
TEST(ProcedureSend, AbortedJobQuietsThePartner) {
  for (const Event why : {Event::Reset, Event::Restarted}) {
    Scripted s;
    s.partner.expect("02").send("10");
    s.send(Bytes(100, 0x41));
    s.lines.run(50);
    s.cpu.abort(why);
    s.lines.run(1'000);
    EXPECT_EQ(s.end(), number(why));
    EXPECT_EQ(s.lines.seen.back().value, Procedure::kNak);
    EXPECT_LT(s.lines.seen.size(), 50U);
  }
}

// PTP-P3964-28, PTP-PHY-10
TEST(ProcedureSend, WaitsForTheEndOfAReception) {
  Scripted s;
  s.partner.send("02").expect("10").send(Bytes(100, 0x42)).send("10 03 13").expect("10");
  s.lines.run(20);
  s.send(hex("41"));
  s.partner.expect("02").send("10").expect("41 10 03 52").send("10");
  s.lines.run(1'000);
  EXPECT_EQ(s.end(), "0000");
  EXPECT_TRUE(s.partner.done());
  EXPECT_EQ(s.mailbox(), text(Bytes(100, 0x42)));
}

// PTP-P3964-18, PTP-PARAM-27, PTP-ERR-32
TEST(ProcedureSend, BothHigh) {
  Procedures p({}, {});
  p.send(hex("41"));
  p.b.send(hex("42"), p.lines.now);
  p.lines.run(13'000);
  EXPECT_EQ(p.endOfA(), "070B");
  EXPECT_EQ(p.endOfB(), "070B");
}

// PTP-P3964-13, PTP-P3964-18, PTP-P3964-53: a conflict that does not last, or is not the first
// error
TEST(ProcedureSend, ConflictBesideOtherErrors) {
  Scripted refused(attempts(1, 2));
  refused.partner.expect("02").send("02").wait(20).send("15");
  refused.send(hex("41"));
  refused.lines.run(3'000);
  EXPECT_EQ(refused.end(), "0702");
  Scripted later(attempts(1, 2));
  later.partner.expect("02").send("10").expect("41 10 03 52").send("15").expect("02").send("02");
  later.send(hex("41"));
  later.lines.run(3'000);
  EXPECT_EQ(later.end(), "0706");
  Scripted once(attempts(2, 1));
  once.partner.expect("02").send("02 02");
  once.send(hex("41"));
  once.lines.run(5'000);
  EXPECT_EQ(once.end(), "0703");
}

// PTP-P3964-18, PTP-PARAM-27, PTP-ERR-33
TEST(ProcedureSend, BothLow) {
  Procedures p(low(), low());
  p.send(hex("41"));
  p.b.send(hex("42"), p.lines.now);
  p.lines.run(300);
  EXPECT_EQ(p.lines.trace().substr(0, 29), "A 02 | B 02 | A 10 | B 10 | A");
  EXPECT_EQ(p.endOfA(), "070C");
  EXPECT_EQ(p.endOfB(), "070C");
}

// PTP-P3964-53
TEST(ProcedureSend, ReportsTheFirstError) {
  Scripted s(attempts(2, 2));
  s.partner.expect("02 02").send("10").expect("41 10 03 52").send("15");
  s.partner.expect("02").send("10").expect("41 10 03 52").send("15");
  s.send(hex("41"));
  s.lines.run(3'000);
  EXPECT_EQ(s.end(), "0703");
}

// PTP-P3964-06, PTP-PARAM-26
TEST(ProcedureSend, SevenDataBits) {
  ProcedureParameters high, other = low();
  high.mask = other.mask = 0x7F;
  Procedures p(high, other, {.frame = {7, Parity::Even, 1}});
  p.send(counting(256));
  p.lines.run(3'000);
  EXPECT_EQ(p.endOfA(), "0000");
  Bytes half = counting(128);
  half.insert(half.end(), half.begin(), half.begin() + 128);
  EXPECT_EQ(p.mailB.take()->telegram, half);
}

// PTP-P3964-51
TEST(ProcedureSend, LostLastDleDeliversTwice) {
  Procedures p;
  p.lines.line.port(1).disturb(1, {Fault::Kind::Drop});
  p.send(hex("41"));
  p.lines.run(3'000);
  EXPECT_EQ(p.endOfA(), "0000");
  EXPECT_EQ(p.mailB.telegrams(), 2U);
}

}  // namespace
}  // namespace merker::serial
