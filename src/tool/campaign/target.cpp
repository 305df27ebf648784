#include "campaign/target.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "base/text.h"
#include "io/amount.h"

namespace merker::campaign {
namespace {

using compilation::Build;
using plant::Signal;
using Form = plant::Parameter::Form;

constexpr std::string_view kNames =
    "plant.NAME.PARAMETER, plant.NAME.INPUT, set.OPERAND, cpu.model, cpu.engine, scenario.file, "
    "scenario.name";

struct Word {
  std::string_view name;
  Target target;
};

std::optional<Target> wordTarget(std::string_view name) {
  static const Word kTargets[] = {{"cpu.model", CpuModelName{}},
                                  {"cpu.engine", Engine{}},
                                  {"scenario.file", ScenarioFile{}},
                                  {"scenario.name", ScenarioName{}}};
  for (const Word& word : kTargets)
    if (equalsIgnoreCase(word.name, name)) return word.target;
  return std::nullopt;
}

// "stroke, minimum, HAND_FILL": what can be varied.
std::string namesOf(const plant::PlantSettings& plant) {
  std::string names;
  const auto add = [&](std::string_view name) {
    names += fmt::format("{}{}", names.empty() ? "" : ", ", name);
  };
  for (const plant::Parameter& parameter : plant.kind->parameters) add(parameter.key);
  for (std::uint32_t i = 0; i < plant.kind->signals.size(); ++i)
    if (plant.kind->signals[i].side == Signal::Side::Input && plant.wireOf(i) == nullptr)
      add(plant.kind->signals[i].name);
  return names;
}

std::optional<Target> plantTarget(std::string_view rest, const Parameter& parameter,
                                  const Build& build, Problems& problems) {
  const auto point = rest.find('.');
  const auto plant = build.project.plants.find(rest.substr(0, point));
  if (build.project.plants.plants.empty()) {
    problems.add(ProblemCode::P0987, parameter.position);
    return std::nullopt;
  }
  if (!plant || point == std::string_view::npos) {
    problems.add(ProblemCode::P0986, parameter.position, rest.substr(0, point),
                 build.project.plants.names());
    return std::nullopt;
  }
  const plant::PlantSettings& settings = build.project.plants.plants[*plant];
  const std::string_view name = rest.substr(point + 1);
  const auto& rows = settings.kind->parameters;
  const auto row = std::ranges::find(rows, name, &plant::Parameter::key);
  if (row != rows.end())
    return PlantParameter{*plant, static_cast<std::uint32_t>(row - rows.begin())};
  const auto signal = settings.kind->signal(name);
  if (signal && settings.kind->signals[*signal].side == Signal::Side::Input &&
      settings.wireOf(*signal) == nullptr) {
    PlantInput input;
    input.signal.does = simulator::PlantValue::Does::Set;
    input.signal.text = rest;
    input.signal.position = parameter.position;
    return input;
  }
  problems.add(ProblemCode::P0781, parameter.position, settings.name, name, namesOf(settings));
  return std::nullopt;
}

bool hasFraction(const Parameter& parameter) {
  return parameter.draw || std::ranges::any_of(parameter.values, [](const auto& one) {
           return one.value.number && *one.value.number != std::floor(*one.value.number);
         });
}

// Of the types with 32 bits: MD 20 has none of them, and holds what is written to it.
bool hasInteger(TypeCode type) {
  return type == TypeCode::DInt || type == TypeCode::Time || type == TypeCode::TimeOfDay;
}

std::optional<Target> operandTarget(std::string_view text, const Parameter& parameter,
                                    const Build& build, Problems& problems) {
  simulator::Term term{std::string(text), parameter.position, {}, {}, {}};
  if (auto problem = simulator::resolveOperand(term, build.resolver())) {
    problems.add(*problem);
    return std::nullopt;
  }
  const address::Reference& reference = term.reference;
  const bool real =
      reference.type == TypeCode::Real || (simulator::bitWidth(reference) == 32 &&
                                           !hasInteger(reference.type) && hasFraction(parameter));
  return Operand{{std::move(term), {}}, real, parameter.draw.has_value()};
}

std::optional<Target> findTarget(const Parameter& parameter, const Build& build,
                                 Problems& problems) {
  const std::string_view name = parameter.name;
  if (auto target = wordTarget(name)) return target;
  if (upper(name).starts_with("PLANT."))
    return plantTarget(name.substr(6), parameter, build, problems);
  if (upper(name).starts_with("SET."))
    return operandTarget(trim(name.substr(4)), parameter, build, problems);
  problems.add(ProblemCode::P0780, parameter.position, name, kNames);
  return std::nullopt;
}

// "a number from 0.1 to 3600", "a duration from …"
std::string rangeOf(const plant::Parameter& row) {
  const auto length = [](double seconds) {
    return io::formatLength({std::llround(seconds * 1e9)});
  };
  switch (row.form) {
    case Form::Number:
      return fmt::format("a number from {:g} to {:g}", row.low, row.high);
    case Form::Whole:
      return fmt::format("a whole number from {:.0f} to {:.0f}", row.low, row.high);
    case Form::Flag:
      return "true or false";
    case Form::Time:
      return fmt::format("a duration from \"{0}\" to \"{1}\", or seconds", length(row.low),
                         length(row.high));
  }
  return {};
}

// A timer or counter takes less than the bits of its word; the PLC itself says what.
void checkCells(const Parameter& parameter, const Operand& target, const Build& build,
                Problems& problems) {
  const address::Operand& operand = target.assignment.operand.reference.operand;
  if (operand.kind != address::OperandKind::Timer && !address::isCounter(operand)) return;
  const auto plc = build.controller();
  for (const Parameter::Listed& one : parameter.values) {
    Problems told;
    const auto set = withValue(target, one.value, one.position, build.resolver(), told);
    const std::string reason = set ? simulator::apply(*set, false, *plc) : std::string();
    if (!reason.empty()) problems.add(ProblemCode::P0790, one.position, one.value.text, reason);
  }
}

// What one listed value of each kind of target must be. All values that are wrong are told.
struct Check {
  const Parameter& parameter;
  const Build& build;
  Problems& problems;

  template <typename IsGood>
  void each(std::string_view what, IsGood isGood) const {
    for (const Parameter::Listed& one : parameter.values)
      if (!isGood(one.value)) problems.add(ProblemCode::P0704, one.position, parameter.name, what);
  }
  // A text of a list: nothing is drawn from it.
  template <typename IsGood>
  void words(std::string_view what, IsGood isGood) const {
    if (parameter.draw) problems.add(ProblemCode::P0704, parameter.position, parameter.name, what);
    each(what, [&](const Value& value) { return !value.number && isGood(value.text); });
  }

  void operator()(const PlantParameter& target) const {
    const auto& plant = build.project.plants.plants[target.plant];
    const plant::Parameter& row = plant.kind->parameters[target.parameter];
    each(rangeOf(row), [&](const Value& value) { return plantNumber(row, value).has_value(); });
  }
  void operator()(const PlantInput& target) const {
    for (const Parameter::Listed& one : parameter.values) {
      simulator::PlantValue signal = withValue(target, one.value, one.position);
      simulator::resolve(signal, &build.project.plants, problems);
    }
  }
  void operator()(const Operand& target) const {
    for (const Parameter::Listed& one : parameter.values)
      (void)withValue(target, one.value, one.position, build.resolver(), problems);
    checkCells(parameter, target, build, problems);
  }
  void operator()(const CpuModelName&) const {
    words("the name of a CPU", [](const std::string&) { return true; });  // plan.cpp has loaded it
  }
  void operator()(const Engine&) const {
    words("\"interpreter\" or \"jit\"",
          [](const std::string& text) { return text == "interpreter" || text == "jit"; });
  }
  void operator()(const ScenarioFile&) const {
    words("a file of scenarios: \"fill.scn\"",
          [](const std::string& text) { return !text.empty(); });
  }
  void operator()(const ScenarioName&) const {
    words("a text that the scenario's name contains", [](const std::string&) { return true; });
  }
};

// What a value means to its target: equal for values that make the same run. Nothing if it cannot
// be taken at all.
struct Meaning {
  const Value& value;
  const Build& build;

  std::optional<std::string> operator()(const PlantParameter& target) const {
    const auto& plant = build.project.plants.plants[target.plant];
    const auto number = plantNumber(plant.kind->parameters[target.parameter], value);
    return number ? std::optional(fmt::format("{}", *number)) : std::nullopt;
  }
  std::optional<std::string> operator()(const PlantInput& target) const {
    Problems problems;
    simulator::PlantValue signal = withValue(target, value, {});
    simulator::resolve(signal, &build.project.plants, problems);
    return problems.empty() ? std::optional(fmt::format("{}", signal.number)) : std::nullopt;
  }
  std::optional<std::string> operator()(const Operand& target) const {
    Problems problems;
    const auto set = withValue(target, value, {}, build.resolver(), problems);
    if (!set) return std::nullopt;
    const simulator::Term& term = set->value;
    if (!term.constant) return term.content ? *term.content : term.text;
    const TypeCode type = set->operand.reference.type;
    return fmt::format("{:08X}", simulator::adapt(*term.constant, type).bits);
  }
  // Names: files of their own, all else without regard to upper and lower case.
  std::optional<std::string> operator()(const ScenarioFile&) const { return value.text; }
  template <typename Name>
  std::optional<std::string> operator()(const Name&) const {
    return upper(value.text);
  }
};

// Each value once: two runs of the same have one row, and one weight in every mean. A range is told
// once.
void checkRepeated(const Parameter& parameter, const Target& target, const Build& build,
                   Problems& problems) {
  std::set<std::string> known;
  Position last;
  for (const Parameter::Listed& one : parameter.values) {
    const auto meaning = std::visit(Meaning{one.value, build}, target);
    if (!meaning || known.insert(*meaning).second || one.position == last) continue;
    problems.add(ProblemCode::P0788, one.position, parameter.name, one.value.text);
    last = one.position;
  }
}

}  // namespace

bool actsLate(const Target& target) {
  return std::holds_alternative<PlantInput>(target) || std::holds_alternative<Operand>(target);
}

std::optional<double> plantNumber(const plant::Parameter& row, const Value& value) {
  std::optional<double> number = value.number;
  if (!number && row.form == Form::Flag && (value.text == "true" || value.text == "false"))
    number = value.text == "true" ? 1 : 0;
  if (!number && row.form == Form::Time)
    if (const auto length = io::parseLength(value.text))
      number = static_cast<double>(length->ns) / 1e9;
  if (!number) return std::nullopt;
  const bool whole = row.form == Form::Whole || row.form == Form::Flag;
  const double high = row.form == Form::Flag ? 1 : row.high;
  if (*number < row.low || *number > high || (whole && *number != std::floor(*number)))
    return std::nullopt;
  return number;
}

std::optional<Target> bindTarget(const Parameter& parameter, const Build& build,
                                 Problems& problems) {
  const auto target = findTarget(parameter, build, problems);
  if (!target) return target;
  std::visit(Check{parameter, build, problems}, *target);
  checkRepeated(parameter, *target, build, problems);
  return target;
}

simulator::PlantValue withValue(const PlantInput& input, const Value& value,
                                const Position& place) {
  simulator::PlantValue signal = input.signal;
  signal.value = value.text;
  signal.valuePosition = place;
  return signal;
}

// As AWL writes it: a whole number for 32 bits has L#.
static std::string constantOf(const Operand& operand, const Value& value) {
  if (!value.number) return value.text;
  if (operand.real) return fmt::format("{:.9e}", *value.number);
  const double number = operand.drawn ? std::round(*value.number) : *value.number;
  if (number != std::floor(number)) return value.text;
  const address::Reference& reference = operand.assignment.operand.reference;
  const bool wide = simulator::bitWidth(reference) == 32 && reference.type != TypeCode::Time &&
                    reference.type != TypeCode::TimeOfDay;
  return fmt::format("{}{}", wide ? "L#" : "", std::llround(number));
}

std::optional<simulator::Assignment> withValue(const Operand& operand, const Value& value,
                                               const Position& place,
                                               const simulator::Resolver& resolver,
                                               Problems& problems) {
  simulator::Assignment assignment = operand.assignment;
  assignment.value = {constantOf(operand, value), place, {}, {}, {}};
  const std::size_t before = problems.size();
  simulator::resolve(assignment, resolver, problems);
  return problems.size() == before ? std::optional(std::move(assignment)) : std::nullopt;
}

}  // namespace merker::campaign
