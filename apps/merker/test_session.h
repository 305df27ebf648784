// What `merker test` does with the programs, scenarios and self-checks that were found.
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "build.h"
#include "compilation/network.h"
#include "cpu_option.h"
#include "ordered_work.h"
#include "project/discovery.h"
#include "scenario/coverage.h"
#include "scenario/scenario.h"
#include "scenario/test_result.h"

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
  explicit TestSession(Options options) : options_(std::move(options)), work_(options_.jobs) {}

  // False if the targets hold no test.
  bool run(const std::vector<project::TestTarget>& targets);
  // Prints what is wrong with a target that holds none.
  void compile(const project::TestTarget& target);

  const std::vector<simulator::TestResult>& results() const { return results_; }
  const simulator::Coverage& coverage() const { return coverage_; }
  bool unreadable() const { return unreadable_; }
  bool broken() const { return broken_; }  // problems where nothing was to be tested
  std::size_t failed() const;

 private:
  using Task = OrderedWork::Task;
  using Tasks = std::vector<Task>;
  // What a file of scenarios is read for and run with: one PLC or several.
  struct Bench {
    const Problems& problems;  // of the program
    std::function<std::vector<simulator::Scenario>(const source::SourceFile&, Problems&)> read;
    std::function<simulator::TestResult(const simulator::Scenario&)> run;
  };

  // What follows is called by several threads at once.
  Tasks tasks(const project::TestTarget& target, std::atomic<bool>& found);
  Tasks networkTasks(const project::TestTarget& target, project::Project project);
  OrderedWork::Say selfChecks(const project::TestTarget& target, const project::Project& project);
  template <typename Built>  // of one PLC or of several
  void addScenarios(const project::TestTarget& target, const std::shared_ptr<const Built>& built,
                    Tasks& to);
  void addScenarios(const std::string& file, const std::shared_ptr<const Bench>& bench, Tasks& to);
  std::unique_ptr<controller::Controller> controller(const Build& build) const;
  simulator::TestResult scenario(const simulator::Scenario& scenario, const Build& build);
  simulator::TestResult scenario(const simulator::Scenario& scenario,
                                 const compilation::NetworkBuild& build);
  void count(const controller::Controller& plc);
  OrderedWork::Say added(simulator::TestResult result);
  void add(simulator::TestResult result);
  bool chosen(const std::string& file, const std::string& name) const;

  Options options_;
  OrderedWork work_;
  std::vector<simulator::TestResult> results_;
  std::mutex coverageMutex_;
  simulator::Coverage coverage_;
  std::atomic<bool> unreadable_ = false, broken_ = false;
};

}  // namespace merker::app
