// One run of a campaign after the other, in one process. Runs with the same beginning can be forked
// from where it ends (apps/merker).
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "campaign/plan.h"
#include "plc/controller.h"
#include "scenario/test_result.h"

namespace merker::campaign {

// What came out of a run: a row of the table of results beside its parameters.
struct Outcome {
  bool passed = false;
  std::string message;  // why not
  double seconds = 0;   // of virtual time, with the beginning
  std::uint64_t cycles = 0;
  std::vector<std::optional<double>> measures;
  bool operator==(const Outcome&) const = default;
};

class Run {
 public:
  explicit Run(const Plan& plan) : plan_(plan) {}
  // A PLC at the place where the values of its own runs act.
  void begin(const Choice& choice);
  // To the end; `choice` has the beginning of the last one.
  Outcome end(const Choice& choice);

 private:
  std::string apply(const Choice& choice);  // the reason why not
  void follow(const simulator::Scenario* scenario, const Choice& choice, Outcome& outcome);
  std::string told(simulator::Failure failure) const;
  void judge(const std::vector<Measure>& measures, Outcome& outcome) const;

  const Plan& plan_;
  std::unique_ptr<controller::Controller> plc_;
  std::string refused_;  // why there is no beginning
};

}  // namespace merker::campaign
