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

}  // namespace
}  // namespace merker::io
