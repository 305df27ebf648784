// The sub-module in operation with the partner at the other end of its line.
#include "serial/coupling.h"
#include "serial/decoder.h"
#include "stations.h"

namespace merker::serial {
namespace {

constexpr Instant instant(std::int64_t ms) { return Instant{} + Duration::milliseconds(ms); }

Bytes all(Partner& partner) { return partner.takeAll(); }

Parameters procedure() {
  Parameters p = defaults(Protocol::Procedure);
  p.procedure.preparation = {};
  return p;
}

TEST(SerialPartner, CharactersGoBothWays) {
  Coupling coupling(defaults(Protocol::Ascii));
  ASSERT_TRUE(coupling.partner().send(hex("414243"), instant(10)));
  coupling.advance(instant(10));
  coupling.advance(instant(100));
  const auto entry = coupling.interface().take();
  ASSERT_TRUE(entry);
  EXPECT_EQ(text(entry->telegram), "41 42 43");
  coupling.interface().send(hex("0102"), instant(100));
  coupling.advance(instant(200));
  EXPECT_TRUE(coupling.partner().take(hex("01")));
  EXPECT_FALSE(coupling.partner().take(hex("03")));
  EXPECT_TRUE(coupling.partner().take(hex("02")));
  EXPECT_TRUE(coupling.partner().take({}));
}

TEST(SerialPartner, AnswersWhatEndsSo) {
  Coupling coupling(procedure());
  coupling.advance(instant(10));
  EXPECT_EQ(text(all(coupling.partner())), "15");
  coupling.partner().answer({hex("02"), hex("10"), Duration::milliseconds(3)});
  coupling.partner().answer({hex("4110 03 52"), hex("10"), {}});
  coupling.interface().send(hex("41"), instant(10));
  coupling.advance(instant(100));
  EXPECT_EQ(text(all(coupling.partner())), "02 41 10 03 52");
  EXPECT_EQ(number(coupling.interface().outbox().takeEnd()), "0000");
}

TEST(SerialPartner, SpeaksAProtocolOfItsOwn) {
  Coupling coupling(procedure());
  ProcedureParameters other = procedure().procedure;
  other.highPriority = false;
  coupling.partner().speak(Partner::Speaks::Procedure, other, instant(0));
  coupling.partner().answer({hex("5A"), hex("5B 10"), {}});
  coupling.interface().send(hex("5A 01"), instant(100));
  coupling.advance(instant(500));
  EXPECT_TRUE(coupling.partner().take(hex("5A 01")));
  const auto entry = coupling.interface().take();
  ASSERT_TRUE(entry);
  EXPECT_EQ(text(entry->telegram), "5B 10");
  EXPECT_EQ(number(coupling.partner().ended()), "0000");
}

TEST(SerialPartner, ServesAndFetchesOverRk512) {
  Parameters p = defaults(Protocol::ComputerLink);
  Coupling coupling(p);
  ProcedureParameters other = p.procedure;
  other.highPriority = false;
  coupling.partner().speak(Partner::Speaks::ComputerLink, other, instant(0));
  coupling.partner().memory().set('D', 10, 0, hex("01020304"));
  const LinkJob job{.fetch = true, .block = 10, .length = 4};
  coupling.interface().link()->begin(job, instant(100));
  coupling.advance(instant(1'000));
  const auto fetched = coupling.interface().link()->takeFetched(instant(1'000));
  ASSERT_TRUE(fetched);
  EXPECT_EQ(text(*fetched), "01 02 03 04");
}

// A hostile sender fills no memory.
TEST(SerialPartner, KeepsNoMoreThanSoMuch) {
  Coupling coupling(defaults(Protocol::Ascii));
  EXPECT_TRUE(coupling.partner().send(Bytes(Partner::kMost, 1), instant(0)));
  EXPECT_FALSE(coupling.partner().send(hex("01"), instant(0)));
  EXPECT_EQ(coupling.partner().room(), 0U);
  for (std::int64_t i = 1; i <= 200; ++i) {
    if (coupling.interface().outbox().free())
      coupling.interface().send(Bytes(1024, 2), instant(i * 1'200));
    coupling.advance(instant(i * 1'200));
    coupling.interface().outbox().takeEnd();
  }
  EXPECT_LE(coupling.partner().received().size(), Partner::kMost);
  EXPECT_LE(coupling.sightings().size(), Coupling::kMostSightings);
  EXPECT_GT(coupling.seen(), coupling.sightings().size());
}

// An idle line costs nothing: nobody has to be called.
TEST(SerialCoupling, AnIdleLineHasNoEvents) {
  Parameters p = defaults(Protocol::Ascii);
  EXPECT_EQ(Coupling(p).next(), Instant::never());
  p.diagnosticInterrupt = true;
  EXPECT_EQ(Coupling(p).next(), Instant::never());
}

TEST(SerialCoupling, ABreakIsToldOnceComingAndGoing) {
  Parameters p = defaults(Protocol::Ascii);
  p.diagnosticInterrupt = true;
  Coupling coupling(p);
  coupling.cut(Coupling::End::Cpu, true, instant(10));
  ASSERT_NE(coupling.next(), Instant::never());
  coupling.advance(instant(20));
  EXPECT_EQ(coupling.takeWireBreak(), true);
  EXPECT_EQ(coupling.takeWireBreak(), std::nullopt);
  coupling.cut(Coupling::End::Cpu, false, instant(30));
  coupling.advance(instant(40));
  EXPECT_EQ(coupling.takeWireBreak(), false);
}

TEST(SerialCoupling, WithoutSupplyNothingIsSentAndTheBufferIsLost) {
  Coupling coupling(procedure());
  coupling.advance(instant(10));
  all(coupling.partner());
  coupling.supply(false, instant(10));
  coupling.partner().send(hex("02"), instant(20));
  coupling.advance(instant(1'000));
  EXPECT_EQ(text(all(coupling.partner())), "");
  coupling.supply(true, instant(1'000));
  coupling.advance(instant(1'100));
  EXPECT_EQ(text(all(coupling.partner())), "15");  // the driver starts anew
}

// A BREAK that a missing supply was ends with it, at the other end too.
TEST(SerialCoupling, PartnerSendsAgainWhenTheSupplyIsBack) {
  Coupling coupling(procedure());
  ProcedureParameters other = procedure().procedure;
  other.highPriority = false;
  coupling.partner().speak(Partner::Speaks::Procedure, other, instant(0));
  coupling.supply(false, instant(100));
  coupling.supply(true, instant(300));
  coupling.partner().send(hex("41"), instant(500));
  coupling.advance(instant(1'000));
  EXPECT_EQ(number(coupling.partner().ended()), "0000");
  ASSERT_TRUE(coupling.interface().take());
}

// PTP-P3964-26: at once, also while nothing is being sent: the CPU does not hear its STX
TEST(SerialPartner, BreakEndsItsTelegram) {
  Coupling coupling(procedure());
  coupling.partner().speak(Partner::Speaks::Procedure, procedure().procedure, instant(0));
  coupling.cut(Coupling::End::Cpu, true, instant(50));
  coupling.partner().send(hex("41"), instant(50));
  coupling.cut(Coupling::End::Partner, true, instant(100));
  coupling.advance(instant(110));
  EXPECT_EQ(number(coupling.partner().ended()), "080D");
}

// PTP-LINE-11
TEST(SerialDecoder, NamesWhatABlockIsMadeOf) {
  Decoder decoder(Protocol::ComputerLink, true);
  std::string said;
  const auto see = [&](std::size_t port, std::string_view bytes) {
    for (const std::uint8_t byte : hex(bytes)) {
      const std::string meaning = decoder.meaning({.port = port, .value = byte});
      if (!meaning.empty()) said += meaning + "\n";
    }
  };
  see(0, "02");
  see(1, "10");
  see(0, "0000414410100000FF1F10031A");
  EXPECT_NE(said.find("wants to send\nconnection is there\nDLE of the data, doubled"),
            std::string::npos)
      << said;
  EXPECT_NE(said.find("BCC wrong"), std::string::npos) << said;
  said.clear();
  see(1, "15");
  see(0, "02");
  see(1, "10");
  see(0, "000041440A000002FF1F010203041003FA");
  see(1, "10");
  see(1, "02");
  see(0, "10");
  see(1, "00000012100301");
  EXPECT_EQ(said,
            "block refused\nwants to send\nconnection is there\nend of the block\n"
            "BCC right; SEND DB 10, byte 0, 4 bytes\nblock acknowledged\nwants to send\n"
            "connection is there\nend of the block\nBCC right; reaction, error 12H\n");
  EXPECT_EQ(characterName(0x10), "DLE");
  EXPECT_EQ(characterName('A'), "'A'");
}

// What a decoder says of "A 02 10", "B 15", separated by " | "; "." where a name says it all.
class Saying {
 public:
  void see(std::size_t port, std::string_view bytes, std::uint8_t faults = 0) {
    for (const std::uint8_t byte : hex(bytes))
      add(decoder_.meaning({.port = port, .value = byte, .faults = faults}));
  }
  void see(Sighting::Kind kind) { add(decoder_.meaning({.port = 1, .kind = kind})); }
  std::string said() { return std::exchange(said_, {}); }

 private:
  void add(const std::string& meaning) {
    said_ += (said_.empty() ? "" : " | ") + (meaning.empty() ? "." : meaning);
  }
  Decoder decoder_{Protocol::Procedure, true};
  std::string said_;
};

// PTP-LINE-11, PTP-P3964-13: both call; the one of low priority receives first.
TEST(SerialDecoder, AConflictAndWhoGivesWay) {
  Saying line;
  line.see(0, "02");
  line.see(1, "02");
  line.see(0, "10");
  line.see(1, "44100357");
  line.see(0, "10 02");
  EXPECT_EQ(line.said(),
            "wants to send | initialisation conflict | gives way; connection is there | . | . | "
            "end of the block | BCC right; 1 byte | block acknowledged | wants to send");
  line.see(1, "10");
  line.see(0, "4142");
  EXPECT_EQ(line.said(), "connection is there | . | .");
}

// PTP-LINE-11: NAK behind the last attempt, however that one failed; NAK of a receiver.
TEST(SerialDecoder, WhatANakIs) {
  Saying line;
  line.see(0, "15 02 15");
  EXPECT_EQ(line.said(), "ready | wants to send | breaks off");
  line.see(0, "02");
  line.see(1, "15");
  line.see(0, "15");
  EXPECT_EQ(line.said(), "wants to send | refused | breaks off");
  line.see(1, "41");
  line.see(0, "15");
  line.see(0, "15");
  EXPECT_EQ(line.said(), "unexpected | refused | ready");
}

// PTP-LINE-11, PTP-LINE-09
TEST(SerialDecoder, FaultyCharactersAndBreaks) {
  Saying line;
  line.see(0, "02");
  line.see(1, "10");
  line.see(0, "41", Character::kParity | Character::kFrame);
  line.see(0, "100352");
  line.see(1, "15");
  EXPECT_EQ(line.said(),
            "wants to send | connection is there | parity fault; frame fault | . | end of the "
            "block | BCC right; 1 byte, faulty characters among them | block refused");
  line.see(0, "02");
  line.see(Sighting::Kind::Interrupted);
  line.see(Sighting::Kind::Restored);
  line.see(1, "02");
  line.see(0, "10");
  EXPECT_EQ(line.said(),
            "wants to send | BREAK begins | BREAK ends | wants to send | connection is there");
}

// PTP-LINE-01, PTP-LINE-11
TEST(SerialCoupling, SeesFaultsAndBreaks) {
  Coupling coupling(defaults(Protocol::Ascii));
  coupling.disturb(Coupling::End::Partner, 1, {.kind = Fault::Kind::Parity});
  coupling.partner().send(hex("4142"), instant(10));
  coupling.advance(instant(10));
  coupling.advance(instant(100));
  coupling.cut(Coupling::End::Cpu, true, instant(100));
  coupling.advance(instant(200));
  coupling.cut(Coupling::End::Cpu, false, instant(200));
  coupling.advance(instant(300));
  std::string seen;
  for (const Sighting& one : coupling.sightings())
    seen += fmt::format("{} {} {}\n", one.port, nameOf(one), faultsOf(one));
  EXPECT_EQ(seen, "1 'A' \n1 'B' parity fault\n1 BREAK BREAK\n1 BREAK BREAK\n");
}

TEST(SerialPartner, HasOneJobAtATime) {
  Parameters parameters = defaults(Protocol::ComputerLink);
  Coupling coupling(parameters);
  ProcedureParameters other = parameters.procedure;
  other.highPriority = false;
  coupling.partner().speak(Partner::Speaks::ComputerLink, other, instant(0));
  const LinkJob job{.fetch = true, .type = 'D', .block = 10, .length = 2};
  EXPECT_TRUE(coupling.partner().begin(job, {}, instant(10)));
  EXPECT_FALSE(coupling.partner().begin(job, {}, instant(10)));
  coupling.partner().speak(Partner::Speaks::Characters, other, instant(20));
  EXPECT_FALSE(coupling.partner().begin(job, {}, instant(20)));
}

}  // namespace
}  // namespace merker::serial
