#include "test_session.h"

#include <algorithm>
#include <iostream>
#include <limits>

#include "base/text.h"
#include "chosen_scenario.h"
#include "engine_option.h"
#include "scenario/junit.h"
#include "scenario/runner.h"
#include "scenario/self_check.h"

namespace merker::app {
namespace {

project::Project loadTarget(const project::TestTarget& target, const ProjectOptions& options) {
  if (target.sources.empty()) return loadProject(target.path, options);
  return loadSources(target.sources, options);
}

bool checksItself(const project::Project& project) {
  return std::any_of(
      project.sources.begin(), project.sources.end(),
      [](const source::SourceFile& file) { return simulator::hasChecks(file.text()); });
}

constexpr std::uint32_t kNoLine = std::numeric_limits<std::uint32_t>::max();

// Those of one scenario.
Problems between(Problems all, std::uint32_t first, std::uint32_t end) {
  all.sort();
  Problems own;
  for (const Problem& problem : all.list())
    if (problem.position.line >= first && problem.position.line < end) own.add(problem);
  return own;
}

// A test that could not run has failed, with the first error as the reason.
simulator::TestResult notRun(const std::string& file, const std::string& name,
                             const Problems& problems) {
  simulator::TestResult result{file, name, {}, {}};
  for (const Problem& problem : problems.list()) {
    if (problem.severity() != Severity::Error) continue;
    result.failures.push_back({problem.position, {}, "not run: " + problem.message});
    break;
  }
  return result;
}

struct ScenarioFile {
  Result<source::SourceFile> file;  // the scenarios' texts are views into it
  Problems problems;
  std::vector<simulator::Scenario> list;

  bool missing() const { return !file && file.error().code == ProblemCode::P0101; }
  FileLookup files() const {
    return [this](const std::string&) { return file ? &file.value() : nullptr; };
  }
};

template <typename Bench>
std::shared_ptr<const ScenarioFile> readScenarios(const std::string& path, const Bench& bench) {
  auto read = std::make_shared<ScenarioFile>(ScenarioFile{source::readSource(path), {}, {}});
  if (read->file)
    read->list = bench.read(read->file.value(), read->problems);
  else
    read->problems.add(read->file.error());
  return read;
}

}  // namespace

bool TestSession::run(const std::vector<project::TestTarget>& targets) {
  std::atomic<bool> found = false;
  std::vector<OrderedWork::Target> work;
  for (const project::TestTarget& target : targets)
    work.push_back([&] { return tasks(target, found); });
  work_.run(std::move(work));
  return found;
}

TestSession::Tasks TestSession::tasks(const project::TestTarget& target, std::atomic<bool>& found) {
  auto project = std::make_shared<project::Project>(loadTarget(target, options_.project));
  if (project->unreadable) unreadable_ = true;
  if (!target.scenarios.empty()) found = true;
  if (project->network) return networkTasks(target, std::move(*project));
  Tasks list;
  if (target.selfChecks && checksItself(*project)) {
    found = true;
    if (chosen(target.path, "self-checks"))
      list.push_back([this, target, project] { return selfChecks(target, *project); });
  }
  if (target.scenarios.empty()) return list;
  auto built = std::make_shared<Build>(build(*project, false));
  requireOb1(*built);
  requireWorkMemory(*built);
  addScenarios(target, std::shared_ptr<const Build>(built), list);
  return list;
}

// The stations' own scenarios and checks are found in their folders.
TestSession::Tasks TestSession::networkTasks(const project::TestTarget& target,
                                             project::Project project) {
  Tasks list;
  if (target.scenarios.empty()) return list;
  const auto built = std::make_shared<const compilation::NetworkBuild>(
      compilation::buildNetwork(std::move(project), true));
  if (built->unreadable) unreadable_ = true;
  addScenarios(target, built, list);
  return list;
}

void TestSession::compile(const project::TestTarget& target) {
  project::Project project = loadTarget(target, options_.project);
  if (project.network) {
    const auto several = compilation::buildNetwork(std::move(project), false);
    printProblems(several.problems, several.files());
    if (!several.ok()) broken_ = true;
    return;
  }
  const Build built = build(std::move(project), false);
  printProblems(built.problems, built.files());
  if (!built.ok()) broken_ = true;
}

OrderedWork::Say TestSession::selfChecks(const project::TestTarget& target,
                                         const project::Project& project) {
  auto built = std::make_shared<Build>(build(project, true));
  requireOb1(*built);
  requireWorkMemory(*built);
  // the scenarios' build prints the same problems
  const bool silent = !target.scenarios.empty() && built->ok();
  simulator::TestResult result = notRun(target.path, "self-checks", built->problems);
  if (built->ok()) {
    const auto plc = controller(*built);
    result = simulator::runSelfChecks(target.path, *plc);
    count(*plc);
  }
  return [this, built, silent, result] {
    if (!silent) printProblems(built->problems, built->files());
    add(result);
  };
}

template <typename Built>
void TestSession::addScenarios(const project::TestTarget& target,
                               const std::shared_ptr<const Built>& built, Tasks& to) {
  to.push_back([built] { return [built] { printProblems(built->problems, built->files()); }; });
  const auto bench = std::make_shared<const Bench>(
      Bench{built->problems,
            [built](const source::SourceFile& file, Problems& problems) {
              return boundScenarios(file, *built, problems);
            },
            [this, built](const simulator::Scenario& one) { return scenario(one, *built); }});
  for (const std::string& file : target.scenarios) addScenarios(file, bench, to);
}

void TestSession::addScenarios(const std::string& path, const std::shared_ptr<const Bench>& bench,
                               Tasks& to) {
  const auto read = readScenarios(path, *bench);
  if (read->missing()) unreadable_ = true;
  to.push_back([read] { return [read] { printProblems(read->problems, read->files()); }; });
  const std::vector<simulator::Scenario>& list = read->list;
  if (list.empty() && read->problems.hasErrors())
    to.push_back([this, path, read] { return added(notRun(path, "scenarios", read->problems)); });
  for (std::size_t i = 0; i < list.size(); ++i) {
    if (!chosen(path, list[i].name)) continue;
    const Problems own = between(read->problems, list[i].position.line,
                                 i + 1 < list.size() ? list[i + 1].position.line : kNoLine);
    to.push_back([this, path, read, bench, i, why = own.hasErrors() ? own : bench->problems] {
      const simulator::Scenario& one = read->list[i];
      return added(why.hasErrors() ? notRun(path, one.name, why) : bench->run(one));
    });
  }
}

std::unique_ptr<controller::Controller> TestSession::controller(const Build& build) const {
  auto plc = build.controller(options_.coverage);
  (void)useEngine(options_.engine, *plc);
  useSkipping(options_.noSkip, *plc);
  return plc;
}

void TestSession::count(const controller::Controller& plc) {
  if (!options_.coverage) return;
  const std::lock_guard lock(coverageMutex_);
  coverage_.add(plc);
}

simulator::TestResult TestSession::scenario(const simulator::Scenario& scenario,
                                            const Build& build) {
  const auto plc = controller(build);
  simulator::TestResult result = simulator::runScenario(scenario, *plc);
  count(*plc);
  return result;
}

simulator::TestResult TestSession::scenario(const simulator::Scenario& scenario,
                                            const compilation::NetworkBuild& build) {
  const auto network = build.network(1, options_.coverage);
  std::vector<simulator::NamedPlc> plcs;
  for (std::size_t i = 0; i < network->size(); ++i) {
    (void)useEngine(options_.engine, network->itself(i));
    useSkipping(options_.noSkip, network->itself(i));
    plcs.push_back({network->name(i), &network->station(i)});
  }
  simulator::TestResult result = simulator::runScenario(scenario, plcs);
  for (std::size_t i = 0; i < network->size(); ++i) count(network->itself(i));
  return result;
}

OrderedWork::Say TestSession::added(simulator::TestResult result) {
  return [this, result = std::move(result)] { add(result); };
}

void TestSession::add(simulator::TestResult result) {
  if (!options_.quiet) {
    std::cout << (result.passed() ? "ok      " : "FAILED  ") << result.file << ": " << result.name
              << '\n';
    for (const simulator::Failure& failure : result.failures)
      std::cout << "        " << simulator::describe(failure) << '\n';
    std::cout << std::flush;
  }
  results_.push_back(std::move(result));
}

bool TestSession::chosen(const std::string& file, const std::string& name) const {
  const std::string filter = upper(options_.filter);
  return upper(file).find(filter) != std::string::npos ||
         upper(name).find(filter) != std::string::npos;
}

std::size_t TestSession::failed() const {
  return static_cast<std::size_t>(std::count_if(
      results_.begin(), results_.end(), [](const auto& result) { return !result.passed(); }));
}

}  // namespace merker::app
