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

}  // namespace

template <typename Built>
void TestSession::scenarios(const project::TestTarget& target, const Built& built) {
  printProblems(built.problems, built.files());
  const Bench bench{built.problems,
                    [&](const source::SourceFile& file, Problems& problems) {
                      return boundScenarios(file, built, problems);
                    },
                    [&](const simulator::Scenario& one) { return scenario(one, built); }};
  for (const std::string& file : target.scenarios) scenarios(file, bench);
}

bool TestSession::run(const project::TestTarget& target) {
  project::Project project = loadTarget(target, options_.project);
  unreadable_ |= project.unreadable;
  if (project.network) return runNetwork(target, std::move(project));
  const bool checks = target.selfChecks && checksItself(project);
  if (checks && chosen(target.path, "self-checks")) selfChecks(target, project);
  if (target.scenarios.empty()) return checks;
  Build built = build(project, false);
  requireOb1(built);
  requireWorkMemory(built);
  scenarios(target, built);
  return true;
}

// The stations' own scenarios and checks are found in their folders.
bool TestSession::runNetwork(const project::TestTarget& target, project::Project project) {
  if (target.scenarios.empty()) return false;
  const auto built = compilation::buildNetwork(std::move(project), true);
  unreadable_ |= built.unreadable;
  scenarios(target, built);
  return true;
}

void TestSession::compile(const project::TestTarget& target) {
  project::Project project = loadTarget(target, options_.project);
  if (project.network) {
    const auto several = compilation::buildNetwork(std::move(project), false);
    printProblems(several.problems, several.files());
    broken_ |= !several.ok();
    return;
  }
  const Build built = build(std::move(project), false);
  printProblems(built.problems, built.files());
  broken_ |= !built.ok();
}

void TestSession::selfChecks(const project::TestTarget& target, const project::Project& project) {
  Build built = build(project, true);
  requireOb1(built);
  requireWorkMemory(built);
  // the scenarios' build prints the same problems
  if (target.scenarios.empty() || !built.ok()) printProblems(built.problems, built.files());
  if (!built.ok()) return add(notRun(target.path, "self-checks", built.problems));
  const auto plc = controller(built);
  add(simulator::runSelfChecks(target.path, *plc));
  count(*plc);
}

void TestSession::scenarios(const std::string& path, const Bench& bench) {
  auto file = source::readSource(path);
  if (!file) {
    unreadable_ |= file.error().code == ProblemCode::P0101;
    Problems problems;
    problems.add(file.error());
    printProblems(problems, [](const std::string&) { return nullptr; });
    return add(notRun(path, "scenarios", problems));
  }
  const FileLookup files = [&](const std::string&) { return &file.value(); };
  Problems problems;
  const std::vector<simulator::Scenario> list = bench.read(file.value(), problems);
  printProblems(problems, files);
  if (list.empty() && problems.hasErrors()) add(notRun(path, "scenarios", problems));
  for (std::size_t i = 0; i < list.size(); ++i) {
    if (!chosen(path, list[i].name)) continue;
    const Problems own = between(problems, list[i].position.line,
                                 i + 1 < list.size() ? list[i + 1].position.line : kNoLine);
    const Problems& why = own.hasErrors() ? own : bench.problems;
    if (why.hasErrors())
      queue_.add([result = notRun(path, list[i].name, why)] { return result; });
    else
      queue_.add([&, i] { return bench.run(list[i]); });
  }
  queue_.run();
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
