// Time and faults of the rack, and what it tells the CPU of them.
#include <algorithm>

#include "clock/standstill.h"
#include "io/diagnosis.h"
#include "io/rack.h"

namespace merker::io {

ModuleEvent Rack::event(std::uint32_t index, ModuleEvent::Kind kind) const {
  const Module& module = of(index);
  ModuleEvent event{.kind = kind};
  event.output = !module.inputStart && module.outputStart;
  event.address = static_cast<std::uint16_t>(module.inputStart    ? *module.inputStart
                                             : module.outputStart ? *module.outputStart
                                                                  : 0);
  if (kind == ModuleEvent::Kind::RackFailed || kind == ModuleEvent::Kind::RackReturned)
    event.points = 1u << module.rack;  // RACKS_FLTD (S7-OBI-11)
  return event;
}

// S7-OBI-06. Channels that change at one instant are one interrupt, until the CPU has taken it.
void Rack::interrupt(std::uint32_t index, std::uint32_t points) {
  if (points == 0 || !present(index)) return;
  ModuleEvent fresh = event(index, ModuleEvent::Kind::HardwareInterrupt);
  fresh.points = points;
  const auto same = std::find_if(events_.begin(), events_.end(), [&](const ModuleEvent& other) {
    return other.kind == fresh.kind && other.address == fresh.address &&
           other.output == fresh.output && (other.points & points) == 0;
  });
  if (same == events_.end()) return events_.push_back(fresh);
  same->points |= points;
}

// Coming while any fault is there, going when the last one has gone (S7-ERR-05).
void Rack::diagnose(std::uint32_t index) {
  Unit& unit = units_[index];
  std::vector<std::uint8_t> now = diagnosis(*of(index).type, unit);
  if (now == unit.diagnosis) return;
  unit.diagnosis = std::move(now);
  reportDiagnosis(index);
}

void Rack::reportFaults() {
  for (std::uint32_t i = 0; i < units_.size(); ++i)
    if ((units_[i].diagnosis[0] & 1) != 0) reportDiagnosis(i);
}

void Rack::reportDiagnosis(std::uint32_t index) {
  const Unit& unit = units_[index];
  if (!of(index).parameters.diagnosticInterrupt || !present(index)) return;
  const bool coming = (unit.diagnosis[0] & 1) != 0;
  ModuleEvent interrupt = event(
      index, coming ? ModuleEvent::Kind::DiagnosticComing : ModuleEvent::Kind::DiagnosticGoing);
  std::copy_n(unit.diagnosis.begin(), kRecord0, interrupt.data.begin());
  events_.push_back(interrupt);
}

void Rack::refresh(std::uint32_t index) {
  showBits(index);
  for (std::uint32_t c = 0; c < of(index).type->analogInputs; ++c) convert(index, c);
  diagnose(index);
}

void Rack::presence(std::uint32_t index, ModuleEvent::Kind kind) {
  presenceChanged_ = true;
  events_.push_back(event(index, kind));
  for (std::uint32_t i = 0; i < units_.size(); ++i)
    if (of(i).rack == of(index).rack) refresh(i);
}

bool Rack::fault(std::uint32_t index, FaultKind kind, std::optional<std::uint32_t> channel,
                 bool there) {
  if (!possible(*of(index).type, kind)) return false;
  Unit& unit = units_[index];
  const auto change = [&](std::uint16_t& bits) {
    bits = static_cast<std::uint16_t>(there ? bits | bitOf(kind) : bits & ~bitOf(kind));
  };
  if (nameOf(kind).channel) {
    for (std::uint32_t c = 0; c < unit.channelFaults.size(); ++c)
      if (!channel || *channel == c) change(unit.channelFaults[c]);
  } else {
    if (unit.has(kind) == there) return true;
    change(unit.moduleFaults);
  }
  if (kind == FaultKind::Removed)
    presence(index, there ? ModuleEvent::Kind::Removed : ModuleEvent::Kind::Inserted);
  else if (kind == FaultKind::RackPower)
    presence(index, there ? ModuleEvent::Kind::RackFailed : ModuleEvent::Kind::RackReturned);
  else
    refresh(index);
  return true;
}

bool Rack::faulty(std::uint32_t index) const {
  return !present(index) || (units_[index].diagnosis[0] & 1) != 0;
}

void Rack::findNext() {
  next_ = Instant::never();
  for (const Unit& unit : units_) {
    next_ = std::min(next_, *std::min_element(unit.levelDue.begin(), unit.levelDue.end()));
    next_ = std::min(next_, *std::min_element(unit.amountDue.begin(), unit.amountDue.end()));
  }
  if (signals_ == 0) return;
  for (std::uint32_t i = 0; i < units_.size(); ++i) next_ = std::min(next_, nextChange(i));
}

// In the order of time; what falls together is one event of its module.
void Rack::advance(Instant now) {
  for (Standstill loop; next_ <= now && loop.moves(next_);) {
    const Instant at = next_;
    for (std::uint32_t i = 0; i < units_.size(); ++i) {
      Unit& unit = units_[i];
      std::uint32_t passing = 0;
      for (std::uint32_t c = 0; c < unit.levelDue.size(); ++c) {
        if (unit.levelDue[c] > at) continue;
        unit.levelDue[c] = Instant::never();
        passing |= 1u << c;
      }
      follow(i, at);
      if (passing != 0) take(i, (unit.delivered & ~passing) | (unit.levels & passing));
      bool converted = false;
      for (std::uint32_t c = 0; c < unit.amountDue.size(); ++c) {
        if (unit.amountDue[c] > at) continue;
        unit.amountDue[c] = Instant::never();
        convert(i, c);
        converted = true;
      }
      if (converted) diagnose(i);
    }
    findNext();
  }
}

}  // namespace merker::io
