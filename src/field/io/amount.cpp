#include "io/amount.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <span>

#include "base/text.h"

namespace merker::io {
namespace {

struct UnitName {
  std::string_view name;
  double factor;
};

constexpr UnitName kTimes[] = {{"us", 1e3}, {"ms", 1e6}, {"s", 1e9}, {"m", 60e9}, {"h", 3600e9}};
constexpr UnitName kVoltages[] = {{"V", 1}, {"mV", 0.001}};
constexpr UnitName kCurrents[] = {{"mA", 1}};
constexpr UnitName kResistances[] = {{"Ohm", 1}, {"Ω", 1}, {"kOhm", 1000}};
constexpr UnitName kTemperatures[] = {{"degC", 1}, {"°C", 1}, {"C", 1}};
constexpr UnitName kLengths[] = {{"m", 1}, {"cm", 0.01}};

std::span<const UnitName> unitsOf(Quantity quantity) {
  switch (quantity) {
    case Quantity::Voltage:
      return kVoltages;
    case Quantity::Current:
      return kCurrents;
    case Quantity::Resistance:
      return kResistances;
    case Quantity::Temperature:
      return kTemperatures;
  }
  return {};
}

// A number and one of the units behind it.
std::optional<double> parse(std::string_view text, std::span<const UnitName> units) {
  text = trim(text);
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || !std::isfinite(value)) return std::nullopt;
  const std::string_view unit = trim(text.substr(static_cast<std::size_t>(end - text.data())));
  for (const UnitName& row : units)
    if (equalsIgnoreCase(row.name, unit)) return value * row.factor;
  return std::nullopt;
}

}  // namespace

std::optional<Duration> parseLength(std::string_view text) {
  const auto value = parse(text, kTimes);
  if (!value || *value < 0 || *value > 1e18) return std::nullopt;
  return Duration{std::llround(*value)};
}

std::string formatLength(Duration length) {
  if (length.ns >= 1'000'000'000 && length.ns % 1'000'000'000 == 0)
    return fmt::format("{}s", length.ns / 1'000'000'000);
  return fmt::format("{:g}ms", static_cast<double>(length.ns) / 1e6);
}

std::optional<double> parseAmount(std::string_view text, Quantity quantity) {
  return parse(text, unitsOf(quantity));
}

std::string formatAmount(double amount, Quantity quantity) {
  return fmt::format("{:g}{}", amount, unitOf(quantity));
}

std::optional<double> parseMetres(std::string_view text) { return parse(text, kLengths); }

}  // namespace merker::io
