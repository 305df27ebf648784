#include "importing/import.h"

#include <algorithm>

#include "archive/tree.h"
#include "base/text.h"
#include "base/visible.h"
#include "compilation/build.h"
#include "importing/file_material.h"
#include "importing/merker_project.h"
#include "importing/output.h"
#include "importing/project_writer.h"
#include "importing/s7p_material.h"
#include "importing/step5_material.h"
#include "importing/unused.h"

namespace merker::importing {
namespace {

// A program of STEP 7, of STEP 5 or of Merker itself.
struct Candidate {
  std::string name;
  const s7p::Project* project = nullptr;
  const s7p::Program* program = nullptr;
  const Step5Program* step5 = nullptr;
  const MerkerProject* merker = nullptr;
};

std::vector<Candidate> candidates(const std::vector<s7p::Project>& projects,
                                  const std::vector<Step5Program>& step5,
                                  const std::vector<MerkerProject>& merker) {
  std::vector<Candidate> list;
  for (const s7p::Project& project : projects)
    for (const s7p::Program& program : project.programs)
      list.push_back({program.name, &project, &program, nullptr, nullptr});
  for (const MerkerProject& project : merker)
    list.push_back({project.name, nullptr, nullptr, nullptr, &project});
  if (!merker.empty()) return list;  // what lies in them is theirs
  for (const Step5Program& program : step5)
    list.push_back({program.name, nullptr, nullptr, &program, nullptr});
  return list;
}

// What `merker check` will say about the new project.
void check(const Output& output, Report& report) {
  if (output.stopped()) return;
  compilation::Build build = compilation::build(project::load(output.folder(), ""), false);
  if (build.ok()) return;
  for (const Problem& problem : build.problems.list())
    if (problem.severity() == Severity::Error)
      return report.add(
          Note::StillProblems, build.problems.count(Severity::Error),
          fmt::format("{}:{}: {}", problem.position.file, problem.position.line, problem.message),
          build.problems.count(Severity::Error) == 1 ? "error" : "errors");
}

void write(const Material& material, const std::string& folder, const Options& options,
           Report& report) {
  Output output(folder, report, options.stop);
  writeProject(material, output, report);
  check(output, report);
}

// The report of one folder, in it and for the terminal.
void finish(const std::string& folder, Report& report, Outcome& outcome) {
  const std::string text = report.text();
  Output(folder, report).write("import-report.txt", text);
  outcome.report += text;
  outcome.folders.push_back(folder);
  outcome.lines.insert(outcome.lines.end(), report.lines().begin(), report.lines().end());
  outcome.lost |= report.count(Effect::Lost) > 0;
}

void importStep7(const archive::Tree& tree, const Candidate& candidate, const Options& options,
                 const std::string& folder, Report& report) {
  report.add(Note::Program, candidate.name, candidate.project->name);
  report.add(Note::CodePage, candidate.project->page.number());
  const Material material = materialOf(tree, *candidate.project, *candidate.program, report);
  if (material.blocks.empty()) report.add(Note::EmptyProgram, candidate.name);
  for (const archive::Refused& refused : tree.refused()) report.add(refused);
  write(material, folder, options, report);
}

void importMerker(const archive::Tree& tree, const Candidate& candidate, const Options& options,
                  const std::string& folder, Report& report) {
  report.add(Note::Program, candidate.name, "Merker");
  Output output(folder, report, options.stop);
  copyMerkerProject(tree, *candidate.merker, output, report);
  for (const archive::Refused& refused : tree.refused()) report.add(refused);
  check(output, report);
}

void importStep5(const archive::Tree& tree, const Candidate& candidate, const Options& options,
                 const std::string& folder, Report& report) {
  report.add(Note::Program, candidate.name, "STEP 5");
  Output output(folder, report, options.stop);
  const bool any =
      writeStep5Project(tree, options.source, *candidate.step5, options.codePage, output, report);
  for (const archive::Refused& refused : tree.refused()) report.add(refused);
  if (any)
    check(output, report);
  else
    report.add(Note::EmptyProgram, candidate.name);
}

void importPrograms(const archive::Tree& tree, const std::vector<Candidate>& chosen,
                    const Report& common, const Options& options, Outcome& outcome) {
  Report names;
  Output root(outcome.folder, names);
  for (const Candidate& candidate : chosen) {
    if (options.stop.stop_requested()) return;
    Report report = common;
    const std::string folder = chosen.size() == 1
                                   ? outcome.folder
                                   : outcome.folder + "/" + root.unused(candidate.name, "");
    if (candidate.merker != nullptr)
      importMerker(tree, candidate, options, folder, report);
    else if (candidate.step5 != nullptr)
      importStep5(tree, candidate, options, folder, report);
    else
      importStep7(tree, candidate, options, folder, report);
    if (chosen.size() > 1) outcome.report += fmt::format("{}\n", visible(folder));
    finish(folder, report, outcome);
  }
}

}  // namespace

Outcome importSource(const Options& options) {
  Outcome outcome;
  outcome.folder = options.folder.empty() ? stemOf(options.source) : options.folder;
  const archive::Tree tree(options.source);
  if (!tree.readable()) {
    outcome.result = Result::Unreadable;
    return outcome;
  }
  Report common;
  s7p::Faults faults;
  const std::vector<s7p::Project> projects = s7p::findProjects(tree, faults, options.page);
  for (const s7p::Fault& fault : faults) common.add(fault);
  const std::vector<Step5Program> step5 = step5Programs(tree, projects.empty());
  reportUnused(tree, projects, common);
  const std::vector<MerkerProject> merker = merkerProjects(tree, options.source);
  std::vector<Candidate> chosen = candidates(projects, step5, merker);
  for (const Candidate& candidate : chosen) outcome.programs.push_back(candidate.name);
  if (!options.program.empty())
    std::erase_if(chosen,
                  [&](const Candidate& c) { return !equalsIgnoreCase(c.name, options.program); });
  if (chosen.empty() && !options.program.empty()) {
    outcome.result = Result::NoSuchProgram;
    return outcome;
  }
  if (!isFree(outcome.folder)) {
    outcome.result = Result::Exists;
    return outcome;
  }
  if (!chosen.empty()) {
    importPrograms(tree, chosen, common, options, outcome);
    if (options.stop.stop_requested()) outcome.result = Result::Stopped;
    return outcome;
  }
  Report report = common;
  const Material material = materialOf(tree, stemOf(options.source), options.page, report);
  for (const archive::Refused& refused : tree.refused()) report.add(refused);
  if (material.empty()) {
    outcome.result = Result::Nothing;
    outcome.report = report.text();
    return outcome;
  }
  write(material, outcome.folder, options, report);
  finish(outcome.folder, report, outcome);
  if (options.stop.stop_requested()) outcome.result = Result::Stopped;
  return outcome;
}

}  // namespace merker::importing
