// The line: frames, exact times, wrong rates, polarity, open pairs, several senders.
#include <random>

#include "stations.h"

namespace merker::serial {
namespace {

constexpr Frame k8E1, k7O1{7, Parity::Odd, 1};

std::string bitsOf(const Frame& frame, std::uint8_t value) {
  std::string result;
  for (unsigned i = 0; i < frame.bits(); ++i)
    result += (encode(frame, value) >> i & 1U) ? '1' : '0';
  return result;
}

Settings with(std::uint32_t baud, Frame frame = {}) { return {.baud = baud, .frame = frame}; }

// A sends everything, B hears.
struct Hearing {
  explicit Hearing(const Settings& ofA = {}, const Settings& ofB = {})
      : lines(sender, partner, ofA, ofB) {}
  std::string heard() {
    Bytes bytes;
    faults = 0;
    for (const Character& c : partner.heard) {
      bytes.push_back(c.value);
      faults += c.good() ? 0U : 1U;
    }
    return text(bytes);
  }
  Script sender, partner;
  Coupled lines;
  unsigned faults = 0;
};

// PTP-VEC-69, PTP-PHY-11
TEST(SerialFrame, BitsInTheOrderOfTime) {
  EXPECT_EQ(bitsOf(k8E1, 0x41), "01000001001");
  EXPECT_EQ(bitsOf(k7O1, 0x43), "0110000101");
}

// PTP-ASCII-21, PTP-LINE-09: no character begins where a wrong stop bit ends
TEST(SerialLine, WrongLastStopBitIsOneFaultyCharacter) {
  constexpr Frame k8N1{8, Parity::None, 1}, k7E1{7, Parity::Even, 1}, k8E2{8, Parity::Even, 2};
  for (const std::uint32_t baud : {300U, 1200U, 2400U, 4800U, 9600U, 19200U, 38400U})
    for (const Frame& frame : {k8N1, k7E1, k7O1, k8E1, k8E2}) {
      Hearing h(with(baud, frame), with(baud, frame));
      h.lines.line.port(0).disturb(1, {Fault::Kind::Stop});
      h.sender.send("42 15").wait(300).send("43");
      h.lines.run(1'000);
      EXPECT_EQ(h.heard(), "42 15 43") << baud << ' ' << frame.bits();
      EXPECT_EQ(h.faults, 1U);
    }
}

// PTP-PHY-13
TEST(SerialFrame, LengthOfAllTenFrames) {
  struct Row {
    Frame frame;
    unsigned bits;
  };
  const Row rows[] = {{{7, Parity::Even, 1}, 10}, {{7, Parity::Odd, 1}, 10},
                      {{8, Parity::None, 1}, 10}, {{7, Parity::Even, 2}, 11},
                      {{7, Parity::Odd, 2}, 11},  {{8, Parity::Even, 1}, 11},
                      {{8, Parity::Odd, 1}, 11},  {{8, Parity::None, 2}, 11},
                      {{8, Parity::Even, 2}, 12}, {{8, Parity::Odd, 2}, 12}};
  for (const Row& row : rows) {
    EXPECT_EQ(row.frame.bits(), row.bits);
    EXPECT_EQ(characterTime(row.frame, 9600).ns, (row.bits * 1'000'000'000LL + 4800) / 9600);
    for (unsigned value = 0; value <= row.frame.mask(); ++value) {
      const Decoded d = decode(row.frame, encode(row.frame, static_cast<std::uint8_t>(value)));
      EXPECT_EQ(d.value, value);
      EXPECT_FALSE(d.parityFault || d.frameFault);
    }
  }
}

// PTP-PHY-14, PTP-LINE-02
TEST(SerialLine, CharactersTakeTheirTimeWithoutDrift) {
  for (const std::uint32_t baud : {300U, 600U, 1200U, 2400U, 4800U, 9600U, 19200U, 38400U}) {
    Hearing h(with(baud), with(baud));
    h.sender.send(Bytes(1000, 0x55));
    h.lines.run(40'000);
    ASSERT_EQ(h.partner.heard.size(), 1000U);
    const std::int64_t exact = (11'000 * 1'000'000'000LL + baud / 2) / baud;
    EXPECT_LE(std::abs(h.partner.heard.back().at.ns - exact), 1) << baud;
    EXPECT_TRUE(h.partner.heard.back().good());
  }
}

// Looked at between its bits, a line delivers the same at the same time.
TEST(SerialLine, HowOftenItIsLookedAtDoesNotMatter) {
  for (const std::uint32_t baud : {9600U, 9900U, 19200U}) {
    Hearing once(with(9600), with(baud)), often(with(9600), with(baud));
    for (Hearing* h : {&once, &often}) h->sender.send(counting(256));
    once.lines.run(300);
    often.lines.poke();
    for (std::int64_t ns = 0; ns <= 300'000'000; ns += 37'000) often.lines.line.advance({ns});
    const auto& a = once.partner.heard;
    const auto& b = often.partner.heard;
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i) {
      EXPECT_EQ(a[i].value, b[i].value);
      EXPECT_EQ(a[i].faults, b[i].faults);
      EXPECT_EQ(a[i].at, b[i].at);
    }
  }
}

// PTP-PHY-04
TEST(SerialLine, FourWiresCarryBothDirectionsAtOnce) {
  Hearing h;
  h.sender.send(counting(1000));
  h.partner.send(Bytes(1000, 0xA5));
  h.lines.run(2'000);
  EXPECT_EQ(h.heard(), text(counting(1000)));
  EXPECT_EQ(h.faults, 0U);
  EXPECT_EQ(h.sender.heard.size(), 1000U);
}

// PTP-PHY-16
TEST(SerialLine, DifferentSettingsGiveFaultyCharacters) {
  const Settings others[] = {with(19200), with(4800), with(9600, {8, Parity::Odd, 1}),
                             with(9600, {7, Parity::Even, 1})};
  for (const Settings& other : others) {
    Hearing h(with(9600), other);
    h.sender.send(counting(200));
    h.lines.run(1'000);
    h.heard();
    EXPECT_GT(h.faults, 20U);
  }
}

// PTP-PHY-16
TEST(SerialLine, SmallDifferenceOfRateIsNoFault) {
  Hearing h(with(9600), with(9800));
  h.sender.send(counting(200));
  h.lines.run(1'000);
  EXPECT_EQ(h.heard(), text(counting(200)));
  EXPECT_EQ(h.faults, 0U);
}

// PTP-PHY-17, PTP-DIAG-10, PTP-LINE-09
TEST(SerialLine, OpenPairIsABreakWithThePresetForIt) {
  Hearing h;
  h.lines.run(10);
  h.lines.line.cut(1, true, h.lines.now);
  h.lines.run(10);
  h.lines.line.cut(1, false, h.lines.now);
  h.lines.run(10);
  const auto& breaks = h.partner.breaks;
  ASSERT_EQ(breaks.size(), 2U);
  EXPECT_EQ(breaks[0], std::make_pair(true, Instant{10'000'000} + characterTime({}, 9600)));
  EXPECT_EQ(breaks[1], std::make_pair(false, Instant{20'000'000}));
  h.sender.send("41");
  h.lines.run(10);
  EXPECT_EQ(h.heard(), "41");
}

// PTP-PHY-17
TEST(SerialLine, OpenPairIsIdleWithTheOtherPreset) {
  Settings idle;
  idle.preset = Preset::Idle;
  Hearing h(idle, idle);
  h.lines.line.cut(1, true, h.lines.now);
  h.sender.send("41 42");
  h.lines.run(100);
  EXPECT_TRUE(h.partner.breaks.empty());
  EXPECT_TRUE(h.partner.heard.empty());
}

// PTP-DIAG-10
TEST(SerialLine, BreakIsLongerThanACharacter) {
  for (const unsigned bits : {11U, 22U}) {
    Hearing h;
    for (unsigned sent = 0; sent < bits; sent += 11)
      h.lines.line.noise(1, 0, 11, 9600, Instant{} + bitTime(sent, 9600));
    h.lines.run(10);
    EXPECT_EQ(h.partner.breaks.size(), bits == 22 ? 2U : 0U);
    ASSERT_EQ(h.partner.heard.size(), bits == 22 ? 0U : 1U);
    if (bits == 11) {
      EXPECT_EQ(h.partner.heard[0].faults, Character::kFrame);
    }
  }
}

// PTP-PHY-21
TEST(SerialLine, SwappedPolarityGivesNoGoodCharacter) {
  for (const Preset preset : {Preset::Break, Preset::Idle}) {
    Settings settings;
    settings.preset = preset;
    Hearing h(settings, settings);
    h.lines.line.swapPolarity(1, true, h.lines.now);
    h.lines.run(10);
    h.sender.send("41 42 43");
    h.lines.run(100);
    h.heard();
    EXPECT_EQ(h.faults, h.partner.heard.size());
    EXPECT_EQ(h.partner.breaks.empty(), preset == Preset::Idle);
  }
}

// PTP-LINE-01, PTP-LINE-09
TEST(SerialLine, EachFaultOfACharacter) {
  struct Row {
    Fault fault;
    const char* heard;
    std::uint8_t faults;  // of the second character
  };
  const Row rows[] = {{{Fault::Kind::Drop}, "41 43", 0},
                      {{Fault::Kind::Duplicate}, "41 42 42 43", 0},
                      {{Fault::Kind::Replace, 0x99}, "41 99 43", 0},
                      {{Fault::Kind::Insert, 0x99}, "41 99 42 43", 0},
                      {{Fault::Kind::Flip, 0x002}, "41 43 43", Character::kParity},
                      {{Fault::Kind::Parity}, "41 42 43", Character::kParity},
                      {{Fault::Kind::Stop}, "41 42 43", Character::kFrame},
                      {{Fault::Kind::Overrun}, "41 42 43", Character::kOverrun},
                      {{Fault::Kind::Delay, 0, Duration::milliseconds(7)}, "41 42 43", 0}};
  for (const Row& row : rows) {
    Hearing h;
    h.lines.line.port(0).pace(
        Duration::microseconds(row.fault.kind == Fault::Kind::Stop ? 500 : 0));
    h.lines.line.port(0).disturb(1, row.fault);
    h.sender.send("41 42 43");
    h.lines.run(100);
    EXPECT_EQ(h.heard(), row.heard);
    EXPECT_EQ(h.partner.heard[1].faults, row.faults);
    if (row.fault.kind == Fault::Kind::Delay) {
      EXPECT_LE(std::abs(h.partner.heard[1].at.ns - 7'000'000 - bitTime(22, 9600).ns), 2);
    }
  }
}

// PTP-PHY-05
TEST(SerialLine, TwoWiresWithoutEchoAndAnAnswerBehindTheChangeOver) {
  Settings settings{.mode = Mode::TwoWire, .preset = Preset::Idle};
  Script a, b;
  Coupled lines(a, b, settings, settings, true);
  b.expect("41 42").wait(1).send("43");
  a.send("41 42");
  lines.run(50);
  ASSERT_EQ(a.heard.size(), 1U);
  EXPECT_TRUE(a.heard[0].is(0x43));
  EXPECT_LE(std::abs(a.heard[0].at.ns - 1'000'000 - bitTime(33, 9600).ns), 2);
  EXPECT_EQ(b.heard.size(), 2U);
}

// PTP-PHY-06
TEST(SerialLine, TwoSendersAtOnceCorruptEachOther) {
  Settings settings{.mode = Mode::TwoWire, .preset = Preset::Idle};
  Script a, b, c;
  Line line(true);
  for (Script* station : {&a, &b, &c}) line.join(*station, settings);
  a.send("41 42 43");
  b.send("41 42 43");
  line.advance({});
  line.advance(Instant{50'000'000});
  EXPECT_FALSE(c.heard.empty());
  for (const Character& heard : c.heard) EXPECT_FALSE(heard.good());
}

// PTP-PHY-18, PTP-PHY-19, PTP-LINE-03
TEST(SerialLine, MasterReachesAllSlavesAndOneAnswers) {
  const Settings master{.mode = Mode::MultipointMaster, .preset = Preset::Idle};
  const Settings slave{.mode = Mode::MultipointSlave, .preset = Preset::Idle};
  Script stations[4];
  Line line;
  for (std::size_t i = 0; i < 4; ++i) line.join(stations[i], i == 0 ? master : slave);
  stations[2].expect("02 41").send("42");
  stations[0].send("02 41");
  line.advance({});
  line.advance(Instant{50'000'000});
  for (std::size_t i = 1; i < 4; ++i) EXPECT_EQ(stations[i].heard.size(), 2U);
  ASSERT_EQ(stations[0].heard.size(), 1U);
  EXPECT_TRUE(stations[0].heard[0].is(0x42));
}

// A start bit that is over before its middle is no character.
TEST(SerialLine, ShortDisturbanceIsNoCharacter) {
  Hearing h;
  h.lines.line.noise(1, 0, 1, 38400, Instant{1'000'000});
  h.lines.run(2);
  h.sender.send("41");
  h.lines.run(10);
  EXPECT_EQ(h.heard(), "41");
  EXPECT_EQ(h.faults, 0U);
}

TEST(SerialLine, IdleLineHasNoEvents) {
  Hearing h;
  h.sender.send("41 42");
  h.lines.run(10);
  EXPECT_EQ(h.lines.line.next(), Instant::never());
}

// The order of time is kept whatever is on the line, and it always ends.
TEST(SerialLine, RandomNoiseNeverStopsTime) {
  std::mt19937 random(7);
  for (unsigned round = 0; round < 40; ++round) {
    const Settings settings = {.preset = round % 2 ? Preset::Break : Preset::Idle};
    Hearing h(settings, with(round % 3 ? 9600 : 2400));
    Instant at;
    for (unsigned i = 0; i < 200; ++i) {
      at = at + Duration{static_cast<std::int64_t>(random() % 3'000'000)};
      h.lines.line.advance(at);
      h.lines.line.noise(1, static_cast<std::uint16_t>(random()),
                         static_cast<std::uint8_t>(1 + random() % 12), 300U << random() % 8, at);
    }
    h.lines.line.advance(at + Duration::seconds(1));
    Instant last{-1};
    for (const Character& c : h.partner.heard) {
      EXPECT_GT(c.at, last);
      last = c.at;
    }
    EXPECT_EQ(h.lines.line.next(), Instant::never());
  }
}

}  // namespace
}  // namespace merker::serial
