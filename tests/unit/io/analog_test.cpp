#include <gtest/gtest.h>

#include "make.h"

namespace merker::io {
namespace {

Terminal input(const Rack& rack, std::string_view module, std::uint32_t channel) {
  return *rack.terminal(module, Side::AnalogInput, channel);
}

// S7-CPU-18, S7-CPU-19
TEST(AnalogInput, onBoard) {
  Rack rack(good({}));
  rack.setAmount(input(rack, "2.3", 0), 10, at(0));
  rack.setAmount(input(rack, "2.3", 3), -5, at(0));
  rack.setAmount(input(rack, "2.3", 4), 100, at(0));  // Pt100
  EXPECT_EQ(word(rack, 752), 0);
  EXPECT_EQ(rack.next(), at(5));  // five channels, 1 ms each
  rack.advance(at(5));
  EXPECT_EQ(word(rack, 752), 27648);
  EXPECT_EQ(word(rack, 758), 0x10000 - 13824);
  EXPECT_EQ(word(rack, 760), 1000);
  rack.setAmount(input(rack, "2.3", 0), 12, at(6));
  rack.advance(at(10));
  EXPECT_EQ(word(rack, 752), 32767);
}

Module transmitter() {
  Module module = make(0, 4, "6ES7 331-7KF02-0AB0");
  for (AnalogInput& channel : module.parameters.analogInputs) {
    channel.range = findMeasuringRange("4..20mA");
    channel.wireBreakCheck = true;
  }
  module.parameters.diagnosticInterrupt = true;
  module.parameters.analogInputs[0].upperLimit = 18;
  module.parameters.analogInputs[0].lowerLimit = 6;
  return module;
}

// The example of the SM 331's manual: limits 6 and 18 mA, LB 8 and LB 9 of OB 40 name the channel.
TEST(AnalogInput, limits) {
  Rack rack(good({transmitter()}));
  const auto pointsAt = [&](double amount, std::int64_t ms) {
    rack.setAmount(input(rack, "4", 0), amount, at(ms));
    rack.advance(at(ms + 200));
    std::uint32_t points = 0;
    for (const ModuleEvent& event : rack.takeEvents()) points |= event.points;
    return points;
  };
  EXPECT_EQ(pointsAt(12, 0), 0u);
  EXPECT_EQ(pointsAt(18.5, 1000), 0x01000000u);
  EXPECT_EQ(pointsAt(19, 2000), 0u);  // still beyond
  EXPECT_EQ(pointsAt(12, 3000), 0u);
  EXPECT_EQ(pointsAt(5.71, 4000), 0x00010000u);
}

// S7-OBI-09: coming with MDL_DEFECT and EXT_FAULT, later going
TEST(AnalogInput, wireBreakOfATransmitter) {
  Rack rack(good({transmitter()}));
  rack.setAmount(input(rack, "4", 2), 0, at(0));
  rack.advance(at(1000));
  EXPECT_EQ(word(rack, 260), 32767);
  auto events = rack.takeEvents();
  ASSERT_EQ(events.size(), 1u);
  EXPECT_EQ(events[0].kind, ModuleEvent::Kind::DiagnosticComing);
  EXPECT_EQ(events[0].address, 256);
  EXPECT_EQ(events[0].data, (std::array<std::uint8_t, 4>{0x0D, 0x15, 0, 0}));
  rack.setAmount(input(rack, "4", 2), 12, at(1000));
  rack.advance(at(2000));
  events = rack.takeEvents();
  ASSERT_EQ(events.size(), 1u);
  EXPECT_EQ(events[0].kind, ModuleEvent::Kind::DiagnosticGoing);
  EXPECT_EQ(events[0].data, (std::array<std::uint8_t, 4>{0, 0x15, 0, 0}));
}

// The interrupt comes beyond the limit, not at it, and once for each crossing.
TEST(AnalogInput, theLimitItselfIsNotBeyond) {
  Rack rack(good({transmitter()}));
  const auto pointsAt = [&](double amount, std::int64_t ms) {
    rack.setAmount(input(rack, "4", 0), amount, at(ms));
    rack.advance(at(ms + 200));
    std::uint32_t points = 0;
    for (const ModuleEvent& event : rack.takeEvents()) points |= event.points;
    return points;
  };
  EXPECT_EQ(pointsAt(18, 0), 0u);
  EXPECT_EQ(pointsAt(6, 1000), 0u);
  EXPECT_EQ(pointsAt(5.98, 2000), 0x00010000u);  // one step of 12 bits is 0.0046 mA
  EXPECT_EQ(pointsAt(6, 3000), 0u);
  EXPECT_EQ(pointsAt(5.98, 4000), 0x00010000u);
  EXPECT_EQ(pointsAt(18.02, 5000), 0x01000000u);
  EXPECT_EQ(pointsAt(18, 6000), 0u);
  EXPECT_EQ(pointsAt(18.02, 7000), 0x01000000u);
}

TEST(AnalogInput, limitsOfTheSecondChannelHaveTheirOwnBits) {
  Module module = transmitter();
  module.parameters.analogInputs[2].upperLimit = 18;
  module.parameters.analogInputs[2].lowerLimit = 6;
  Rack rack(good({module}));
  for (const std::uint32_t channel : {0u, 2u}) rack.setAmount(input(rack, "4", channel), 12, at(0));
  rack.advance(at(200));
  rack.setAmount(input(rack, "4", 2), 19, at(200));
  rack.setAmount(input(rack, "4", 0), 5, at(200));
  EXPECT_TRUE(rack.takeEvents().empty());
  rack.advance(at(400));
  const auto events = rack.takeEvents();
  ASSERT_EQ(events.size(), 1u);
  EXPECT_EQ(events[0].kind, ModuleEvent::Kind::HardwareInterrupt);
  EXPECT_EQ(events[0].address, 256);
  EXPECT_EQ(events[0].points, 0x04010000u);
}

// An open voltage input drifts to overflow, a current loop that is open carries 0 mA: 0 from
// 0 to 20 mA, the underrange or underflow from 4 to 20 mA, overflow where a wire break is checked.
TEST(AnalogInput, wireBreak) {
  struct Case {
    std::string_view range;
    bool check;
    std::uint16_t shown;
  };
  for (const Case& c :
       {Case{"±10V", false, 32767}, Case{"±20mA", false, 0}, Case{"0..20mA", false, 0},
        Case{"4..20mA", false, 0x8000}, Case{"4..20mA", true, 32767}}) {
    Module module = make(0, 4, "6ES7 331-7KF02-0AB0");
    for (AnalogInput& channel : module.parameters.analogInputs) {
      channel.range = findMeasuringRange(c.range);
      channel.wireBreakCheck = c.check;
    }
    Rack rack(good({module}));
    const std::uint32_t four = *rack.module("4");
    rack.setAmount(input(rack, "4", 1), 5, at(0));
    rack.advance(at(1000));
    const std::uint16_t before = word(rack, 258);
    rack.fault(four, FaultKind::WireBreak, 1, true);
    EXPECT_EQ(word(rack, 258), c.shown) << c.range << c.check;
    rack.fault(four, FaultKind::WireBreak, 1, false);
    EXPECT_EQ(word(rack, 258), before) << c.range << c.check;
  }
}

// S7-CPU-19: a deactivated channel takes no time of conversion.
TEST(AnalogInput, deactivatedChannelsTakeNoTime) {
  Module module = onBoard(3);
  module.parameters.analogInputs[1].range = nullptr;
  module.parameters.analogInputs[2].range = nullptr;
  module.parameters.analogInputs[4].range = nullptr;
  Rack rack(good({module}));
  rack.setAmount(input(rack, "2.3", 0), 10, at(0));
  EXPECT_EQ(rack.next(), at(2));  // two channels, 1 ms each
  rack.setAmount(input(rack, "2.3", 3), 5, Instant{at(2).ns - 1});
  EXPECT_EQ(rack.next(), at(2));
  rack.advance(at(2));
  EXPECT_EQ(word(rack, 752), 27648);
  EXPECT_EQ(word(rack, 758), 13824);
  rack.setAmount(input(rack, "2.3", 0), 5, at(2));  // the cycle of now has begun
  EXPECT_EQ(rack.next(), at(4));
}

TEST(AnalogInput, withoutAnyChannelNothingIsConverted) {
  Module module = onBoard(3);
  for (AnalogInput& channel : module.parameters.analogInputs) channel.range = nullptr;
  Rack rack(good({module}));
  rack.setAmount(input(rack, "2.3", 0), 10, at(0));
  EXPECT_EQ(rack.next(), Instant::never());
}

// S7-CPU-16, S7-CPU-19: 12 bits on board. With sign one step is 16, of 0 to 20 mA it is 8.
TEST(AnalogInput, onBoardHasTwelveBits) {
  Module module = onBoard(3);
  module.parameters.analogInputs[1].range = findMeasuringRange("0..20mA");
  Rack rack(good({module}));
  std::int64_t ms = 0;
  const auto shown = [&](std::uint32_t channel, double counts, double rated) {
    rack.setAmount(input(rack, "2.3", channel), counts / 27648 * rated, at(ms));
    rack.advance(at(ms += 10));
    return word(rack, 752 + 2 * channel);
  };
  EXPECT_EQ(shown(0, 13824, 10), 13824);
  EXPECT_EQ(shown(0, 13839, 10), 13824);
  EXPECT_EQ(shown(0, 13840, 10), 13840);
  EXPECT_EQ(shown(0, -16, 10), 0x10000 - 16);
  EXPECT_EQ(shown(0, -15, 10), 0x10000 - 16);
  EXPECT_EQ(shown(1, 13824, 20), 13824);
  EXPECT_EQ(shown(1, 13831, 20), 13824);
  EXPECT_EQ(shown(1, 13832, 20), 13832);
}

TEST(AnalogInput, faultsByTheValue) {
  Rack rack(good({make(0, 4, "6ES7 331-7KF02-0AB0")}));
  const std::uint32_t four = *rack.module("4");
  rack.fault(four, FaultKind::Underflow, 1, true);
  EXPECT_EQ(word(rack, 258), 0x8000);
  EXPECT_EQ(word(rack, 256), 0);
  rack.fault(four, FaultKind::Underflow, 1, false);
  rack.fault(four, FaultKind::Overflow, 1, true);
  EXPECT_EQ(word(rack, 258), 32767);
  rack.fault(four, FaultKind::Overflow, 1, false);
  EXPECT_EQ(word(rack, 258), 0);
  for (const FaultKind kind : {FaultKind::LoadVoltage, FaultKind::Defect}) {
    rack.fault(four, kind, {}, true);
    EXPECT_EQ(word(rack, 258), 32767);
    rack.fault(four, kind, {}, false);
    EXPECT_EQ(word(rack, 258), 0);
  }
}

// Data record 1 says what the amount itself shows: overflow, underflow, the break of a checked
// wire.
TEST(AnalogInput, measuredFaultsStandInTheDiagnosis) {
  Rack rack(good({transmitter()}));
  const Module& module = *rack.at(256, false);
  std::int64_t ms = 0;
  const auto channelByte = [&](double amount) {
    rack.setAmount(input(rack, "4", 1), amount, at(ms));
    rack.advance(at(ms += 1000));
    return rack.record1(module)[9];  // channel 1
  };
  EXPECT_EQ(channelByte(12), 0);
  EXPECT_EQ(channelByte(30), 0x80);
  EXPECT_EQ(channelByte(3.61), 0);
  EXPECT_EQ(channelByte(3.59), 0x10);
  EXPECT_EQ(channelByte(4), 0);
  EXPECT_EQ(rack.record1(module)[0], 0);
}

TEST(AnalogInput, deactivatedChannelShowsOverflow) {
  Module module = make(0, 4, "6ES7 331-7KF02-0AB0");
  module.parameters.analogInputs[1].range = nullptr;
  const Rack rack(good({module}));
  EXPECT_EQ(word(rack, 258), 32767);
  EXPECT_FALSE(rack.faulty(*rack.module("4")));
}

TEST(AnalogOutput, valuesAndSubstitutes) {
  Module module = make(0, 4, "6ES7 332-5HD01-0AB0");
  module.parameters.onStop = OnStop::Substitute;
  module.parameters.analogOutputs[1].range = findMeasuringRange("4..20mA");
  module.parameters.analogOutputs[1].substitute = 4;
  Rack rack(good({module}));
  const std::uint8_t bytes[] = {0x36, 0x00, 0x36, 0x00};  // 13824
  rack.disableOutputs(false);
  rack.written(256, bytes, 4);
  const auto output = [&](std::uint32_t c) {
    return rack.amount(*rack.terminal("4", Side::AnalogOutput, c));
  };
  EXPECT_DOUBLE_EQ(output(0), 5);
  EXPECT_DOUBLE_EQ(output(1), 12);
  rack.disableOutputs(true);
  EXPECT_DOUBLE_EQ(output(0), 0);
  EXPECT_DOUBLE_EQ(output(1), 4);
}

// Bits below the resolution are not put out: 12 bits with sign leave four, without sign three.
TEST(AnalogOutput, lowBitsDoNotCount) {
  Module module = onBoard(3);
  module.parameters.analogOutputs[1].range = findMeasuringRange("0..20mA");
  Rack rack(good({module}));
  rack.disableOutputs(false);
  const auto output = [&](std::uint32_t c, std::uint16_t value) {
    const std::uint8_t bytes[] = {static_cast<std::uint8_t>(value >> 8),
                                  static_cast<std::uint8_t>(value)};
    rack.written(752 + 2 * c, bytes, 2);
    return rack.amount(*rack.terminal("2.3", Side::AnalogOutput, c));
  };
  EXPECT_NEAR(output(0, 0x0007), 0, 1e-9);
  EXPECT_NEAR(output(0, 0x000F), 0, 1e-9);
  EXPECT_NEAR(output(0, 0x0010), 16.0 / 27648 * 10, 1e-9);
  EXPECT_NEAR(output(0, 0x3607), 5, 1e-9);
  EXPECT_NEAR(output(0, 0xFFFF), -16.0 / 27648 * 10, 1e-9);
  EXPECT_NEAR(output(1, 0x0007), 0, 1e-9);
  EXPECT_NEAR(output(1, 0x0008), 8.0 / 27648 * 20, 1e-9);
}

TEST(AnalogOutput, faultsTakeItsAmount) {
  Module module = make(0, 4, "6ES7 332-5HD01-0AB0");
  Rack rack(good({module}));
  const std::uint32_t four = *rack.module("4");
  const std::uint8_t bytes[] = {0x36, 0x00, 0x36, 0x00};
  rack.disableOutputs(false);
  rack.written(256, bytes, 4);
  const auto output = [&](std::uint32_t c) {
    return rack.amount(*rack.terminal("4", Side::AnalogOutput, c));
  };
  for (const FaultKind kind : {FaultKind::ShortCircuit, FaultKind::WireBreak}) {
    rack.fault(four, kind, 1, true);
    EXPECT_DOUBLE_EQ(output(0), 5);
    EXPECT_DOUBLE_EQ(output(1), 0);
    rack.fault(four, kind, 1, false);
    EXPECT_DOUBLE_EQ(output(1), 5);
  }
  for (const FaultKind kind : {FaultKind::LoadVoltage, FaultKind::Defect, FaultKind::Removed}) {
    rack.fault(four, kind, {}, true);
    EXPECT_DOUBLE_EQ(output(0), 0);
    rack.fault(four, kind, {}, false);
    EXPECT_DOUBLE_EQ(output(0), 5);
  }
  rack.disableOutputs(true);  // without voltage and current in STOP
  EXPECT_DOUBLE_EQ(output(0), 0);
}

TEST(AnalogOutput, keepsItsAmountInStop) {
  Module module = make(0, 4, "6ES7 332-5HD01-0AB0");
  module.parameters.onStop = OnStop::Keep;
  Rack rack(good({module}));
  const std::uint8_t half[] = {0x36, 0x00}, full[] = {0x6C, 0x00};
  rack.disableOutputs(false);
  rack.written(256, half, 2);
  rack.disableOutputs(true);
  rack.written(256, full, 2);
  const Terminal output = *rack.terminal("4", Side::AnalogOutput, 0);
  EXPECT_DOUBLE_EQ(rack.amount(output), 5);
  rack.disableOutputs(false);
  EXPECT_DOUBLE_EQ(rack.amount(output), 10);
}

}  // namespace
}  // namespace merker::io
