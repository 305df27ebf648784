// A campaign bound to its project: everything that a run needs, compiled once for all of them.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "campaign/definition.h"
#include "campaign/expansion.h"
#include "campaign/measure.h"
#include "campaign/target.h"
#include "compilation/build.h"
#include "scenario/scenario.h"

namespace merker::campaign {

// The project for one CPU model.
struct Variant {
  std::string model;  // of cpu.model; empty: as the project has it
  compilation::Build build;
  std::vector<Target> targets;  // of the parameters, in their order
  std::vector<Measure> measures;
  // Plants with a generator that the seed of a run moves: the parameter `seed`, unless it is
  // varied.
  std::vector<PlantParameter> seeded;
  std::vector<std::pair<ScenarioText, simulator::Scenario>> scenarios;
};

class Plan {
 public:
  // Loads and compiles; problems of the project are in the variants' builds.
  Plan(Definition definition, Problems& problems);
  // After a build without problems. `version`: of this program.
  void bind(const std::string& version, Problems& problems);

  const Definition& definition() const { return definition_; }
  const std::vector<std::unique_ptr<Variant>>& variants() const { return variants_; }
  Choice choice(std::uint64_t number) const { return choiceAt(definition_, number); }
  const Variant& variant(const Choice& choice) const;
  // Null: it runs for a time only.
  const simulator::Scenario* scenario(const Choice& choice) const;
  // SHA-256 of what a run is: files, what is measured, parameters, seed, version. 64 digits.
  std::string id(const Choice& choice) const;
  // The same number for runs that are the same up to where their own values act.
  std::uint64_t beginning(std::uint64_t number) const;
  // For problems: the campaign's file, the project's, the scenarios'.
  const source::SourceFile* file(const std::string& name) const;

 private:
  void load(const std::string& model, Problems& problems);
  void bind(Variant& variant, Problems& problems);
  void findSeeded(Variant& variant) const;
  void readScenarios(Problems& problems);
  void bindScenarios(Variant& variant, Problems& problems);
  const Parameter* parameter(std::string_view name) const;
  ScenarioText scenarioText(const Choice& choice) const;
  std::vector<ScenarioText> scenarioTexts() const;
  std::string contents(const std::string& version) const;

  Definition definition_;
  std::vector<std::unique_ptr<Variant>> variants_;
  std::vector<std::unique_ptr<source::SourceFile>> files_;  // of scenarios
  std::string contents_;
};

}  // namespace merker::campaign
