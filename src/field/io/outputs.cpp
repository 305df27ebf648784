// Outputs between the bytes from the CPU and their terminals, with their substitute values; both
// sides of a terminal as they can be read.
#include "io/rack.h"

namespace merker::io {

bool Rack::level(Terminal terminal) const {
  if (terminal.side == Side::DigitalOutput) return outputLevel(terminal.module, terminal.channel);
  return terminal.side == Side::DigitalInput &&
         units_[terminal.module].digital.level(terminal.channel);
}

double Rack::amount(Terminal terminal) const {
  if (terminal.side == Side::AnalogOutput) return outputAmount(terminal.module, terminal.channel);
  return terminal.side == Side::AnalogInput
             ? units_[terminal.module].analog.amount(terminal.channel)
             : 0;
}

const MeasuringRange* Rack::range(Terminal terminal) const {
  const Parameters& parameters = of(terminal.module).parameters;
  const bool output = terminal.side == Side::AnalogOutput;
  if (output && isOfAxis(configuration_, of(terminal.module), terminal.channel))
    return findMeasuringRange("±10V");  // POS-WIRE-05
  if (terminal.side == Side::AnalogInput) return parameters.analogInputs[terminal.channel].range;
  if (terminal.side == Side::AnalogOutput) return parameters.analogOutputs[terminal.channel].range;
  return nullptr;
}

// Nothing can be written to the sub-module 2.4 (CNT-PIO-04).
bool Rack::answersOutput(std::uint32_t byte) const {
  const auto owner = outputs_.owner(byte);
  return answers(owner) && of(*owner).type->kind != ModuleKind::Counting;
}

bool Rack::outputLevel(std::uint32_t index, std::uint32_t channel) const {
  const Module& module = of(index);
  const Unit& unit = units_[index];
  constexpr std::uint16_t kDead =
      bitOf(FaultKind::LoadVoltage) | bitOf(FaultKind::Fuse) | bitOf(FaultKind::Defect);
  if (!outputs_.supplied() || unit.faults.hasAny(kDead) || !present(index)) return false;
  if (unit.faults.has(channel, FaultKind::ShortCircuit) ||
      unit.faults.has(channel, FaultKind::WireBreak))
    return false;
  if (unit.driven.always(channel)) return *unit.driven.level(channel);
  const OnStop onStop = module.parameters.onStop;
  if (outputs_.disabled() && onStop == OnStop::Zero) return false;  // S7-STATE-02
  if (outputs_.disabled() && onStop == OnStop::Substitute)
    return (module.parameters.substituteBits >> channel & 1) != 0;
  if (const auto driven = unit.driven.level(channel))  // CNT-PIN-13
    return !outputs_.disabled() && *driven;
  if (module.asiCp) return asiOutput(module, channel);
  return (outputs_.byte(*module.outputStart + channel / 8) >> (channel % 8) & 1) != 0;
}

double Rack::outputAmount(std::uint32_t index, std::uint32_t channel) const {
  const Module& module = of(index);
  const ModuleFaults& faults = units_[index].faults;
  const AnalogOutput& output = module.parameters.analogOutputs[channel];
  const bool dead = faults.has(FaultKind::LoadVoltage) || faults.has(FaultKind::Defect);
  if (!outputs_.supplied() || dead || !present(index)) return 0;
  if (faults.has(channel, FaultKind::ShortCircuit) || faults.has(channel, FaultKind::WireBreak))
    return 0;
  const auto& driven = units_[index].amount;
  if (driven && driven->channel == channel) return driven->volts;
  if (output.range == nullptr) return 0;
  const OnStop onStop = module.parameters.onStop;
  if (outputs_.disabled() && onStop == OnStop::Zero) return 0;  // without voltage and current
  if (outputs_.disabled() && onStop == OnStop::Substitute) return output.substitute;
  const std::uint16_t word = outputs_.word(*module.outputStart + 2 * channel);
  const int unused = (1 << (15 - module.type->bits(*output.range))) - 1;
  return toAmount(*output.range, static_cast<std::int16_t>(word & ~unused));
}

std::uint8_t Rack::putOutBits(std::uint32_t index, std::uint32_t offset) const {
  unsigned bits = 0;
  for (std::uint32_t c = 8 * offset; c < 8 * offset + 8 && c < of(index).type->digitalOutputs; ++c)
    bits |= unsigned{outputLevel(index, c)} << (c % 8);
  return static_cast<std::uint8_t>(bits);
}

std::uint8_t Rack::putOut(std::uint32_t byte) const {
  if (!outputs_.supplied() || !answersOutput(byte)) return 0;
  const std::uint32_t owner = *outputs_.owner(byte);
  const Module& module = of(owner);
  const std::uint32_t offset = byte - *module.outputStart;
  if (module.type->digitalOutputs > 0) return putOutBits(owner, offset);
  const auto& driven = units_[owner].amount;
  if (driven && driven->channel == offset / 2)
    return static_cast<std::uint8_t>(offset % 2 == 0 ? driven->word >> 8 : driven->word);
  const bool put = !outputs_.disabled() || module.parameters.onStop == OnStop::Keep;
  if (put) return outputs_.byte(byte);
  if (module.parameters.onStop == OnStop::Zero) return 0;
  const AnalogOutput& output = module.parameters.analogOutputs[offset / 2];
  if (output.range == nullptr) return 0;
  const auto word = static_cast<std::uint16_t>(
      toShown(*output.range, output.substitute, module.type->bits(*output.range), false));
  return static_cast<std::uint8_t>(offset % 2 == 0 ? word >> 8 : word);
}

}  // namespace merker::io
