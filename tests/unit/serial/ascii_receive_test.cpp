// Receiving with the ASCII driver: end criteria, faults, the buffer, STOP of the CPU.
#include "ascii_stations.h"

namespace merker::serial {
namespace {

AsciiParameters checked(AsciiParameters parameters, std::uint8_t characters) {
  parameters.checkCharacters = characters;
  return parameters;
}

// Characters of a partner whose ends are so many microseconds apart.
std::string receive(const AsciiParameters& parameters,
                    const std::vector<std::pair<int, int>>& steps) {
  AsciiCpu c(parameters);
  std::uint64_t index = 0;
  Bytes bytes;
  for (const auto& [value, distance] : steps) {
    const Duration idle = Duration::microseconds(distance) - characterTime({}, 9600);
    if (index > 0) c.lines.line.port(1).disturb(index, {Fault::Kind::Delay, 0, idle});
    bytes.push_back(static_cast<std::uint8_t>(value));
    ++index;
  }
  c.partner.send(bytes);
  c.lines.run(3'000);
  return c.mailbox();
}

// PTP-VEC-67, PTP-PHY-15, PTP-ASCII-37, PTP-PARAM-12, PTP-OPEN-21
TEST(AsciiReceive, CharacterDelayEndsTheTelegram) {
  EXPECT_EQ(receive({}, {{0x41, 0}, {0x42, 2'000}, {0x43, 3'500}, {0x44, 5'000}}), "41 42 43; 44");
  EXPECT_EQ(receive({}, {{0x41, 0}, {0x42, 3'900}}), "41 42");
  EXPECT_EQ(receive({}, {{0x41, 0}, {0x42, 4'100}}), "41; 42");
}

// PTP-ASCII-11, PTP-ASCII-20, PTP-ERR-49, PTP-OVW-03
TEST(AsciiReceive, TransparentUpToItsLength) {
  AsciiCpu c;
  c.partner.send(counting(1024)).wait(20).send(counting(1025));
  c.lines.run(4'000);
  EXPECT_EQ(c.mailbox(), text(counting(1024)) + "; 0816");
  AsciiCpu count(byCount(1024));
  count.partner.send(counting(1024));
  count.lines.run(4'000);
  EXPECT_EQ(count.mailbox(), text(counting(1024)));
}

// PTP-ASCII-12, PTP-PARAM-14, PTP-ERR-37
TEST(AsciiReceive, FixedCountIsNotReached) {
  AsciiCpu c(byCount(4));
  c.partner.send("01 02 03").wait(20).send("11 12 13 14");
  c.lines.run(100);
  EXPECT_EQ(c.mailbox(), "0806; 11 12 13 14");
}

// PTP-VEC-66, PTP-ASCII-13, PTP-ASCII-14
TEST(AsciiReceive, FixedCountWithMoreOrLess) {
  AsciiCpu quiet(byCount(4)), merged(byCount(4)), less(byCount(4));
  quiet.partner.send("01 02 03 04 05 06");
  merged.partner.send("01 02 03 04 05 06").wait(2).send("07 08");
  less.partner.send("01 02 03").wait(2).send("04 05 06 07 08");
  for (AsciiCpu* c : {&quiet, &merged, &less}) c->lines.run(100);
  EXPECT_EQ(quiet.mailbox(), "01 02 03 04; 0806");
  EXPECT_EQ(merged.mailbox(), "01 02 03 04; 05 06 07 08");
  EXPECT_EQ(less.mailbox(), "01 02 03 04; 05 06 07 08");
}

// PTP-ASCII-15, PTP-ASCII-17, PTP-PARAM-17, PTP-PARAM-18
TEST(AsciiReceive, EndCharacter) {
  AsciiCpu c(byEnd(0x0D));
  c.partner.send("41 42 0D 43 0D").wait(20).send(counting(10));
  c.lines.run(100);
  EXPECT_EQ(c.mailbox(), "41 42 0D; 43 0D; 0806");
}

// PTP-ASCII-18
TEST(AsciiReceive, CharactersBehindTheEndCharacter) {
  AsciiCpu quiet(byEnd()), merged(byEnd());
  quiet.partner.send("41 03 42");
  merged.partner.send("41 03 42").wait(2).send("43 03");
  for (AsciiCpu* c : {&quiet, &merged}) c->lines.run(100);
  EXPECT_EQ(quiet.mailbox(), "41 03; 0806");
  EXPECT_EQ(merged.mailbox(), "41 03; 42 43 03");
}

// PTP-VEC-63, PTP-VEC-65, PTP-ASCII-16
TEST(AsciiReceive, TwoEndCharacters) {
  AsciiCpu c(byTwoEnds());
  c.partner.send("41 0D 42 0D 0A").wait(20).send("41 42 0D 0A").wait(20).send("0A 0D 0D 0A");
  c.lines.run(100);
  EXPECT_EQ(c.mailbox(), "41 0D 42 0D 0A; 41 42 0D 0A; 0A 0D 0D 0A");
}

// PTP-VEC-64, PTP-ASCII-10, PTP-ASCII-15, PTP-PARAM-17
TEST(AsciiReceive, BlockCheckCharactersAreStoredUnchecked) {
  AsciiParameters parameters = checked(byEnd(), 1);
  parameters.sending = AsciiParameters::Sending::Length;
  AsciiCpu c(parameters);
  c.send(hex("41 43 03 01"));
  c.partner.send("41 43 03 01 41 43 03 02");
  c.lines.run(100);
  EXPECT_EQ(c.sent(0), "41 43 03 01");
  EXPECT_EQ(c.mailbox(), "41 43 03 01; 41 43 03 02");
  AsciiCpu two(checked(byTwoEnds(), 2));
  two.partner.send("41 0D 0A 03 03").wait(20).send("41 0D 0A 03");
  two.lines.run(100);
  EXPECT_EQ(two.mailbox(), "41 0D 0A 03 03; 0806");
}

// PTP-ASCII-19
TEST(AsciiReceive, EndCharacterComesTooLate) {
  AsciiCpu c(byEnd());
  c.partner.send(Bytes(1100, 0x41)).send("03").wait(20).send("42 03");
  c.lines.run(4'000);
  EXPECT_EQ(c.mailbox(), "0816; 42 03");
}

// PTP-ASCII-21, PTP-ERR-45, PTP-ERR-46, PTP-ERR-42
TEST(AsciiReceive, FaultyCharacterSpoilsItsTelegram) {
  const std::pair<Fault::Kind, const char*> rows[] = {
      {Fault::Kind::Parity, "0810"}, {Fault::Kind::Stop, "0811"}, {Fault::Kind::Overrun, "080C"}};
  for (const auto& [kind, event] : rows) {
    for (const AsciiParameters& parameters : {AsciiParameters{}, byCount(5), byEnd(0x45)}) {
      AsciiCpu c(parameters);
      c.lines.line.port(1).pace(Duration::milliseconds(1));
      c.lines.line.port(1).disturb(2, {kind});
      c.partner.send("41 42 43 44 45").wait(20).send("46 47 48 49 45");
      c.lines.run(200);
      EXPECT_EQ(c.mailbox(), std::string(event) + "; 46 47 48 49 45");
    }
  }
}

// PTP-PHY-16
TEST(AsciiReceive, PartnerWithAnotherParity) {
  AsciiParameters parameters;
  Mailbox mail;
  Ascii cpu(parameters, mail);
  Script partner;
  Coupled lines(cpu, partner, {}, {.frame = {8, Parity::Odd, 1}});
  partner.send("41 42 43");
  lines.run(100);
  EXPECT_EQ(number(mail.take()->event), "0810");
}

// PTP-ASCII-22, SFB61-09
TEST(AsciiReceive, OldestTelegramFirst) {
  AsciiCpu c(byEnd());
  c.partner.send("41 03 42 03 43 03");
  c.lines.run(100);
  EXPECT_EQ(c.mailbox(), "41 03; 42 03; 43 03");
}

// PTP-ASCII-24, PTP-ERR-44, PTP-PARAM-03
TEST(AsciiReceive, FullBufferDiscardsTheNewTelegram) {
  AsciiCpu c(byCount(1024));
  c.partner.send(Bytes(1024, 0x41)).send(Bytes(1024, 0x42)).send(Bytes(1024, 0x43));
  c.lines.run(5'000);
  EXPECT_EQ(c.take(), "0B01");
  EXPECT_EQ(c.take(), "080E");
  EXPECT_EQ(c.take(), text(Bytes(1024, 0x41)));
  EXPECT_EQ(c.take(), text(Bytes(1024, 0x42)));
  EXPECT_EQ(c.take(), "none");
}

// PTP-ASCII-34, PTP-ERR-43
TEST(AsciiReceive, BreakOnTheLine) {
  AsciiCpu c;
  c.partner.send("41 42");
  c.lines.run(5);
  c.lines.line.cut(0, true, c.lines.now);
  c.lines.run(100);
  c.lines.line.cut(0, false, c.lines.now);
  c.partner.wait(1).send("43");
  c.lines.run(100);
  EXPECT_EQ(c.mailbox(), "080D; 43");
}

// PTP-PARAM-02, PTP-PARAM-03, PTP-PARAM-04, PTP-ERR-48
TEST(AsciiReceive, StopOfTheCpu) {
  for (const bool discards : {false, true}) {
    AsciiParameters parameters = byEnd();
    parameters.discardInStop = discards;
    AsciiCpu c(parameters);
    c.partner.send("41 03 42");
    c.lines.run(4);
    c.cpu.cpuStopped();
    c.partner.send("43 03").wait(20).send("44 03");
    c.lines.run(100);
    c.cpu.cpuStarted();
    c.partner.wait(1).send("45 03");
    c.lines.run(100);
    EXPECT_EQ(c.mailbox(), discards ? "0814; 41 03; 45 03" : "41 03; 42 43 03; 44 03; 45 03");
  }
}

}  // namespace
}  // namespace merker::serial
