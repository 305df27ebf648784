// Receiving with 3964(R): each transition of its machine.
#include "stations.h"

namespace merker::serial {
namespace {

ProcedureParameters transmissions(std::uint8_t count) {
  ProcedureParameters parameters;
  parameters.transmissions = count;
  return parameters;
}

Duration behind(const Scripted& s, std::size_t index) {
  return s.lines.seen[index].start - s.lines.seen[index - 1].end;
}

// PTP-P3964-29, PTP-P3964-36, PTP-P3964-37
TEST(ProcedureReceive, FromSetupToEnd) {
  Scripted s;
  s.partner.send("02").expect("10").wait(200).send("41").wait(200).send("10").wait(200).send("03");
  s.partner.wait(200).send("52").expect("10");
  s.lines.run(1'000);
  EXPECT_TRUE(s.partner.done());
  EXPECT_EQ(s.mailbox(), "41");
}

// PTP-P3964-31
TEST(ProcedureReceive, CharactersWhileItWaitsForABuffer) {
  Scripted s;
  s.mail.put(Bytes(1024));
  s.mail.put(Bytes(1024));
  s.partner.send("02").wait(100).send("41 42");
  s.lines.run(500);
  EXPECT_EQ(s.lines.trace(), "B 02 41 42 | A 15");
  s.mail.clear();
  EXPECT_EQ(s.mailbox(), "0B01; 0802; 080A");
}

// PTP-P3964-34, PTP-ERR-42
TEST(ProcedureReceive, DisturbedCharacterInIdleIsReportedAtOnce) {
  Scripted s;
  s.lines.line.port(1).disturb(0, {Fault::Kind::Parity});
  s.partner.send("41");
  s.lines.run(10);
  EXPECT_EQ(s.mailbox(), "080C");
  s.lines.run(300);
  EXPECT_EQ(s.lines.trace(), "B 41 | A 15");
}

// PTP-P3964-33
TEST(ProcedureReceive, WaitsUntilTheLineIsQuiet) {
  Scripted s;
  s.partner.send("41").wait(100).send("42").wait(150).send("02");
  s.lines.run(1'000);
  ASSERT_EQ(s.lines.seen.size(), 4U);
  EXPECT_EQ(behind(s, 3), Duration::milliseconds(220));
  EXPECT_EQ(s.mailbox(), "0802");
}

// PTP-P3964-35, PTP-ERR-43
TEST(ProcedureReceive, BreakDiscardsTheTelegram) {
  Scripted s;
  s.partner.send("02").expect("10").send("41 42 43 10 03 53");
  s.lines.run(5);
  s.lines.line.cut(0, true, s.lines.now);
  s.lines.run(500);
  EXPECT_EQ(s.mailbox(), "080D");
  s.lines.line.cut(0, false, s.lines.now);
  s.partner.send("02").expect("10").send("41 10 03 52").expect("10");
  s.lines.run(500);
  EXPECT_EQ(s.mailbox(), "41");
}

// PTP-P3964-41, PTP-P3964-54, PTP-ERR-42
TEST(ProcedureReceive, TransmissionFaults) {
  for (const Fault::Kind kind : {Fault::Kind::Parity, Fault::Kind::Stop, Fault::Kind::Overrun}) {
    Scripted s;
    s.lines.line.port(1).pace(Duration::milliseconds(1));
    s.lines.line.port(1).disturb(2, {kind});
    s.partner.send("02").expect("10").send("41 42 43 44 45 10 03 52").expect("15");
    s.partner.send("02").expect("10").send("41 42 43 44 45 10 03 52").expect("10");
    s.lines.run(1'000);
    EXPECT_TRUE(s.partner.done());
    EXPECT_EQ(s.mailbox(), "0801; 41 42 43 44 45");
  }
  Scripted bad(transmissions(2));
  for (const std::uint64_t index : {2U, 11U})
    bad.lines.line.port(1).disturb(index, {Fault::Kind::Parity});
  for (unsigned i = 0; i < 2; ++i)
    bad.partner.send("02").expect("10").send("41 42 43 44 45 10 03 52").expect("15");
  bad.lines.run(1'000);
  EXPECT_TRUE(bad.partner.done());
  EXPECT_EQ(bad.mailbox(), "0801; 080C");
}

// PTP-P3964-42, PTP-ERR-37
TEST(ProcedureReceive, PartnerStopsInTheTelegram) {
  for (const char* begun : {"", "41 42", "41 10", "41 10 03"}) {
    Scripted s;
    s.partner.send("02").expect("10");
    if (*begun != 0) s.partner.send(begun);
    s.lines.run(5'000);
    EXPECT_EQ(s.lines.seen.back().value, Procedure::kNak);
    EXPECT_EQ(behind(s, s.lines.seen.size() - 1), Duration::milliseconds(220)) << begun;
    EXPECT_EQ(s.mailbox(), "0806");
  }
}

// PTP-P3964-42
TEST(ProcedureReceive, RepetitionAfterTheCharacterDelay) {
  Scripted s;
  s.partner.send("02").expect("10").send("41").expect("15").send("02").expect("10");
  s.partner.send("41 10 03 52").expect("10");
  s.lines.run(5'000);
  EXPECT_TRUE(s.partner.done());
  EXPECT_EQ(s.mailbox(), "0806; 41");
}

// PTP-P3964-46, PTP-ERR-39
TEST(ProcedureReceive, BlockCheckIsAlwaysWrong) {
  Scripted s;
  for (unsigned i = 0; i < 6; ++i)
    s.partner.send("02").expect("10").send("41 10 03 53").expect("15");
  s.lines.run(5'000);
  EXPECT_TRUE(s.partner.done());
  EXPECT_EQ(s.mailbox(), "0801; 0808");
  s.partner.send("02").expect("10").send("41 10 03 52").expect("10");
  s.lines.run(500);
  EXPECT_EQ(s.mailbox(), "41");
}

// PTP-P3964-48, PTP-P3964-53, PTP-ERR-40
TEST(ProcedureReceive, NoRepetition) {
  Scripted s;
  s.partner.send("02").expect("10").send("41 10 03 53").expect("15");
  s.lines.run(2'000);
  EXPECT_EQ(s.mailbox(), "0801");
  s.lines.run(20);
  EXPECT_EQ(s.mailbox(), "0809");
}

// PTP-P3964-49
TEST(ProcedureReceive, OtherCharactersBeforeTheRepetition) {
  Scripted s;
  s.partner.send("02").expect("10").send("41 10 03 53").expect("15").send("41 15").wait(1'900);
  s.partner.send("02").expect("10").send("41 10 03 52").expect("10");
  s.lines.run(5'000);
  EXPECT_TRUE(s.partner.done());
  EXPECT_EQ(s.mailbox(), "0801; 41");
}

// PTP-P3964-50, PTP-ERR-49
TEST(ProcedureReceive, TelegramIsTooLong) {
  Scripted s(transmissions(1));
  s.partner.send("02").expect("10").send(Bytes(1025, 0x41)).send("10 03 52").expect("15");
  s.lines.run(5'000);
  EXPECT_TRUE(s.partner.done());
  EXPECT_EQ(s.mailbox(), "0816");
}

// PTP-P3964-55
TEST(ProcedureReceive, TelegramThatDoesNotFitIsRefused) {
  Scripted s(transmissions(1));
  s.mail.put(Bytes(1024));
  s.mail.put(Bytes(1020));
  s.partner.send("02").expect("10").send("41 42 43 44 45 10 03 52").expect("15");
  s.lines.run(1'000);
  EXPECT_TRUE(s.partner.done());
  s.mail.clear();
  EXPECT_EQ(s.mailbox(), "0B01; 080A");
}

// PTP-OPEN-19, PTP-PARAM-02
TEST(ProcedureReceive, CpuInStopThatDiscards) {
  Scripted s;
  s.mail.refuse(true);
  s.partner.send("02").expect("15");
  s.lines.run(500);
  EXPECT_EQ(behind(s, 1), Duration::milliseconds(400));
  s.mail.start();
  EXPECT_EQ(s.mailbox(), "080A");
  s.partner.send("02").expect("10").send("41 10 03 52").expect("10");
  s.lines.run(500);
  EXPECT_EQ(s.mailbox(), "41");
}

// PTP-PARAM-30, PTP-PARAM-31
TEST(ProcedureReceive, TimesAreParameters) {
  ProcedureParameters parameters;
  parameters.characterDelay = Duration::milliseconds(20);
  parameters.acknowledgeDelay = Duration::milliseconds(70);
  Scripted s(parameters);
  s.partner.send("02").expect("10").send("41");
  s.lines.run(500);
  EXPECT_EQ(behind(s, 3), Duration::milliseconds(20));
  s.send(hex("41"));
  s.lines.run(60);
  s.lines.trace();
  s.lines.run(200);
  EXPECT_EQ(behind(s, 1), Duration::milliseconds(70));
}

}  // namespace
}  // namespace merker::serial
