#include "catalogue/measuring_range.h"

#include <array>
#include <cctype>
#include <cmath>
#include <string>

namespace merker {
namespace {

// Tables "Representation of analog values" of the module data manual.
constexpr MeasuringRange symmetric(std::string_view name, Quantity quantity, double rated,
                                   int sets) {
  return {name,   quantity, static_cast<std::uint16_t>(sets), -rated, rated, -27648, 27648,
          -32512, 32511};
}
constexpr MeasuringRange unipolar(std::string_view name, Quantity quantity, double low, double high,
                                  int sets, double wireBreak = 0) {
  return {name,  quantity, static_cast<std::uint16_t>(sets), low, high, 0, 27648, -4864,
          32511, wireBreak};
}
constexpr MeasuringRange resistance(std::string_view name, double rated, int sets) {
  return {name, Quantity::Resistance, static_cast<std::uint16_t>(sets), 0, rated, 0, 27648, 0,
          32511};
}
// Parts of a degree: 10 or, in the climatic ranges, 100.
constexpr MeasuringRange temperature(std::string_view name, int sets, int low, int high, int under,
                                     int over, int parts) {
  return {name,         Quantity::Temperature, static_cast<std::uint16_t>(sets),
          double(low),  double(high),          low * parts,
          high * parts, under * parts,         over * parts};
}

using Q = Quantity;
constexpr std::array kRanges{
    symmetric("±10V", Q::Voltage, 10, kVolts | kStandard),
    symmetric("±5V", Q::Voltage, 5, kVolts),
    symmetric("±2.5V", Q::Voltage, 2.5, kVolts),
    symmetric("±1V", Q::Voltage, 1, kVolts),
    symmetric("±500mV", Q::Voltage, 0.5, kVolts),
    symmetric("±250mV", Q::Voltage, 0.25, kVolts),
    symmetric("±80mV", Q::Voltage, 0.08, kVolts),
    unipolar("0..10V", Q::Voltage, 0, 10, kStandard | kFixed),
    unipolar("1..5V", Q::Voltage, 1, 5, kVolts | kFiveVolts),
    symmetric("±20mA", Q::Current, 20, kCurrents | kStandard),
    symmetric("±10mA", Q::Current, 10, kCurrents),
    symmetric("±3.2mA", Q::Current, 3.2, kCurrents),
    unipolar("0..20mA", Q::Current, 0, 20, kCurrents | kStandard | kFixed),
    unipolar("4..20mA", Q::Current, 4, 20, kCurrents | kStandard, 3.6),
    temperature("Pt100", kThermometers | kOnBoardResistor, -200, 850, -243, 1000, 10),
    resistance("600Ohm", 600, kResistances | kOnBoardResistor),
    resistance("300Ohm", 300, kResistances),
    resistance("150Ohm", 150, kResistances),
    temperature("Pt100 climatic", kThermometers, -120, 130, -145, 155, 100),
    temperature("Ni100", kThermometers, -60, 250, -105, 295, 10),
    temperature("Ni100 climatic", kThermometers, -60, 250, -105, 295, 100),
    temperature("Type K", kThermocouples, -270, 1372, -270, 1622, 10),
    temperature("Type J", kThermocouples, -210, 1200, -210, 1450, 10),
    temperature("Type E", kThermocouples, -270, 1000, -270, 1200, 10),
    temperature("Type N", kThermocouples, -270, 1300, -270, 1550, 10),
    temperature("Type L", kThermocouples, -200, 900, -200, 1150, 10)};

void replaceAll(std::string& text, std::string_view old, std::string_view other) {
  for (std::size_t at = 0; (at = text.find(old, at)) != std::string::npos; at += other.size())
    text.replace(at, old.size(), other);
}

std::string rangeName(std::string_view name) {
  std::string text;
  for (const char c : name)
    if (c != ' ') text += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  replaceAll(text, "+/-", "±");
  replaceAll(text, "+-", "±");
  replaceAll(text, "Ω", "ohm");
  return text;
}

}  // namespace

std::string_view unitOf(Quantity quantity) {
  constexpr std::array<std::string_view, 4> kUnits{"V", "mA", "Ohm", "degC"};
  return kUnits[static_cast<std::size_t>(quantity)];
}

std::span<const MeasuringRange> measuringRanges() { return kRanges; }

const MeasuringRange* findMeasuringRange(std::string_view name) {
  const std::string wanted = rangeName(name);
  for (const MeasuringRange& range : kRanges)
    if (rangeName(range.name) == wanted) return &range;
  return nullptr;
}

std::int16_t toShown(const MeasuringRange& range, double amount, unsigned bits,
                     bool wireBreakCheck) {
  if (wireBreakCheck && amount < range.wireBreak) return kOverflow;
  const double part = (amount - range.low) / (range.high - range.low);
  const double exact = range.shownLow + part * (range.shownHigh - range.shownLow);
  if (exact > range.highest + 0.5) return kOverflow;
  if (exact < range.lowest - 0.5) return kUnderflow;
  const auto shown = static_cast<std::int32_t>(std::lround(exact));
  const bool whole = range.quantity == Quantity::Temperature;
  return static_cast<std::int16_t>(whole ? shown : shown & ~((1 << (15 - bits)) - 1));
}

// Beyond the overrange an output is without voltage and current; a unipolar one never goes below 0.
double toAmount(const MeasuringRange& range, std::int16_t shown) {
  if (shown > range.highest || (range.low < 0 && shown < range.lowest)) return 0;
  const double part = double(shown - range.shownLow) / (range.shownHigh - range.shownLow);
  const double amount = range.low + part * (range.high - range.low);
  return range.low >= 0 && amount < 0 ? 0 : amount;
}

}  // namespace merker
