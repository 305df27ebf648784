// The words a step begins with.
#pragma once

#include <string>
#include <string_view>

#include "simulator/scenario.h"

namespace merker::simulator {

struct StepWord {
  std::string_view words;  // "set", "cold restart"
  enum class Rest : std::uint8_t {
    None,
    Assignments,
    Wait,
    Expectation,
    Count,
    Fault,
    Terminals,
    Pulses,
    Encoder,
    Plants,
    Switch,
    Trigger,
    End,
    Scenario
  } rest;
  StepKind kind;  // meaningful for all but End and Scenario
};

// The step that `line` begins with; the words are taken off. Null if there is none.
const StepWord* takeStepWord(std::string_view& line);
// Whether the line begins with a step that needs simulated signals.
bool expectsSignal(std::string_view line);
// "set, wait, …", for problems.
std::string stepWords();

}  // namespace merker::simulator
