// station Press: what follows is done by this station of a project of several, in a repeat up to
// its end.
#pragma once

#include <string>

#include "scenario/steps/bare.h"

namespace merker::simulator::steps {

struct Station {
  static constexpr std::string_view kWords = "station";

  std::string name;
  Position position;

  bool parse(const StepLine& line) {
    if (line.rest().empty())
      return line.fail(ProblemCode::P0952, line.whole(), "the name of a station");
    name = line.rest();
    position = line.at(line.rest());
    return true;
  }
  void resolve(const StepBinding&) {}  // StepBinding::bind looks at it
  bool perform(StepRun&) const { return true; }
};

}  // namespace merker::simulator::steps
