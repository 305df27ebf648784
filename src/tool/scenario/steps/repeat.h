// repeat N … end: the steps between, N times.
#pragma once

#include <cstdint>
#include <vector>

#include "scenario/step_binding.h"
#include "scenario/step_line.h"
#include "scenario/step_run.h"

namespace merker::simulator::steps {

struct Repeat {
  static constexpr std::string_view kWords = "repeat";

  std::uint64_t count = 0;
  std::vector<Step> body;  // filled line by line up to `end`

  bool parse(const StepLine& line) { return line.number(line.rest(), count); }
  void resolve(const StepBinding& binding) { binding.bind(body); }
  bool perform(StepRun& run) const {
    for (std::uint64_t i = 0; i < count; ++i)
      if (!run.run(body)) return false;
    return true;
  }
};

}  // namespace merker::simulator::steps
