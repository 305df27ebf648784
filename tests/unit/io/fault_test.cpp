#include "io/fault.h"

#include <gtest/gtest.h>

#include "make.h"

namespace merker::io {
namespace {

using Kind = ModuleEvent::Kind;

Module diagnosing(std::uint32_t rack, std::uint32_t slot, std::string_view type) {
  Module module = make(rack, slot, type);
  module.parameters.diagnosticInterrupt = true;
  return module;
}

TEST(Fault, loadVoltageOfAnInputModule) {
  Rack rack(good({diagnosing(0, 4, "6ES7 321-7BH01-0AB0")}));
  const std::uint32_t module = *rack.module("4");
  rack.deliver(0, 0xFF, 0xFF, {});
  EXPECT_TRUE(rack.fault(module, FaultKind::LoadVoltage, {}, true));
  EXPECT_EQ(rack.inputs()[0], 0);
  EXPECT_TRUE(rack.faulty(module));
  const auto events = rack.takeEvents();
  ASSERT_EQ(events.size(), 1u);
  EXPECT_EQ(events[0].kind, Kind::DiagnosticComing);
  EXPECT_EQ(events[0].data, (std::array<std::uint8_t, 4>{0x15, 0x1F, 0, 0}));
  rack.fault(module, FaultKind::LoadVoltage, {}, false);
  EXPECT_EQ(rack.inputs()[0], 0xFF);
  EXPECT_EQ(rack.takeEvents().at(0).kind, Kind::DiagnosticGoing);
}

TEST(Fault, dataRecordOneNamesTheChannel) {
  Rack rack(good({diagnosing(0, 4, "6ES7 331-7KF02-0AB0")}));
  rack.fault(*rack.module("4"), FaultKind::Overflow, 3, true);
  const Module* module = rack.at(256, false);
  ASSERT_NE(module, nullptr);
  EXPECT_EQ(rack.record1(*module), (std::vector<std::uint8_t>{0x0D, 0x15, 0, 0, 0x71, 8, 8, 0x08, 0,
                                                              0, 0, 0x80, 0, 0, 0, 0}));
  EXPECT_EQ(rack.record0(*module), (std::vector<std::uint8_t>{0x0D, 0x15, 0, 0}));
  EXPECT_EQ(rack.at(256, true), nullptr);
}

TEST(Fault, shortCircuitOfAnOutput) {
  Rack rack(good({diagnosing(0, 4, "6ES7 322-8BF00-0AB0")}));
  const std::uint8_t ones = 0xFF;
  rack.disableOutputs(false);
  rack.written(0, &ones, 1);
  rack.fault(*rack.module("4"), FaultKind::ShortCircuit, 2, true);
  EXPECT_FALSE(rack.level(*rack.terminal("4", Side::DigitalOutput, 2)));
  EXPECT_TRUE(rack.level(*rack.terminal("4", Side::DigitalOutput, 3)));
  const auto events = rack.takeEvents();
  ASSERT_EQ(events.size(), 1u);
  EXPECT_TRUE(events[0].output);  // a module with outputs only: IO_FLAG 16#55
}

TEST(Fault, withoutDiagnosticInterruptNobodyIsTold) {
  Rack rack(good({make(0, 4, "6ES7 331-7KF02-0AB0")}));
  rack.fault(*rack.module("4"), FaultKind::WireBreak, 0, true);
  EXPECT_TRUE(rack.takeEvents().empty());
  EXPECT_EQ(word(rack, 256), 32767);
}

TEST(Fault, removedModuleDoesNotAnswer) {
  Rack rack(good({make(0, 4, "SM 321 DI16xDC24V")}));
  rack.takePresenceChanged();
  rack.fault(*rack.module("4"), FaultKind::Removed, {}, true);
  EXPECT_FALSE(rack.answersInput(0));
  EXPECT_TRUE(rack.takePresenceChanged());
  EXPECT_EQ(rack.takeEvents().at(0).kind, Kind::Removed);
  rack.fault(*rack.module("4"), FaultKind::Removed, {}, false);
  EXPECT_TRUE(rack.answersInput(0));
  EXPECT_EQ(rack.takeEvents().at(0).kind, Kind::Inserted);
}

TEST(Fault, rackWithoutPower) {
  Module im = make(1, 3, "IM 361");
  Rack rack(good({make(0, 3, "IM 360"), make(0, 4, "SM 321 DI16xDC24V"), im,
                  make(1, 4, "SM 321 DI16xDC24V")}));
  rack.fault(*rack.module("1/3"), FaultKind::RackPower, {}, true);
  EXPECT_FALSE(rack.answersInput(32));
  EXPECT_TRUE(rack.answersInput(0));
  const ModuleEvent event = rack.takeEvents().at(0);
  EXPECT_EQ(event.kind, Kind::RackFailed);
  EXPECT_EQ(event.address, 0);    // an IM has none
  EXPECT_EQ(event.points, 0x2u);  // S7-OBI-11: bit 1, rack 1
}

// S7-ERR-05: the start sets parameters, and modules that have them say what is wrong.
TEST(Fault, presentFaultsAreReportedAfterTheStart) {
  Rack rack(good({diagnosing(0, 4, "6ES7 321-7BH01-0AB0"), make(0, 5, "6ES7 331-7KF02-0AB0")}));
  rack.reportFaults();
  EXPECT_TRUE(rack.takeEvents().empty());
  rack.fault(*rack.module("4"), FaultKind::LoadVoltage, {}, true);
  rack.fault(*rack.module("5"), FaultKind::LoadVoltage, {}, true);  // without diagnostic interrupt
  EXPECT_EQ(rack.takeEvents().size(), 1u);
  rack.reportFaults();
  const auto events = rack.takeEvents();
  ASSERT_EQ(events.size(), 1u);
  EXPECT_EQ(events[0].kind, Kind::DiagnosticComing);
  EXPECT_EQ(events[0].data, (std::array<std::uint8_t, 4>{0x15, 0x1F, 0, 0}));
}

// S7-STATE-02: without its supply a module keeps and substitutes nothing.
TEST(Fault, withoutSupplyNothingIsPutOut) {
  for (const OnStop onStop : {OnStop::Keep, OnStop::Substitute}) {
    Module digital = make(0, 4, "6ES7 322-8BF00-0AB0"), analog = make(0, 5, "6ES7 332-5HD01-0AB0");
    digital.parameters.onStop = analog.parameters.onStop = onStop;
    digital.parameters.substituteBits = 1;
    analog.parameters.analogOutputs[0].substitute = 5;
    Rack rack(good({digital, analog}));
    const std::uint8_t word[] = {0x36, 0x00};
    rack.disableOutputs(false);
    rack.written(0, word, 2);
    rack.written(272, word, 2);
    rack.disableOutputs(true);
    EXPECT_NE(rack.putOut(0), 0);
    EXPECT_NE(rack.putOut(272), 0);
    rack.supply(false);
    EXPECT_EQ(rack.putOut(0), 0);
    EXPECT_EQ(rack.putOut(272), 0);
    EXPECT_FALSE(rack.level(*rack.terminal("4", Side::DigitalOutput, 0)));
    EXPECT_EQ(rack.amount(*rack.terminal("5", Side::AnalogOutput, 0)), 0);
    rack.supply(true);
    EXPECT_EQ(rack.putOut(0), onStop == OnStop::Keep ? 0 : 1);
  }
}

// Not every module can have every fault.
TEST(Fault, possible) {
  Rack rack(good({make(0, 4, "SM 321 DI16xDC24V")}));
  EXPECT_FALSE(rack.fault(*rack.module("4"), FaultKind::Fuse, {}, true));
  EXPECT_FALSE(rack.fault(*rack.module("4"), FaultKind::Overflow, {}, true));
  EXPECT_FALSE(rack.fault(*rack.module("4"), FaultKind::RackPower, {}, true));
  EXPECT_FALSE(rack.fault(*rack.module("2.2"), FaultKind::Removed, {}, true));
  EXPECT_EQ(findFault("WIRE break")->kind, FaultKind::WireBreak);
  EXPECT_EQ(findFault("nonsense"), nullptr);
}

}  // namespace
}  // namespace merker::io
