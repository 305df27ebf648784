// Analog inputs of a module: amounts at the terminals, their conversion and limits (S7-CPU-19).
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "clock/instant.h"
#include "io/configuration.h"
#include "io/module_faults.h"

namespace merker::io {

// What a conversion gives.
struct Converted {
  std::int16_t shown = 0;
  std::uint16_t faults = 0;  // that the module sees in the value, as bits
  std::uint32_t limits = 0;  // that are exceeded now and were not before, bits as in POINT_ADDR
};

class AnalogInputs {
 public:
  AnalogInputs() { due_.fill(Instant::never()); }

  double amount(std::uint32_t channel) const { return amounts_[channel]; }
  void set(std::uint32_t channel, double amount) { amounts_[channel] = amount; }
  void convertAt(std::uint32_t channel, Instant due) {
    due_[channel] = due;
    soonest_ = *std::ranges::min_element(due_);
  }
  // A conversion of this channel is under way: it takes the amount that stands at its end.
  bool converts(std::uint32_t channel, Instant now) const {
    return due_[channel] > now && due_[channel] < Instant::never();
  }
  Instant next() const { return soonest_; }
  std::uint32_t takeDue(Instant at);  // channels, as bits

  Converted convert(const Module& module, std::uint32_t channel, const ModuleFaults& faults);

 private:
  std::int16_t measure(const Module& module, std::uint32_t channel,
                       const ModuleFaults& faults) const;
  std::uint32_t exceed(const Module& module, std::uint32_t channel, std::int16_t shown);

  std::array<double, 8> amounts_{};
  std::array<Instant, 8> due_;          // when the next conversion ends
  Instant soonest_ = Instant::never();  // of them
  std::uint32_t beyond_ = 0;            // bits as in POINT_ADDR: limits that are exceeded now
};

// All channels are converted one after the other; an amount shows after the next whole cycle.
// 0: all are deactivated.
Duration conversionCycle(const Module& module);

}  // namespace merker::io
