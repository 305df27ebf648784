// A SINUMERIK under a debugger.
#pragma once

#include <memory>

#include "control/cnc.h"
#include "monitor/target.h"
#include "softplc/probe.h"

namespace merker::monitor {

std::uint16_t openBlock(const sinumerik::Frame& frame);  // number of the data block, or 0
Registers toRegisters(const sinumerik::Registers& registers, std::uint16_t db);
Registers toRegisters(const sinumerik::InterruptStack& stack);  // of the last STOP

class ControlTarget final : public Target, private sinumerik::Probe {
 public:
  explicit ControlTarget(cnc::Cnc& control) : control_(control) {}

  controller::Controller& plc() override { return control_; }
  ProgramCode program() const override;
  void probe(const std::function<bool(BlockId)>& wanted, Observer& observer) override;
  void removeProbes() override;
  void resume(bool step) override;
  void stepGivenUp() override;
  void run(Instant limit) override;
  void runToCheckpoint(Instant limit) override;
  Depth depth() const override;
  Registers registers() const override;
  std::optional<SourcePlace> position() const override;

 private:
  bool before(const sinumerik::Machine& machine, const sinumerik::CodePlace& place) override;
  void after(const sinumerik::Machine& machine, const sinumerik::CodePlace& place,
             const sinumerik::Passed& passed) override;

  std::optional<SourcePlace> stopped() const;

  cnc::Cnc& control_;
  Observer* observer_ = nullptr;
};

}  // namespace merker::monitor
