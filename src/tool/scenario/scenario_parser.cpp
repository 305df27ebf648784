#include "scenario/scenario_parser.h"

#include <fmt/format.h>

#include <filesystem>

#include "base/text.h"

namespace merker::simulator {

constexpr std::size_t kDeepestRepeat = 16;

std::vector<Step>& ScenarioParser::target() {
  if (!open_.empty()) return std::get<steps::Repeat>(open_.back().does).body;
  if (scenarios_.empty())
    scenarios_.push_back(
        {std::filesystem::path(file_.name()).stem().string(), {file_.name(), 1, 1}, {}});
  return scenarios_.back().steps;
}

std::vector<Scenario> ScenarioParser::parse() {
  for (std::uint32_t number = 1; number <= file_.lineCount(); ++number)
    line(withoutComment(file_.line(number)));
  closeScenario();
  if (scenarios_.empty() && problems_.empty())
    problems_.add(ProblemCode::P0958, Position{file_.name()});
  return std::move(scenarios_);
}

void ScenarioParser::line(std::string_view text) {
  if (text.empty()) return;
  std::string_view rest = text;
  if (takeWords(rest, "scenario")) return beginScenario(lineOf(text, rest));
  if (takeWords(rest, "end")) return endRepeat(lineOf(text, rest));
  if (takeWords(rest, kPartner)) return partnerStep(text, rest);
  const StepWord* const word = expectsSignal(text) ? nullptr : takeStepWord(rest);
  if (word == nullptr) return unknownStep(text);
  step(*word, lineOf(text, rest), false);
}

void ScenarioParser::unknownStep(std::string_view whole) {
  std::string_view rest = whole;
  std::string_view first = takeWord(rest);
  const bool signal = expectsSignal(whole);
  if (signal) {  // expect encoder
    const std::string_view second = takeWord(rest);
    first = whole.substr(0, static_cast<std::size_t>(second.data() + second.size() - whole.data()));
  }
  lineOf(whole, rest)
      .fail(signal ? ProblemCode::P0951 : ProblemCode::P0950, first, first, stepWords());
}

// "partner stop": what the coupled control can do.
void ScenarioParser::partnerStep(std::string_view whole, std::string_view rest) {
  const std::string_view place = rest.empty() ? whole : rest;
  const StepWord* const word = takeStepWord(rest);
  if (word != nullptr && word->partner) return step(*word, lineOf(whole, rest), true);
  lineOf(whole, rest)
      .fail(
          ProblemCode::P0952, place,
          "run, stop, cold restart, warm restart, power off, power on, memory reset, battery low, "
          "battery good or fault; set its operands with set partner.MW 10 = 5");
}

// A repeat counts also with a bad number, so that its end is not a second problem.
void ScenarioParser::step(const StepWord& word, const StepLine& line, bool partner) {
  Step step{line.at(line.whole()), std::string(line.whole()), partner, {}};
  const bool good = word.parse(line, step.does);
  if (std::holds_alternative<steps::Repeat>(step.does))
    beginRepeat(std::move(step));
  else if (good)
    target().push_back(std::move(step));
}

void ScenarioParser::beginScenario(const StepLine& line) {
  closeScenario();
  const std::string_view rest = line.rest();
  std::string name(rest);
  if (rest.size() >= 2 && rest.front() == '"' && rest.back() == '"')
    name = rest.substr(1, rest.size() - 2);
  else
    line.fail(ProblemCode::P0952, rest, "a name in quotation marks");
  scenarios_.push_back({std::move(name), line.at(line.whole()), {}});
}

void ScenarioParser::beginRepeat(Step step) {
  if (open_.size() < kDeepestRepeat && tooDeep_ == 0) return open_.push_back(std::move(step));
  if (tooDeep_++ == 0)
    problems_.add(ProblemCode::P0952, step.position,
                  fmt::format("'end' (repeats can be nested {} deep)", kDeepestRepeat));
}

void ScenarioParser::endRepeat(const StepLine& line) {
  if (!line.rest().empty()) line.fail(ProblemCode::P0959, line.rest(), line.rest(), "end");
  if (tooDeep_ > 0) {
    --tooDeep_;
    return;
  }
  if (open_.empty()) {
    line.fail(ProblemCode::P0957, line.whole());
    return;
  }
  Step repeat = std::move(open_.back());
  open_.pop_back();
  target().push_back(std::move(repeat));
}

void ScenarioParser::closeScenario() {
  for (const Step& repeat : open_) problems_.add(ProblemCode::P0956, repeat.position);
  open_.clear();
  tooDeep_ = 0;
}

std::vector<Scenario> parseScenarios(const source::SourceFile& file, Problems& problems) {
  return ScenarioParser(file, problems).parse();
}

}  // namespace merker::simulator
