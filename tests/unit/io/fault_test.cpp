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

// Manual "S7-300 Module data", appendix B: bytes 0 to 3, type and count of the channels, a bit for
// each faulty one, a byte for each.
TEST(Diagnosis, recordsOfEachKindOfModule) {
  using Record = std::vector<std::uint8_t>;
  struct Case {
    std::string_view type;
    FaultKind kind;
    std::optional<std::uint32_t> channel;
    Record begin;               // bytes 0 to 6
    Record vector;              // behind them
    std::uint8_t channelFault;  // in each channel of the vector
  };
  const Case cases[] = {
      {"6ES7 321-7BH01-0AB0",
       FaultKind::SensorSupply,
       {},
       {0x0D, 0x1F, 0, 0, 0x70, 8, 16},
       {0xFF, 0xFF},
       0x40},
      {"6ES7 321-7BH01-0AB0",
       FaultKind::LoadVoltage,
       {},
       {0x15, 0x1F, 0, 0, 0x70, 8, 16},
       {0, 0},
       0},
      {"6ES7 321-7BH01-0AB0", FaultKind::Defect, {}, {0x03, 0x1F, 0, 0, 0x70, 8, 16}, {0, 0}, 0},
      {"6ES7 322-8BF00-0AB0", FaultKind::Fuse, {}, {0x0D, 0x1F, 0, 0x20, 0x72, 8, 8}, {0xFF}, 0x20},
      {"6ES7 322-8BF00-0AB0",
       FaultKind::LoadVoltage,
       {},
       {0x1D, 0x1F, 0, 0, 0x72, 8, 8},
       {0xFF},
       0x40},
      {"6ES7 322-8BF00-0AB0",
       FaultKind::ShortCircuit,
       2,
       {0x0D, 0x1F, 0, 0, 0x72, 8, 8},
       {0x04},
       0x08},
      {"6ES7 322-8BF00-0AB0",
       FaultKind::WireBreak,
       7,
       {0x0D, 0x1F, 0, 0, 0x72, 8, 8},
       {0x80},
       0x10},
      {"6ES7 331-7KF02-0AB0", FaultKind::LoadVoltage, {}, {0x15, 0x15, 0, 0, 0x71, 8, 8}, {0}, 0},
      {"6ES7 331-7KF02-0AB0", FaultKind::Defect, {}, {0x03, 0x15, 0, 0x10, 0x71, 8, 8}, {0}, 0},
      {"6ES7 331-7KF02-0AB0", FaultKind::Overflow, 0, {0x0D, 0x15, 0, 0, 0x71, 8, 8}, {0x01}, 0x80},
      {"6ES7 331-7KF02-0AB0",
       FaultKind::Underflow,
       5,
       {0x0D, 0x15, 0, 0, 0x71, 8, 8},
       {0x20},
       0x40},
      {"6ES7 332-5HD01-0AB0",
       FaultKind::WireBreak,
       1,
       {0x0D, 0x15, 0, 0, 0x73, 8, 4},
       {0x02},
       0x10},
      {"6ES7 332-5HD01-0AB0",
       FaultKind::ShortCircuit,
       3,
       {0x0D, 0x15, 0, 0, 0x73, 8, 4},
       {0x08},
       0x08},
      {"6ES7 332-5HD01-0AB0",
       FaultKind::LoadVoltage,
       {},
       {0x1D, 0x15, 0, 0, 0x73, 8, 4},
       {0x0F},
       0x40},
  };
  for (const Case& c : cases) {
    Rack rack(good({make(0, 4, c.type)}));
    ASSERT_TRUE(rack.fault(*rack.module("4"), c.kind, c.channel, true)) << c.type;
    Record wanted = c.begin;
    wanted.insert(wanted.end(), c.vector.begin(), c.vector.end());
    for (std::uint32_t i = 0; i < c.begin[6]; ++i)
      wanted.push_back((c.vector[i / 8] >> i % 8 & 1) != 0 ? c.channelFault : std::uint8_t{0});
    const Module& module = *rack.configuration().find("4");
    EXPECT_EQ(rack.record1(module), wanted) << c.type << nameOf(c.kind).words;
    EXPECT_EQ(rack.record0(module), Record(wanted.begin(), wanted.begin() + 4));
    EXPECT_TRUE(rack.faulty(*rack.module("4")));
    rack.fault(*rack.module("4"), c.kind, c.channel, false);
    EXPECT_FALSE(rack.faulty(*rack.module("4"))) << c.type << nameOf(c.kind).words;
  }
}

// CNT-DIAG-03, CNT-DIAG-04: the sub-module 2.4; an SM 338 is of the analog class.
TEST(Diagnosis, recordsOnBoard) {
  Rack rack(good({}));
  const auto record = [&](std::string_view name, FaultKind kind) {
    const std::uint32_t index = *rack.module(name);
    EXPECT_TRUE(rack.fault(index, kind, {}, true));
    const auto bytes = rack.record1(*rack.configuration().find(name));
    rack.fault(index, kind, {}, false);
    return bytes;
  };
  using Record = std::vector<std::uint8_t>;
  EXPECT_EQ(record("2.4", FaultKind::ParameterError), (Record{0x81, 0x08, 0, 0}));
  EXPECT_EQ(record("2.4", FaultKind::InterruptLost), (Record{0x01, 0x08, 0, 0x40}));
  Rack positions(good({make(0, 4, "SM 338")}));
  EXPECT_TRUE(positions.fault(*positions.module("4"), FaultKind::LoadVoltage, {}, true));
  EXPECT_EQ(positions.record1(*positions.configuration().find("4")), (Record{0x15, 0x05, 0, 0}));
}

// Which faults a module can have, by its kind.
TEST(Fault, possibleByKindOfModule) {
  constexpr int kKinds = 12;  // in the order of FaultKind
  struct Case {
    std::string_view type;
    std::string_view can;
  };
  for (const Case& c :
       {Case{"SM 321 DI16xDC24V", "000011011000"}, Case{"SM 322 DO16xDC24V/0.5A", "010010111000"},
        Case{"6ES7 322-8BF00-0AB0", "110010111000"}, Case{"6ES7 331-7KF02-0AB0", "101110011000"},
        Case{"6ES7 332-5HD01-0AB0", "110010011000"}, Case{"IM 360", "000000000100"},
        Case{"PS 307 5A", "000000000000"}, Case{"FM 350-1 counter", "000000011000"},
        Case{"SM 338", "000010011000"}}) {
    const ModuleType& type = *findModuleTypes(c.type).at(0);
    std::string can;
    for (int kind = 0; kind < kKinds; ++kind)
      can += possible(type, static_cast<FaultKind>(kind)) ? '1' : '0';
    EXPECT_EQ(can, c.can) << c.type;
  }
  const auto onBoardCan = [](std::uint32_t subslot) {
    std::string can;
    for (int kind = 0; kind < kKinds; ++kind)
      can += possible(*onBoardType(defaultCpuModel(), subslot), static_cast<FaultKind>(kind)) ? '1'
                                                                                              : '0';
    return can;
  };
  EXPECT_EQ(onBoardCan(2), "010011100000");
  EXPECT_EQ(onBoardCan(3), "111110000000");
  EXPECT_EQ(onBoardCan(4), "000000000011");
  EXPECT_EQ(onBoardCan(5), "000000000010");
}

TEST(Fault, namesAreInTheirOrder) {
  for (int i = 0; i < 12; ++i) {
    const auto kind = static_cast<FaultKind>(i);
    EXPECT_EQ(nameOf(kind).kind, kind);
    EXPECT_EQ(findFault(nameOf(kind).words), &nameOf(kind));
    EXPECT_EQ(nameOf(kind).channel, i < 4);
  }
  EXPECT_TRUE(faultNames().starts_with("wire break, short circuit, overflow, "));
}

// Without a channel: all of them; one channel: none beside it.
TEST(Fault, ofOneChannelOrAll) {
  Rack rack(good({diagnosing(0, 4, "6ES7 331-7KF02-0AB0")}));
  const std::uint32_t four = *rack.module("4");
  rack.fault(four, FaultKind::Overflow, {}, true);
  for (std::uint32_t c = 0; c < 8; ++c) EXPECT_EQ(word(rack, 256 + 2 * c), 32767);
  rack.fault(four, FaultKind::Overflow, 3, false);
  for (std::uint32_t c = 0; c < 8; ++c) EXPECT_EQ(word(rack, 256 + 2 * c), c == 3 ? 0 : 32767);
  EXPECT_EQ(rack.takeEvents().size(), 2u);  // each change of the diagnosis
  rack.fault(four, FaultKind::Overflow, {}, false);
  const auto events = rack.takeEvents();
  ASSERT_EQ(events.size(), 1u);
  EXPECT_EQ(events[0].kind, Kind::DiagnosticGoing);
  EXPECT_TRUE(rack.fault(four, FaultKind::Defect, {}, false));  // was not there: nothing happens
  EXPECT_TRUE(rack.takeEvents().empty());
}

// A module that is not there reports nothing but its absence, and is reported missing no second
// time.
TEST(Fault, aRemovedModuleIsSilent) {
  Module module = diagnosing(0, 4, "6ES7 321-7BH01-0AB0");
  module.parameters.risingEdges = 1;
  Rack rack(good({module, make(0, 5, "SM 321 DI16xDC24V")}));
  const std::uint32_t four = *rack.module("4");
  rack.deliver(0, 0xFF, 0x02, {});
  rack.fault(four, FaultKind::Removed, {}, true);
  EXPECT_EQ(rack.inputs()[0], 0);
  EXPECT_TRUE(rack.faulty(four));
  EXPECT_FALSE(rack.faulty(*rack.module("5")));
  EXPECT_EQ(rack.takeEvents().size(), 1u);
  rack.fault(four, FaultKind::Removed, {}, true);
  EXPECT_TRUE(rack.takeEvents().empty());
  rack.setLevel(*rack.terminal("4", Side::DigitalInput, 0), true, at(0));
  rack.advance(at(100));
  EXPECT_TRUE(rack.takeEvents().empty());
  EXPECT_FALSE(rack.deliver(0, 1, 1, {}));
  rack.fault(four, FaultKind::Removed, {}, false);
  EXPECT_EQ(rack.inputs()[0], 3);
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
