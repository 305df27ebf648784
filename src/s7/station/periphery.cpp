#include "station/periphery.h"

#include <algorithm>

#include "clock/standstill.h"
#include "cpu/cpu.h"

namespace merker::station {

void Periphery::connect(cpu::Cpu& cpu) {
  cpu::Areas& areas = cpu.machine().areas;
  const std::uint32_t bytes = rack_.configuration().model->peripheralBytes;
  areas.inputConfigured.assign(bytes, false);
  areas.outputConfigured.assign(bytes, false);
  for (std::uint32_t byte = 0; byte < bytes; ++byte) {
    areas.inputConfigured[byte] = rack_.at(byte, false) != nullptr;
    areas.outputConfigured[byte] = rack_.at(byte, true) != nullptr;
  }
  showPresence(cpu);
  // Sensors have had their supply long enough for any input delay when the CPU begins.
  plants_.show(rack_, Instant{} - Duration::seconds(1));
  showBefore(cpu);
  cpu.modules().connect(this);
}

void Periphery::joinWires(cpu::Cpu& cpu, network::Node& node, std::size_t partner, bool plant) {
  wires_.join(node, partner, plant);
  showBefore(cpu);
}

// What the inputs are when time begins.
void Periphery::showBefore(cpu::Cpu& cpu) {
  rack_.advance(Instant{});
  rack_.takeChanged();
  cpu.machine().areas.inputs = rack_.inputs();
}

// What happens outside, between two calls of the CPU, is told at its next instruction boundary.
Instant Periphery::next() const {
  return rack_.pending() ? Instant{} : std::min({rack_.next(), nextOfChannels(), plants_.next()});
}

Instant Periphery::nextOfChannels() const {
  return std::min(
      {counting_.next(), positioning_.next(), serial_.next(), exchange_.next(), nextOfPartners()});
}

Instant Periphery::nextVisible(bool access) const {
  if (rack_.pending()) return Instant{};
  return std::min({access ? rack_.next() : rack_.nextVisible(), nextOfChannels(),
                   counting_.nextVisible(), plants_.silentUntil(rack_, access)});
}

// What is there to tell, or due.
Periphery::Notice Periphery::pending(Instant now) const {
  if (rack_.pendingVisibly() || rack_.nextVisible() <= now) return Notice::Anyhow;
  return rack_.pending() || rack_.next() <= now ? Notice::ByAccess : Notice::No;
}

void Periphery::passed(cpu::Cpu& cpu, Instant now) {
  plants_.advanceAlone(rack_, now);
  goOn(now);
  showInputs(cpu);
}

std::string_view Periphery::due(Instant now) const {
  if (plants_.next() <= now) return "plants";
  if (exchange_.next() <= now) return "DP master";
  if (dp_.next() <= now) return "DP interface";
  if (wires_.next() <= now) return "wires to other stations";
  if (positioning_.next() <= now) return "sub-module 2.5";
  if (serial_.next() <= now) return "sub-module 2.1";
  return counting_.next() <= now ? "sub-module 2.4" : "modules of the rack";
}

void Periphery::goOn(Instant now) {
  wires_.hear(now);
  const auto next = [this] { return std::min(plants_.next(), positioning_.next()); };
  for (Standstill loop; next() <= now && loop.moves(next());) {  // by time
    const Instant at = next();
    rack_.advance(at);
    positioning_.advance(at);  // the cycle at this instant acts on the step that begins here
    plants_.advance(rack_, at);
  }
  rack_.advance(now);
  positioning_.advance(now);
  dp_.hear(now);
  wires_.look(now);
}

void Periphery::advance(cpu::Cpu& cpu, Instant now) {
  noticed_ = nextOfChannels() <= now ? Notice::Anyhow : pending(now);
  goOn(now);
  noticed_ = std::max(noticed_, pending(now));
  counting_.advance(now);
  serial_.advance(now);
  if (rack_.takePresenceChanged()) {
    showPresence(cpu);
    dp_.changed(now);
  }
  exchangeData(cpu, now);
  dp_.advance(now);
  wires_.look(now);
  showInputs(cpu);
  for (const ModuleEvent& event : rack_.takeEvents()) cpu.moduleEvents().happened(event);
}

void Periphery::refresh(Instant now) {
  rack_.settle(now);
  counting_.advance(now);
}

void Periphery::reading(cpu::Cpu& cpu) {
  refresh(cpu.machine().clock);
  showInputs(cpu);
  if (rack_.pending()) cpu.machine().interrupt();
}

// Signals, channels that count or measure and slaves are worked out when asked; everything else
// says when it acts next.
bool Periphery::steady() const {
  return !rack_.hasSignals() && counting_.steady() && !exchange_.any() && !hasPartners();
}

void Periphery::acknowledged(cpu::Cpu&, std::uint32_t address) { counting_.acknowledged(address); }

// CNT-GATE-10, -11; POS-RUN-33, POS-END-08
void Periphery::modeChanged(cpu::Cpu& cpu) {
  const Instant now = cpu.machine().clock;
  if (cpu.mode() == cpu::Mode::Startup) {
    counting_.start(now);
    positioning_.start(now);
    serial_.start(now);
  }
  if (cpu.mode() == cpu::Mode::Stop) counting_.stop(), serial_.stop(now);
  if (cpu.mode() == cpu::Mode::Stop || cpu.mode() == cpu::Mode::Halt) positioning_.stop(now);
  dp_.execute(cpu.mode() != cpu::Mode::Stop, cpu.powered(), now);
}

void Periphery::supply(cpu::Cpu& cpu, bool on) {
  if (!on) positioning_.stop(cpu.machine().clock);
  rack_.supply(on);
  dp_.supply(on, cpu.machine().clock);
  wires_.look(cpu.machine().clock);
  serial_.supply(on, cpu.machine().clock);
}

void Periphery::written(cpu::Cpu& cpu, std::uint32_t first, std::uint32_t count) {
  const std::uint8_t* const bytes = &cpu.machine().areas.outputs[first];
  if (!exchange_.any()) rack_.written(first, bytes, count);
  for (std::uint32_t i = 0; i < count && exchange_.any(); ++i)
    exchange_.ownsOutput(first + i) ? exchange_.written(first + i, bytes[i], cpu.machine().clock)
                                    : rack_.written(first + i, &bytes[i], 1);
  dp_.written(first, count, cpu.machine().clock);
  wires_.look(cpu.machine().clock);
}

void Periphery::disableOutputs(cpu::Cpu& cpu, bool disabled) {
  rack_.disableOutputs(disabled);
  if (cpu.powered()) dp_.changed(cpu.machine().clock);
  wires_.look(cpu.machine().clock);
}

bool Periphery::deliver(cpu::Cpu& cpu, std::uint32_t first, std::uint32_t count, std::uint8_t mask,
                        const std::uint8_t* bytes) {
  for (std::uint32_t i = 0; i < count; ++i)
    if (!rack_.answersInput(first + i)) return false;
  for (std::uint32_t i = 0; i < count; ++i)
    rack_.deliver(first + i, mask, bytes[i], cpu.machine().clock);
  showInputs(cpu);
  return true;
}

// Bits of this byte that the terminal is, if it is an input.
std::uint8_t Periphery::inputBits(const io::Terminal& terminal, std::uint32_t byte) const {
  const io::Module& module = rack_.configuration().modules[terminal.module];
  // An AS-i slave: its bits lie in bytes of the CP.
  if (isOutput(terminal.side) || !module.inputStart) return 0;
  const bool digital = isDigital(terminal.side);
  const std::uint32_t first =
      *module.inputStart + (digital ? terminal.channel / 8 : 2 * terminal.channel);
  if (digital) return first == byte ? static_cast<std::uint8_t>(1u << (terminal.channel & 7)) : 0;
  return first == byte || first + 1 == byte ? 0xFF : 0;
}

// Inputs at this byte that lie at an output of a plant.
std::uint8_t Periphery::drivenBits(std::uint32_t byte) const {
  unsigned bits = 0;
  for (const plant::PlantSettings& plant : plants_.configuration().plants)
    for (const plant::Wire& wire : plant.wires) {
      if (const auto* data = std::get_if<io::ProcessData>(&wire.end)) {
        const io::Module& module = rack_.configuration().modules[data->module];
        const std::uint32_t first = module.inputStart.value_or(0) + 2u * data->word;
        if (!data->setpoint && byte >= first && byte < first + 2u * data->words) bits = 0xFF;
        continue;
      }
      if (const auto* terminal = std::get_if<io::Terminal>(&wire.end))
        bits |= inputBits(*terminal, byte);
    }
  for (const plant::LentTerminal& one : plants_.configuration().lent)
    bits |= inputBits(one.terminal, byte);
  return static_cast<std::uint8_t>(bits);
}

void Periphery::deliverAll(cpu::Cpu& cpu, const std::vector<std::uint8_t>& bytes) {
  for (std::uint32_t i = 0; i < bytes.size(); ++i) {
    const auto mask = static_cast<std::uint8_t>(~drivenBits(i));
    if (mask != 0 && rack_.answersInput(i)) deliver(cpu, i, 1, mask, &bytes[i]);
  }
}

void Periphery::showPresence(cpu::Cpu& cpu) {
  cpu::Areas& areas = cpu.machine().areas;
  for (std::uint32_t byte = 0; byte < areas.inputPresent.size(); ++byte) {
    areas.inputPresent[byte] = rack_.answersInput(byte);
    areas.outputPresent[byte] = rack_.answersOutput(byte);
  }
}

void Periphery::showInputs(cpu::Cpu& cpu) {
  const io::Bytes changed = rack_.takeChanged();
  auto& shown = cpu.machine().areas.inputs;
  if (!exchange_.any()) {
    std::copy_n(rack_.inputs().begin() + changed.first, changed.count,
                shown.begin() + changed.first);
    return;
  }
  for (std::uint32_t i = changed.first; i < changed.first + changed.count; ++i)
    if (exchange_.ownsInput(i))
      exchange_.inputChanged(i, cpu.machine().clock);
    else
      shown[i] = rack_.inputs()[i];
}

// What slaves have changed comes with their turns on the bus.
void Periphery::exchangeData(cpu::Cpu& cpu, Instant now) {
  for (const io::Bytes& seen : exchange_.advance(now))
    std::copy_n(rack_.inputs().begin() + seen.first, seen.count,
                cpu.machine().areas.inputs.begin() + seen.first);
}

}  // namespace merker::station
