// Small programs on a station, for tests of what runs them.
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "scenario/runner.h"
#include "scenario/self_check.h"
#include "station/station.h"
#include "step7/compiler.h"
#include "system/library.h"

namespace merker::simulator {

class Machine {
 public:
  explicit Machine(std::string source, bool checks = false) {
    options_.library = &library_;
    options_.checks = checks;
    sources_.emplace_back("test.awl", std::move(source));
    auto compilation = step7::compile(sources_, options_);
    for (const Problem& problem : compilation.problems.list())
      if (problem.severity() == Severity::Error)
        ADD_FAILURE() << source::format(problem, &sources_[0]);
    program_ = std::make_shared<const block::Program>(std::move(compilation.program));
  }

  station::Station station(bool coverage = false) const {
    station::Options options;
    options.program = program_;
    options.coverage = coverage;
    return station::Station(std::move(options));
  }

  address::Reference reference(const std::string& text) const {
    auto result = step7::resolve(text, *program_, options_, {});
    EXPECT_TRUE(result) << text;
    return result ? result.value() : address::Reference{};
  }

  // The only scenario of `text`, run on a station of its own.
  TestResult run(const std::string& text) const {
    const source::SourceFile file("test.scn", text);
    Problems problems;
    auto scenarios = parseScenarios(file, problems);
    const Resolver resolver = [this](std::string_view operand, const Position& at) {
      return step7::resolve(operand, *program_, options_, at);
    };
    for (Scenario& scenario : scenarios) resolve(scenario, resolver, problems);
    for (const Problem& problem : problems.list()) ADD_FAILURE() << source::format(problem, &file);
    station::Station one = station();
    return scenarios.empty() ? TestResult{} : runScenario(scenarios[0], one);
  }

 private:
  block::Program library_ = system::library(defaultCpuModel());
  step7::CompileOptions options_;
  std::vector<source::SourceFile> sources_;
  std::shared_ptr<const block::Program> program_;
};

}  // namespace merker::simulator
