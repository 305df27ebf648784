#include "io/analog_inputs.h"

#include <algorithm>

namespace merker::io {
namespace {

// Without supply or with a fault of its own the module measures nothing.
constexpr std::uint16_t kDead = bitOf(FaultKind::LoadVoltage) | bitOf(FaultKind::Defect);

}  // namespace

Duration conversionCycle(const Module& module) {
  std::int64_t active = 0;
  for (std::uint32_t c = 0; c < module.type->analogInputs; ++c)
    active += module.parameters.analogInputs[c].range != nullptr ? 1 : 0;
  return Duration::microseconds(module.type->conversionTime) * active;
}

std::uint32_t AnalogInputs::takeDue(Instant at) {
  std::uint32_t channels = 0;
  if (soonest_ > at) return channels;
  for (std::uint32_t c = 0; c < due_.size(); ++c) {
    if (due_[c] > at) continue;
    due_[c] = Instant::never();
    channels |= 1u << c;
  }
  soonest_ = *std::ranges::min_element(due_);
  return channels;
}

// The amount as the channel sees it, with the faults that change it. An open voltage input,
// resistor or thermocouple drifts to overflow; a current loop that is open carries 0 mA.
std::int16_t AnalogInputs::measure(const Module& module, std::uint32_t channel,
                                   const ModuleFaults& faults) const {
  const AnalogInput& input = module.parameters.analogInputs[channel];
  if (input.range == nullptr || faults.hasAny(kDead)) return kOverflow;
  const std::uint16_t put = faults.putAt(channel);
  if ((put & bitOf(FaultKind::Overflow)) != 0) return kOverflow;
  if ((put & bitOf(FaultKind::Underflow)) != 0) return kUnderflow;
  const bool broken = (put & bitOf(FaultKind::WireBreak)) != 0;
  if (broken && input.range->quantity != Quantity::Current) return kOverflow;
  return toShown(*input.range, broken ? 0 : amounts_[channel], module.type->bits(*input.range),
                 input.wireBreakCheck);
}

Converted AnalogInputs::convert(const Module& module, std::uint32_t channel,
                                const ModuleFaults& faults) {
  const AnalogInput& input = module.parameters.analogInputs[channel];
  Converted result;
  result.shown = measure(module, channel, faults);
  const bool active = input.range != nullptr && !faults.hasAny(kDead);
  const bool broken = active && input.wireBreakCheck && result.shown == kOverflow &&
                      amounts_[channel] < input.range->wireBreak;
  if (broken) result.faults = bitOf(FaultKind::WireBreak);
  if (active && !broken && result.shown == kOverflow && faults.putAt(channel) == 0)
    result.faults = bitOf(FaultKind::Overflow);
  if (active && result.shown == kUnderflow) result.faults = bitOf(FaultKind::Underflow);
  result.limits = exceed(module, channel, result.shown);
  return result;
}

// POINT_ADDR of OB 40: LB 8 upper limits, LB 9 lower limits, a bit for each channel (module data
// manual, SM 331 hardware interrupts).
std::uint32_t AnalogInputs::exceed(const Module& module, std::uint32_t channel,
                                   std::int16_t shown) {
  constexpr std::uint32_t kUpper = 24, kLower = 16;
  const AnalogInput& input = module.parameters.analogInputs[channel];
  const auto limit = [&](const std::optional<double>& amount) {
    return toShown(*input.range, *amount, module.type->bits(*input.range), false);
  };
  const std::uint32_t upper = 1u << (kUpper + channel), lower = 1u << (kLower + channel);
  std::uint32_t beyond = beyond_ & ~(upper | lower);
  if (input.upperLimit && shown > limit(input.upperLimit)) beyond |= upper;
  if (input.lowerLimit && shown < limit(input.lowerLimit)) beyond |= lower;
  const std::uint32_t fresh = beyond & ~beyond_;
  beyond_ = beyond;
  return fresh;
}

}  // namespace merker::io
