// What can be set for the sub-module, and what is refused (technology manual 6.3; rows PARAM of the
// requirements, which need the hardware configuration to be shown as a whole).
#include "serial/parameters.h"

#include <gtest/gtest.h>

namespace merker::serial {
namespace {

constexpr Protocol kAll[] = {Protocol::Ascii, Protocol::Procedure, Protocol::ComputerLink};
constexpr std::uint32_t kRates[] = {300, 600, 1200, 2400, 4800, 9600, 19200, 38400};

std::string refused(const Parameters& parameters) {
  std::string result;
  for (const Refusal& refusal : check(parameters))
    result += (result.empty() ? "" : "; ") + refusal.text;
  return result;
}

template <typename Change>
std::string refusedWith(Protocol protocol, const Change& change) {
  Parameters parameters = defaults(protocol);
  change(parameters);
  return refused(parameters);
}

TEST(SerialParameters, DefaultsAreThoseOfTheManual) {
  for (const Protocol protocol : kAll) EXPECT_EQ(refused(defaults(protocol)), "");
  const Parameters p;
  EXPECT_FALSE(p.diagnosticInterrupt);
  EXPECT_FALSE(p.discardInStop);
  EXPECT_EQ(p.line.baud, 9600U);
  EXPECT_EQ(p.line.frame, (Frame{8, Parity::Even, 1}));
  EXPECT_EQ(p.line.mode, Mode::PointToPoint);
  EXPECT_EQ(p.line.preset, Preset::Break);
  EXPECT_EQ(p.ascii.end, AsciiParameters::End::Delay);
  EXPECT_EQ(p.ascii.delay, Duration::milliseconds(4));
  EXPECT_EQ(p.ascii.length, 1024);
  EXPECT_TRUE(p.ascii.pause);
  EXPECT_EQ(p.ascii.endCharacters, 1);
  EXPECT_EQ(p.ascii.end1, 0x03);
  EXPECT_EQ(p.ascii.end2, 0);
  EXPECT_EQ(p.ascii.sending, AsciiParameters::Sending::UpToEnd);
  EXPECT_FALSE(p.ascii.flowControl);
  EXPECT_EQ(p.ascii.xon, 0x11);
  EXPECT_EQ(p.ascii.xoff, 0x13);
  EXPECT_EQ(p.ascii.xonWait, Duration::seconds(20));
  EXPECT_TRUE(p.procedure.highPriority);
  EXPECT_TRUE(p.procedure.blockCheck);
  EXPECT_EQ(p.procedure.characterDelay, Duration::milliseconds(220));
  EXPECT_EQ(p.procedure.acknowledgeDelay, Duration::milliseconds(2'000));
  EXPECT_EQ(defaultAcknowledgeDelay(true), Duration::milliseconds(2'000));
  EXPECT_EQ(defaultAcknowledgeDelay(false), Duration::milliseconds(550));
  EXPECT_EQ(p.procedure.setups, 6);
  EXPECT_EQ(p.procedure.transmissions, 6);
  EXPECT_TRUE(p.mailbox.preventOverwriting);
  EXPECT_TRUE(p.mailbox.wholeBuffer);
  EXPECT_EQ(p.mailbox.telegrams, 10);
  EXPECT_FALSE(p.mailbox.clearAtStart);
  EXPECT_EQ(defaultPreset(Mode::PointToPoint), Preset::Break);
  EXPECT_EQ(defaultPreset(Mode::MultipointMaster), Preset::Idle);
  EXPECT_EQ(defaultPreset(Mode::TwoWire), Preset::Idle);
}

TEST(SerialParameters, ShortestTimesOfEachRate) {
  const std::int64_t ascii[] = {130, 65, 32, 16, 8, 4, 2, 1};
  const std::int64_t procedure[] = {60, 40, 30, 20, 20, 20, 20, 20};
  for (std::size_t i = 0; i < 8; ++i) {
    for (const Protocol protocol : kAll) {
      const std::int64_t least = protocol == Protocol::Ascii ? ascii[i] : procedure[i];
      const std::int64_t step = protocol == Protocol::Ascii ? 1 : 10;
      EXPECT_EQ(leastCharacterDelay(protocol, kRates[i]), Duration::milliseconds(least));
      for (const std::int64_t below : {std::int64_t{0}, step}) {
        const auto change = [&](Parameters& p) {
          p.line.baud = kRates[i];
          p.ascii.delay = p.procedure.characterDelay = Duration::milliseconds(least - below);
          p.procedure.acknowledgeDelay = Duration::milliseconds(2'000);
        };
        EXPECT_EQ(refusedWith(protocol, change).empty(), below == 0) << kRates[i];
      }
    }
  }
}

TEST(SerialParameters, TimesOnTheGridAndWithinTheirLimits) {
  const auto delay = [](std::int64_t us) {
    return [us](Parameters& p) {
      p.ascii.delay = p.procedure.acknowledgeDelay = Duration::microseconds(us);
    };
  };
  EXPECT_EQ(refusedWith(Protocol::Ascii, delay(65'535'000)), "");
  EXPECT_EQ(refusedWith(Protocol::Ascii, delay(65'536'000)),
            "character delay time must be 4 to 65535 ms in steps of 1 ms at 9600 baud");
  EXPECT_NE(refusedWith(Protocol::Ascii, delay(4'500)), "");
  EXPECT_EQ(refusedWith(Protocol::Procedure, delay(65'530'000)), "");
  EXPECT_EQ(refusedWith(Protocol::Procedure, delay(225'000)),
            "acknowledgement delay time must be 20 to 65530 ms in steps of 10 ms at 9600 baud");
  EXPECT_NE(refusedWith(Protocol::ComputerLink, delay(65'540'000)), "");
}

TEST(SerialParameters, NextTimeThatCanBeSet) {
  const auto ms = [](std::int64_t value) { return Duration::milliseconds(value); };
  EXPECT_EQ(settable(Protocol::Procedure, 9600, ms(225)), ms(230));
  EXPECT_EQ(settable(Protocol::Procedure, 9600, ms(230)), ms(230));
  EXPECT_EQ(settable(Protocol::Procedure, 300, ms(20)), ms(60));
  EXPECT_EQ(settable(Protocol::Ascii, 300, ms(4)), ms(130));
  EXPECT_EQ(settable(Protocol::Ascii, 9600, Duration::microseconds(4'100)), ms(5));
  EXPECT_EQ(settable(Protocol::Procedure, 9600, ms(70'000)), ms(65'530));
}

TEST(SerialParameters, Frames) {
  for (const Parity parity : {Parity::None, Parity::Odd, Parity::Even}) {
    for (const std::uint8_t bits : {std::uint8_t{7}, std::uint8_t{8}}) {
      const auto change = [&](Parameters& p) { p.line.frame = {bits, parity, 2}; };
      EXPECT_EQ(refusedWith(Protocol::Ascii, change),
                bits == 7 && parity == Parity::None ? "7 data bits need a parity" : "");
    }
  }
  const auto seven = [](Parameters& p) { p.line.frame.dataBits = 7; };
  EXPECT_EQ(refusedWith(Protocol::Procedure, seven), "");
  EXPECT_EQ(refusedWith(Protocol::ComputerLink, seven), "RK 512 has 8 data bits");
  EXPECT_NE(refusedWith(Protocol::Ascii, [](Parameters& p) { p.line.frame.stopBits = 3; }), "");
  EXPECT_NE(refusedWith(Protocol::Ascii, [](Parameters& p) { p.line.baud = 14'400; }), "");
}

TEST(SerialParameters, WiringOfEachProtocol) {
  const auto wired = [](Mode mode, Preset preset, bool flow) {
    return [=](Parameters& p) {
      p.line.mode = mode;
      p.line.preset = preset;
      p.ascii.flowControl = flow;
    };
  };
  for (const Mode mode : {Mode::MultipointMaster, Mode::TwoWire}) {
    EXPECT_EQ(refusedWith(Protocol::Ascii, wired(mode, Preset::Idle, false)), "");
    EXPECT_EQ(refusedWith(Protocol::Ascii, wired(mode, Preset::None, false)), "");
    EXPECT_EQ(refusedWith(Protocol::Ascii, wired(mode, Preset::Break, false)),
              "break recognition needs four wires between two partners (RS 422)");
    EXPECT_EQ(refusedWith(Protocol::Ascii, wired(mode, Preset::Idle, true)),
              "XON/XOFF needs four wires between two partners (RS 422)");
    for (const Protocol protocol : {Protocol::Procedure, Protocol::ComputerLink})
      EXPECT_EQ(refusedWith(protocol, wired(mode, Preset::Idle, false)),
                "3964(R) and RK 512 need four wires between two partners (RS 422)");
  }
  for (const Preset preset : {Preset::None, Preset::Break, Preset::Idle})
    for (const Protocol protocol : kAll)
      EXPECT_EQ(refusedWith(protocol, wired(Mode::PointToPoint, preset, true)), "");
  EXPECT_NE(refusedWith(Protocol::Ascii, wired(Mode::MultipointSlave, Preset::Idle, false)), "");
}

TEST(SerialParameters, CharactersAndCounts) {
  using End = AsciiParameters::End;
  const auto with = [](End end, unsigned length, std::uint8_t end1, std::uint8_t xoff, bool seven) {
    return [=](Parameters& p) {
      p.ascii.end = end;
      p.ascii.length = static_cast<std::uint16_t>(length);
      p.ascii.end1 = end1;
      p.ascii.flowControl = true;
      p.ascii.xoff = xoff;
      if (seven) p.line.frame.dataBits = 7;
    };
  };
  EXPECT_EQ(refusedWith(Protocol::Ascii, with(End::Characters, 0, 0xFF, 0x13, false)), "");
  EXPECT_EQ(refusedWith(Protocol::Ascii, with(End::Characters, 0, 0x80, 0x81, true)),
            "end character 1 must be 0 to 127; XOFF must be 0 to 127");
  for (const std::uint8_t end : {std::uint8_t{0x11}, std::uint8_t{0x13}})
    EXPECT_EQ(refusedWith(Protocol::Ascii, with(End::Characters, 0, end, 0x13, false)),
              "XON and XOFF cannot be end characters");
  EXPECT_EQ(refusedWith(Protocol::Ascii, with(End::Delay, 0, 3, 0x11, false)),
            "XON and XOFF must be different characters");
  EXPECT_EQ(refusedWith(Protocol::Ascii, with(End::Count, 0, 3, 0x13, false)),
            "telegram length must be 1 to 1024");
  EXPECT_EQ(refusedWith(Protocol::Ascii, with(End::Count, 1'024, 3, 0x13, false)), "");
  EXPECT_NE(refusedWith(Protocol::Ascii, with(End::Count, 1'025, 3, 0x13, false)), "");
}

TEST(SerialParameters, AttemptsAndBuffer) {
  const auto none = [](Parameters& p) { p.procedure.setups = p.procedure.transmissions = 0; };
  EXPECT_EQ(refusedWith(Protocol::Procedure, none),
            "set-up attempts must be 1 to 255; transmission attempts must be 1 to 255");
  for (const unsigned telegrams : {0U, 1U, 10U, 11U}) {
    const auto change = [&](Parameters& p) {
      p.mailbox.wholeBuffer = false;
      p.mailbox.telegrams = static_cast<std::uint8_t>(telegrams);
    };
    const bool good = telegrams == 1 || telegrams == 10;
    EXPECT_EQ(refusedWith(Protocol::Procedure, change).empty(), good);
    EXPECT_EQ(refusedWith(Protocol::ComputerLink, change), "");  // it has no buffer
  }
}

// PTP-PARAM-13, PTP-PARAM-16
TEST(SerialParameters, OneOrTwoEndCharactersAndTheRateWhereItMatters) {
  for (const std::uint8_t count : {std::uint8_t{0}, std::uint8_t{3}})
    EXPECT_EQ(refusedWith(Protocol::Ascii,
                          [count](Parameters& p) {
                            p.ascii.end = AsciiParameters::End::Characters;
                            p.ascii.endCharacters = count;
                          }),
              "number of end characters must be 1 to 2");
  const auto delay = [](std::uint32_t baud) {
    return refusedWith(Protocol::Ascii, [baud](Parameters& p) {
      p.line.baud = baud;
      p.ascii.delay = Duration::milliseconds(0);
    });
  };
  EXPECT_EQ(delay(300),
            "character delay time must be 130 to 65535 ms in steps of 1 ms at 300 baud");
  EXPECT_EQ(delay(38'400), "character delay time must be 1 to 65535 ms in steps of 1 ms");
}

}  // namespace
}  // namespace merker::serial
