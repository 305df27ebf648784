#include "scenario/step_words.h"

#include <array>

#include "base/text.h"

namespace merker::simulator {
namespace {

template <IsStep S>
bool parse(const StepLine& line, AnyStep& step) {
  return step.emplace<S>().parse(line);
}

// Whether the coupled control can do it, too: `kPartner` of the step.
template <IsStep S>
constexpr bool partnerCan() {
  if constexpr (requires { S::kPartner; }) return S::kPartner;
  return false;
}

template <IsStep... All>
constexpr std::array<StepWord, sizeof...(All)> rowsOf(const std::variant<All...>*) {
  return {StepWord{All::kWords, parse<All>, partnerCan<All>()}...};
}

// In the order of AnyStep, which is the order in which problems list them.
constexpr auto kSteps = rowsOf(static_cast<const AnyStep*>(nullptr));

}  // namespace

bool takeWords(std::string_view& line, std::string_view wanted) {
  std::string_view rest = line;
  while (!wanted.empty()) {
    const std::string_view one = takeWord(rest);
    if (!equalsIgnoreCase(one, takeWord(wanted))) return false;
  }
  line = rest;
  return true;
}

const StepWord* takeStepWord(std::string_view& line) {
  const StepWord* found = nullptr;
  std::string_view behind;
  for (const StepWord& step : kSteps) {
    std::string_view rest = line;
    if (!takeWords(rest, step.words)) continue;
    if (found != nullptr && found->words.size() > step.words.size()) continue;  // power on …
    found = &step;
    behind = rest;
  }
  if (found != nullptr) line = behind;
  return found;
}

bool expectsSignal(std::string_view line) {
  if (!equalsIgnoreCase(takeWord(line), "expect")) return false;
  const std::string_view one = takeWord(line);
  return equalsIgnoreCase(one, "pulses") || equalsIgnoreCase(one, "encoder");
}

std::string stepWords() {
  std::string list;
  for (const StepWord& step : kSteps) list += std::string(step.words) + ", ";
  return list + "end";
}

}  // namespace merker::simulator
