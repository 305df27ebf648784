// merker test PATH...
#include <CLI/CLI.hpp>
#include <iostream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <thread>

#include "command.h"
#include "cpu_option.h"
#include "engine_option.h"
#include "input.h"
#include "scenario/junit.h"
#include "test_session.h"

namespace merker::app {
namespace {

struct TestOptions {
  std::vector<std::string> paths;
  ProjectOptions project;
  std::string filter, junit, coverage, engine;
  unsigned jobs = std::max(1u, std::thread::hardware_concurrency());
  bool json = false, noSkip = false;
};

nlohmann::json toJson(const simulator::TestResult& result) {
  nlohmann::json failures = nlohmann::json::array();
  for (const simulator::Failure& failure : result.failures)
    failures.push_back({{"file", failure.position.file},
                        {"line", failure.position.line},
                        {"seconds", static_cast<double>(failure.time.ns) / 1e9},
                        {"message", failure.message}});
  return {{"file", result.file},
          {"name", result.name},
          {"passed", result.passed()},
          {"failures", failures}};
}

void summary(const TestSession& session, bool json) {
  const std::size_t failed = session.failed(), passed = session.results().size() - failed;
  if (!json) {
    std::cout << passed << " passed, " << failed << " failed\n";
    return;
  }
  nlohmann::json list = nlohmann::json::array();
  for (const auto& result : session.results()) list.push_back(toJson(result));
  print({{"passed", passed}, {"failed", failed}, {"results", list}});
}

template <typename Write>
bool writeFile(const std::string& path, Write write) {
  if (path.empty()) return true;
  std::ostringstream out;
  write(out);
  return writeText(path, out.str());
}

// False if the path does not exist.
bool testPath(const std::string& path, TestSession& session) {
  bool missing = false;
  const std::vector<project::TestTarget> targets = project::findTests(path, missing);
  if (!session.run(targets))
    for (const project::TestTarget& target : targets) session.compile(target);
  if (missing) std::cerr << "merker test: " << path << " does not exist\n";
  return !missing;
}

void nothingTested(const TestOptions& options) {
  std::cerr << "merker test: nothing was tested: ";
  if (options.filter.empty())
    std::cerr << "no scenario (*.scn) and no //= check was found\n";
  else
    std::cerr << "no name of a scenario or file contains '" << options.filter << "' (--filter)\n";
}

int test(const TestOptions& options) {
  if (const auto problem = whyMissing(options.engine)) {
    std::cerr << "merker test: " << *problem << '\n';
    return kUsage;
  }
  ProjectOptions inFolder = options.project;
  inFolder.station.clear();
  std::vector<std::string> paths;
  for (const std::string& path : options.paths) paths.push_back(chosenPath(path, options.project));
  TestSession session({inFolder, options.filter, options.engine, !options.coverage.empty(),
                       options.json, options.jobs, options.noSkip});
  bool unreadable = false;
  for (const std::string& path : paths) unreadable |= !testPath(path, session);
  const bool nothing = session.results().empty();
  if (nothing && !unreadable && !session.unreadable()) nothingTested(options);
  unreadable |= !writeFile(
      options.junit, [&](std::ostream& out) { simulator::writeJunit(session.results(), out); });
  unreadable |=
      !writeFile(options.coverage, [&](std::ostream& out) { session.coverage().write(out); });
  summary(session, options.json);
  if (unreadable || session.unreadable()) return kUnreadable;
  return session.failed() > 0 || nothing || session.broken() ? kProblems : kGood;
}

}  // namespace

void addTest(CLI::App& program, int& result) {
  auto* command =
      program.add_subcommand("test", "run scenarios (*.scn) and self-checking programs (//=)");
  auto options = std::make_shared<TestOptions>();
  command->add_option("PATH", options->paths, "projects, folders, sources, scenarios")->required();
  command->add_option("--filter", options->filter,
                      "only tests whose name or file contains this text");
  command->add_option("--junit", options->junit, "write the results as JUnit XML");
  command->add_option("--coverage", options->coverage,
                      "write which source lines ran (lcov format)");
  command
      ->add_option("-j,--jobs", options->jobs,
                   "scenarios that run at the same time; otherwise one for each processor")
      ->check(CLI::Range(1u, 256u));
  addProjectOptions(*command, options->project);
  addEngine(*command, options->engine);
  addNoSkip(*command, options->noSkip);
  command->add_flag("--json", options->json, "the results as one JSON object");
  command->footer(
      "Examples:\n"
      "  merker test examples\n"
      "  merker test plant --filter \"third slider\"\n"
      "  merker test plant --junit result.xml --coverage plant.info");
  command->callback([options, &result] { result = test(*options); });
}

}  // namespace merker::app
