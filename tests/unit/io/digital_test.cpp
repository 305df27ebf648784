#include <gtest/gtest.h>

#include "make.h"

namespace merker::io {
namespace {

Rack compact(std::uint32_t rising = 0, std::uint32_t falling = 0) {
  Module module = onBoard(2);
  module.parameters.risingEdges = rising;
  module.parameters.fallingEdges = falling;
  return Rack(good({module}));
}

Terminal input(const Rack& rack, std::uint32_t channel) {
  return *rack.terminal("2.2", Side::DigitalInput, channel);
}

// S7-HWCFG-09: 3 ms input delay
TEST(DigitalInput, delay) {
  Rack rack = compact();
  rack.setLevel(input(rack, 9), true, at(10));
  EXPECT_EQ(rack.next(), at(13));
  rack.advance(Instant{at(13).ns - 1});
  EXPECT_EQ(rack.inputs()[125], 0);
  rack.advance(at(13));
  EXPECT_EQ(rack.inputs()[125], 2);
  EXPECT_EQ(rack.next(), Instant::never());
}

TEST(DigitalInput, aShortPulseIsNotSeen) {
  Rack rack = compact(1, 1);
  rack.setLevel(input(rack, 0), true, at(0));
  rack.setLevel(input(rack, 0), false, at(2));
  EXPECT_EQ(rack.next(), Instant::never());
  rack.advance(at(100));
  EXPECT_TRUE(rack.takeEvents().empty());
}

// S7-OBI-06: edge on E 124.1
TEST(DigitalInput, hardwareInterrupt) {
  Rack rack = compact(2);
  rack.setLevel(input(rack, 1), true, at(0));
  rack.setLevel(input(rack, 2), true, at(0));
  rack.advance(at(3));
  const auto events = rack.takeEvents();
  ASSERT_EQ(events.size(), 1u);
  EXPECT_EQ(events[0].kind, ModuleEvent::Kind::HardwareInterrupt);
  EXPECT_EQ(events[0].address, 124);
  EXPECT_EQ(events[0].points, 2u);
  EXPECT_FALSE(events[0].output);
  rack.setLevel(input(rack, 1), false, at(10));
  rack.advance(at(20));
  EXPECT_TRUE(rack.takeEvents().empty());  // no interrupt for falling edges
}

TEST(DigitalInput, edgesAtTheSameInstantAreOneEvent) {
  Rack rack = compact(1, 2);
  rack.setLevel(input(rack, 1), true, at(0));
  rack.advance(at(3));
  rack.setLevel(input(rack, 0), true, at(10));
  rack.setLevel(input(rack, 1), false, at(10));
  rack.advance(at(50));
  const auto events = rack.takeEvents();
  ASSERT_EQ(events.size(), 1u);
  EXPECT_EQ(events[0].points, 3u);
}

TEST(DigitalInput, deliveredValuesPassTheDelayAndInterrupt) {
  Rack rack = compact(2);
  EXPECT_TRUE(rack.deliver(124, 2, 2, {}));
  EXPECT_EQ(rack.inputs()[124], 2);
  EXPECT_EQ(rack.takeEvents().size(), 1u);
  EXPECT_TRUE(rack.level(input(rack, 1)));
  EXPECT_FALSE(rack.deliver(0, 1, 1, {}));  // no module
}

TEST(DigitalInput, changesAreHandedOnOnce) {
  Rack rack = compact();
  rack.takeChanged();
  rack.deliver(126, 1, 1, {});
  rack.deliver(124, 1, 1, {});
  const Bytes bytes = rack.takeChanged();
  EXPECT_EQ(bytes.first, 124u);
  EXPECT_EQ(bytes.count, 3u);
  EXPECT_EQ(rack.takeChanged().count, 0u);
}

// An input that returns within the delay, a second change, and what is nothing new.
TEST(DigitalInput, delayBeginsWithEachChange) {
  Rack rack = compact(1);
  rack.setLevel(input(rack, 0), true, at(0));
  rack.setLevel(input(rack, 0), true, at(2));  // nothing new
  EXPECT_EQ(rack.next(), at(3));
  rack.setLevel(input(rack, 1), true, at(1));
  EXPECT_EQ(rack.next(), at(3));
  rack.advance(at(3));
  EXPECT_EQ(rack.inputs()[124], 1);
  EXPECT_EQ(rack.next(), at(4));
  rack.setLevel(input(rack, 0), false, at(3));
  rack.setLevel(input(rack, 0), true, at(4));
  rack.advance(at(20));
  EXPECT_EQ(rack.inputs()[124], 3);
  EXPECT_EQ(rack.takeEvents().size(), 1u);
  EXPECT_TRUE(rack.level(input(rack, 0)));
  EXPECT_FALSE(rack.level(input(rack, 2)));
}

// Two edges of one channel are two interrupts, also if the CPU has not looked in between.
TEST(DigitalInput, twoEdgesOfAChannelAreTwoEvents) {
  Rack rack = compact(1, 1);
  rack.setLevel(input(rack, 0), true, at(0));
  rack.advance(at(3));
  rack.setLevel(input(rack, 0), false, at(10));
  rack.advance(at(13));
  EXPECT_EQ(rack.takeEvents().size(), 2u);
}

TEST(DigitalInput, outputsAndAnalogInputsHaveNoLevel) {
  Rack rack = compact();
  const Terminal output = *rack.terminal("2.2", Side::DigitalOutput, 0);
  rack.setLevel(output, true, at(0));
  EXPECT_FALSE(rack.level(output));
  const Terminal analog = *rack.terminal("2.3", Side::AnalogInput, 0);
  rack.setLevel(analog, true, at(0));
  EXPECT_FALSE(rack.level(analog));
  EXPECT_EQ(rack.next(), Instant::never());
  EXPECT_FALSE(rack.terminal("2.2", Side::DigitalInput, 24));
  EXPECT_TRUE(rack.terminal("2.2", Side::DigitalInput, 23));
  EXPECT_FALSE(rack.terminal("2.2", Side::DigitalOutput, 16));
  EXPECT_TRUE(rack.terminal("2.2", Side::DigitalOutput, 15));
}

// Only the bits of the mask, from terminals beyond the first byte too; other modules take bytes as
// they are.
TEST(DigitalInput, deliveredBitsAreThoseOfTheMask) {
  Rack rack = compact();
  rack.deliver(125, 0xFF, 0xF0, {});
  rack.deliver(125, 0x18, 0x08, {});
  EXPECT_EQ(rack.inputs()[125], 0xE8);
  EXPECT_EQ(rack.inputs()[124], 0);
  EXPECT_TRUE(rack.level(input(rack, 11)));
  rack.deliver(752, 0xFF, 0x55, {});
  rack.deliver(752, 0x0F, 0x0A, {});
  EXPECT_EQ(rack.inputs()[752], 0x5A);
}

// The CPU 312C has ten inputs: bits that no terminal stands for stay 0.
TEST(DigitalInput, bitsWithoutTerminalStayZero) {
  const CpuModel& model = *findCpuModel("312C");
  Rack rack(good({onBoard(2, model)}, model));
  EXPECT_TRUE(rack.deliver(124, 0xFF, 0xFF, {}));
  EXPECT_TRUE(rack.deliver(125, 0xFF, 0xFF, {}));
  EXPECT_EQ(rack.inputs()[124], 0xFF);
  EXPECT_EQ(rack.inputs()[125], 0x03);
  EXPECT_FALSE(rack.terminal("2.2", Side::DigitalInput, 10));
}

// A level that still waits when the module delivers another value is forgotten.
TEST(DigitalInput, deliveringEndsTheDelay) {
  Rack rack = compact();
  rack.setLevel(input(rack, 0), true, at(0));
  rack.deliver(124, 1, 0, at(1));
  EXPECT_EQ(rack.next(), Instant::never());
  rack.advance(at(10));
  EXPECT_EQ(rack.inputs()[124], 0);
}

Rack outputs(OnStop onStop) {
  Module module = make(0, 4, "6ES7 322-8BF00-0AB0");
  module.parameters.onStop = onStop;
  module.parameters.substituteBits = 0x80;
  return Rack(good({module}));
}

std::uint32_t levels(const Rack& rack) {
  std::uint32_t bits = 0;
  for (std::uint32_t c = 0; c < 8; ++c)
    bits |= std::uint32_t{rack.level(*rack.terminal("4", Side::DigitalOutput, c))} << c;
  return bits;
}

// S7-STATE-02, S7-STATE-11, S7-HWCFG-09
TEST(DigitalOutput, disabled) {
  const std::uint8_t byte = 0x0F, other = 0xF0;
  for (const auto& [onStop, stopped] :
       {std::pair{OnStop::Zero, 0u}, {OnStop::Keep, 0x0Fu}, {OnStop::Substitute, 0x80u}}) {
    Rack rack = outputs(onStop);
    rack.disableOutputs(false);
    rack.written(0, &byte, 1);
    EXPECT_EQ(levels(rack), 0x0Fu);
    rack.disableOutputs(true);
    EXPECT_EQ(levels(rack), stopped);
    rack.written(0, &other, 1);  // T PAB in OB 100 is seen at the transition to RUN
    EXPECT_EQ(levels(rack), stopped);
    rack.disableOutputs(false);
    EXPECT_EQ(levels(rack), 0xF0u);
  }
}

// Faults of the module take all its outputs, those of a channel only that one.
TEST(DigitalOutput, faults) {
  Rack rack = outputs(OnStop::Zero);
  const std::uint32_t four = *rack.module("4");
  const std::uint8_t ones = 0xFF;
  rack.disableOutputs(false);
  rack.written(0, &ones, 1);
  for (const FaultKind kind :
       {FaultKind::LoadVoltage, FaultKind::Fuse, FaultKind::Defect, FaultKind::Removed}) {
    rack.fault(four, kind, {}, true);
    EXPECT_EQ(levels(rack), 0u);
    EXPECT_EQ(rack.putOut(0), 0);
    rack.fault(four, kind, {}, false);
    EXPECT_EQ(levels(rack), 0xFFu);
    EXPECT_EQ(rack.putOut(0), 0xFF);
  }
  for (const FaultKind kind : {FaultKind::ShortCircuit, FaultKind::WireBreak}) {
    rack.fault(four, kind, 6, true);
    EXPECT_EQ(levels(rack), 0xBFu);
    EXPECT_EQ(rack.putOut(0), 0xBF);
    rack.fault(four, kind, 6, false);
  }
  EXPECT_EQ(rack.putOut(1), 0);  // nobody is there
}

// CNT-PIN-13: an output that a channel drives does not follow its bit, and is 0 while outputs are
// disabled.
TEST(DigitalOutput, driven) {
  Rack rack(good({}));
  const std::uint8_t bytes[] = {0x03, 0x00};
  const Terminal zero = *rack.terminal("2.2", Side::DigitalOutput, 0);
  rack.disableOutputs(false);
  rack.written(124, bytes, 2);
  rack.drive(zero, false);
  EXPECT_FALSE(rack.level(zero));
  EXPECT_EQ(rack.putOut(124), 0x02);
  rack.drive(zero, true);
  EXPECT_TRUE(rack.level(zero));
  rack.disableOutputs(true);
  EXPECT_FALSE(rack.level(zero));
}

// What is written beyond the periphery, or partly, changes nothing else.
TEST(DigitalOutput, writtenAtTheEnd) {
  Module module = make(0, 4, "6ES7 322-8BF00-0AB0");
  module.outputStart = 1023;
  Rack rack(good({module}));
  const std::uint8_t bytes[] = {0x5A, 0x5A};
  rack.disableOutputs(false);
  rack.written(1023, bytes, 2);
  EXPECT_EQ(rack.putOut(1023), 0x5A);
  rack.written(1024, bytes, 2);
  EXPECT_EQ(rack.putOut(1024), 0);
}

}  // namespace
}  // namespace merker::io
