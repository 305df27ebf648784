#include "simulator/scenario_parser.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <filesystem>

#include "base/text.h"
#include "simulator/duration.h"
#include "simulator/line.h"

namespace merker::simulator {

constexpr std::size_t kDeepestRepeat = 16;

// An empty part may have lost its place; the whole line stands for it.
Position ScenarioParser::at(std::string_view text) const {
  if (text.empty()) text = line_;
  const auto offset = static_cast<std::size_t>(text.data() - file_.text().data());
  return file_.position(offset, std::max<std::size_t>(text.size(), 1));
}

std::vector<Step>& ScenarioParser::target() {
  if (!open_.empty()) return open_.back().body;
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
  line_ = text;
  std::string_view rest = text;
  if (const StepWord* word = expectsSignal(text) ? nullptr : takeStepWord(rest))
    return step(*word, text, rest);
  std::string_view first = takeWord(rest);
  if (equalsIgnoreCase(first, kPartner)) return partnerStep(text, rest);
  if (!expectsSignal(text)) {
    fail(ProblemCode::P0950, first, first, stepWords());
    return;
  }
  if (equalsIgnoreCase(first, "expect")) {  // expect encoder
    const std::string_view second = takeWord(rest);
    first = text.substr(0, static_cast<std::size_t>(second.data() + second.size() - text.data()));
  }
  fail(ProblemCode::P0951, first, first, stepWords());
}

// "partner stop": what the coupled control can do.
void ScenarioParser::partnerStep(std::string_view whole, std::string_view rest) {
  using enum StepKind;
  constexpr StepKind kKinds[] = {
      Run,        Stop,        ColdRestart, WarmRestart, PowerOff, PowerOn, PowerOnUnbuffered,
      BatteryLow, BatteryGood, MemoryReset, Fault};
  const std::string_view place = rest.empty() ? whole : rest;
  const StepWord* word = takeStepWord(rest);
  if (word != nullptr && word->rest != StepWord::Rest::End &&
      std::find(std::begin(kKinds), std::end(kKinds), word->kind) != std::end(kKinds))
    return step(*word, whole, rest, true);
  fail(ProblemCode::P0952, place,
       "run, stop, cold restart, warm restart, power off, power on, memory reset, battery low, "
       "battery good or fault; its operands are set as set partner.MW 10 = 5");
}

void ScenarioParser::step(const StepWord& word, std::string_view whole, std::string_view rest,
                          bool partner) {
  if (word.rest == StepWord::Rest::Scenario) return beginScenario(whole, rest);
  if (word.rest == StepWord::Rest::End) return endRepeat(whole, rest);
  Step step;
  step.kind = word.kind;
  step.position = at(whole);
  step.text = whole;
  step.partner = partner;
  const bool good = content(step, word.rest, rest);
  if (step.kind == StepKind::Repeat)
    beginRepeat(std::move(step));
  else if (good)
    target().push_back(std::move(step));
}

bool ScenarioParser::content(Step& step, StepWord::Rest kind, std::string_view rest) {
  switch (kind) {
    case StepWord::Rest::Assignments:
      step.assignments = assignments(rest);
      return !step.assignments.empty();
    case StepWord::Rest::Wait:
      return wait(step, rest);
    case StepWord::Rest::Expectation:
      return expectation(step.expectation, rest);
    case StepWord::Rest::Count:
      return count(step.count, rest);
    case StepWord::Rest::Fault:
      return parseFault(
          rest, step.fault, [this](std::string_view text) { return at(text); }, problems_);
    case StepWord::Rest::Pulses:
    case StepWord::Rest::Encoder:
      return parseSignal(
          rest, kind == StepWord::Rest::Encoder, step.signal,
          [this](std::string_view text) { return at(text); }, problems_);
    case StepWord::Rest::Terminals:
      return terminals(step.terminals, rest);
    case StepWord::Rest::Plants:
      return plants(step.plants, rest);
    case StepWord::Rest::Switch:
      return switchTo(step, rest);
    case StepWord::Rest::Trigger:
      return trigger(step, rest);
    case StepWord::Rest::None:
    case StepWord::Rest::End:
    case StepWord::Rest::Scenario:
      break;
  }
  return rest.empty() || fail(ProblemCode::P0959, rest, rest, step.text);
}

void ScenarioParser::beginScenario(std::string_view whole, std::string_view rest) {
  closeScenario();
  std::string name(rest);
  if (rest.size() >= 2 && rest.front() == '"' && rest.back() == '"')
    name = rest.substr(1, rest.size() - 2);
  else
    fail(ProblemCode::P0952, rest.empty() ? whole : rest, "a name in quotation marks");
  scenarios_.push_back({std::move(name), at(whole), {}});
}

// Also with a bad count, so that its end is not a second problem.
void ScenarioParser::beginRepeat(Step step) {
  if (open_.size() < kDeepestRepeat && tooDeep_ == 0) return open_.push_back(std::move(step));
  if (tooDeep_++ == 0)
    problems_.add(ProblemCode::P0952, step.position,
                  fmt::format("'end' (at most {} repeats inside each other)", kDeepestRepeat));
}

void ScenarioParser::endRepeat(std::string_view whole, std::string_view rest) {
  if (!rest.empty()) fail(ProblemCode::P0959, rest, rest, "end");
  if (tooDeep_ > 0) {
    --tooDeep_;
    return;
  }
  if (open_.empty()) {
    fail(ProblemCode::P0957, whole);
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

bool ScenarioParser::wait(Step& step, std::string_view rest) {
  std::string_view words = rest;
  const std::string_view number = takeWord(words);
  if (equalsIgnoreCase(words, "cycles") || equalsIgnoreCase(words, "cycle")) {
    step.kind = StepKind::WaitCycles;
    return count(step.count, number);
  }
  const auto duration = parseDuration(rest);
  if (!duration) return fail(ProblemCode::P0953, rest.empty() ? number : rest, rest);
  step.duration = *duration;
  return true;
}

bool ScenarioParser::terminals(std::vector<TerminalValue>& list, std::string_view rest) {
  const auto place = [this](std::string_view text) { return at(text); };
  for (std::string_view part : splitList(rest)) {
    const auto sign = findOutside(part, [](std::string_view tail) { return tail[0] == '='; });
    if (sign == std::string_view::npos) return fail(ProblemCode::P0952, part, "MODULE.DI0 = VALUE");
    TerminalValue value;
    if (!parseTerminal(trim(part.substr(0, sign)), trim(part.substr(sign + 1)), value, place,
                       problems_))
      return false;
    list.push_back(std::move(value));
  }
  return true;
}

bool ScenarioParser::plants(std::vector<PlantValue>& list, std::string_view rest) {
  const auto place = [this](std::string_view text) { return at(text); };
  for (std::string_view part : splitList(rest))
    if (!parsePlantStep(part, list.emplace_back(), place, problems_)) return false;
  return true;
}

bool ScenarioParser::count(std::uint64_t& number, std::string_view text) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error == std::errc() && end == text.data() + text.size() && number <= 1'000'000'000)
    return true;
  number = 0;
  return fail(ProblemCode::P0952, text, "a whole number from 0 to 1000000000");
}

bool ScenarioParser::switchTo(Step& step, std::string_view rest) {
  const auto position = parseSwitch(rest);
  if (!position) return fail(ProblemCode::P0952, rest, "RUN-P, RUN, STOP or MRES");
  step.switchPosition = *position;
  return true;
}

bool ScenarioParser::trigger(Step& step, std::string_view rest) {
  const ParsedTrigger parsed = parseTrigger(rest);
  step.trigger = parsed.trigger;
  return parsed.expected.empty() || fail(ProblemCode::P0952, parsed.wrong, parsed.expected);
}

bool ScenarioParser::term(Term& term, std::string_view text, std::string_view where,
                          std::string_view what) {
  if (text.empty()) return fail(ProblemCode::P0952, where, what);
  term.text = text;
  term.position = at(text);
  return true;
}

bool ScenarioParser::assignment(std::vector<Assignment>& list, std::string_view text) {
  const auto sign = findOutside(text, [](std::string_view rest) { return rest[0] == '='; });
  if (sign == std::string_view::npos) return fail(ProblemCode::P0952, text, "OPERAND = VALUE");
  Assignment assignment;
  const bool good = term(assignment.operand, trim(text.substr(0, sign)), text, "an operand") &&
                    term(assignment.value, trim(text.substr(sign + 1)), text, "a value");
  if (good) list.push_back(std::move(assignment));
  return good;
}

std::vector<Assignment> ScenarioParser::assignments(std::string_view text) {
  if (line_.empty()) line_ = text;
  std::vector<Assignment> list;
  for (std::string_view part : splitList(text)) assignment(list, part);
  return list;
}

std::vector<Scenario> parseScenarios(const source::SourceFile& file, Problems& problems) {
  return ScenarioParser(file, problems).parse();
}

std::vector<Assignment> parseAssignments(const source::SourceFile& file, std::string_view text,
                                         Problems& problems) {
  return ScenarioParser(file, problems).assignments(text);
}

}  // namespace merker::simulator
