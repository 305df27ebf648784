// What steps have in common that are all said by their words: `stop`, `power off`.
#pragma once

#include "scenario/step_binding.h"
#include "scenario/step_line.h"
#include "scenario/step_run.h"

namespace merker::simulator::steps {

struct Bare {
  bool parse(const StepLine& line) { return line.ends(); }
  void resolve(const StepBinding&) {}
};

}  // namespace merker::simulator::steps
