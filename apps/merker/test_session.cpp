#include "test_session.h"

#include <algorithm>
#include <iostream>

#include "base/text.h"
#include "simulator/junit.h"
#include "simulator/runner.h"
#include "simulator/self_check.h"

namespace merker::app {
namespace {

project::Project loadTarget(const project::TestTarget& target, const std::string& cpu) {
  if (target.sources.empty()) return project::load(target.path, cpu);
  return project::loadSources(target.sources.front(), target.sources, cpu);
}

bool checksItself(const project::Project& project) {
  return std::any_of(
      project.sources.begin(), project.sources.end(),
      [](const source::SourceFile& file) { return simulator::hasChecks(file.text()); });
}

}  // namespace

void TestSession::run(const project::TestTarget& target) {
  if (target.scenarios.empty() && !target.selfChecks) return;
  const project::Project project = loadTarget(target, options_.cpu);
  unreadable_ |= project.unreadable;
  const bool checks = target.selfChecks && checksItself(project);
  if (project.unreadable && !checks && target.scenarios.empty())
    printProblems(project.problems, [&](const std::string& name) { return project.file(name); });
  if (checks && chosen(target.path, "self-checks")) selfChecks(target, project);
  if (target.scenarios.empty()) return;
  Build built = build(project, false);
  requireOb1(built);
  requireWorkMemory(built);
  printProblems(built.problems, built.files());
  for (const std::string& file : target.scenarios) scenarios(file, built);
}

void TestSession::selfChecks(const project::TestTarget& target, const project::Project& project) {
  Build built = build(project, true);
  requireOb1(built);
  requireWorkMemory(built);
  // the scenarios' build prints the same problems
  if (target.scenarios.empty() || !built.ok()) printProblems(built.problems, built.files());
  if (!built.ok()) return notRun(target.path, "self-checks", built.problems);
  station::Station station = built.station(options_.coverage);
  add(simulator::runSelfChecks(target.path, station));
  if (options_.coverage) coverage_.add(station);
}

void TestSession::scenarios(const std::string& path, const Build& build) {
  auto file = source::readSource(path);
  if (!file) {
    unreadable_ |= file.error().code == ProblemCode::P0101;
    Problems problems;
    problems.add(file.error());
    printProblems(problems, [](const std::string&) { return nullptr; });
    return notRun(path, "scenarios", problems);
  }
  const FileLookup files = [&](const std::string&) { return &file.value(); };
  Problems problems;
  std::vector<simulator::Scenario> list = simulator::parseScenarios(file.value(), problems);
  printProblems(problems, files);
  if (list.empty() && problems.hasErrors()) notRun(path, "scenarios", problems);
  for (simulator::Scenario& one : list) {
    if (!chosen(path, one.name)) continue;
    if (problems.hasErrors())
      notRun(path, one.name, problems);
    else if (!build.ok())
      notRun(path, one.name, build.problems);
    else
      scenario(one, build, files);
  }
}

void TestSession::scenario(simulator::Scenario& scenario, const Build& build,
                           const FileLookup& files) {
  Problems problems;
  simulator::resolve(scenario, build.resolver(), problems);
  printProblems(problems, files);
  if (problems.hasErrors()) return notRun(scenario.position.file, scenario.name, problems);
  station::Station station = build.station(options_.coverage);
  add(simulator::runScenario(scenario, station));
  if (options_.coverage) coverage_.add(station);
}

// A test that could not run has failed, with the first error as the reason.
void TestSession::notRun(const std::string& file, const std::string& name,
                         const Problems& problems) {
  simulator::TestResult result{file, name, {}, {}};
  for (const Problem& problem : problems.list()) {
    if (problem.severity() != Severity::Error) continue;
    result.failures.push_back({problem.position, {}, "not run: " + problem.message});
    break;
  }
  add(std::move(result));
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
