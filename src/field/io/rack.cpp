#include "io/rack.h"

#include <algorithm>
#include <utility>

#include "io/diagnosis.h"

namespace merker::io {
namespace {

void own(std::vector<std::uint16_t>& owner, std::optional<std::uint32_t> start, unsigned count,
         std::size_t module) {
  if (!start) return;
  for (std::uint32_t i = *start; i < *start + count && i < owner.size(); ++i)
    owner[i] = static_cast<std::uint16_t>(module);
}

std::uint32_t channelsOf(const ModuleType& type, Side side) {
  switch (side) {
    case Side::DigitalInput:
      return type.digitalInputs;
    case Side::DigitalOutput:
      return type.digitalOutputs;
    case Side::AnalogInput:
      return type.analogInputs;
    case Side::AnalogOutput:
      return type.analogOutputs;
  }
  return 0;
}

// Sensors at rest: the lower end of ranges that begin above 0 (4 mA), else 0.
double amountAtRest(const MeasuringRange* range) {
  return range != nullptr && range->low > 0 ? range->low : 0;
}

}  // namespace

Rack::Rack(Configuration configuration)
    : configuration_(std::move(configuration)), units_(configuration_.modules.size()) {
  const std::size_t bytes = configuration_.model->peripheralBytes;
  for (auto* list : {&inputs_, &outputs_, &kept_}) list->resize(bytes);
  for (auto* owner : {&inputOwner_, &outputOwner_}) owner->assign(bytes, kNobody);
  for (std::uint32_t i = 0; i < units_.size(); ++i) {
    const Module& module = of(i);
    own(inputOwner_, module.inputStart, module.type->inputBytes, i);
    own(outputOwner_, module.outputStart, module.type->outputBytes, i);
    for (std::uint32_t c = 0; c < module.type->analogInputs; ++c) {
      units_[i].amounts[c] = amountAtRest(module.parameters.analogInputs[c].range);
      convert(i, c);
    }
    units_[i].diagnosis = diagnosis(*module.type, units_[i]);
  }
  events_.clear();
}

std::uint32_t Rack::index(const Module& module) const {
  return static_cast<std::uint32_t>(&module - configuration_.modules.data());
}

std::optional<std::uint32_t> Rack::module(std::string_view name) const {
  const Module* found = configuration_.find(name);
  if (found == nullptr) return std::nullopt;
  return index(*found);
}

std::optional<Terminal> Rack::terminal(std::string_view name, Side side,
                                       std::uint32_t channel) const {
  const auto found = module(name);
  if (!found || channel >= channelsOf(*of(*found).type, side)) return std::nullopt;
  return Terminal{*found, side, channel};
}

bool Rack::answers(const std::vector<std::uint16_t>& owner, std::uint32_t byte) const {
  return byte < owner.size() && owner[byte] != kNobody && present(owner[byte]);
}

bool Rack::present(std::uint32_t index) const {
  if (units_[index].has(FaultKind::Removed)) return false;
  for (std::uint32_t i = 0; i < units_.size(); ++i)
    if (of(i).rack == of(index).rack && units_[i].has(FaultKind::RackPower)) return false;
  return true;
}

void Rack::setInput(std::uint32_t byte, std::uint8_t value) {
  if (inputs_[byte] == value) return;
  inputs_[byte] = value;
  changedFirst_ = std::min(changedFirst_, byte);
  changedLast_ = std::max(changedLast_, byte);
}

Bytes Rack::takeChanged() {
  const bool any = changedFirst_ <= changedLast_;
  const Bytes changed{any ? changedFirst_ : 0, any ? changedLast_ - changedFirst_ + 1 : 0};
  changedFirst_ = UINT32_MAX;
  changedLast_ = 0;
  return changed;
}

bool Rack::takePresenceChanged() { return std::exchange(presenceChanged_, false); }
std::vector<ModuleEvent> Rack::takeEvents() { return std::exchange(events_, {}); }

void Rack::written(std::uint32_t first, const std::uint8_t* bytes, std::uint32_t count) {
  if (first >= outputs_.size()) return;
  std::copy_n(bytes, std::min<std::size_t>(count, outputs_.size() - first),
              outputs_.begin() + first);
}

void Rack::disableOutputs(bool disabled) {
  if (disabled && !outputsDisabled_) kept_ = outputs_;
  outputsDisabled_ = disabled;
}

// What an output kept is gone with the supply (S7-STATE-02).
void Rack::supply(bool on) {
  supplied_ = on;
  if (!on) std::fill(kept_.begin(), kept_.end(), std::uint8_t{0});
}

std::uint8_t Rack::putOut(std::uint32_t byte) const {
  if (!supplied_ || !answersOutput(byte)) return 0;
  const std::uint32_t owner = outputOwner_[byte];
  const Module& module = of(owner);
  const std::uint32_t offset = byte - *module.outputStart;
  if (module.type->digitalOutputs > 0) {
    unsigned bits = 0;
    for (std::uint32_t c = 8 * offset; c < 8 * offset + 8 && c < module.type->digitalOutputs; ++c)
      bits |= unsigned{outputLevel(owner, c)} << (c % 8);
    return static_cast<std::uint8_t>(bits);
  }
  if (!outputsDisabled_) return outputs_[byte];
  if (module.parameters.onStop == OnStop::Zero) return 0;
  if (module.parameters.onStop == OnStop::Keep) return kept_[byte];
  const AnalogOutput& output = module.parameters.analogOutputs[offset / 2];
  if (output.range == nullptr) return 0;
  const auto word = static_cast<std::uint16_t>(
      toShown(*output.range, output.substitute, module.type->bits(*output.range), false));
  return static_cast<std::uint8_t>(offset % 2 == 0 ? word >> 8 : word);
}

// Nothing can be written to the sub-module 2.4 (CNT-PIO-04).
bool Rack::answersOutput(std::uint32_t byte) const {
  return answers(outputOwner_, byte) && of(outputOwner_[byte]).type->kind != ModuleKind::Counting;
}

bool Rack::deliver(std::uint32_t byte, std::uint8_t mask, std::uint8_t value, Instant now) {
  if (!answersInput(byte)) return false;
  const std::uint32_t owner = inputOwner_[byte];
  const Module& module = of(owner);
  if (module.type->kind != ModuleKind::Digital) {
    setInput(byte, static_cast<std::uint8_t>((inputs_[byte] & ~mask) | (value & mask)));
    return true;
  }
  Unit& unit = units_[owner];
  const std::uint32_t shift = 8 * (byte - *module.inputStart);
  const std::uint32_t bits = std::uint32_t{mask} << shift;
  const std::uint32_t levels = std::uint32_t{value} << shift;
  for (std::uint32_t c = 0; c < module.type->digitalInputs; ++c) {
    if ((bits >> c & 1) == 0) continue;
    setLevel({owner, Side::DigitalInput, c}, (levels >> c & 1) != 0, now);
    unit.levelDue[c] = Instant::never();
  }
  take(owner, (unit.delivered & ~bits) | (unit.levels & bits));
  findNext();
  return true;
}

const Module* Rack::at(std::uint32_t address, bool output) const {
  const auto& owner = output ? outputOwner_ : inputOwner_;
  if (address >= owner.size() || owner[address] == kNobody) return nullptr;
  return &of(owner[address]);
}

std::vector<std::uint8_t> Rack::record1(const Module& module) const {
  return diagnosis(*module.type, units_[index(module)]);
}

std::vector<std::uint8_t> Rack::record0(const Module& module) const {
  auto record = record1(module);
  record.resize(kRecord0);
  return record;
}

}  // namespace merker::io
