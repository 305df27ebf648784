// What a start of a run fixes until its end (POS-RUN-03, POS-RUN-23), and the units of the channel:
// positions in pulses, speeds of set-points in thousandths of a pulse per second (POS-PLANT-02).
#pragma once

#include <cstdint>

#include "clock/instant.h"
#include "io/axis_channel.h"

namespace merker::positioning {

// Set-points, switching points and monitoring are processed so often (POS-RUN-02).
constexpr Duration kCycle = Duration::milliseconds(4);
constexpr std::int64_t kMillisecondsPerCycle = 4;
constexpr std::int64_t kThousandths = 1000;  // of a pulse per second
// The range of positions that the CPU can process (POS-PARAM-16).
constexpr std::int64_t kTravelLimit = 500'000'000;

enum class Mode : std::uint8_t { None = 0, Jog = 1, Reference = 3, Relative = 4, Absolute = 5 };

// Directions are 1 (plus: positions rise) and -1.
template <typename Value>
struct PerDirection {
  Value plus{}, minus{};
  const Value& of(int direction) const { return direction > 0 ? plus : minus; }
};

// How far before the target a run changes over to creep speed and is cut off (POS-RUN-05).
struct Differences {
  std::int32_t changeover = 1000, cutOff = 100;
};

struct Motion {
  std::int32_t speed = 1000;                            // analog: pulses/s
  bool rapid = false;                                   // digital
  std::int32_t acceleration = 100, deceleration = 100;  // analog: pulses/s^2
  PerDirection<Differences> differences;
};

// Cycles that a time lasts: rounded up (POS-PARAM-04, POS-PARAM-07).
constexpr std::int64_t cyclesOf(std::int32_t milliseconds) {
  return (milliseconds + kMillisecondsPerCycle - 1) / kMillisecondsPerCycle;
}

// Half of the target range, which the CPU rounds up to an even number (POS-PARAM-02).
constexpr std::int64_t halfRange(const io::AxisChannel& parameters) {
  return (std::int64_t{parameters.targetRange} + 1) / 2;
}

}  // namespace merker::positioning
