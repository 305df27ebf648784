// Parameters of the sub-module 2.5 "Positioning" (technology manual 3.2.3 to 3.2.7, 4.2.3 to
// 4.2.7; POS-PARAM). Lengths are in pulses, a quarter of an increment of the encoder; times in ms.
#pragma once

#include <cstdint>

namespace merker::io {

// By which outputs the drive is controlled: SFB 44 or SFB 46.
enum class AxisOutput : std::uint8_t { Analog, Digital };
enum class AnalogControl : std::uint8_t { Bipolar, WithDirection };  // +-10 V; 0 to 10 V and sign
// Which edges begin and end a measurement of a length.
enum class LengthEdges : std::uint8_t { Off, Rising, Falling, RisingFalling, FallingRising };

// One switch for each monitoring function; POS-MON.
struct AxisMonitors {
  bool missingPulse = false, travel = false, workingRange = false;
  bool movement = false, approach = false, targetRange = false;
};

struct AxisChannel {
  AxisOutput output = AxisOutput::Analog;
  bool diagnosticInterrupt = false;
  // drive
  std::int32_t targetRange = 50;
  std::int32_t monitoringTime = 2000;
  std::int32_t highestSpeed = 1000, creepSpeed = 100;           // pulses/s; analog
  std::int32_t cutOffDelay = 1000;                              // analog
  std::uint32_t maxFrequency = 60, accompanyingFrequency = 10;  // kHz
  AnalogControl analogControl = AnalogControl::Bipolar;
  std::uint8_t digitalControl = 1;  // control types 1 to 4
  // axis
  bool rotary = false;
  std::int32_t lowLimit = -100'000'000, highLimit = 100'000'000;  // software limit switches; linear
  std::int32_t rotaryEnd = 100'000;
  LengthEdges lengthEdges = LengthEdges::Off;
  std::int32_t reference = 0;         // coordinate of the reference point
  bool referenceBelowSwitch = false;  // seen from the switch it lies in the direction minus
  // encoder
  std::int32_t increments = 1000;
  bool inverted = false;  // rising counts are falling positions
  AxisMonitors monitors{.travel = true, .workingRange = true, .movement = true};
  AxisMonitors interrupts{};
};

}  // namespace merker::io
