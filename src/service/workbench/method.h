// The requests of the protocol (docs/workbench-protocol.md), one row each, one file per group.
#pragma once

#include <span>
#include <string_view>

#include "workbench/fields.h"
#include "workbench/later.h"
#include "workbench/shared.h"

namespace merker::workbench {

struct Call {
  Shared& shared;
  std::uint64_t id;  // of the browser
  Browser& browser;
  const Fields& fields;
  std::shared_ptr<const Json> request;  // what the fields are of

  Plc& plc() const { return *shared.plc; }
  // Of a machine that has them, as the row of the request says.
  station::BlockCpu& blockCpu() const { return *shared.plc->blockCpu(); }
  plant::Field& field() const { return *shared.plc->field(); }
  monitor::Monitor& monitor() const { return shared.plc->monitor(); }
};

// What a request needs: nothing, a PLC, one that is switched on; and what it must be able to do.
struct Needs {
  enum class State : std::uint8_t { Nothing, Plc, PlcOn } state = State::Nothing;
  std::optional<monitor::Feature> feature;

  static const Needs Nothing, Plc, PlcOn;
  static constexpr Needs able(monitor::Feature feature) { return {State::Plc, feature}; }
  static constexpr Needs ableOn(monitor::Feature feature) { return {State::PlcOn, feature}; }
};
inline constexpr Needs Needs::Nothing{State::Nothing, {}};
inline constexpr Needs Needs::Plc{State::Plc, {}};
inline constexpr Needs Needs::PlcOn{State::PlcOn, {}};

// Action: something that a user does to the PLC; it is recorded. Compiled: it looks at the program
// as it stands on the disk, compiled. Compiles: it does that itself. Requests of the last two do
// not hold up those of the same browser that come behind them.
enum class Kind : std::uint8_t { Plain, Action, Compiled, Compiles };

struct Method {
  std::string_view name;
  Needs needs;
  Answer (*run)(const Call& call);
  Kind kind = Kind::Plain;
};

// All of them, in groups of a subject.
std::span<const std::span<const Method>> methodGroups();
// Null: there is none.
const Method* findMethod(std::string_view name);

std::span<const Method> plcMethods();
std::span<const Method> variableMethods();
std::span<const Method> fileMethods();
std::span<const Method> programMethods();
std::span<const Method> dataMethods();
std::span<const Method> debugMethods();
std::span<const Method> symbolMethods();
std::span<const Method> hardwareMethods();
std::span<const Method> diagnosisMethods();
std::span<const Method> processMethods();
std::span<const Method> projectMethods();
std::span<const Method> trendMethods();
std::span<const Method> modifyMethods();
std::span<const Method> timerMethods();
std::span<const Method> snapshotMethods();
std::span<const Method> recordingMethods();
std::span<const Method> downloadMethods();
std::span<const Method> importMethods();
std::span<const Method> serialMethods();
std::span<const Method> networkMethods();
std::span<const Method> stationMethods();
std::span<const Method> plcsMethods();

// {} or the problem.
Answer done(const std::optional<Problem>& problem = {});
Answer empty();
// Of a request: what it names is no place in a file.
Problems withoutPlace(const Problems& problems);

}  // namespace merker::workbench
