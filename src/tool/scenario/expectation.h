// What `expect` speaks of: one of the value types of expectations/ (docs/formats/scenario.md).
#pragma once

#include <concepts>
#include <string>
#include <variant>

#include "scenario/expectations/diagnostics.h"
#include "scenario/expectations/led.h"
#include "scenario/expectations/mode.h"
#include "scenario/expectations/plant.h"
#include "scenario/expectations/stack.h"
#include "scenario/expectations/terminal.h"
#include "scenario/expectations/values.h"

namespace merker::simulator {

// It can be expected of this PLC: of any, or only of a SIMATIC S7 station.
template <typename E, typename Plc>
concept CanLookAt = requires(const E& one, Plc& plc) {
  { one.holds(plc) } -> std::same_as<bool>;
  { one.actual(plc) } -> std::same_as<std::string>;
};

// What every expectation has. The list below does not compile with one that lacks a part.
template <typename E>
concept IsExpectation = CanLookAt<E, station::Station> &&
    requires(E& one, const StepLine& line, const Claim& claim, const StepBinding& binding) {
  { one.parse(line, claim) } -> std::same_as<bool>;
  one.resolve(binding);
  // A scenario that speaks of the state of the CPU may end in STOP.
  { E::kSpeaksOfState } -> std::convertible_to<bool>;
};

template <IsExpectation... E>
using OneExpectationOf = std::variant<E...>;

using AnyExpectation =
    OneExpectationOf<expectations::Values, expectations::Mode, expectations::Diagnostics,
                     expectations::Terminal, expectations::Led, expectations::Plant,
                     expectations::Stack>;

// Reads what stands behind `expect`, without the time; `ofPartner`: of the coupled control.
bool parseExpectation(const StepLine& line, std::string_view text, bool ofPartner,
                      AnyExpectation& expectation);

// LEDs, terminals and plants exist on a SIMATIC S7 station only.
bool needsStation(const AnyExpectation& expectation);
bool speaksOfState(const AnyExpectation& expectation);
// `station` is `plc`, or null if that is none.
bool holds(const AnyExpectation& expectation, controller::Controller& plc,
           station::Station* station);
// "A 1.2 is 0", "mode is STOP: …": what is there instead.
std::string actual(const AnyExpectation& expectation, controller::Controller& plc,
                   station::Station* station);

}  // namespace merker::simulator
