#include "io/rack.h"

#include <algorithm>
#include <utility>

#include "clock/standstill.h"
#include "io/diagnosis.h"

namespace merker::io {
namespace {

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
    : configuration_(std::move(configuration)),
      units_(configuration_.modules.size()),
      present_(units_.size(), 1),
      inputs_(configuration_),
      outputs_(configuration_),
      edges_(units_.size()) {
  for (std::uint32_t i = 0; i < units_.size(); ++i) {
    const Module& module = of(i);
    for (std::uint32_t c = 0; c < module.type->analogInputs; ++c) {
      units_[i].analog.set(c, amountAtRest(module.parameters.analogInputs[c].range));
      convert(i, c);
    }
    units_[i].diagnosis = diagnosisOf(i);
  }
  static_cast<void>(events_.take());  // limits that amounts at rest exceed
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

const Module* Rack::at(std::uint32_t address, bool output) const {
  const auto owner = output ? outputs_.owner(address) : inputs_.owner(address);
  return owner ? &of(*owner) : nullptr;
}

void Rack::findNext() {
  next_ = nextVisible_ = Instant::never();
  for (std::uint32_t i = 0; i < units_.size(); ++i) {
    const Instant digital = units_[i].digital.next(of(i).parameters);
    const Instant analog = units_[i].analog.next();
    next_ = std::min({next_, digital, analog});
    nextVisible_ = std::min(nextVisible_, digital);
    if (analog < nextVisible_ && !onlyByAccess(i)) nextVisible_ = analog;
  }
}

bool Rack::onlyByAccess(std::uint32_t module) const {
  const Parameters& parameters = of(module).parameters;
  return of(module).inputStart >= imageBytes() && !parameters.diagnosticInterrupt &&
         std::ranges::none_of(parameters.analogInputs, [](const AnalogInput& input) {
           return input.upperLimit || input.lowerLimit;
         });
}

// In the order of time; what falls together is one event of its module.
void Rack::advance(Instant now) {
  for (Standstill loop; next_ <= now && loop.moves(next_);) {
    const Instant at = next_;
    for (std::uint32_t i = 0; i < units_.size(); ++i) advance(i, at);
    findNext();
  }
}

void Rack::advance(std::uint32_t index, Instant at) {
  Unit& unit = units_[index];
  if (const auto levels = unit.digital.advance(at, of(index).parameters)) take(index, *levels);
  const std::uint32_t due = unit.analog.takeDue(at);
  if (due == 0) return;
  bool others = false;
  for (std::uint32_t c = 0; c < of(index).type->analogInputs; ++c)
    if ((due >> c & 1) != 0) others |= convert(index, c);
  if (others) diagnose(index);
}

std::vector<std::uint8_t> Rack::record1(const Module& module) const {
  return diagnosisOf(index(module));
}

std::vector<std::uint8_t> Rack::record0(const Module& module) const {
  auto record = record1(module);
  record.resize(kRecord0);
  return record;
}

}  // namespace merker::io
