// Sending with the ASCII driver, and its flow control.
#include "ascii_stations.h"

namespace merker::serial {
namespace {

using Sending = AsciiParameters::Sending;

AsciiParameters sending(Sending how, AsciiParameters parameters = byEnd()) {
  parameters.sending = how;
  return parameters;
}

// Time between the first two telegrams of two bytes on the line.
Duration gap(const AsciiCpu& c) { return c.lines.seen[2].start - c.lines.seen[1].end; }

void twoJobs(AsciiCpu& c) {
  for (unsigned i = 0; i < 2; ++i) {
    c.send(hex("41 42"));
    while (c.cpu.outbox().busy()) c.lines.run(1);
  }
}

// PTP-ASCII-01, PTP-ASCII-02, PTP-ASCII-03, PTP-ASCII-35, PTP-ASCII-36
TEST(AsciiSend, SendsTheBytesOfTheJobAndNothingElse) {
  AsciiCpu c;
  c.send(counting(256));
  c.lines.run(1'000);
  EXPECT_EQ(c.sent(0), text(counting(256)));
  EXPECT_EQ(c.end(), "0000");
}

// PTP-ASCII-02
TEST(AsciiSend, SevenDataBitsCutTheEighth) {
  AsciiCpu c({}, {.frame = {7, Parity::Even, 1}});
  c.send(hex("C1"));
  c.lines.run(100);
  ASSERT_EQ(c.partner.heard.size(), 1U);
  EXPECT_TRUE(c.partner.heard[0].is(0x41));
}

// PTP-ASCII-35
TEST(AsciiSend, IsDoneWithTheLastStopBit) {
  AsciiCpu c;
  c.send(hex("41 42"));
  while (c.cpu.outbox().busy()) {
    c.lines.now = c.lines.now + Duration{1'000};
    c.lines.poke();
  }
  EXPECT_LT((c.lines.now - c.lines.seen.back().end).ns, 1'000);
}

// PTP-ASCII-04, PTP-PARAM-15
TEST(AsciiSend, PauseWithTheCharacterDelay) {
  AsciiParameters parameters;
  parameters.delay = Duration::milliseconds(50);
  parameters.preparation = {};
  AsciiCpu c(parameters);
  twoJobs(c);
  EXPECT_GT(gap(c), Duration::milliseconds(50));
  EXPECT_LT(gap(c), Duration::milliseconds(51));
}

// PTP-ASCII-05, PTP-ASCII-09, PTP-PARAM-15
TEST(AsciiSend, PauseWithAFixedCountIfNotSwitchedOff) {
  for (const bool pause : {true, false}) {
    AsciiParameters parameters = byCount(8);
    parameters.delay = Duration::milliseconds(50);
    parameters.pause = pause;
    parameters.preparation = {};
    AsciiCpu c(parameters);
    twoJobs(c);
    EXPECT_EQ(gap(c) >= Duration::milliseconds(50), pause);
    EXPECT_EQ(c.sent(0), "41 42 41 42");
  }
  AsciiParameters ends = sending(Sending::Length);
  ends.preparation = {};
  ends.delay = Duration::milliseconds(50);
  AsciiCpu c(ends);
  twoJobs(c);
  EXPECT_LE(gap(c), Duration::milliseconds(1));
}

// PTP-VEC-61, PTP-ASCII-06, PTP-PARAM-19
TEST(AsciiSend, UpToTheEndCharacter) {
  AsciiCpu c(byEnd());
  c.send(hex("41 42 03 44 45"));
  c.lines.run(100);
  EXPECT_EQ(c.sent(0), "41 42 03");
  EXPECT_EQ(c.end(), "0000");
  AsciiCpu two(byTwoEnds());
  two.send(hex("41 0D 42 0D 0A 43"));
  two.lines.run(100);
  EXPECT_EQ(two.sent(0), "41 0D 42 0D 0A");
}

// PTP-VEC-62, PTP-ASCII-06, PTP-ERR-05
TEST(AsciiSend, EndCharacterIsMissing) {
  AsciiCpu c(byEnd());
  c.send(hex("41 42 43"));
  c.lines.run(100);
  EXPECT_EQ(c.sent(0), "");
  EXPECT_EQ(c.end(), "050E");
}

// PTP-ASCII-07, PTP-PARAM-19
TEST(AsciiSend, UpToTheLengthOfTheJob) {
  AsciiCpu c(sending(Sending::Length));
  c.send(hex("41 03 42 43"));
  c.lines.run(100);
  EXPECT_EQ(c.sent(0), "41 03 42 43");
}

// PTP-VEC-63, PTP-ASCII-08, PTP-PARAM-19
TEST(AsciiSend, AppendsTheEndCharacters) {
  AsciiCpu c(sending(Sending::Append, byTwoEnds()));
  c.send(hex("41 42"));
  c.lines.run(100);
  EXPECT_EQ(c.sent(0), "41 42 0D 0A");
  AsciiCpu one(sending(Sending::Append));
  one.send(Bytes(1023, 0x41));
  one.lines.run(2'000);
  EXPECT_EQ(one.end(), "0000");
  one.send(Bytes(1024, 0x41));
  one.lines.run(2'000);
  EXPECT_EQ(one.end(), "050E");
}

// PTP-VEC-68, PTP-ASCII-28, PTP-ASCII-32, PTP-ERR-29
TEST(AsciiSend, WaitsForXon) {
  AsciiCpu c(withFlow());
  c.cpu.start({});
  c.partner.expect("11 41 42").wait(1).send("13");
  c.send(hex("41 42 43 44 45 46"));
  c.lines.run(19'900);
  EXPECT_EQ(c.sent(0), "11 41 42 43 44");  // 44 was on its way
  EXPECT_EQ(c.end(), "none");
  c.lines.run(200);
  EXPECT_EQ(c.end(), "0708");
  c.partner.wait(1).send("11");
  c.lines.run(50);
  c.send(hex("47"));
  c.lines.run(50);
  EXPECT_EQ(c.end(), "0000");
}

// PTP-ASCII-32, PTP-PARAM-11
TEST(AsciiSend, GoesOnWithTheNextByteAfterXon) {
  AsciiParameters parameters = withFlow();
  parameters.xonWait = Duration::milliseconds(500);
  AsciiCpu c(parameters);
  c.partner.expect("41 42").wait(1).send("13").wait(490).send("11");
  c.send(hex("41 42 43 44 45 46"));
  c.lines.run(1'000);
  EXPECT_EQ(c.sent(0), "41 42 43 44 45 46");
  EXPECT_EQ(c.end(), "0000");
}

// PTP-ASCII-32
TEST(AsciiSend, JobThatBeginsWhileHeld) {
  AsciiCpu c(withFlow());
  c.partner.send("13");
  c.lines.run(30'000);
  c.send(hex("41"));
  c.lines.run(19'000);
  EXPECT_EQ(c.end(), "none");
  c.partner.wait(1).send("11");
  c.lines.run(10);
  EXPECT_EQ(c.end(), "0000");
}

// PTP-ASCII-33, PTP-ASCII-20, PTP-PARAM-10
TEST(AsciiSend, FlowCharactersAreNoData) {
  AsciiParameters parameters = withFlow();
  parameters.xon = 0x51;
  parameters.xoff = 0x52;
  AsciiCpu c(parameters), without;
  for (AsciiCpu* cpu : {&c, &without}) {
    cpu->partner.send("41 51 42 11 13");
    cpu->lines.run(100);
  }
  EXPECT_EQ(c.mailbox(), "41 42 11 13");
  EXPECT_EQ(without.mailbox(), "41 51 42 11 13");
}

// PTP-ASCII-29, PTP-ASCII-31, PTP-PARAM-05
TEST(AsciiSend, XoffFiftyCharactersBeforeTheEndOfTheBuffer) {
  AsciiCpu c(withFlow(byCount(100)));
  c.partner.send(Bytes(1998, 0x41));
  c.lines.run(2'300);
  EXPECT_EQ(c.sent(0), "13");
  const Sighting& xoff = *std::find_if(c.lines.seen.begin(), c.lines.seen.end(),
                                       [](const Sighting& s) { return s.port == 0; });
  EXPECT_EQ(xoff.start, c.partner.done() ? c.lines.seen[1997].end : Instant{});
  c.take();  // the warning
  c.take();
  c.take();
  EXPECT_EQ(c.sent(0), "13 11");
}

// PTP-ASCII-29, PTP-ASCII-31
TEST(AsciiSend, XoffAtTheNumberOfTelegrams) {
  AsciiCpu c(withFlow(byCount(2)), {}, {.wholeBuffer = false, .telegrams = 2});
  c.partner.send("41 42 43 44");
  c.lines.run(100);
  EXPECT_EQ(c.sent(0), "13");
  EXPECT_EQ(c.take(), "41 42");
  EXPECT_EQ(c.sent(0), "13 11");
}

// PTP-ASCII-30, PTP-ERR-47: what fills the buffer to its last byte is stored, one byte more is not
TEST(AsciiSend, TelegramThatEndsBehindTheBuffer) {
  for (const std::size_t rest : {45U, 46U, 1100U}) {
    AsciiCpu c(withFlow(byEnd()));
    for (const std::size_t size : {std::size_t{1000}, std::size_t{1000}, rest}) {
      Bytes telegram(size, 0x41);
      telegram.push_back(0x03);
      c.partner.send(telegram).wait(10);
    }
    c.lines.run(4'000);
    EXPECT_EQ(c.take(), "0B01");
    if (rest > 45) {
      EXPECT_EQ(c.take(), "0812");
    }
    EXPECT_EQ(c.take().size(), 1001 * 3 - 1U);
    EXPECT_EQ(c.take().size(), 1001 * 3 - 1U);
    EXPECT_EQ(c.take(), rest > 45 ? "none" : text(Bytes(45, 0x41)) + " 03");
    EXPECT_EQ(c.take(), "none");
  }
}

// PTP-ASCII-30, PTP-ERR-47
TEST(AsciiSend, PartnerThatIgnoresXoff) {
  AsciiCpu c(withFlow(byCount(512)));
  c.partner.send(Bytes(2048, 0x41)).send(Bytes(10, 0x42));
  c.lines.run(4'000);
  EXPECT_EQ(c.take(), "0B01");
  EXPECT_EQ(c.take(), "0812");
  for (unsigned i = 0; i < 4; ++i) EXPECT_EQ(c.take(), text(Bytes(512, 0x41)));
  EXPECT_EQ(c.take(), "none");
}

// SFB62-04
TEST(AsciiSend, ClearedBufferSendsXon) {
  AsciiCpu c(withFlow(byCount(1000)));
  c.partner.send(Bytes(2000, 0x41));
  c.lines.run(4'000);
  c.mail.clear();
  c.cpu.fetched();
  c.lines.run(10);
  EXPECT_EQ(c.sent(0), "13 11");
}

// PTP-PARAM-02, PTP-PARAM-06, PTP-ERR-03
TEST(AsciiSend, StopOfTheCpuAbortsTheJobAndHoldsThePartner) {
  AsciiParameters parameters = withFlow();
  parameters.discardInStop = true;
  AsciiCpu c(parameters);
  c.send(Bytes(100, 0x41));
  c.lines.run(50);
  c.cpu.cpuStopped();
  c.lines.run(50);
  EXPECT_EQ(c.end(), "0501");
  EXPECT_EQ(c.lines.seen.back().value, 0x13);
  EXPECT_LT(c.lines.seen.size(), 50U);
  c.cpu.cpuStarted();
  c.lines.run(50);
  EXPECT_EQ(c.lines.seen.back().value, 0x11);
}

// SFB60-11
TEST(AsciiSend, OverTwoWiresItWaitsForTheEndOfAReception) {
  AsciiParameters parameters;
  parameters.twoWire = true;
  AsciiCpu c(parameters, {.mode = Mode::TwoWire, .preset = Preset::Idle});
  c.partner.send(Bytes(50, 0x42));
  c.lines.run(20);
  c.send(hex("41"));
  c.lines.run(200);
  EXPECT_EQ(c.end(), "0000");
  EXPECT_EQ(c.mailbox(), text(Bytes(50, 0x42)));
  EXPECT_EQ(c.lines.seen.back().port, 0U);
  AsciiCpu four;
  four.partner.send(Bytes(50, 0x42));
  four.lines.run(20);
  four.send(hex("41"));
  four.lines.run(10);
  EXPECT_EQ(four.end(), "0000");
}

// PTP-ERR-10
TEST(AsciiSend, ResetEndsTheJob) {
  AsciiCpu c;
  c.send(Bytes(100, 0x41));
  c.lines.run(50);
  c.cpu.abort(Event::Reset);
  const std::size_t sent = c.lines.seen.size();
  c.lines.run(50);
  EXPECT_EQ(c.end(), "051D");
  EXPECT_EQ(c.lines.seen.size(), sent);
}

}  // namespace
}  // namespace merker::serial
