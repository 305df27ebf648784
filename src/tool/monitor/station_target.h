// A SIMATIC S7 under a debugger.
#pragma once

#include <memory>

#include "cpu/probe.h"
#include "monitor/target.h"
#include "station/station.h"

namespace merker::monitor {

Registers toRegisters(const cpu::Registers& registers, bool fourAccumulators);

class StationTarget final : public Target, private cpu::Probe {
 public:
  explicit StationTarget(station::Station& station) : station_(station) {}

  controller::Controller& plc() override { return station_; }
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
  bool executing() const;
  bool before(cpu::Machine& machine, std::uint32_t offset) override;
  void after(cpu::Machine& machine, const cpu::Code& code, std::uint32_t offset) override;

  station::Station& station_;
  Observer* observer_ = nullptr;
};

}  // namespace merker::monitor
