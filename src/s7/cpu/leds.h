// The LEDs on the front and what lights them (S7-CPU-31).
#pragma once

#include <cstdint>

#include "clock/instant.h"

namespace merker::cpu {

enum class Light : std::uint8_t { Off, On, Slow, Fast };  // Slow 0.5 Hz, Fast 2 Hz

struct Leds {
  Light sf = Light::Off;    // red: group error
  Light bf = Light::Off;    // red: a rack or station does not answer
  Light batf = Light::Off;  // red: battery
  Light dc5v = Light::Off;  // green: 5 V supply
  Light frce = Light::Off;  // yellow: forces are active
  Light run = Light::Off;   // green
  Light stop = Light::Off;  // yellow
  bool operator==(const Leds&) const = default;
};

// Whether one sees it shine at this moment. Blinking begins dark with each period.
bool shines(Light light, Instant now);

}  // namespace merker::cpu
