#include "campaign/plan.h"

#include <algorithm>

#include "base/text.h"
#include "campaign/contents.h"
#include "campaign/digest.h"
#include "project/files.h"
#include "project/settings.h"

namespace merker::campaign {
namespace {

// The position of a parameter among the parameters; its value in a choice.
const Value* chosenValue(const Definition& definition, const Choice& choice,
                         std::string_view name) {
  for (std::size_t i = 0; i < definition.parameters.size(); ++i)
    if (equalsIgnoreCase(definition.parameters[i].name, name)) return &choice.values[i];
  return nullptr;
}

}  // namespace

const Parameter* Plan::parameter(std::string_view name) const {
  for (const Parameter& one : definition_.parameters)
    if (equalsIgnoreCase(one.name, name)) return &one;
  return nullptr;
}

Plan::Plan(Definition definition, Problems& problems) : definition_(std::move(definition)) {
  const Parameter* const models = parameter("cpu.model");
  if (models == nullptr) {
    load("", problems);
    return;
  }
  for (const Parameter::Listed& one : models->values)
    if (project::findModel(one.value.text))
      load(one.value.text, problems);
    else
      problems.add(ProblemCode::P0705, one.position, one.value.text, project::modelNames());
}

void Plan::load(const std::string& model, Problems& problems) {
  const auto same = [&](const auto& variant) { return equalsIgnoreCase(variant->model, model); };
  if (std::ranges::any_of(variants_, same)) return;
  const std::string path = project::join(definition_.folder, definition_.project);
  if (!project::isFile(path) && !project::isFolder(path)) {
    problems.add(ProblemCode::P0704, definition_.projectPosition, "project",
                 "the folder of a project or a source; there is no " + path);
    return;
  }
  project::Project project = project::load(path, model);
  if (project.network) {
    problems.add(ProblemCode::P0704, definition_.projectPosition, "project",
                 "a project of one station; a campaign cannot vary several stations");
    return;
  }
  auto variant = std::make_unique<Variant>();
  variant->model = model;
  variant->build = compilation::build(std::move(project), false);
  compilation::requireOb1(variant->build);
  compilation::requireWorkMemory(variant->build);
  variants_.push_back(std::move(variant));
}

void Plan::bind(const std::string& version, Problems& problems) {
  readScenarios(problems);
  for (const auto& variant : variants_) {
    bind(*variant, problems);
    if (problems.hasErrors()) return;  // one message for what is wrong with each model
  }
  contents_ = contents(version);
}

void Plan::bind(Variant& variant, Problems& problems) {
  for (const Parameter& one : definition_.parameters)
    if (auto target = bindTarget(one, variant.build, problems))
      variant.targets.push_back(std::move(*target));
  for (const MeasureText& text : definition_.measures)
    if (auto measure = bindMeasure(text, variant.build, problems))
      variant.measures.push_back(std::move(*measure));
  findSeeded(variant);
  bindScenarios(variant, problems);
}

void Plan::findSeeded(Variant& variant) const {
  const auto& plants = variant.build.project.plants.plants;
  for (std::uint32_t i = 0; definition_.repeat > 0 && i < plants.size(); ++i) {
    const auto& rows = plants[i].kind->parameters;
    const auto seed = std::ranges::find(rows, "seed", &plant::Parameter::key);
    if (seed == rows.end() || parameter("plant." + plants[i].name + ".seed") != nullptr) continue;
    variant.seeded.push_back({i, static_cast<std::uint32_t>(seed - rows.begin())});
  }
}

// Each file with each name.
std::vector<ScenarioText> Plan::scenarioTexts() const {
  std::vector<ScenarioText> texts;
  const Parameter* const files = parameter("scenario.file");
  const Parameter* const names = parameter("scenario.name");
  if (definition_.scenario) texts.push_back(*definition_.scenario);
  if (files != nullptr) texts.clear();
  for (std::size_t i = 0; files != nullptr && i < files->values.size(); ++i)
    texts.push_back({files->values[i].value.text,
                     definition_.scenario ? definition_.scenario->name : "",
                     files->values[i].position});
  if (names == nullptr) return texts;
  std::vector<ScenarioText> named;
  for (const ScenarioText& text : texts)
    for (const Parameter::Listed& one : names->values)
      named.push_back({text.file, one.value.text, one.position});
  return named;
}

void Plan::readScenarios(Problems& problems) {
  const auto texts = scenarioTexts();
  if (const Parameter* names = parameter("scenario.name"); names != nullptr && texts.empty())
    problems.add(ProblemCode::P0744, names->position, names->name, "'scenario', the file");
  for (const ScenarioText& text : texts) {
    const std::string path = project::join(definition_.folder, text.file);
    if (file(path) != nullptr) continue;
    auto read = source::readSource(path);
    if (read)
      files_.push_back(std::make_unique<source::SourceFile>(std::move(read.value())));
    else
      problems.add(ProblemCode::P0704, text.position, text.file,
                   "a file of scenarios: " + read.error().message);
  }
}

void Plan::bindScenarios(Variant& variant, Problems& problems) {
  const auto& hardware = variant.build.project.hardware;
  const simulator::Resolver resolver = variant.build.resolver();
  for (const ScenarioText& text : scenarioTexts()) {
    const source::SourceFile* const from = file(project::join(definition_.folder, text.file));
    if (from == nullptr) continue;  // told by readScenarios
    std::vector<simulator::Scenario> list = simulator::parseScenarios(*from, problems);
    const auto chosen = std::ranges::find_if(list, [&](const simulator::Scenario& one) {
      return upper(one.name).find(upper(text.name)) != std::string::npos;
    });
    if (chosen == list.end()) {
      problems.add(ProblemCode::P0704, text.position, text.name,
                   "contained in the name of a scenario of " + text.file);
      continue;
    }
    simulator::resolve(*chosen, resolver, problems, hardware ? &*hardware : nullptr,
                       &variant.build.project.plants);
    variant.scenarios.emplace_back(text, std::move(*chosen));
  }
}

const Variant& Plan::variant(const Choice& choice) const {
  const Value* const model = chosenValue(definition_, choice, "cpu.model");
  const auto found = std::ranges::find_if(variants_, [&](const auto& one) {
    return model == nullptr || equalsIgnoreCase(one->model, model->text);
  });
  return **found;
}

ScenarioText Plan::scenarioText(const Choice& choice) const {
  ScenarioText text = definition_.scenario.value_or(ScenarioText{});
  if (const Value* file = chosenValue(definition_, choice, "scenario.file")) text.file = file->text;
  if (const Value* name = chosenValue(definition_, choice, "scenario.name")) text.name = name->text;
  return text;
}

const simulator::Scenario* Plan::scenario(const Choice& choice) const {
  const ScenarioText wanted = scenarioText(choice);
  for (const auto& [text, scenario] : variant(choice).scenarios)
    if (text.file == wanted.file && text.name == wanted.name) return &scenario;
  return nullptr;
}

const source::SourceFile* Plan::file(const std::string& name) const {
  for (const auto& one : files_)
    if (one->name() == name) return one.get();
  for (const auto& variant : variants_)
    if (const source::SourceFile* one = variant->build.project.file(name)) return one;
  return nullptr;
}

std::string Plan::contents(const std::string& version) const {
  Digest digest;
  digest.addPart("merker campaign 1");
  digest.addPart(version);
  if (!variants_.empty()) addProject(variants_.front()->build, digest);
  for (const auto& one : files_) digest.addPart(one->text());
  addDefinition(definition_, digest);
  return digest.text();
}

std::string Plan::id(const Choice& choice) const {
  Digest digest;
  digest.addPart(contents_);
  for (std::size_t i = 0; i < choice.values.size(); ++i) {
    digest.addPart(definition_.parameters[i].name);
    digest.addPart(choice.values[i].text);
  }
  digest.addPart(std::to_string(choice.seed));
  return digest.text();
}

// The digits of the number but for parameters that act late; the seed, if it acts early.
std::uint64_t Plan::beginning(std::uint64_t number) const {
  const std::vector<Target>& targets = variants_.front()->targets;
  bool seedActs = !variants_.front()->seeded.empty();
  for (std::size_t i = 0; i < targets.size(); ++i)
    seedActs |= definition_.parameters[i].draw && !actsLate(targets[i]);
  std::uint64_t group = 0, weight = 1;
  const auto add = [&](std::uint64_t size, bool acts) {
    if (acts) group += number % size * weight;
    if (acts) weight *= size;
    number /= size;
  };
  if (definition_.repeat > 0) add(definition_.repeat, seedActs);
  for (std::size_t i = targets.size(); i > 0; --i)
    if (const Parameter& one = definition_.parameters[i - 1]; !one.draw)
      add(one.values.size(), !actsLate(targets[i - 1]));
  return group;
}

}  // namespace merker::campaign
