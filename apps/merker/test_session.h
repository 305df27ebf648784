// What `merker test` does with the programs, scenarios and self-checks that were found.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "build.h"
#include "compilation/network.h"
#include "cpu_option.h"
#include "project/discovery.h"
#include "scenario/coverage.h"
#include "scenario/scenario.h"
#include "scenario/test_result.h"
#include "test_queue.h"

namespace merker::app {

class TestSession {
 public:
  struct Options {
    ProjectOptions project;
    std::string filter;
    std::string engine;
    bool coverage = false;
    bool quiet = false;  // no line per test
    unsigned jobs = 1;   // threads
    bool noSkip = false;
  };
  explicit TestSession(Options options)
      : options_(std::move(options)),
        queue_(options_.jobs, [this](auto result) { add(std::move(result)); }) {}

  // False if the target holds no test.
  bool run(const project::TestTarget& target);
  // Prints what is wrong with a target that holds none.
  void compile(const project::TestTarget& target);

  const std::vector<simulator::TestResult>& results() const { return results_; }
  const simulator::Coverage& coverage() const { return coverage_; }
  bool unreadable() const { return unreadable_; }
  bool broken() const { return broken_; }  // problems where nothing was to be tested
  std::size_t failed() const;

 private:
  std::unique_ptr<controller::Controller> controller(const Build& build) const;
  void selfChecks(const project::TestTarget& target, const project::Project& project);
  bool runNetwork(const project::TestTarget& target, project::Project project);
  // What a file of scenarios is read for and run with: one PLC or several.
  struct Bench {
    const Problems& problems;  // of the program
    std::function<std::vector<simulator::Scenario>(const source::SourceFile&, Problems&)> read;
    std::function<simulator::TestResult(const simulator::Scenario&)> run;
  };
  template <typename Built>  // of one PLC or of several
  void scenarios(const project::TestTarget& target, const Built& built);
  void scenarios(const std::string& file, const Bench& bench);
  simulator::TestResult scenario(const simulator::Scenario& scenario, const Build& build);
  simulator::TestResult scenario(const simulator::Scenario& scenario,
                                 const compilation::NetworkBuild& build);
  void count(const controller::Controller& plc);
  void add(simulator::TestResult result);
  bool chosen(const std::string& file, const std::string& name) const;

  Options options_;
  TestQueue queue_;
  std::vector<simulator::TestResult> results_;
  std::mutex coverageMutex_;
  simulator::Coverage coverage_;
  bool unreadable_ = false, broken_ = false;
};

}  // namespace merker::app
