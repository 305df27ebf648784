// SEND_PTP, RCV_PTP and RES_RCVB call by call, with a partner (rows SFBG, SFB60 to SFB62 of the
// requirements, which need a program of a CPU to be shown as a whole).
#include "programs.h"

namespace merker::serial {
namespace {

class TwoPrograms {
 public:
  explicit TwoPrograms(Protocol protocol = Protocol::Procedure)
      : a(of(protocol)), b(of(protocol, false)), lines(a.interface, b.interface) {}
  void run(unsigned ms) {
    lines.run(ms);
    a.now = b.now = lines.now;
  }
  // A sends, with a call each millisecond.
  std::pair<std::string, unsigned> send() {
    return a.until(lines, [this](bool first) { return a.send(first); });
  }
  Program a, b;
  Coupled lines;
};

// SFBG-04, SFBG-13: DONE for one call; REQ that stays is one job.
TEST(CommunicationBlocks, LifeOfAJob) {
  TwoPrograms t;
  t.a.length = 5;
  t.a.blocks.bytes[10] = hex("41 42 43 44 45");
  const auto [shown, calls] = t.a.until(t.lines, [&](bool) { return t.a.send(true); });
  EXPECT_EQ(shown, "DONE 0000");
  EXPECT_GT(calls, 2U);
  for (unsigned i = 0; i < 200; ++i) {
    EXPECT_EQ(t.a.send(true), "-");
    t.run(1);
  }
  EXPECT_EQ(t.b.receive(true), "-");
  EXPECT_EQ(t.b.receive(true), "DONE 0000");
  EXPECT_EQ(t.b.received, 5);
  EXPECT_EQ(text(t.b.blocks.read({20, 0}, 6)), "41 42 43 44 45 00");
  EXPECT_EQ(t.b.receive(true), "-");
  EXPECT_EQ(t.b.received, 5);
}

// SFBG-13, SFBG-17, SFB60-08, ERR-05: errors of parameters one call later.
TEST(CommunicationBlocks, WrongParameters) {
  for (const std::int32_t length : {0, -1, 1'025}) {
    Program p;
    p.length = length;
    EXPECT_EQ(p.send(true), "-");
    EXPECT_EQ(p.send(true), "ERROR 050E");
    EXPECT_EQ(p.send(true), "-");
  }
  Program p;
  p.permitted = false;
  EXPECT_EQ(joined({p.send(true), p.send(false)}), "-ERROR 0502");
  EXPECT_EQ(joined({p.clear(true), p.clear(false)}), "-ERROR 0502");
  EXPECT_EQ(joined({p.receive(true), p.receive(false)}), "-ERROR 0502");
}

// SFBG-22, ERR-01, ERR-02
TEST(CommunicationBlocks, AreasOfTheProgram) {
  const std::tuple<std::uint32_t, std::uint32_t, const char*> rows[] = {{11, 0, "ERROR 0301"},
                                                                        {10, 8'191, "ERROR 0301"},
                                                                        {12, 8'190, "-"},
                                                                        {10, 1'999, "ERROR 0303"}};
  for (const auto& [block, offset, answer] : rows) {
    Program p;
    p.blocks.bytes[12].resize(9'000);
    p.source = {block, offset};
    p.length = 2;
    p.send(true);
    EXPECT_EQ(p.send(true), answer);
  }
}

// SFB60-09: a portion of 206 bytes in each call.
TEST(CommunicationBlocks, SendingCopiesInPortions) {
  TwoPrograms t;
  t.a.length = 400;
  t.a.blocks.bytes[10] = Bytes(400, 1);
  t.a.now = t.lines.now;
  t.a.send(true);
  t.a.blocks.bytes[10] = Bytes(400, 2);
  t.lines.run(100);
  EXPECT_TRUE(t.lines.seen.empty());
  t.a.now = t.lines.now;
  t.a.send(true);
  while (t.a.send(true) == "-") t.run(1);
  Bytes expected(206, 1);
  expected.resize(400, 2);
  t.b.receive(true);
  EXPECT_EQ(text(t.b.blocks.read({20, 0}, 206)), text(Bytes(206, 1)));
  EXPECT_EQ(t.b.blocks.bytes[20][206], 0);
  EXPECT_EQ(t.b.receive(true), "-");
  EXPECT_EQ(t.b.receive(true), "DONE 0000");
  EXPECT_EQ(t.b.blocks.read({20, 0}, 400), expected);
}

// SFBG-15, ERR-11, OPEN-09
TEST(CommunicationBlocks, SecondRequestWhileAJobRuns) {
  TwoPrograms t;
  t.a.length = 200;
  t.a.send(true);
  t.run(50);
  t.a.send(false);
  EXPECT_EQ(t.a.send(true), "-");
  EXPECT_EQ(t.a.send(true), "ERROR 0522");
  const auto [shown, calls] = t.a.until(t.lines, [&](bool) { return t.a.send(true); });
  EXPECT_EQ(shown, "DONE 0000");
  EXPECT_EQ(t.b.interface.take()->telegram.size(), 200U);
}

// SFBG-01: two instances are one block.
TEST(CommunicationBlocks, SecondInstance) {
  TwoPrograms t;
  t.a.send(true);
  t.a.instance = 61;
  EXPECT_EQ(t.a.send(true), "-");
  EXPECT_EQ(t.a.send(true), "ERROR 0522");
}

// SFBG-16, ERR-10, OPEN-06, OPEN-07
TEST(CommunicationBlocks, Reset) {
  TwoPrograms t;
  t.a.length = 200;
  t.a.send(true);
  t.run(50);
  EXPECT_EQ(t.a.send(true, true), "-");
  EXPECT_EQ(t.a.send(true, true), "-");
  EXPECT_EQ(t.a.send(true, true), "ERROR 051D");
  EXPECT_EQ(t.a.send(false, true), "-");
  EXPECT_EQ(t.a.send(true, true), "-");  // blocked
  t.run(1'000);
  EXPECT_EQ(t.a.send(true, true), "-");
  Program idle;
  EXPECT_EQ(joined({idle.send(false, true), idle.send(false), idle.send(false)}), "--DONE 0000");
  EXPECT_EQ(joined({idle.receive(false, true), idle.receive(false), idle.receive(false)}),
            "--DONE 0000");
  EXPECT_EQ(idle.received, 0);
  EXPECT_EQ(joined({idle.clear(false, true), idle.clear(false), idle.clear(false)}), "--DONE 0000");
}

// SFBG-18: an edge of the first call is kept, and there are three calls before it is done.
TEST(CommunicationBlocks, StartUp) {
  Program p;
  p.clearer.start();
  EXPECT_EQ(joined({p.clear(true), p.clear(true), p.clear(true), p.clear(true)}), "---DONE 0000");
}

// SFBG-14, SFBG-19, ERR-03, OPEN-10
TEST(CommunicationBlocks, StopOfTheCpuAbortsTheJob) {
  for (const std::int32_t length : {200, 800}) {  // 800: still being copied
    TwoPrograms t;
    t.a.length = length;
    t.a.send(true);
    if (length == 200) t.run(50);
    t.a.interface.cpuStopped();
    t.run(100);
    t.a.interface.cpuStarted();
    t.a.sender.start();
    const auto [shown, calls] = t.a.until(t.lines, [&](bool) { return t.a.send(true); });
    EXPECT_EQ(shown, "ERROR 0501");
    EXPECT_GE(calls, 3U);
    EXPECT_EQ(t.a.until(t.lines, [&](bool) { return t.a.send(true); }).first, "DONE 0000");
  }
}

// SFB60-10
TEST(CommunicationBlocks, DoneOfEachProtocol) {
  Script silent;
  for (const Protocol protocol : {Protocol::Ascii, Protocol::Procedure}) {
    Program p(of(protocol));
    Coupled lines(p.interface, silent);
    const auto shown = p.until(
                            lines, [&](bool first) { return p.send(first); }, 20'000)
                           .first;
    EXPECT_EQ(shown, protocol == Protocol::Ascii ? "DONE 0000" : "ERROR 0703");
  }
}

// ERR-22, ERR-34, SFBG-09, OPEN-08: repetitions are warnings.
TEST(CommunicationBlocks, Warnings) {
  TwoPrograms t;
  t.lines.line.port(0).disturb(1, {Fault::Kind::Flip, 0x006});
  EXPECT_EQ(t.send().first, "0701");
  EXPECT_EQ(t.a.until(t.lines, [&](bool) { return t.a.send(false); }).first, "DONE 0000");
  EXPECT_EQ(joined({t.b.receive(true), t.b.receive(true)}), "-0801");
  EXPECT_EQ(joined({t.b.receive(true), t.b.receive(true)}), "-DONE 0000");
}

// SFB61-01, OPEN-20: EN_R switches only the hand-over.
TEST(CommunicationBlocks, EnableOfReceiving) {
  TwoPrograms t;
  t.a.length = 400;
  t.send();
  EXPECT_EQ(t.b.receive(false), "-");
  EXPECT_EQ(t.b.receive(true), "-");
  EXPECT_EQ(t.b.receive(false), "-");
  EXPECT_EQ(t.b.receive(false), "ERROR 051D");
  EXPECT_EQ(t.b.received, 0);
}

// SFB61-09, SFB61-10, SFB61-11
TEST(CommunicationBlocks, TelegramsAndErrorsInTheirOrder) {
  TwoPrograms t(Protocol::Ascii);
  t.a.length = 20;
  t.send();
  t.run(10);
  t.lines.line.port(0).disturb(25, {Fault::Kind::Parity});
  t.send();
  t.run(10);
  t.a.length = 30;
  t.send();
  t.run(10);
  std::string all;
  for (unsigned i = 0; i < 6; ++i) all += t.b.receive(true) + " ";
  EXPECT_EQ(all, "- DONE 0000 - ERROR 0810 - DONE 0000 ");
  EXPECT_EQ(t.b.received, 30);
  t.b.blocks.bytes[20].resize(10);
  t.send();
  t.run(10);
  EXPECT_EQ(joined({t.b.receive(true), t.b.receive(true)}), "-ERROR 0303");
  EXPECT_FALSE(t.b.interface.take());
}

// SFB62-02: what is arriving stays.
TEST(CommunicationBlocks, ClearsTheBuffer) {
  TwoPrograms t;
  for (unsigned i = 0; i < 3; ++i) {
    t.send();
    t.a.send(false);
  }
  t.a.length = 100;
  t.a.now = t.lines.now;
  t.a.send(true);
  t.run(60);
  EXPECT_EQ(t.b.clear(true), "-");
  EXPECT_EQ(t.b.clear(true), "DONE 0000");
  t.run(200);
  EXPECT_EQ(t.b.interface.take()->telegram.size(), 100U);
  EXPECT_FALSE(t.b.interface.take());
}

// DIAG-01: only where it is enabled, coming and going.
TEST(CommunicationBlocks, WireBreak) {
  for (const bool enabled : {false, true}) {
    Parameters parameters;
    parameters.diagnosticInterrupt = enabled;
    Program p(parameters);
    Script partner;
    Coupled lines(p.interface, partner);
    lines.line.cut(0, true, lines.now);
    lines.run(10);
    EXPECT_EQ(p.interface.takeWireBreak().has_value(), enabled);
    EXPECT_FALSE(p.interface.takeWireBreak());
    lines.line.cut(0, false, lines.now);
    lines.run(10);
    EXPECT_EQ(p.interface.takeWireBreak(), enabled ? std::optional(false) : std::nullopt);
  }
}

// PARAM-20: the parameters reach the driver.
TEST(CommunicationBlocks, ParametersOfTheSubmodule) {
  Parameters parameters = of(Protocol::Procedure);
  parameters.mailbox.clearAtStart = true;
  parameters.discardInStop = true;
  Program p(parameters);
  Script partner;
  Coupled lines(p.interface, partner);
  partner.send("02").expect("10").send("41 10 03 52").expect("10");
  lines.run(100);
  p.interface.cpuStopped();
  partner.send("02").expect("15");
  lines.run(500);
  EXPECT_TRUE(partner.done());
  p.interface.cpuStarted();
  EXPECT_EQ(number(p.interface.take()->event), "080A");
  EXPECT_FALSE(p.interface.take());
}

}  // namespace
}  // namespace merker::serial
