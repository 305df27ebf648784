// Inputs between their terminals and the bytes towards the CPU.
#include <utility>

#include "base/bytes.h"
#include "io/rack.h"

namespace merker::io {

void Rack::setLevel(Terminal terminal, bool level, Instant now) {
  if (terminal.side != Side::DigitalInput) return;
  detach(terminal, now);
  if (this->level(terminal) == level) return;
  edges_.note({terminal, level, now, nullptr});
  change(terminal, level, now);
}

void Rack::change(Terminal terminal, bool level, Instant now) {
  DigitalInputs& inputs = units_[terminal.module].digital;
  if (inputs.change(terminal.channel, level, now, of(terminal.module).parameters.inputDelay))
    findNext();
}

void Rack::attach(Terminal terminal, std::shared_ptr<const signal::Signal> signal, Instant now) {
  if (terminal.side != Side::DigitalInput) return;
  DigitalInputs& inputs = units_[terminal.module].digital;
  const bool level = signal->level(now);
  if (inputs.attached(terminal.channel)) {  // one signal in the place of another
    if (const auto levels = inputs.settle(terminal.channel, now, of(terminal.module).parameters))
      take(terminal.module, *levels);
    --signals_;
  }
  const Instant held =
      level == this->level(terminal) ? inputs.heldSince(terminal.channel, now) : now;
  edges_.note({terminal, level, now, signal});
  change(terminal, level, now);
  inputs.attach(terminal.channel, std::move(signal), now, held);
  ++signals_;
  findNext();
}

void Rack::detach(Terminal terminal, Instant now) {
  DigitalInputs& inputs = units_[terminal.module].digital;
  if (!inputs.attached(terminal.channel)) return;
  if (const auto levels = inputs.settle(terminal.channel, now, of(terminal.module).parameters))
    take(terminal.module, *levels);
  inputs.detach(terminal.channel);
  --signals_;
  edges_.note({terminal, level(terminal), now, nullptr});
  findNext();
}

void Rack::settle(Instant now) {
  if (signals_ == 0) return;
  for (std::uint32_t i = 0; i < units_.size(); ++i)
    if (const auto levels = units_[i].digital.settle(now, of(i).parameters)) take(i, *levels);
}

void Rack::take(std::uint32_t index, std::uint32_t levels) {
  const std::uint32_t edges = units_[index].digital.deliver(levels, of(index).parameters);
  showBits(index);
  interrupt(index, edges);
}

// A module without supply or with an inner fault shows 0.
void Rack::showBits(std::uint32_t index) {
  const Module& module = of(index);
  if (module.type->digitalInputs == 0) return;
  const Unit& unit = units_[index];
  constexpr std::uint16_t kDead =
      bitOf(FaultKind::LoadVoltage) | bitOf(FaultKind::SensorSupply) | bitOf(FaultKind::Defect);
  const std::uint32_t bits =
      !unit.faults.hasAny(kDead) && present(index) ? unit.digital.delivered() : 0;
  if (module.asiCp) return showAsi(index, bits);
  for (std::uint32_t i = 0; i < module.type->inputBytes; ++i)
    inputs_.set(*module.inputStart + i, static_cast<std::uint8_t>(bits >> (8 * i)));
}

bool Rack::deliver(std::uint32_t byte, std::uint8_t mask, std::uint8_t value, Instant now) {
  if (!answersInput(byte)) return false;
  const std::uint32_t owner = *inputs_.owner(byte);
  const Module& module = of(owner);
  if (module.type->kind != ModuleKind::Digital) {
    inputs_.set(byte, static_cast<std::uint8_t>((inputs()[byte] & ~mask) | (value & mask)));
    return true;
  }
  DigitalInputs& digital = units_[owner].digital;
  const std::uint32_t shift = 8 * (byte - *module.inputStart);
  const std::uint32_t bits = std::uint32_t{mask} << shift;
  const std::uint32_t levels = std::uint32_t{value} << shift;
  for (std::uint32_t c = 0; c < module.type->digitalInputs; ++c) {
    if ((bits >> c & 1) == 0) continue;
    setLevel({owner, Side::DigitalInput, c}, (levels >> c & 1) != 0, now);
    digital.skipDelay(c);
  }
  take(owner, digital.passing(bits));
  findNext();
  return true;
}

void Rack::setAmount(Terminal terminal, double amount, Instant now) {
  if (terminal.side != Side::AnalogInput) return;
  AnalogInputs& inputs = units_[terminal.module].analog;
  inputs.set(terminal.channel, amount);
  if (inputs.converts(terminal.channel, now)) return;  // its end is the same
  const std::int64_t cycle = conversionCycle(of(terminal.module)).ns;
  if (cycle == 0) return;  // all channels deactivated
  inputs.convertAt(terminal.channel, Instant{(now.ns / cycle + 1) * cycle});
  findNext();
}

bool Rack::convert(std::uint32_t index, std::uint32_t channel) {
  Unit& unit = units_[index];
  const Converted result = unit.analog.convert(of(index), channel, unit.faults);
  const std::uint32_t byte = *of(index).inputStart + 2 * channel;
  const auto word = static_cast<std::uint16_t>(present(index) ? result.shown : 0);
  inputs_.set(byte, static_cast<std::uint8_t>(word >> 8));
  inputs_.set(byte + 1, static_cast<std::uint8_t>(word));
  interrupt(index, result.limits);
  return unit.faults.see(channel, result.faults);
}

void Rack::show(std::uint32_t module, std::uint32_t channel, std::uint32_t data) {
  std::uint8_t bytes[4];
  storeDWord(bytes, present(module) ? data : 0);
  for (std::uint32_t i = 0; i < 4; ++i)
    inputs_.set(*of(module).inputStart + 4 * channel + i, bytes[i]);
}

}  // namespace merker::io
