// The time raster of the control: sampling time of the position control, IPO clock, call of OB 1,
// and what the bases of the timers really last in it (S5-SCHED-T1, -T2).
#pragma once

#include <cstdint>

#include "clock/instant.h"
#include "mc5/instruction.h"
#include "softplc/timer.h"

namespace merker::sinumerik {

// Software version, as far as the PLC differs: 1, or from SW 2.3 (T/M) and SW 2 (N) on.
enum class Software : std::uint8_t { Sw1, Sw2 };

constexpr int kSamplesPerIpo = 4;

struct Raster {
  Duration sampling;  // Servoabtastzeit; also the raster of alarms and timers
  Duration ipo;       // IPO-Takt
  unsigned factor;    // IPO clocks between calls of OB 1
  Duration call;      // Aufrufraster
  TimeBases timeBases;
};

// `samplingCode`: MD 155 of the NC, 0..5. `callFactor`: PLC-MD 2, which COP does not look at.
Raster makeRaster(std::uint8_t samplingCode, unsigned callFactor, mc5::Variant variant,
                  Software software);

}  // namespace merker::sinumerik
