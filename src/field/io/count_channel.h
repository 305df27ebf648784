// Parameters of a channel of the sub-module 2.4 (technology manual 5.3.3 to 5.3.5). Which of them
// mean something depends on the mode.
#pragma once

#include <cstdint>

namespace merker::io {

enum class CountMode : std::uint8_t { None, Endless, Once, Periodic, Frequency, PulseWidth };
enum class CountDirection : std::uint8_t { None, Forward, Backward };
enum class Evaluation : std::uint8_t { PulseDirection, Single, Double, Quadruple };
// Behaviour of the output: when counting, and when measuring a frequency.
enum class CountOutput : std::uint8_t { None, AtLeast, AtMost, Pulse };
enum class LimitOutput : std::uint8_t { None, Outside, Below, Above };

// Causes of a hardware interrupt, one bit each; the first four as they lie in OB40_POINT_ADDR
// (CNT-PRAL-03 to -06).
enum CountCause : std::uint8_t {
  kGateOpened = 1,
  kGateClosed = 2,
  kCountLimit = 4,  // counting: overflow or underflow
  kComparator = 8,
  kLimit = 4,  // frequency: above or below
  kMeasured = 8,
  kCountEdge = 16
};

struct CountChannel {
  CountMode mode = CountMode::None;
  std::uint32_t maxFrequency = 0, latchFrequency = 0;  // kHz; sets the input filter
  Evaluation evaluation = Evaluation::PulseDirection;
  bool hardwareGate = false, inverted = false;
  // hardware interrupts
  bool onGateOpened = false, onGateClosed = false;
  bool onComparator = false, onOverflow = false, onUnderflow = false, onCountEdge = false;
  bool onLowLimit = false, onHighLimit = false, onMeasured = false;
  // counting
  CountDirection direction = CountDirection::None;
  std::int32_t endValue = 2'147'483'647;  // forward: end value, backward: start value
  bool interruptGate = false;             // else the gate function is "cancel"
  std::int32_t comparison = 0;
  std::int32_t hysteresis = 0;
  CountOutput output = CountOutput::None;
  std::int32_t pulseDuration = 0;  // ms
  bool showPeriod = false;         // input data: period duration
  bool microseconds = false;       // its time base: 1 us, else 125 ns
  // frequency
  std::int32_t integrationTime = 100;        // ms
  std::int32_t lowLimit = 0, highLimit = 0;  // mHz
  bool averaged = false;
  LimitOutput limitOutput = LimitOutput::None;
  // pulse width
  bool analogFormat = false;  // output value to 27648, else per mille
  bool milliseconds = false;  // time base 1 ms, else 0.1 ms
  std::int32_t onDelay = 0, period = 20'000, minimumPulse = 2;  // in the time base
};

}  // namespace merker::io
