// AS-Interface behind a CP 343-2 (S7-NET-17): where the bits of 31 slaves lie, what profiles make
// of them, slaves that fail.
#include "io/asi.h"

#include <gtest/gtest.h>

#include "make.h"

namespace merker::io {
namespace {

Module cpWith(std::vector<AsiSlave> slaves) {
  Module cp = make(0, 4, "CP 343-2");
  cp.parameters.diagnosticInterrupt = true;
  cp.asi = std::make_shared<const std::vector<AsiSlave>>(std::move(slaves));
  return cp;
}

std::vector<AsiSlave> allSlaves() {
  std::vector<AsiSlave> slaves;
  for (std::uint32_t address = 1; address <= kHighestAsiAddress; ++address)
    slaves.push_back({.address = address, .name = "S" + std::to_string(address)});
  return slaves;
}

constexpr std::uint32_t kStart = 256;

TEST(AsInterface, ThirtyOneSlavesFillSixteenBytes) {
  Rack rack(good({cpWith(allSlaves())}));
  std::vector<std::uint8_t> expected(16);
  for (std::uint32_t address = 1; address <= kHighestAsiAddress; ++address)
    for (std::uint32_t bit = 0; bit < kAsiBits; ++bit) {
      const auto terminal = rack.terminal("S" + std::to_string(address), Side::DigitalInput, bit);
      ASSERT_TRUE(terminal);
      rack.setLevel(*terminal, true, at(0));
      rack.advance(at(1));
      const std::uint32_t byte = address / 2, shift = address % 2 == 0 ? 4 : 0;
      expected[byte] = static_cast<std::uint8_t>(expected[byte] | 1u << (shift + bit));
      const auto& inputs = rack.inputs();
      EXPECT_TRUE(std::equal(expected.begin(), expected.end(), inputs.begin() + kStart));
    }
  EXPECT_EQ(rack.inputs()[kStart], 0x0F);  // the upper half is the CP's own
}

TEST(AsInterface, OutputsLieAtTheSamePlaces) {
  Rack rack(good({cpWith(allSlaves())}));
  rack.disableOutputs(false);
  const std::uint8_t bytes[] = {0xF1, 0x23};
  rack.written(kStart, bytes, 2);
  const auto levels = [&](const char* slave) {
    unsigned bits = 0;
    for (std::uint32_t i = 0; i < kAsiBits; ++i)
      bits |= unsigned{rack.level(*rack.terminal(slave, Side::DigitalOutput, i))} << i;
    return bits;
  };
  EXPECT_EQ(levels("S1"), 1u);
  EXPECT_EQ(levels("S2"), 2u);
  EXPECT_EQ(levels("S3"), 3u);
  EXPECT_EQ(levels("AS4/4"), 0u);
}

TEST(AsInterface, TheIoCodeSaysWhatIsWhat) {
  // D0 is bit 0.
  constexpr std::pair<unsigned, unsigned> kCodes[] = {
      {0xF, 0x0}, {0x7, 0x8}, {0xF, 0x8}, {0x3, 0xC}, {0xF, 0xC}, {0x1, 0xE},
      {0xF, 0xE}, {0xF, 0xF}, {0x0, 0xF}, {0x8, 0x7}, {0x8, 0xF}, {0xC, 0x3},
      {0xC, 0xF}, {0xE, 0x1}, {0xE, 0xF}, {0x0, 0x0}};
  for (std::uint8_t code = 0; code < std::size(kCodes); ++code) {
    EXPECT_EQ(asiInputs(code), kCodes[code].first) << unsigned{code};
    EXPECT_EQ(asiOutputs(code), kCodes[code].second) << unsigned{code};
  }
}

TEST(AsInterface, TheCpTellsWhichSlavesAreMissing) {
  Rack rack(good({cpWith(allSlaves())}));
  static_cast<void>(rack.takeEvents());
  const Module& cp = *rack.at(kStart, false);
  const auto clear = rack.record1(cp);
  ASSERT_EQ(clear.size(), 16u);
  EXPECT_EQ(clear[0], 0);
  EXPECT_EQ(std::vector<std::uint8_t>(clear.begin() + 4, clear.begin() + 7),
            (std::vector<std::uint8_t>{0x60, 0x00, 0x40}));
  ASSERT_TRUE(rack.fault(*rack.module("S9"), FaultKind::Removed, {}, true));
  const auto record = rack.record1(cp);
  EXPECT_EQ(std::vector<std::uint8_t>(record.begin() + 7, record.end()),
            (std::vector<std::uint8_t>{0, 2, 0, 0, 0, 0, 0, 0, 0}));
  EXPECT_EQ(record[0] & 1, 1);
  auto events = rack.takeEvents();
  ASSERT_EQ(events.size(), 1u);  // OB 82 of the CP, no OB 83 of a slave
  EXPECT_EQ(events[0].kind, ModuleEvent::Kind::DiagnosticComing);
  ASSERT_TRUE(rack.fault(*rack.module("S9"), FaultKind::Removed, {}, false));
  EXPECT_EQ(rack.record1(cp), clear);
  EXPECT_EQ(rack.takeEvents().size(), 1u);
}

TEST(AsInterface, WithoutTheCpNobodyAnswers) {
  Rack rack(good({cpWith(allSlaves())}));
  rack.setLevel(*rack.terminal("S1", Side::DigitalInput, 0), true, at(0));
  rack.advance(at(1));
  EXPECT_EQ(rack.inputs()[kStart], 1);
  rack.fault(*rack.module("4"), FaultKind::LoadVoltage, {}, true);
  EXPECT_EQ(rack.inputs()[kStart], 0);
  rack.fault(*rack.module("4"), FaultKind::LoadVoltage, {}, false);
  EXPECT_EQ(rack.inputs()[kStart], 1);
  rack.fault(*rack.module("4"), FaultKind::Removed, {}, true);
  EXPECT_FALSE(rack.answersInput(kStart));
  EXPECT_FALSE(rack.present(*rack.module("S31")));
}

}  // namespace
}  // namespace merker::io
