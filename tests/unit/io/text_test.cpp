// Amounts, lengths of time and terminals as merker.toml and scenarios write them.
#include <gtest/gtest.h>

#include "io/amount.h"
#include "io/terminal.h"

namespace merker::io {
namespace {

TEST(Amount, unitsOfEachQuantity) {
  EXPECT_DOUBLE_EQ(*parseAmount("5.5V", Quantity::Voltage), 5.5);
  EXPECT_DOUBLE_EQ(*parseAmount("80 mV", Quantity::Voltage), 0.08);
  EXPECT_DOUBLE_EQ(*parseAmount("-80MV", Quantity::Voltage), -0.08);
  EXPECT_DOUBLE_EQ(*parseAmount("18mA", Quantity::Current), 18);
  EXPECT_DOUBLE_EQ(*parseAmount("120Ohm", Quantity::Resistance), 120);
  EXPECT_DOUBLE_EQ(*parseAmount("120Ω", Quantity::Resistance), 120);
  EXPECT_DOUBLE_EQ(*parseAmount("1.2kOhm", Quantity::Resistance), 1200);
  EXPECT_DOUBLE_EQ(*parseAmount(" -20.5degC ", Quantity::Temperature), -20.5);
  EXPECT_DOUBLE_EQ(*parseAmount("20°C", Quantity::Temperature), 20);
  EXPECT_DOUBLE_EQ(*parseAmount("20C", Quantity::Temperature), 20);
  for (const char* wrong : {"", "V", "5", "5mA", "5 V x", "nanV", "infV", "1e999V"})
    EXPECT_FALSE(parseAmount(wrong, Quantity::Voltage)) << wrong;
  EXPECT_FALSE(parseAmount("5V", Quantity::Current));
}

TEST(Amount, asText) {
  EXPECT_EQ(formatAmount(5.5, Quantity::Voltage), "5.5V");
  EXPECT_EQ(formatAmount(4, Quantity::Current), "4mA");
  EXPECT_EQ(formatAmount(-20.5, Quantity::Temperature), "-20.5degC");
  EXPECT_EQ(formatAmount(120, Quantity::Resistance), "120Ohm");
}

TEST(Length, ofTime) {
  EXPECT_EQ(parseLength("0.1ms")->ns, 100'000);
  EXPECT_EQ(parseLength("1us")->ns, 1'000);
  EXPECT_EQ(parseLength("150ms")->ns, 150'000'000);
  EXPECT_EQ(parseLength("2s")->ns, 2'000'000'000);
  EXPECT_EQ(parseLength("1m")->ns, 60'000'000'000);
  EXPECT_EQ(parseLength("1h")->ns, 3'600'000'000'000);
  EXPECT_EQ(parseLength("0s")->ns, 0);
  EXPECT_EQ(parseLength("1000000000s")->ns, 1'000'000'000'000'000'000);
  for (const char* wrong : {"", "5", "-1s", "1d", "1000000001s"})
    EXPECT_FALSE(parseLength(wrong)) << wrong;
  EXPECT_EQ(formatLength(Duration::seconds(2)), "2s");
  EXPECT_EQ(formatLength(Duration::seconds(1)), "1s");
  EXPECT_EQ(formatLength(Duration::milliseconds(150)), "150ms");
  EXPECT_EQ(formatLength(Duration::milliseconds(1500)), "1500ms");
  EXPECT_EQ(formatLength(Duration::microseconds(100)), "0.1ms");
  EXPECT_EQ(formatLength({}), "0ms");
}

TEST(Length, ofCables) {
  EXPECT_DOUBLE_EQ(*parseMetres("7.5m"), 7.5);
  EXPECT_DOUBLE_EQ(*parseMetres("50cm"), 0.5);
  EXPECT_FALSE(parseMetres("7.5"));
  EXPECT_FALSE(parseMetres("7.5mm"));
}

TEST(TerminalName, sidesAndChannels) {
  const auto name = parseTerminal("Panel.DI3");
  ASSERT_TRUE(name);
  EXPECT_EQ(name->module, "Panel");
  EXPECT_EQ(name->side, Side::DigitalInput);
  EXPECT_EQ(name->channel, 3u);
  EXPECT_EQ(parseTerminal("2.2.do15")->module, "2.2");
  EXPECT_EQ(parseTerminal("2.2.do15")->side, Side::DigitalOutput);
  EXPECT_EQ(parseTerminal("2.2.do15")->channel, 15u);
  EXPECT_EQ(parseTerminal("\"Fill level\".AI0")->module, "Fill level");
  EXPECT_EQ(parseTerminal("\"Fill level\".AI0")->side, Side::AnalogInput);
  EXPECT_EQ(parseTerminal("4.AO1")->side, Side::AnalogOutput);
  for (const char* wrong : {"", "DI3", ".DI3", "4.", "4.DI", "4.DX3", "4.DI3x", "4.D3", "4.DI-1"})
    EXPECT_FALSE(parseTerminal(wrong)) << wrong;
}

}  // namespace
}  // namespace merker::io
