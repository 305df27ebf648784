// Counting channels of the compact CPUs as rows: where they are wired and how fast they count
// (technology manual 5.2.2, 5.3.3 and 5.10.1; CNT-OVW-01, -03, CNT-PIN-01 to -09).
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "catalogue/cpu_model.h"

namespace merker {

// A terminal of the digital sub-module 2.2: channel (8 x byte + bit) and pin of the connector.
struct CountingPin {
  std::uint8_t channel = 0, pin = 0;
};

struct CountingPins {
  CountingPin a, b, gate, latch;  // inputs
  CountingPin output;
};

// kHz: only with this maximum count edges and periods are measured (CNT-PARAM-16, -17, -19).
inline constexpr std::uint32_t kMeasuringFrequency = 1;

struct CountingType {
  std::string_view connector;                  // "X1", where all of them are
  std::span<const CountingPins> channels;      // 2, 3 or 4
  std::span<const std::uint32_t> frequencies;  // kHz that can be set, the highest first
};

// Null for a CPU that does not count.
const CountingType* countingType(const CpuModel& model);

}  // namespace merker
