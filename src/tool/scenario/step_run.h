// A scenario while it runs: what its steps work on, and what came out so far.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "plc/capability.h"
#include "scenario/forced.h"
#include "scenario/start.h"
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
  StepRun(std::vector<NamedPlc> plcs, TestResult& result, const Until* until = nullptr);

  // Up to the first failure or where the run is to end; false then.
  bool run(const std::vector<Step>& steps);
  bool speaksOfState(std::size_t station) const { return stations_[station].speaksOfState; }

  // For the steps. All that has failed is false.
  controller::Controller& plc() { return *here().plc.plc; }
  Axes& axes() { return here().axes; }
  ForceList& forces() { return forces_; }
  void clearForces() { forces_.clear(at_); }  // of the station
  const Step& step() const { return *step_; }
  void speakOfState() { here().speaksOfState = true; }
  // "memory reset: the CPU refuses", at the step.
  bool fail(std::string_view reason);
  bool failAt(const Position& position, std::string message);
  bool powered() { return powered(plc()); }
  // The station of the operand, which may be another one than that of the step.
  bool powered(const address::Reference& operand);
  // "SINUMERIK 810 GA3 has no mode switch", at the step.
  bool lacks(std::string_view what);
  bool noPartner();
  // What the step works on; null if this PLC has none, which is then the failure.
  template <controller::IsCapability C>
  C* need() {
    C* const found = controller::capability<C>(plc());
    if (found == nullptr) lacks(C::kName);
    return found;
  }

 private:
  struct Station {
    NamedPlc plc;
    Axes axes;
    bool speaksOfState = false;
  };
  Station& here() { return stations_[at_]; }
  bool powered(const controller::Controller& plc);
  bool reached(const Step& step);
  bool perform(const Step& step);
  bool performHere(const Step& step);
  bool performByPartner(const Step& step);

  std::vector<Station> stations_;
  std::size_t at_ = 0;  // the one that performs
  TestResult& result_;
  const Until* until_;
  const Step* step_ = nullptr;  // being performed
  ForceList forces_;
};

}  // namespace merker::simulator
