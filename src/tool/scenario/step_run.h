// A scenario while it runs: what its steps work on, and what came out so far.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "plc/capability.h"
#include "scenario/forced.h"
#include "scenario/test_result.h"
#include "signal/encoder.h"

namespace merker::simulator {

struct Step;
struct Until;

// The axes of encoders, by the terminal of track A: an axis stays where it was left.
using Axes = std::map<std::string, signal::Motion>;

class StepRun {
 public:
  StepRun(controller::Controller& plc, TestResult& result, const Until* until = nullptr);

  // Up to the first failure or where the run is to end; false then.
  bool run(const std::vector<Step>& steps);
  bool speaksOfState() const { return speaksOfState_; }

  // For the steps. All that has failed is false.
  controller::Controller& plc() { return plc_; }
  Axes& axes() { return axes_; }
  ForceList& forces() { return forces_; }
  const Step& step() const { return *step_; }
  void speakOfState() { speaksOfState_ = true; }
  // "memory reset: the CPU refuses", at the step.
  bool fail(std::string_view reason);
  bool failAt(const Position& position, std::string message);
  bool powered();
  // "SINUMERIK 810 GA3 has no mode switch", at the step.
  bool lacks(std::string_view what);
  bool noPartner();
  // What the step works on; null if this PLC has none, which is then the failure.
  template <controller::IsCapability C>
  C* need() {
    C* const found = controller::capability<C>(plc_);
    if (found == nullptr) lacks(C::kName);
    return found;
  }

 private:
  bool reached(const Step& step) const;
  bool perform(const Step& step);
  bool performHere(const Step& step);
  bool performByPartner(const Step& step);

  controller::Controller& plc_;
  TestResult& result_;
  const Until* until_;
  const Step* step_ = nullptr;  // being performed
  Axes axes_;
  ForceList forces_;
  bool speaksOfState_ = false;
};

}  // namespace merker::simulator
