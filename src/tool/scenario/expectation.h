// What `expect` speaks of: one of the value types of expectations/ (docs/formats/scenario.md).
#pragma once

#include <concepts>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "scenario/expectations/axis.h"
#include "scenario/expectations/diagnostics.h"
#include "scenario/expectations/led.h"
#include "scenario/expectations/mode.h"
#include "scenario/expectations/plant.h"
#include "scenario/expectations/serial.h"
#include "scenario/expectations/stack.h"
#include "scenario/expectations/terminal.h"
#include "scenario/expectations/values.h"

namespace merker::simulator {

// What every expectation has. The list below does not compile with one that lacks a part.
template <typename E>
concept IsExpectation = requires(E& one, const E& ready, const StepLine& line, const Claim& claim,
                                 const StepBinding& binding, controller::Controller& plc) {
  { one.parse(line, claim) } -> std::same_as<bool>;
  one.resolve(binding);
  { ready.holds(plc) } -> std::same_as<bool>;
  { ready.actual(plc) } -> std::same_as<std::string>;
  // A scenario that speaks of the state of the CPU may end in STOP.
  { E::kSpeaksOfState } -> std::convertible_to<bool>;
};

template <IsExpectation... E>
using OneExpectationOf = std::variant<E...>;

using AnyExpectation =
    OneExpectationOf<expectations::Values, expectations::Mode, expectations::Diagnostics,
                     expectations::Terminal, expectations::Led, expectations::Plant,
                     expectations::Stack, expectations::Axis, expectations::Serial>;

// Reads what stands behind `expect`, without the time; `ofPartner`: of the coupled control.
bool parseExpectation(const StepLine& line, std::string_view text, bool ofPartner,
                      AnyExpectation& expectation);

bool speaksOfState(const AnyExpectation& expectation);
// "LEDs": what it looks at (`Needs`) and this PLC does not have; empty if there is all it needs.
std::string_view missing(const AnyExpectation& expectation, const controller::Controller& plc);
// Nothing is missing.
bool holds(const AnyExpectation& expectation, controller::Controller& plc);
// Before this instant it comes to the same as long as the memory of the PLC and its mode stay as
// they are; none: nobody knows.
std::optional<Instant> staysUntil(const AnyExpectation& expectation,
                                  const controller::Controller& plc);
// "A 1.2 is 0", "mode is STOP: …": what is there instead.
std::string actual(const AnyExpectation& expectation, controller::Controller& plc);

}  // namespace merker::simulator
