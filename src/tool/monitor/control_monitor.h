// A SINUMERIK through the monitor.
#pragma once

#include "control/cnc.h"
#include "monitor/control_target.h"
#include "monitor/monitor.h"

namespace merker::monitor {

class ControlMonitor final : public Monitor {
 public:
  ControlMonitor(cnc::Cnc& control, const source::SymbolTable& symbols,
                 simulator::Resolver resolver);

  ~ControlMonitor() override;
  ControlMonitor(const ControlMonitor&) = delete;
  ControlMonitor& operator=(const ControlMonitor&) = delete;

  bool can(Feature feature) const override;
  void stop() override;
  std::string clock() const override { return {}; }
  bool downloadWaits() const override { return false; }
  std::size_t diagnosticsAdded() const override { return control_.diagnostics().size(); }
  Stacks stacks() const override;
  std::vector<DiagnosticLine> diagnostics() const override;
  ModuleInformation information() const override;
  std::vector<FrameVariable> variables(std::size_t depth) const override;

 private:
  void writeInCycle(const address::Reference& reference, const Value& value) override;
  bool canForce(const address::Reference& reference) const override;
  bool canWrite(const address::Reference& reference) const override;
  bool takes(const address::Reference& reference, const Value& value) const override;
  bool holdsForces() const override;

  cnc::Cnc& control_;
};

}  // namespace merker::monitor
