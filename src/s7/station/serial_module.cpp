#include "station/serial_module.h"

namespace merker::station {

SerialModule::SerialModule(io::Rack& rack) : rack_(rack) {
  const auto module = rack.module("2.1");
  if (!module) return;
  module_ = *module;
  const io::Module& self = rack.configuration().modules[module_];
  address_ = self.inputStart.value_or(0);
  serial::Parameters parameters = *self.parameters.serial;
  parameters.diagnosticInterrupt = self.parameters.diagnosticInterrupt;
  coupling_ = std::make_unique<serial::Coupling>(parameters);
}

void SerialModule::start(Instant now) {
  if (coupling_) coupling_->cpuStarted(now);
}

void SerialModule::stop(Instant now) {
  if (coupling_) coupling_->cpuStopped(now);
}

void SerialModule::supply(bool on, Instant now) {
  if (!coupling_) return;
  coupling_->supply(on, now);
  broken_ = false;
  rack_.fault(module_, io::FaultKind::LineBreak, std::nullopt, false);
}

bool SerialModule::put() const { return rack_.has(module_, io::FaultKind::LineBreak); }

Instant SerialModule::next() const {
  if (!coupling_) return Instant::never();
  return put() != broken_ ? Instant{} : coupling_->next();
}

// A line break that somebody else puts there cuts the line (`fault X27 line break`); one that the
// interface sees is told.
void SerialModule::advance(Instant now) {
  if (!coupling_) return;
  if (put() != broken_) coupling_->cut(serial::Coupling::End::Cpu, put(), now);
  broken_ = put();
  if (next() <= now) coupling_->advance(now);
  const auto change = coupling_->takeWireBreak();
  if (!change) return;
  broken_ = *change;
  rack_.fault(module_, io::FaultKind::LineBreak, std::nullopt, broken_);
}

}  // namespace merker::station
