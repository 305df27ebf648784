// Faults of the modules, and what the rack tells the CPU of them.
#include <utility>

#include "io/diagnosis.h"
#include "io/rack.h"

namespace merker::io {

void Rack::interrupt(std::uint32_t index, std::uint32_t points) {
  if (points != 0 && present(index)) events_.interrupt(of(index), points);
}

// Coming while any fault is there, going when the last one has gone (S7-ERR-05).
void Rack::diagnose(std::uint32_t index) {
  Unit& unit = units_[index];
  std::vector<std::uint8_t> now = diagnosis(*of(index).type, unit.faults);
  if (now == unit.diagnosis) return;
  unit.diagnosis = std::move(now);
  reportDiagnosis(index);
}

void Rack::showAxisErrors(std::uint32_t index, std::uint16_t errors) {
  Unit& unit = units_[index];
  const std::uint16_t before = unit.faults.axis();
  const bool wasFaulty = unit.faulty();
  if (before == errors) return;
  unit.faults.showAxis(errors);
  unit.diagnosis = diagnosis(*of(index).type, unit.faults);
  if ((errors & ~before) != 0 || wasFaulty != unit.faulty()) reportDiagnosis(index);
}

void Rack::reportFaults() {
  for (std::uint32_t i = 0; i < units_.size(); ++i)
    if (units_[i].faulty()) reportDiagnosis(i);
}

void Rack::reportDiagnosis(std::uint32_t index) {
  if (!of(index).parameters.diagnosticInterrupt || !present(index)) return;
  events_.diagnosis(of(index), units_[index].diagnosis, units_[index].faulty());
}

void Rack::refresh(std::uint32_t index) {
  showBits(index);
  for (std::uint32_t c = 0; c < of(index).type->analogInputs; ++c) convert(index, c);
  diagnose(index);
}

void Rack::presence(std::uint32_t index, ModuleEvent::Kind kind) {
  events_.presence(of(index), kind);
  for (std::uint32_t i = 0; i < units_.size(); ++i)
    if (of(i).rack == of(index).rack) refresh(i);
}

bool Rack::fault(std::uint32_t index, FaultKind kind, std::optional<std::uint32_t> channel,
                 bool there) {
  using Kind = ModuleEvent::Kind;
  if (!possible(*of(index).type, kind)) return false;
  if (!units_[index].faults.put(kind, channel, there)) return true;
  if (kind == FaultKind::Removed)
    presence(index, there ? Kind::Removed : Kind::Inserted);
  else if (kind == FaultKind::RackPower)
    presence(index, there ? Kind::RackFailed : Kind::RackReturned);
  else
    refresh(index);
  return true;
}

bool Rack::faulty(std::uint32_t index) const { return !present(index) || units_[index].faulty(); }

}  // namespace merker::io
