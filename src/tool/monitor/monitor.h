// The one interface to a running CPU for everybody outside: command line, workbench, server. Values
// by operand or symbol, forces, variable tables, breakpoints, stacks, diagnosis.
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
#include "monitor/forced.h"
#include "monitor/frame_variables.h"
#include "monitor/location.h"
#include "monitor/module_information.h"
#include "monitor/stacks.h"
#include "monitor/variable_table.h"

namespace merker::monitor {

// What somebody wants an operand to be: "MW 10", "00FF", HEX.
struct Wish {
  std::string_view operand, value;
  DisplayFormat format = DisplayFormat::Automatic;
};

class Monitor {
 public:
  // Station, symbols and whatever the resolver stands on outlive the monitor; the station stays
  // where it is. One monitor per station.
  Monitor(station::Station& station, const source::SymbolTable& symbols,
          simulator::Resolver resolver);
  ~Monitor();
  Monitor(const Monitor&) = delete;
  Monitor& operator=(const Monitor&) = delete;

  station::Station& station() { return station_; }
  Debugger& debugger() { return debugger_; }
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
  std::optional<Problem> unforce(std::string_view operand) { return unforce(std::vector{operand}); }
  std::optional<Problem> unforce(const std::vector<std::string_view>& operands);
  void unforceAll();
  const std::vector<Forced>& forces() const;
  // The table stays with the monitor.
  VariableTable& addTable();
  void removeTable(const VariableTable& table);
  // Whoever else looks and modifies at these points.
  void onPoint(std::function<void(cpu::CyclePoint)> observer) { observer_ = std::move(observer); }
  // Refused are what does not exist, what takes no value, and outputs that are forced.
  std::optional<Problem> checkWrite(const address::Reference& reference) const;

  // looks at the CPU
  Stacks stacks() const;
  std::vector<DiagnosticLine> diagnostics() const { return diagnosticList(station_); }
  ModuleInformation information() const { return moduleInformation(station_); }
  std::vector<FrameVariable> variables(std::size_t depth) const;

 private:
  Result<address::Reference> local(std::string_view text, const Position& at) const;
  bool isForced(const address::Reference& reference) const;
  void forceAgain();

  station::Station& station_;
  const source::SymbolTable& symbols_;
  simulator::Resolver resolver_;
  Debugger debugger_;
  std::list<VariableTable> tables_;
  mutable std::vector<Forced> forces_;  // as last seen: the CPU holds them
  std::function<void(cpu::CyclePoint)> observer_;
};

}  // namespace merker::monitor
