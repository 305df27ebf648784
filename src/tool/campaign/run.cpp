#include "campaign/run.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "campaign/draw.h"
#include "campaign/recorder.h"
#include "check/relation.h"
#include "plant/field.h"
#include "plc/machine_code.h"
#include "scenario/junit.h"
#include "scenario/runner.h"

namespace merker::campaign {
namespace {

using controller::Controller;

// A drawn value beyond the limits of the parameter is the limit.
double within(const plant::Parameter& row, const Value& value) {
  if (const auto number = plantNumber(row, value)) return *number;
  double number = value.number.value_or(row.standard);
  if (row.form == plant::Parameter::Form::Whole) number = std::round(number);
  return std::clamp(number, row.low, row.form == plant::Parameter::Form::Flag ? 1 : row.high);
}

// The plants of the project with the values of a run.
plant::Configuration plantsOf(const Variant& variant, const Choice& choice) {
  plant::Configuration plants = variant.build.project.plants;
  for (std::size_t i = 0; i < variant.targets.size(); ++i) {
    const auto* target = std::get_if<PlantParameter>(&variant.targets[i]);
    if (target == nullptr) continue;
    plant::PlantSettings& settings = plants.plants[target->plant];
    settings.parameters[target->parameter] =
        within(settings.kind->parameters[target->parameter], choice.values[i]);
  }
  for (const PlantParameter& one : variant.seeded) {
    plant::PlantSettings& settings = plants.plants[one.plant];
    settings.parameters[one.parameter] =
        plantSeed(choice.seed, fmt::format("plant.{}.seed", settings.name));
  }
  return plants;
}

std::string useEngine(const Variant& variant, const Choice& choice, Controller& plc) {
  for (std::size_t i = 0; i < variant.targets.size(); ++i) {
    if (!std::holds_alternative<Engine>(variant.targets[i])) continue;
    auto* const code = controller::capability<controller::MachineCode>(plc);
    const bool compiled = choice.values[i].text == "jit";
    if (code != nullptr ? !code->setCompiled(compiled) : compiled)
      return "the engine jit is not available on this computer for " + plc.modelName();
  }
  return {};
}

}  // namespace

void Run::begin(const Choice& choice) {
  const Variant& variant = plan_.variant(choice);
  plc_ = variant.build.controller(plantsOf(variant, choice));
  refused_ = useEngine(variant, choice, *plc_);
  if (!refused_.empty() || plan_.scenario(choice) != nullptr) return;
  refused_ = simulator::startFresh(*plc_);
  if (refused_.empty() && plan_.definition().start)
    plc_->advanceTo(plc_->now() + *plan_.definition().start);
}

std::string Run::apply(const Choice& choice) {
  const Variant& variant = plan_.variant(choice);
  auto* const field = controller::capability<plant::Field>(*plc_);
  for (std::size_t i = 0; i < variant.targets.size(); ++i) {
    Problems problems;
    if (const auto* input = std::get_if<PlantInput>(&variant.targets[i])) {
      simulator::PlantValue value = withValue(*input, choice.values[i], {});
      simulator::resolve(value, &variant.build.project.plants, problems);
      if (problems.empty()) simulator::apply(value, *field->plants(), *field->rack(), plc_->now());
    }
    if (const auto* operand = std::get_if<Operand>(&variant.targets[i])) {
      const auto value =
          withValue(*operand, choice.values[i], {}, variant.build.resolver(), problems);
      if (const std::string reason = value ? simulator::apply(*value, false, *plc_) : "";
          !reason.empty())
        return reason;
    }
    if (!problems.empty()) return problems.list().front().message;
  }
  return {};
}

// With the file's name from the campaign's folder, so that it is the same wherever that stands.
std::string Run::told(simulator::Failure failure) const {
  const std::filesystem::path file = failure.position.file;
  failure.position.file = file.lexically_relative(plan_.definition().folder).generic_string();
  return simulator::describe(failure);
}

// The scenario, if any, then the rest of the time.
void Run::follow(const simulator::Scenario* scenario, const Choice& choice, Outcome& outcome) {
  const Variant& variant = plan_.variant(choice);
  std::optional<Recorder> recorder;
  Instant begun = plc_->now();
  const auto begin = [&] {
    begun = plc_->now();
    const std::string reason = apply(choice);
    if (!reason.empty()) return reason;
    recorder.emplace(variant.measures, *plc_);
    const auto sample = [&](Controller&) { recorder->sample(); };
    const bool outside = std::ranges::any_of(variant.measures, &Measure::needsEachCycle);
    outside ? plc_->onCycle(sample) : plc_->onChange(sample);
    return reason;
  };
  if (scenario != nullptr) {
    const auto result = simulator::runScenario(*scenario, {{{}, plc_.get()}}, begin);
    if (!result.passed()) outcome.message = told(result.failures.front());
  } else {
    outcome.message = begin();
  }
  if (!recorder) return plc_->onCycle({});  // another program than wanted would have been measured
  if (plan_.definition().time && begun + *plan_.definition().time > plc_->now())
    plc_->advanceTo(begun + *plan_.definition().time);
  plc_->settle();
  outcome.measures = recorder->results();
  plc_->onCycle({});
  if (scenario == nullptr && outcome.message.empty() && plc_->stoppedByFault())
    outcome.message = "the CPU went to STOP: " + plc_->stopReason();
}

void Run::judge(const std::vector<Measure>& measures, Outcome& outcome) const {
  outcome.measures.resize(measures.size());
  for (std::size_t i = 0; i < measures.size() && outcome.message.empty(); ++i) {
    const auto& required = measures[i].required;
    const auto& value = outcome.measures[i];
    if (!required) continue;
    if (!value)
      outcome.message =
          fmt::format("{} has no value, required is {}", measures[i].name, required->text);
    else if (!block::relates(*value, required->relation, required->value) &&
             !(required->relation == block::Relation::About &&
               block::about(*value, required->value)))
      outcome.message =
          fmt::format("{} is {}, required is {}", measures[i].name, *value, required->text);
  }
  outcome.passed = outcome.message.empty();
}

Outcome Run::end(const Choice& choice) {
  Outcome outcome;
  outcome.message = refused_;
  if (refused_.empty()) follow(plan_.scenario(choice), choice, outcome);
  judge(plan_.variant(choice).measures, outcome);
  outcome.seconds = static_cast<double>(plc_->now().ns) / 1e9;
  outcome.cycles = plc_->cycles();
  return outcome;
}

}  // namespace merker::campaign
