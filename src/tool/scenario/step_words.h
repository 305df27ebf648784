// The words a step begins with.
#pragma once

#include <string>
#include <string_view>

#include "scenario/step.h"

namespace merker::simulator {

// In front of a step or an expectation: of the coupled control.
inline constexpr std::string_view kPartner = "partner";

struct StepWord {
  std::string_view words;  // "set", "cold restart"
  // Makes the step of the rest of its line; false, and a problem, if it is wrong.
  bool (*parse)(const StepLine&, AnyStep&);
  bool partner;  // the coupled control can do it, too
};

// The step that `line` begins with, the longest one; its words are taken off. Null if there is
// none.
const StepWord* takeStepWord(std::string_view& line);
// Takes the words of `wanted` off `line` if it begins with them.
bool takeWords(std::string_view& line, std::string_view wanted);
// Whether the line begins with a step that needs simulated signals.
bool expectsSignal(std::string_view line);
// "set, wait, …", for problems.
std::string stepWords();

}  // namespace merker::simulator
