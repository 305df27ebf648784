// What a station consists of, and how it moves with the other one at its line.
#pragma once

#include "cpu/cpu.h"
#include "station/mixed_engine.h"
#include "station/modules.h"
#include "station/periphery.h"
#include "station/senders.h"
#include "station/station.h"
#include "system/global_data.h"
#include "system/services.h"
#include "system/subnet_links.h"

namespace merker::station {

struct Station::Parts {
  explicit Parts(Options options)
      : model(options.model),
        program(options.program ? options.program : std::make_shared<const block::Program>()),
        engine(*model, options.engine == Engine::Compiled),
        services(*model, options.libraries),
        cpu(*model, engine, services, options.startOfClock,
            options.parameters.value_or(CpuParameters::of(*model))) {
    engine.interpreter().countCoverage(options.coverage);
    if (options.communication) services.configure(*options.communication);
    cpu.load(program);
    if (options.hardware) plug(std::move(*options.hardware), std::move(options.plants));
  }

  const CpuModel* model;
  std::shared_ptr<const block::Program> program;
  MixedEngine engine;
  system::Services services;
  std::unique_ptr<Periphery> periphery;  // null without a hardware configuration
  std::unique_ptr<Modules> modules;
  cpu::Cpu cpu;
  Station* self = nullptr;  // whom the observer gets to see; moves along
  std::function<void(controller::Controller&)> observer;
  bool eachCycle = false;  // the observer wants to see it, also when it changed nothing

  void plug(io::Configuration hardware, plant::Configuration plants) {
    periphery = std::make_unique<Periphery>(std::move(hardware), std::move(plants));
    periphery->connect(cpu);
    modules = std::make_unique<Modules>(periphery->rack(), periphery->exchange());
    services.connect(modules.get(), &periphery->counting(), &periphery->positioning());
    SerialModule& serial = periphery->serial();
    if (serial.coupling() != nullptr) services.connect(serial.coupling(), serial.address());
  }

  // The start itself is the wish, whatever the switch does by its position.
  bool restart(cpu::Restart how) {
    cpu.releaseSwitch();
    return cpu.restart(how);
  }

  system::GlobalDataExchange globalData;
  Senders senders;
  system::SubnetLinks links{cpu};
  block::RetentiveData kept;
  std::vector<DiagnosticEntry> diagnostics;
  std::uint64_t diagnosticsSeen = 0;
  std::vector<CheckResult> checks;

  serial::Coupling* serial() { return periphery ? periphery->serial().coupling() : nullptr; }
  // One step of the CPU. In STOP it answers its partners at the instant at which they ask.
  void step(Instant limit) {
    if (periphery && periphery->nextOfPartners() <= limit) cpu.machine().interrupt();
    if (!onSubnet() || cpu.mode() != cpu::Mode::Stop) return cpu.step(limit);
    rest();
    cpu.step(std::min({limit, services.partners().next(), links.next()}));
    rest();
  }
  // As Connectable::maySend().
  bool maySend() {
    return !links.empty() || !globalData.empty() || !services.partners().idle() ||
           (periphery && periphery->hasPartners()) || cpu.loadMemory().downloaded() ||
           senders.in(cpu.program());
  }
  bool onSubnet() const { return services.partners().joined() || !links.empty(); }
  void rest() {
    system::BasicCommunication& partners = services.partners();
    partners.rest(cpu, cpu.machine().clock, cpu.powered());
    links.rest(partners, services.sendReceive(), cpu.machine().clock, cpu.powered());
    globalData.rest(partners);
  }
  // At the end of a cycle: partners first, then who looks on.
  void checkpoint() {
    if (onSubnet()) {
      services.partners().serve(cpu, cpu.machine().clock);
      links.serve(services.partners(), services.connections(), services.sendReceive(),
                  cpu.machine().clock);
      globalData.exchange(cpu, services.partners());
    }
    if (!observer) return;
    takeAlong();
    observer(*self);
  }
  // To the same time as the other station, which looks at the line or is looked at.
  void follow(Instant t) {
    if (serial()->next() != Instant::never()) cpu.machine().interrupt();
    self->moveTo(t);
  }
  void takeAlong() {
    if (partner) partner->parts_->follow(cpu.machine().clock);
  }
  std::unique_ptr<Station> partner;
};

}  // namespace merker::station
