// Digital channels: input delay, edges, outputs with their substitute values.
#include "io/rack.h"

namespace merker::io {

// A level that lasts for the input delay passes; one that returns before is not seen
// (S7-HWCFG-09).
void Rack::setLevel(Terminal terminal, bool level, Instant now) {
  if (terminal.side != Side::DigitalInput) return;
  detach(terminal, now);
  if (this->level(terminal) == level) return;
  noteEdge(terminal, level, now, nullptr);
  change(terminal, level, now);
}

void Rack::noteEdge(Terminal terminal, bool level, Instant now,
                    std::shared_ptr<const signal::Signal> signal) {
  if ((units_[terminal.module].watched >> terminal.channel & 1) != 0)
    edges_.push_back({terminal, level, now, std::move(signal)});
}

void Rack::change(Terminal terminal, bool level, Instant now) {
  Unit& unit = units_[terminal.module];
  const std::uint32_t bit = 1u << terminal.channel;
  if (((unit.levels & bit) != 0) == level) return;
  unit.levels ^= bit;
  const bool same = ((unit.delivered & bit) != 0) == level;
  unit.levelDue[terminal.channel] =
      same ? Instant::never() : now + of(terminal.module).parameters.inputDelay;
  findNext();
}

bool Rack::level(Terminal terminal) const {
  if (terminal.side == Side::DigitalOutput) return outputLevel(terminal.module, terminal.channel);
  return terminal.side == Side::DigitalInput &&
         (units_[terminal.module].levels >> terminal.channel & 1) != 0;
}

void Rack::take(std::uint32_t index, std::uint32_t levels) {
  Unit& unit = units_[index];
  const Parameters& parameters = of(index).parameters;
  const std::uint32_t rising = levels & ~unit.delivered & parameters.risingEdges;
  const std::uint32_t falling = ~levels & unit.delivered & parameters.fallingEdges;
  unit.delivered = levels;
  showBits(index);
  interrupt(index, rising | falling);
}

// A module without supply or with an inner fault shows 0.
void Rack::showBits(std::uint32_t index) {
  const Module& module = of(index);
  if (module.type->digitalInputs == 0) return;
  const Unit& unit = units_[index];
  constexpr std::uint16_t kDead =
      bitOf(FaultKind::LoadVoltage) | bitOf(FaultKind::SensorSupply) | bitOf(FaultKind::Defect);
  const bool alive = (unit.moduleFaults & kDead) == 0 && present(index);
  for (std::uint32_t i = 0; i < module.type->inputBytes; ++i)
    setInput(*module.inputStart + i,
             alive ? static_cast<std::uint8_t>(unit.delivered >> (8 * i)) : std::uint8_t{0});
}

bool Rack::outputLevel(std::uint32_t index, std::uint32_t channel) const {
  const Module& module = of(index);
  const Unit& unit = units_[index];
  constexpr std::uint16_t kDead =
      bitOf(FaultKind::LoadVoltage) | bitOf(FaultKind::Fuse) | bitOf(FaultKind::Defect);
  if (!supplied_ || (unit.moduleFaults & kDead) != 0 || !present(index)) return false;
  if (unit.has(channel, FaultKind::ShortCircuit) || unit.has(channel, FaultKind::WireBreak))
    return false;
  const OnStop onStop = module.parameters.onStop;
  if (outputsDisabled_ && onStop == OnStop::Zero) return false;  // S7-STATE-02
  if (outputsDisabled_ && onStop == OnStop::Substitute)
    return (module.parameters.substituteBits >> channel & 1) != 0;
  if ((unit.driven >> channel & 1) != 0)  // CNT-PIN-13
    return !outputsDisabled_ && (unit.drivenLevels >> channel & 1) != 0;
  const auto& bytes = outputsDisabled_ ? kept_ : outputs_;
  return (bytes[*module.outputStart + channel / 8] >> (channel % 8) & 1) != 0;
}

}  // namespace merker::io
