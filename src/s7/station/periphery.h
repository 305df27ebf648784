// The modules of a station, coupled to its CPU: terminals on one side, periphery bytes on the
// other. Beside them the plants that are wired to the terminals.
#pragma once

#include "cpu/periphery.h"
#include "io/rack.h"
#include "plant/plants.h"
#include "positioning/positioning.h"
#include "profibus/exchange.h"
#include "station/dp_interface.h"
#include "station/far_wires.h"
#include "station/serial_module.h"
#include "technology/counting.h"

namespace merker::station {

class Periphery : public cpu::Periphery {
 public:
  Periphery(io::Configuration configuration, plant::Configuration plants)
      : rack_(std::move(configuration)),
        counting_(rack_),
        positioning_(rack_),
        serial_(rack_),
        exchange_(rack_),
        dp_(rack_, exchange_),
        plants_(std::move(plants)),
        wires_(rack_, plants_) {}
  Periphery(const Periphery&) = delete;  // the sub-modules know `rack_`
  Periphery& operator=(const Periphery&) = delete;

  io::Rack& rack() { return rack_; }
  const io::Rack& rack() const { return rack_; }
  technology::Counting& counting() { return counting_; }
  positioning::Positioning& positioning() { return positioning_; }
  const positioning::Positioning& positioning() const { return positioning_; }
  SerialModule& serial() { return serial_; }
  profibus::Exchange& exchange() { return exchange_; }
  DpInterface& dp() { return dp_; }
  // Before time begins.
  void joinWires(cpu::Cpu& cpu, network::Node& node, std::size_t partner, bool plant);
  // Other stations reach its modules and plants, past the CPU; when the next one does.
  bool hasPartners() const { return dp_.joined() || wires_.any(); }
  Instant nextOfPartners() const { return std::min(dp_.next(), wires_.next()); }
  // What is worked out only when asked, as it is at `now`.
  void refresh(Instant now);
  plant::Plants& plants() { return plants_; }
  const plant::Plants& plants() const { return plants_; }
  // Tells the CPU which bytes answer, and becomes its periphery. It must outlive the CPU.
  void connect(cpu::Cpu& cpu);
  // A module delivers this value from now on: `set E 124.0 = 1`. False if none lies there.
  bool deliver(cpu::Cpu& cpu, std::uint32_t first, std::uint32_t count, std::uint8_t mask,
               const std::uint8_t* bytes);

  // All inputs, but for the terminals that a plant drives.
  void deliverAll(cpu::Cpu& cpu, const std::vector<std::uint8_t>& bytes);

  // The world goes on while the CPU is switched off.
  void goOn(Instant now);

  Instant next() const override;
  std::string_view due(Instant now) const override;
  void advance(cpu::Cpu& cpu, Instant now) override;
  void reading(cpu::Cpu& cpu) override;
  bool steady() const override;
  Instant nextVisible(bool access) const override;
  Notice noticed() const override { return noticed_; }
  void passed(cpu::Cpu& cpu, Instant now) override;
  void acknowledged(cpu::Cpu& cpu, std::uint32_t address) override;
  void modeChanged(cpu::Cpu& cpu) override;
  void written(cpu::Cpu& cpu, std::uint32_t first, std::uint32_t count) override;
  void disableOutputs(cpu::Cpu& cpu, bool disabled) override;
  void supply(cpu::Cpu& cpu, bool on) override;
  void started(cpu::Cpu&) override { rack_.reportFaults(); }

 private:
  Instant nextOfChannels() const;
  Notice pending(Instant now) const;
  std::uint8_t inputBits(const io::Terminal& terminal, std::uint32_t byte) const;
  std::uint8_t drivenBits(std::uint32_t byte) const;
  void showBefore(cpu::Cpu& cpu);
  void showPresence(cpu::Cpu& cpu);
  void showInputs(cpu::Cpu& cpu);
  void exchangeData(cpu::Cpu& cpu, Instant now);

  io::Rack rack_;
  technology::Counting counting_;
  positioning::Positioning positioning_;
  SerialModule serial_;
  profibus::Exchange exchange_;
  DpInterface dp_;
  plant::Plants plants_;
  FarWires wires_;
  Notice noticed_ = Notice::Anyhow;  // of the last advance
};

}  // namespace merker::station
