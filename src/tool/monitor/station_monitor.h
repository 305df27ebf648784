// A SIMATIC S7 through the monitor.
#pragma once

#include "monitor/monitor.h"
#include "station/station.h"

namespace merker::monitor {

class StationMonitor final : public Monitor {
 public:
  StationMonitor(station::Station& station, const source::SymbolTable& symbols,
                 simulator::Resolver resolver);
  ~StationMonitor() override;

  station::Station& station() { return station_; }
  bool can(Feature feature) const override { return feature != Feature::Nc; }
  void stop() override;
  std::string clock() const override;
  void setClock(std::int64_t milliseconds) override;
  bool downloadWaits() const override;
  bool timersHeld() const override;
  void holdTimers(bool hold) override;
  std::size_t timers() const override;
  void resetTimer(std::size_t number) override;
  std::optional<CycleTimes> cycleTimes() const override;
  std::size_t diagnosticsAdded() const override;
  Stacks stacks() const override;
  std::vector<DiagnosticLine> diagnostics() const override { return diagnosticList(station_); }
  ModuleInformation information() const override { return moduleInformation(station_); }
  std::vector<FrameVariable> variables(std::size_t depth) const override;

 private:
  void writeInCycle(const address::Reference& reference, const Value& value) override;
  bool canForce(const address::Reference& reference) const override;
  bool canWrite(const address::Reference& reference) const override;
  bool holdsForces() const override;
  Result<address::Reference> local(std::string_view text, const Position& at) const override;

  station::Station& station_;
};

}  // namespace merker::monitor
