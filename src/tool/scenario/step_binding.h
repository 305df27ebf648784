// What the steps of a scenario are bound to, once, before anything runs: so all problems come out
// together.
#pragma once

#include <vector>

#include "io/rack.h"
#include "plant/plants.h"
#include "scenario/term.h"

namespace merker::simulator {

struct Step;

struct StepBinding {
  const Resolver& resolver;           // operands of the program
  const io::Configuration* hardware;  // null: there is no hardware configuration
  const plant::Configuration* plants;
  Problems& problems;

  void bind(std::vector<Step>& steps) const;
};

}  // namespace merker::simulator
