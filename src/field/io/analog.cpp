// Analog channels: conversion, limits, outputs with their substitute values (S7-CPU-19).
#include "base/bytes.h"
#include "io/rack.h"

namespace merker::io {

// All channels are converted one after the other; an amount shows after the next whole cycle.
Duration Rack::conversionCycle(std::uint32_t index) const {
  const Module& module = of(index);
  std::int64_t active = 0;
  for (std::uint32_t c = 0; c < module.type->analogInputs; ++c)
    active += module.parameters.analogInputs[c].range != nullptr ? 1 : 0;
  return Duration::microseconds(module.type->conversionTime) * active;
}

void Rack::setAmount(Terminal terminal, double amount, Instant now) {
  if (terminal.side != Side::AnalogInput) return;
  Unit& unit = units_[terminal.module];
  unit.amounts[terminal.channel] = amount;
  const std::int64_t cycle = conversionCycle(terminal.module).ns;
  if (cycle == 0) return;  // all channels deactivated
  unit.amountDue[terminal.channel] = Instant{(now.ns / cycle + 1) * cycle};
  findNext();
}

double Rack::amount(Terminal terminal) const {
  if (terminal.side == Side::AnalogOutput) return outputAmount(terminal.module, terminal.channel);
  return terminal.side == Side::AnalogInput ? units_[terminal.module].amounts[terminal.channel] : 0;
}

const MeasuringRange* Rack::range(Terminal terminal) const {
  const Parameters& parameters = of(terminal.module).parameters;
  if (terminal.side == Side::AnalogInput) return parameters.analogInputs[terminal.channel].range;
  if (terminal.side == Side::AnalogOutput) return parameters.analogOutputs[terminal.channel].range;
  return nullptr;
}

// The amount as the channel sees it, with the faults that change it. An open voltage input,
// resistor or thermocouple drifts to overflow; a current loop that is open carries 0 mA.
std::int16_t Rack::measure(std::uint32_t index, std::uint32_t channel) const {
  const Unit& unit = units_[index];
  const AnalogInput& input = of(index).parameters.analogInputs[channel];
  if (input.range == nullptr || unit.has(FaultKind::LoadVoltage) || unit.has(FaultKind::Defect))
    return kOverflow;
  const std::uint16_t faults = unit.channelFaults[channel];
  if ((faults & bitOf(FaultKind::Overflow)) != 0) return kOverflow;
  if ((faults & bitOf(FaultKind::Underflow)) != 0) return kUnderflow;
  const bool broken = (faults & bitOf(FaultKind::WireBreak)) != 0;
  if (broken && input.range->quantity != Quantity::Current) return kOverflow;
  return toShown(*input.range, broken ? 0 : unit.amounts[channel],
                 of(index).type->bits(*input.range), input.wireBreakCheck);
}

void Rack::show(std::uint32_t index, std::uint32_t channel, std::int16_t shown) {
  units_[index].shown[channel] = shown;
  const std::uint32_t byte = *of(index).inputStart + 2 * channel;
  const auto word = static_cast<std::uint16_t>(present(index) ? shown : 0);
  setInput(byte, static_cast<std::uint8_t>(word >> 8));
  setInput(byte + 1, static_cast<std::uint8_t>(word));
}

void Rack::convert(std::uint32_t index, std::uint32_t channel) {
  Unit& unit = units_[index];
  const AnalogInput& input = of(index).parameters.analogInputs[channel];
  const std::int16_t shown = measure(index, channel);
  show(index, channel, shown);
  // Without supply or with a fault of its own the module measures nothing.
  const bool active =
      input.range != nullptr && !unit.has(FaultKind::LoadVoltage) && !unit.has(FaultKind::Defect);
  const bool broken = active && input.wireBreakCheck && shown == kOverflow &&
                      unit.amounts[channel] < input.range->wireBreak;
  std::uint16_t seen = 0;
  if (broken) seen = bitOf(FaultKind::WireBreak);
  if (active && !broken && shown == kOverflow && unit.channelFaults[channel] == 0)
    seen = bitOf(FaultKind::Overflow);
  if (active && shown == kUnderflow) seen = bitOf(FaultKind::Underflow);
  unit.measuredFaults[channel] = seen;
  checkLimits(index, channel);
}

// POINT_ADDR of OB 40: LB 8 upper limits, LB 9 lower limits, a bit for each channel (module data
// manual, SM 331 hardware interrupts).
void Rack::checkLimits(std::uint32_t index, std::uint32_t channel) {
  constexpr std::uint32_t kUpper = 24, kLower = 16;
  Unit& unit = units_[index];
  const AnalogInput& input = of(index).parameters.analogInputs[channel];
  const auto limit = [&](const std::optional<double>& amount) {
    return toShown(*input.range, *amount, of(index).type->bits(*input.range), false);
  };
  const std::uint32_t upper = 1u << (kUpper + channel), lower = 1u << (kLower + channel);
  std::uint32_t beyond = unit.beyond & ~(upper | lower);
  if (input.upperLimit && unit.shown[channel] > limit(input.upperLimit)) beyond |= upper;
  if (input.lowerLimit && unit.shown[channel] < limit(input.lowerLimit)) beyond |= lower;
  const std::uint32_t fresh = beyond & ~unit.beyond;
  unit.beyond = beyond;
  interrupt(index, fresh);
}

double Rack::outputAmount(std::uint32_t index, std::uint32_t channel) const {
  const Module& module = of(index);
  const Unit& unit = units_[index];
  const AnalogOutput& output = module.parameters.analogOutputs[channel];
  const bool dead = unit.has(FaultKind::LoadVoltage) || unit.has(FaultKind::Defect);
  if (output.range == nullptr || !supplied_ || dead || !present(index)) return 0;
  if (unit.has(channel, FaultKind::ShortCircuit) || unit.has(channel, FaultKind::WireBreak))
    return 0;
  const OnStop onStop = module.parameters.onStop;
  if (outputsDisabled_ && onStop == OnStop::Zero) return 0;  // without voltage and current
  if (outputsDisabled_ && onStop == OnStop::Substitute) return output.substitute;
  const auto& bytes = outputsDisabled_ ? kept_ : outputs_;
  const std::uint16_t word = loadWord(&bytes[*module.outputStart + 2 * channel]);
  const int unused = (1 << (15 - module.type->bits(*output.range))) - 1;
  return toAmount(*output.range, static_cast<std::int16_t>(word & ~unused));
}

}  // namespace merker::io
