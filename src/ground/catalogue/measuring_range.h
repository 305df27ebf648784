// Measuring and output ranges of analog channels and how S7 shows them in 16 bits (S7-CPU-19).
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace merker {

enum class Quantity : std::uint8_t { Voltage, Current, Resistance, Temperature };

// "V", "mA", "Ohm", "degC": the unit in which amounts of this quantity are numbers.
std::string_view unitOf(Quantity quantity);

// Groups of ranges; what a channel can be set to is a sum of them.
enum RangeSet : std::uint16_t {
  kVolts = 1,         // ±80mV … ±10V, 1..5V
  kCurrents = 2,      // ±3.2mA … ±20mA, 0..20mA, 4..20mA
  kResistances = 4,   // 150Ohm, 300Ohm, 600Ohm
  kThermometers = 8,  // Pt100, Ni100
  kThermocouples = 16,
  kStandard = 32,         // ±10V, 0..10V, ±20mA, 0..20mA, 4..20mA: on board, analog outputs
  kFiveVolts = 64,        // 1..5V of an analog output
  kFixed = 128,           // 0..10V, 0..20mA: modules whose range is chosen by the wiring
  kOnBoardResistor = 256  // 600Ohm, Pt100: the fifth analog input on board
};

struct MeasuringRange {
  std::string_view name;  // "4..20mA"
  Quantity quantity;
  std::uint16_t sets;  // RangeSet
  double low, high;    // rated ends, in the unit
  // What the module shows at `low` and `high`: 0 and 27648, or parts of a degree.
  std::int32_t shownLow, shownHigh;
  // Last values before underflow (-32768) and overflow (32767).
  std::int32_t lowest, highest;
  double wireBreak = 0;  // with the check, an amount below this shows 32767; 0 = no check possible
};

std::span<const MeasuringRange> measuringRanges();
// Ignores blanks and case; "+-10V" is "±10V". Null if unknown.
const MeasuringRange* findMeasuringRange(std::string_view name);

inline constexpr std::int16_t kOverflow = 32767, kUnderflow = -32768;

// An amount at the terminal as the module shows it. `bits` is the resolution without sign: bits
// below it are 0; temperatures are shown in full.
std::int16_t toShown(const MeasuringRange& range, double amount, unsigned bits,
                     bool wireBreakCheck);
// What an output channel puts out, in the unit of the range; nothing beyond its limits.
double toAmount(const MeasuringRange& range, std::int16_t shown);

}  // namespace merker
