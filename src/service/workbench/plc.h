// The PLC that everybody looks at, with its monitor and the project it came from.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "compilation/build.h"
#include "monitor/monitor.h"
#include "plant/field.h"
#include "station/block_cpu.h"

namespace merker::workbench {

// The PLC of this configuration with nothing in it.
std::unique_ptr<controller::Controller> withoutProgram(compilation::Build build);

// Workers look at it while the PLC goes on: never changed, but replaced.
using BuildRef = std::shared_ptr<const compilation::Build>;
using ProgramRef = std::shared_ptr<const block::Program>;

class Plc {
 public:
  using Observer = std::function<void(controller::Controller&)>;

  // A program with errors is not loaded: the CPU is there and empty. `controller`: one that was
  // made from this build already.
  explicit Plc(BuildRef build, std::unique_ptr<controller::Controller> controller = {});
  explicit Plc(compilation::Build build, std::unique_ptr<controller::Controller> controller = {});
  ~Plc();
  Plc(const Plc&) = delete;
  Plc& operator=(const Plc&) = delete;

  const compilation::Build& build() const { return *build_; }
  const BuildRef& buildRef() const { return build_; }
  controller::Controller& controller() { return *controller_; }
  const controller::Controller& controller() const { return *controller_; }
  monitor::Monitor& monitor() { return *monitor_; }
  const monitor::Monitor& monitor() const { return *monitor_; }
  bool can(monitor::Feature feature) const { return monitor_->can(feature); }
  // What only some machines have; null: this one has not.
  station::BlockCpu* blockCpu() { return controller::capability<station::BlockCpu>(*controller_); }
  plant::Field* field() { return controller::capability<plant::Field>(*controller_); }
  const plant::Field* field() const {
    return controller::capability<plant::Field>(std::as_const(*controller_));
  }
  const plant::Plants* plants() const { return field() == nullptr ? nullptr : field()->plants(); }
  const io::Rack* rack() const { return field() == nullptr ? nullptr : field()->rack(); }

  // True the first time: somebody observes it from now on.
  bool attach() { return !std::exchange(attached_, true); }
  // If there is a wish, and a choice.
  void use(std::optional<station::Engine> engine);

  // Values by their text; timers and counters as LC loads them.
  Result<address::Reference> operand(std::string_view text) const;
  std::optional<monitor::Value> read(const address::Reference& reference) const;

  // At each cycle checkpoint, in the order in which they came.
  void onCycle(Observer observer);
  // What a CPU with single blocks was given last, by whomever; workers look at it, too.
  ProgramRef program() const;
  // As the CPU has them.
  std::string download(ProgramRef program);
  void take(const cpu::Snapshot& from, ProgramRef program);
  // Another program from the same project; the CPU has it already. `symbols`: a copy of its own,
  // afterwards that of the old one.
  void replace(BuildRef build, source::SymbolTable& symbols);

 private:
  BuildRef build_;
  source::SymbolTable symbols_;  // the monitor keeps looking at it
  simulator::Resolver operands_;
  std::unique_ptr<controller::Controller> controller_;
  std::unique_ptr<monitor::Monitor> monitor_;
  std::vector<Observer> observers_;
  bool attached_ = false;
};

}  // namespace merker::workbench
