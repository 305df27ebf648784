// Faults of the modules, and what the rack tells the CPU of them.
#include <set>
#include <utility>

#include "io/asi.h"
#include "io/diagnosis.h"
#include "io/rack.h"
#include "io/slave.h"

namespace merker::io {

void Rack::interrupt(std::uint32_t index, std::uint32_t points) {
  if (points != 0 && present(index)) events_.interrupt(of(index), points);
}

std::vector<std::uint8_t> Rack::diagnosisOf(std::uint32_t index) const {
  const ModuleType& type = *of(index).type;
  std::vector<std::uint8_t> record = diagnosis(type, units_[index].faults);
  if (isAsiMaster(type)) addMissingSlaves(record, missingOnAsi(index));
  return record;
}

// Coming while any fault is there, going when the last one has gone (S7-ERR-05).
void Rack::diagnose(std::uint32_t index) {
  Unit& unit = units_[index];
  std::vector<std::uint8_t> now = diagnosisOf(index);
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
  showAnswer(index);
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
  if (!possible(*of(index).type, kind)) return false;
  if (!units_[index].faults.put(kind, channel, there)) return true;
  if (of(index).asiCp || isAsiMaster(*of(index).type)) return asiFault(index, kind, there), true;
  const bool line = isHead(*of(index).type);
  if (kind == FaultKind::Removed || kind == FaultKind::RackPower || line)
    presenceFault(index, kind, there);
  else
    refresh(index);
  return true;
}

// A rack is there while its interface module has power; the rack of a slave, moreover, while the
// line is whole from the master to its head, and shorted nowhere. Slaves of an AS-Interface need
// their CP and its supply.
std::vector<char> Rack::presentNow() const {
  std::set<std::uint32_t> lost;
  bool broken = false, shorted = false;
  for (std::uint32_t i = 0; i < units_.size(); ++i) {
    if (isHead(*of(i).type)) {
      broken |= units_[i].faults.has(FaultKind::LineBreak);
      shorted |= units_[i].faults.hasAnywhere(FaultKind::ShortCircuit);
      if (broken) lost.insert(of(i).rack);
    }
    if (units_[i].faults.has(FaultKind::RackPower)) lost.insert(of(i).rack);
  }
  std::vector<char> present(units_.size());
  for (std::uint32_t i = 0; i < units_.size(); ++i)
    present[i] = !units_[i].faults.has(FaultKind::Removed) && !lost.contains(of(i).rack) &&
                 !(shorted && of(i).rack >= kSlaveRack);
  for (std::uint32_t i = 0; i < units_.size(); ++i)
    if (const auto cp = of(i).asiCp)
      present[i] = present[i] && present[*cp] && !units_[*cp].faults.has(FaultKind::LoadVoltage);
  return present;
}

bool Rack::lineReaches(std::uint32_t head) const {
  bool broken = false, shorted = false;
  for (std::uint32_t i = 0; i < units_.size(); ++i) {
    if (!isHead(*of(i).type)) continue;
    broken |= i <= head && units_[i].faults.has(FaultKind::LineBreak);
    shorted |= units_[i].faults.hasAnywhere(FaultKind::ShortCircuit);
  }
  return !broken && !shorted;
}

// CPU 31xC and CPU 31x: Installation (A5E00105492-03), tables 11-8 and 11-11: "module fault",
// OB82_MDL_STOP = 1. Class 1011: an intelligent slave.
void Rack::partnerStops(std::uint32_t head, bool stops) {
  constexpr std::uint8_t kModuleFault = 0x01, kIntelligentSlave = 0x0B, kInStop = 0x04;
  const auto ifStops = [&](std::uint8_t bit) { return stops ? bit : std::uint8_t{0}; };
  events_.diagnosis(of(head), {ifStops(kModuleFault), kIntelligentSlave, ifStops(kInStop), 0},
                    stops);
}

void Rack::presenceFault(std::uint32_t index, FaultKind kind, bool there) {
  using Kind = ModuleEvent::Kind;
  const std::vector<char> before = std::exchange(present_, presentNow());
  if (kind == FaultKind::Removed) return presence(index, there ? Kind::Removed : Kind::Inserted);
  for (std::uint32_t i = 0; i < units_.size(); ++i)
    if (of(i).type->kind == ModuleKind::Interface && before[i] != present_[i])
      presence(i, present_[i] != 0 ? Kind::RackReturned : Kind::RackFailed);
}

bool Rack::faulty(std::uint32_t index) const { return !present(index) || units_[index].faulty(); }

}  // namespace merker::io
