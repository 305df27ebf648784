// Lines to scenarios. Every text is a view into the file, so that a problem can point at it.
#pragma once

#include <string_view>
#include <vector>

#include "scenario/scenario.h"
#include "scenario/step_words.h"

namespace merker::simulator {

class ScenarioParser {
 public:
  ScenarioParser(const source::SourceFile& file, Problems& problems)
      : file_(file), problems_(problems) {}

  std::vector<Scenario> parse();

 private:
  void line(std::string_view text);
  void step(const StepWord& word, const StepLine& line, bool partner);
  void partnerStep(std::string_view whole, std::string_view rest);
  void unknownStep(std::string_view whole);
  void beginScenario(const StepLine& line);
  void beginRepeat(Step step);
  void endRepeat(const StepLine& line);
  void closeScenario();
  StepLine lineOf(std::string_view whole, std::string_view rest) const {
    return {file_, whole, rest, problems_};
  }
  std::vector<Step>& target();

  const source::SourceFile& file_;
  Problems& problems_;
  std::vector<Scenario> scenarios_;
  std::vector<Step> open_;   // repeats not yet ended, outermost first
  std::size_t tooDeep_ = 0;  // further ones
};

}  // namespace merker::simulator
