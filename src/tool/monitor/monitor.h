// The one interface to a running PLC for everybody outside: command line, workbench, server. Values
// by operand or symbol, forces, variable tables, breakpoints, stacks, diagnosis. What a machine
// does not have it answers with `can`; nobody asks for its family.
#pragma once

#include <functional>
#include <list>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "monitor/debugger.h"
#include "monitor/diagnostic_list.h"
#include "monitor/display_format.h"
#include "monitor/feature.h"
#include "monitor/frame_variables.h"
#include "monitor/location.h"
#include "monitor/module_information.h"
#include "monitor/stacks.h"
#include "monitor/variable_table.h"
#include "scenario/forced.h"

namespace merker::monitor {

using simulator::Forced;

// What somebody wants an operand to be: "MW 10", "00FF", HEX.
struct Wish {
  std::string_view operand, value;
  DisplayFormat format = DisplayFormat::Automatic;
};

// A wish that can be carried out.
struct Change {
  address::Reference operand;
  Value value;
};

struct CycleTimes {
  std::int32_t last = 0, shortest = 0, longest = 0;
};

class Monitor : private CycleAccess {
 public:
  virtual ~Monitor() = default;
  Monitor(const Monitor&) = delete;
  Monitor& operator=(const Monitor&) = delete;

  virtual bool can(Feature feature) const = 0;
  controller::Controller& plc() { return target_->plc(); }
  const controller::Controller& plc() const { return std::as_const(*target_).plc(); }
  Debugger& debugger() { return debugger_; }
  const Debugger& debugger() const { return debugger_; }
  ProgramCode program() const { return target_->program(); }
  LocationContext locations(std::string currentFile) const;

  // values, by text (S7-SIM-12); #name is a variable of the block that runs or stands
  Result<address::Reference> operand(std::string_view text) const;
  const simulator::Resolver& resolver() const { return resolver_; }
  Result<std::string> read(std::string_view operand, DisplayFormat format) const;
  std::optional<Problem> write(std::string_view operand, std::string_view value,
                               DisplayFormat format = DisplayFormat::Automatic) {
    return write({{operand, value, format}});
  }
  // All of them, or none if one cannot be carried out.
  std::optional<Problem> write(const std::vector<Wish>& wishes);
  // forces, until they are taken away; the same operand again replaces its value
  std::optional<Problem> force(std::string_view operand, std::string_view value) {
    return force({{operand, value}});
  }
  std::optional<Problem> force(const std::vector<Wish>& wishes);
  std::optional<Problem> force(std::vector<Change> changes);
  std::optional<Problem> unforce(std::string_view operand) { return unforce(std::vector{operand}); }
  std::optional<Problem> unforce(const std::vector<std::string_view>& operands);
  void unforceAll();
  const std::vector<Forced>& forces() const;
  // The table stays with the monitor.
  VariableTable& addTable();
  void removeTable(const VariableTable& table);
  // Whoever else looks and modifies at these points.
  void onPoint(std::function<void(CyclePoint)> observer) { observer_ = std::move(observer); }
  // The same for those who come and go.
  void watch(std::weak_ptr<PointWatcher> watcher) { watchers_.push_back(std::move(watcher)); }
  // Refused are what does not exist, what takes no value, and forced outputs and flags.
  std::optional<Problem> checkWrite(const address::Reference& reference) const override;
  std::optional<Problem> checkValue(const address::Reference& reference,
                                    const Value& value) const override;
  // What a wish at a cycle point comes to; there a forced input is refused, too.
  Result<Change> inCycle(const Wish& wish) const;
  void modifyInCycle(const address::Reference& reference, const Value& value) final;

  // As a programming device does it, not the mode switch.
  virtual void stop() = 0;
  // "2005-09-01 08:00:00.000", as the clock of the machine shows it; empty: it has none.
  virtual std::string clock() const = 0;
  // Milliseconds since 1990-01-01, where the machine has a clock.
  virtual void setClock(std::int64_t) {}
  // A program was given to the machine that it takes at the end of its cycle.
  virtual bool downloadWaits() const = 0;

  // S5 timers by hand (S7-SIM-13), where the machine can: they stand until someone sets them.
  virtual bool timersHeld() const { return false; }
  virtual void holdTimers(bool) {}
  virtual std::size_t timers() const { return 0; }
  virtual void resetTimer(std::size_t) {}

  // looks at the machine
  // Milliseconds; nothing where it measures none.
  virtual std::optional<CycleTimes> cycleTimes() const { return std::nullopt; }
  virtual std::size_t diagnosticsAdded() const = 0;  // since it was built: it only grows
  Registers registers() const { return target_->registers(); }
  virtual Stacks stacks() const = 0;
  virtual std::vector<DiagnosticLine> diagnostics() const = 0;
  virtual ModuleInformation information() const = 0;
  virtual std::vector<FrameVariable> variables(std::size_t depth) const = 0;

 protected:
  // `symbols` and whatever the resolver stands on outlive the monitor; the machine stays where it
  // is. One monitor per machine.
  Monitor(std::unique_ptr<Target> target, const source::SymbolTable& symbols,
          simulator::Resolver resolver);
  void reached(CyclePoint point);
  // A variable of the running block.
  virtual Result<address::Reference> local(std::string_view text, const Position& at) const;

 private:
  virtual void writeInCycle(const address::Reference& reference, const Value& value) = 0;
  virtual bool canForce(const address::Reference& reference) const = 0;
  bool isForceable(const address::Reference& reference) const;
  // Whether `write` would do it. Nothing is changed.
  virtual bool canWrite(const address::Reference& reference) const = 0;
  // Whether an operand that can be written takes this value, too.
  virtual bool takes(const address::Reference&, const Value&) const { return true; }
  // Whether the machine holds anything at a value: a memory reset frees all.
  virtual bool holdsForces() const = 0;
  controller::Controller& machine() override { return plc(); }
  Result<Change> understand(const Wish& wish) const;
  Result<Change> change(const Wish& wish) const;
  bool isForced(const address::Reference& reference) const;
  Problem refusal(const address::Reference& reference) const;
  void forceAgain();

  std::unique_ptr<Target> target_;
  const source::SymbolTable& symbols_;
  simulator::Resolver resolver_;
  Debugger debugger_;
  std::list<VariableTable> tables_;
  mutable std::vector<Forced> forces_;  // as last seen: the machine holds them
  std::function<void(CyclePoint)> observer_;
  std::vector<std::weak_ptr<PointWatcher>> watchers_;
};

// Of the kind of this machine (factory.cpp): the only place that asks for it.
std::unique_ptr<Monitor> monitorOf(controller::Controller& plc, const source::SymbolTable& symbols,
                                   simulator::Resolver resolver);

}  // namespace merker::monitor
