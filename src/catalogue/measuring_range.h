// Measuring and output ranges of analog channels and how S7 shows them in 16 bits (S7-CPU-19).
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace merker {

enum class Quantity : std::uint8_t { Voltage, Current, Resistance, Temperature };

// "V", "mA", "Ohm", "degC": the unit in which amounts of this quantity are numbers.
std::string_view unitOf(Quantity quantity);

struct MeasuringRange {
  std::string_view name;  // "4..20mA"
  Quantity quantity;
  double low, high;  // rated ends, in the unit
  // What the module shows at `low` and `high`: 0 and 27648, or tenths of a degree.
  std::int32_t shownLow, shownHigh;
  // Last values before underflow (-32768) and overflow (32767).
  std::int32_t lowest, highest;
  // With wire break check an amount below this shows 32767 (4..20mA: 3.6 mA); 0 = no check.
  double wireBreak;
};

std::span<const MeasuringRange> measuringRanges();
// Ignores blanks and case; "+-10V" is "±10V". Null if unknown.
const MeasuringRange* findMeasuringRange(std::string_view name);

inline constexpr std::int16_t kOverflow = 32767, kUnderflow = -32768;

// An amount at the terminal as the module shows it. `bits` is the resolution without sign: bits
// below it are 0; temperatures are shown in full.
std::int16_t toShown(const MeasuringRange& range, double amount, unsigned bits,
                     bool wireBreakCheck);
// What an output channel puts out, in the unit of the range; held within its limits.
double toAmount(const MeasuringRange& range, std::int16_t shown);

}  // namespace merker
