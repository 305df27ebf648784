#include "importing/import.h"

#include <algorithm>

#include "archive/tree.h"
#include "base/visible.h"
#include "importing/candidates.h"
#include "importing/check.h"
#include "importing/file_material.h"
#include "importing/output.h"
#include "importing/project_writer.h"
#include "importing/s7p_material.h"
#include "importing/unused.h"

namespace merker::importing {
namespace {

// Into a project that exists it is checked as a whole, later.
void check(const Output& output, const Options& options, Report& report) {
  if (!output.stopped() && options.model.empty())
    reportCheck(output.folder(), options.stop, report);
}

void write(const Material& material, const std::string& folder, const Options& options,
           Report& report) {
  Output output(folder, report, options.stop);
  writeProject(material, output, report);
  check(output, options, report);
}

// The report of one folder, in it and for the terminal.
void finish(const std::string& folder, Report& report, Outcome& outcome) {
  const std::string text = report.text();
  Output(folder, report).write("import-report.txt", text);
  outcome.report += text;
  outcome.folders.push_back(folder);
  outcome.lines.insert(outcome.lines.end(), report.lines().begin(), report.lines().end());
  outcome.lost |= report.lost();
}

void importStep7(const archive::Tree& tree, const Candidate& candidate, const Options& options,
                 const std::string& folder, Report& report) {
  report.add(Note::Program, candidate.name, candidate.project->name);
  report.add(Note::CodePage, candidate.project->page.number());
  Material material = materialOf(tree, *candidate.project, *candidate.program, report);
  material.model = options.model;
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
  check(output, options, report);
}

void importStep5(const archive::Tree& tree, const Candidate& candidate, const Options& options,
                 const std::string& folder, Report& report) {
  report.add(Note::Program, candidate.name, "STEP 5");
  Output output(folder, report, options.stop);
  const bool any =
      writeStep5Project(tree, options.source, *candidate.step5, options.codePage, output, report);
  for (const archive::Refused& refused : tree.refused()) report.add(refused);
  if (any)
    check(output, options, report);
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
    outcome.merkerProject |= candidate.merker != nullptr;
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

// False: nothing can be written there.
bool makeFolder(Outcome& outcome) {
  const std::string why = whyNotWritable(outcome.folder);
  if (why.empty()) return true;
  outcome.result = Result::Unwritable;
  outcome.report = fmt::format("{} cannot be written: {}", visible(outcome.folder), why);
  return false;
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
  const std::vector<MerkerProject> merker = merkerProjects(tree, options.source);
  reportUnused(tree, projects, step5, merker, common);
  const std::vector<Candidate> all = candidates(projects, step5, merker);
  outcome.programs = labels(all);
  const std::vector<Candidate> chosen = chosenOf(all, options.program);
  if (chosen.empty() && !options.program.empty()) {
    outcome.result = Result::NoSuchProgram;
    return outcome;
  }
  if (!isFree(outcome.folder)) {
    outcome.result = Result::Exists;
    return outcome;
  }
  if (!chosen.empty()) {
    if (!makeFolder(outcome)) return outcome;
    importPrograms(tree, chosen, common, options, outcome);
    if (options.stop.stop_requested()) outcome.result = Result::Stopped;
    return outcome;
  }
  Report report = common;
  Material material = materialOf(tree, options.source, options.page, report);
  material.model = options.model;
  for (const archive::Refused& refused : tree.refused()) report.add(refused);
  if (material.empty()) {
    outcome.result = Result::Nothing;
    outcome.report = report.text();
    outcome.refused = reasons(tree);
    return outcome;
  }
  if (!makeFolder(outcome)) return outcome;
  write(material, outcome.folder, options, report);
  finish(outcome.folder, report, outcome);
  if (options.stop.stop_requested()) outcome.result = Result::Stopped;
  return outcome;
}

}  // namespace merker::importing
