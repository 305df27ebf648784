// Telegrams of 3964(R), byte by byte (PTP-VEC-01 to -21).
#include "stations.h"

namespace merker::serial {
namespace {

ProcedureParameters plain(bool high) {
  ProcedureParameters parameters;
  parameters.blockCheck = false;
  parameters.highPriority = high;
  parameters.acknowledgeDelay = kDelayWithoutBlockCheck;
  return parameters;
}

constexpr Duration kCharacter = characterTime({}, 9600);

// A sends the payload; the line must show the block, B must have the payload.
void transfers(const Bytes& payload, const std::string& block, bool blockCheck = true) {
  Procedures p(blockCheck ? ProcedureParameters{} : plain(true), blockCheck ? low() : plain(false));
  p.send(payload);
  p.lines.run(3'000);
  EXPECT_EQ(p.lines.trace(), "A 02 | B 10 | A " + block + " | B 10");
  EXPECT_EQ(p.endOfA(), "0000");
  const auto entry = p.mailB.take();
  ASSERT_TRUE(entry);
  EXPECT_EQ(text(entry->telegram), text(payload));
  EXPECT_FALSE(p.mailB.take());
}

// PTP-VEC-01, PTP-P3964-01, PTP-P3964-03, PTP-P3964-04, PTP-P3964-22, PTP-P3964-44, PTP-P3964-56
TEST(ProcedureVectors, WithBlockCheck) { transfers(hex("41 42 43"), "41 42 43 10 03 53"); }

// PTP-VEC-02, PTP-P3964-39
TEST(ProcedureVectors, WithoutBlockCheck) { transfers(hex("41 42 43"), "41 42 43 10 03", false); }

// PTP-VEC-03, PTP-VEC-04, PTP-VEC-05, PTP-VEC-06, PTP-P3964-02, PTP-P3964-38
TEST(ProcedureVectors, DoubledDle) {
  transfers(hex("10"), "10 10 10 03 13");
  transfers(hex("10 10"), "10 10 10 10 10 03 13");
  transfers(hex("01 10"), "01 10 10 10 03 12");
  transfers(hex("10 03"), "10 10 03 10 03 10");
}

// PTP-VEC-07
TEST(ProcedureVectors, ControlCharactersInTheData) {
  transfers(hex("02 03 15 02"), "02 03 15 02 10 03 05");
}

// PTP-VEC-08, PTP-P3964-45, PTP-ERR-38
TEST(ProcedureVectors, EmptyTelegram) {
  Scripted s;
  s.partner.send("02").expect("10").send("10 03 13").expect("10");
  s.lines.run(100);
  EXPECT_EQ(s.lines.trace(), "B 02 | A 10 | B 10 03 13 | A 10");
  EXPECT_EQ(s.mailbox(), "0807");
  EXPECT_TRUE(isWarning(Event::Empty));
}

// PTP-VEC-09, PTP-VEC-10, PTP-VEC-11, PTP-P3964-05
TEST(ProcedureVectors, BlockCheckIsNeverDoubled) {
  transfers(hex("03"), "03 10 03 10");
  transfers(hex("06"), "06 10 03 15");
  transfers(hex("11"), "11 10 03 02");
}

// PTP-VEC-12, PTP-VEC-13, PTP-OVW-03
TEST(ProcedureVectors, LongTelegrams) {
  Procedures p;
  p.send(counting(1024));
  p.lines.run(3'000);
  std::string trace = p.lines.trace();
  const std::string frame = "A 02 | B 10 | A ";
  EXPECT_EQ(trace.size(), frame.size() + 1031 * 3 - 1 + std::string(" | B 10").size());
  EXPECT_EQ(trace.substr(trace.size() - 15), "10 03 13 | B 10");
  EXPECT_EQ(p.mailB.take()->telegram, counting(1024));
  p.send(counting(200));
  p.lines.run(3'000);
  trace = p.lines.trace();
  EXPECT_EQ(trace.size(), frame.size() + 204 * 3 - 1 + std::string(" | B 10").size());
  EXPECT_EQ(trace.substr(trace.size() - 15), "10 03 03 | B 10");
  EXPECT_EQ(p.mailB.take()->telegram, counting(200));
}

// PTP-VEC-14, PTP-P3964-43, PTP-P3964-47, PTP-ERR-22, PTP-ERR-34
TEST(ProcedureVectors, WrongBlockCheckIsRepeated) {
  Procedures p;
  p.send(hex("41 42 43"));
  p.lines.line.port(0).disturb(6, {Fault::Kind::Replace, 0x52});
  p.lines.run(3'000);
  EXPECT_EQ(p.lines.trace(),
            "A 02 | B 10 | A 41 42 43 10 03 52 | B 15 | "
            "A 02 | B 10 | A 41 42 43 10 03 53 | B 10");
  EXPECT_EQ(number(p.a.outbox().takeWarning()), "0701");
  EXPECT_EQ(p.endOfA(), "0000");
  EXPECT_EQ(number(p.mailB.take()->event), "0801");
  EXPECT_EQ(text(p.mailB.take()->telegram), "41 42 43");
  EXPECT_FALSE(p.mailB.take());
}

// PTP-VEC-15, PTP-P3964-40, PTP-ERR-36
TEST(ProcedureVectors, IllegalPairAfterDle) {
  ProcedureParameters once;
  once.transmissions = 1;
  Scripted s(once);
  s.partner.send("02").expect("10").send("41 10 42 10 03 00").expect("15");
  s.lines.run(100);
  EXPECT_EQ(s.lines.trace(), "B 02 | A 10 | B 41 10 42 10 03 00 | A 15");
  EXPECT_EQ(s.mailbox(), "0805");
}

// PTP-VEC-16, PTP-P3964-09, PTP-P3964-14, PTP-P3964-32, PTP-ERR-24, PTP-OPEN-05, PTP-OPEN-21
TEST(ProcedureVectors, NobodyAnswers) {
  Scripted s;
  s.send(hex("41"));
  s.lines.run(12'100);
  ASSERT_EQ(s.lines.seen.size(), 7U);
  const Instant first = s.lines.seen[0].start;
  for (std::size_t n = 0; n < 7; ++n) {
    const Duration expected =
        (Duration::milliseconds(2'000) + kCharacter) * static_cast<std::int64_t>(n);
    EXPECT_LE(std::abs((s.lines.seen[n].start - first - expected).ns), 6);
    EXPECT_EQ(s.lines.seen[n].value, n < 6 ? Procedure::kStx : Procedure::kNak);
  }
  EXPECT_EQ(s.end(), "0703");
}

// PTP-VEC-17, PTP-P3964-13, PTP-ERR-23, PTP-OPEN-04
TEST(ProcedureVectors, PartnerRefusesEverySetup) {
  Scripted s;
  for (unsigned i = 0; i < 6; ++i) s.partner.expect("02").send("15");
  s.partner.expect("15");
  s.send(hex("41"));
  s.lines.run(100);
  EXPECT_EQ(s.lines.trace(),
            "A 02 | B 15 | A 02 | B 15 | A 02 | B 15 | A 02 | B 15 | A 02 | B 15 | A 02 | B 15 | "
            "A 15");
  EXPECT_EQ(s.end(), "0702");
}

// PTP-VEC-18, PTP-P3964-15, PTP-P3964-16, PTP-P3964-17, PTP-P3964-52
TEST(ProcedureVectors, InitialisationConflict) {
  Procedures p;
  p.send(hex("41 42 43"));
  p.b.send(hex("44 45 46"), p.lines.now);
  p.lines.run(3'000);
  EXPECT_EQ(p.lines.trace(),
            "A 02 | B 02 10 | A 41 42 43 10 03 53 | B 10 02 | A 10 | B 44 45 46 10 03 54 | A 10");
  EXPECT_EQ(p.endOfA(), "0000");
  EXPECT_EQ(p.endOfB(), "0000");
  EXPECT_EQ(text(p.mailB.take()->telegram), "41 42 43");
  EXPECT_EQ(text(p.mailA.take()->telegram), "44 45 46");
}

// PTP-VEC-19, PTP-P3964-33, PTP-ERR-35
TEST(ProcedureVectors, StrayCharacter) {
  Scripted s;
  s.partner.send("41");
  s.lines.run(400);
  ASSERT_EQ(s.lines.seen.size(), 2U);
  EXPECT_EQ(s.lines.seen[1].value, Procedure::kNak);
  EXPECT_EQ(s.lines.seen[1].start, s.lines.seen[0].end + Duration::milliseconds(220));
  EXPECT_EQ(s.mailbox(), "0802");
}

// PTP-VEC-20, PTP-P3964-30, PTP-ERR-41
TEST(ProcedureVectors, ReceiveBufferIsFull) {
  for (const bool freed : {false, true}) {
    Scripted s;
    s.mail.put(Bytes(1024));
    s.mail.put(Bytes(1024));
    s.mail.take();  // the warning
    s.partner.send("02");
    s.lines.run(200);
    if (freed) s.mail.take();
    s.lines.run(300);
    ASSERT_GE(s.lines.seen.size(), 2U);
    const Duration after = s.lines.seen[1].start - s.lines.seen[0].end;
    EXPECT_EQ(s.lines.seen[1].value, freed ? Procedure::kDle : Procedure::kNak);
    EXPECT_EQ(after, Duration::milliseconds(freed ? 200 : 400));
    s.mail.clear();
    if (!freed) {
      EXPECT_EQ(s.mailbox(), "080A");
    }
  }
}

// PTP-VEC-21, PTP-P3964-07, PTP-P3964-08, PTP-P3964-32
TEST(ProcedureVectors, NakAtTheStart) {
  Procedures p;
  p.a.start({});
  p.lines.run(50);
  p.b.start(p.lines.now);
  p.lines.run(500);
  EXPECT_EQ(p.lines.trace(), "A 15 | B 15");
  EXPECT_FALSE(p.mailA.take());
  EXPECT_FALSE(p.mailB.take());
}

}  // namespace
}  // namespace merker::serial
