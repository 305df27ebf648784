// Lines to steps; scenario_parser.cpp and expectation_parser.cpp hold the members. Every text is a
// view into the file, so that a problem can point at it.
#pragma once

#include <string_view>
#include <vector>

#include "simulator/scenario.h"
#include "simulator/step_words.h"

namespace merker::simulator {

// In front of a step or an expectation: of the coupled control.
inline constexpr std::string_view kPartner = "partner";

class ScenarioParser {
 public:
  ScenarioParser(const source::SourceFile& file, Problems& problems)
      : file_(file), problems_(problems) {}

  std::vector<Scenario> parse();
  std::vector<Assignment> assignments(std::string_view text);

 private:
  Position at(std::string_view text) const;
  template <typename... Arguments>
  bool fail(ProblemCode code, std::string_view where, const Arguments&... arguments) {
    problems_.add(code, at(where), arguments...);
    return false;
  }

  void line(std::string_view text);
  void step(const StepWord& word, std::string_view whole, std::string_view rest,
            bool partner = false);
  void partnerStep(std::string_view whole, std::string_view rest);
  bool content(Step& step, StepWord::Rest kind, std::string_view rest);
  void beginScenario(std::string_view whole, std::string_view rest);
  void beginRepeat(Step step);
  void endRepeat(std::string_view whole, std::string_view rest);
  void closeScenario();

  bool wait(Step& step, std::string_view rest);
  bool terminals(std::vector<TerminalValue>& list, std::string_view rest);
  bool plants(std::vector<PlantValue>& list, std::string_view rest);
  bool switchTo(Step& step, std::string_view rest);
  bool trigger(Step& step, std::string_view rest);
  bool count(std::uint64_t& number, std::string_view text);
  bool expectation(Expectation& e, std::string_view rest);
  bool timing(Expectation& e, std::string_view& rest);
  bool mode(Expectation& e, std::string_view rest, std::string_view value);
  bool led(Expectation& e, std::string_view rest, std::string_view which, std::string_view light);
  bool diagnostics(Expectation& e, std::string_view rest);
  bool stack(Expectation& e, std::string_view rest, std::string_view field, std::string_view value);
  bool assignment(std::vector<Assignment>& list, std::string_view text);
  bool term(Term& term, std::string_view text, std::string_view where, std::string_view what);
  std::vector<Step>& target();

  const source::SourceFile& file_;
  Problems& problems_;
  std::vector<Scenario> scenarios_;
  std::string_view line_;    // being read, without its comment
  std::vector<Step> open_;   // repeats not yet ended, outermost first
  std::size_t tooDeep_ = 0;  // further ones
};

}  // namespace merker::simulator
