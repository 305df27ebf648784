#include "workbench/import_task.h"

#include <filesystem>
#include <span>

#include "importing/look.h"
#include "workbench/import_into.h"

namespace merker::workbench {
namespace {

namespace fs = std::filesystem;

Problems notImported(std::string_view why) {
  return refused(ProblemCode::P1308, "the import", why);
}

Problems nothingKnown() {
  return notImported(
      "it contains nothing that can be imported: no STEP 7 project, program file of STEP 5, "
      "source, "
      "symbol table, block or station");
}

// Why there is nothing: what the source holds and nobody can read.
Problems nothingIn(const std::vector<std::string>& reasons) {
  constexpr std::size_t kMost = 5;
  Problems problems;
  for (const std::string& text : std::span(reasons).first(std::min(reasons.size(), kMost)))
    problems.add(ProblemCode::P1308, nowhere(), "the import", text);
  return reasons.empty() ? nothingKnown() : problems;
}

// Null: it was imported.
std::optional<Problems> whyNotImported(const importing::Outcome& outcome, const ImportWish& wish) {
  using importing::Result;
  switch (outcome.result) {
    case Result::Imported:
      return std::nullopt;
    case Result::Unreadable:
      return notImported("the files cannot be read");
    case Result::Nothing:
      return nothingIn(outcome.refused);
    case Result::NoSuchProgram:
      return refused(ProblemCode::P1316, "program", wish.program,
                     outcome.programs.empty()
                         ? std::string()
                         : fmt::format("; there are {}", fmt::join(outcome.programs, ", ")));
    case Result::Unwritable:
      return notImported(outcome.report);
    case Result::Exists:
      return refused(ProblemCode::P1312, wish.name);
    case Result::Stopped:
      return notImported("it was cancelled");
  }
  return std::nullopt;
}

std::string_view effectWord(importing::Effect effect) {
  switch (effect) {
    case importing::Effect::Info:
      return "came";
    case importing::Effect::Changed:
      return "changed";
    case importing::Effect::Lost:
      return "lost";
    case importing::Effect::Beside:
      return "beside";
  }
  return {};
}

// The sentence that the line has, with what it is made of.
Json quoted(const Problem& problem) {
  return {{"code", problem.name()}, {"text", problem.message}, {"arguments", problem.arguments}};
}

// What a browser is told of an import.
Json importResult(const std::vector<importing::Report::Line>& lines, Json folders, Json files) {
  constexpr std::size_t kMost = 5'000;
  Json rows = Json::array();
  bool lost = false;
  for (const auto& line : lines) {
    lost |= line.effect == importing::Effect::Lost;
    if (rows.size() >= kMost) continue;
    rows.push_back({{"effect", effectWord(line.effect)}, {"text", line.text}});
    if (line.problem) rows.back()["quoted"] = quoted(*line.problem);
  }
  return {{"folders", std::move(folders)},
          {"files", std::move(files)},
          {"lost", lost},
          {"report", std::move(rows)},
          {"more", lines.size() - std::min(lines.size(), kMost)}};
}

importing::Outcome runImport(const Upload& upload, const std::string& folder,
                             const ImportWish& wish, const std::stop_token& stop) {
  const Encoding dos = wish.page == 850 ? Encoding::Cp850 : Encoding::Cp437;
  const std::string model = wish.name.empty() ? wish.open.model : std::string();
  return importing::importSource(
      {upload.source(), folder, wish.program, dos, wish.page, stop, model});
}

}  // namespace

Answer lookAt(const Upload& upload, const Workspace& workspace,
              const std::optional<OpenProject>& open, const std::stop_token& stop) {
  const importing::Contents contents = importing::look(upload.source(), stop);
  if (!contents.readable) return notImported("the files cannot be read");
  if (contents.empty()) return nothingIn(contents.refused);
  const bool fits = open && open->growing && (open->listing ? contents.step5 : contents.step7);
  return Json{{"programs", contents.programs},
              {"name", workspace.freeName(upload.name())},
              {"step7", contents.step7},
              {"step5", contents.step5},
              {"loose", fits && !contents.whole}};
}

Answer importNew(const Upload& upload, const Workspace& workspace, const ImportWish& wish,
                 const std::stop_token& stop) {
  const auto folder = workspace.makeFolder(wish.name);
  if (!folder) return one(folder.error());
  const importing::Outcome outcome = runImport(upload, *folder, wish, stop);
  if (auto problems = whyNotImported(outcome, wish)) {
    std::error_code ignored;
    fs::remove_all(*folder, ignored);
    return *problems;
  }
  return importResult(outcome.lines, outcome.folders, Json::array());
}

Answer importInto(const Upload& upload, const ProjectFolder& folder, const ImportWish& wish,
                  const std::stop_token& stop) {
  std::error_code ignored;
  fs::remove_all(upload.output(), ignored);
  importing::Outcome outcome = runImport(upload, upload.output(), wish, stop);
  if (auto problems = whyNotImported(outcome, wish)) return *problems;
  if (outcome.folders.size() > 1) return notImported("choose one of its programs");
  const ProjectFolder made(upload.output());
  for (importing::Report::Line& line : outcome.lines) line.text = made.withoutFolder(line.text);
  Addition addition(folder, made, wish.open);
  if (!addition.add(outcome.lines, stop)) return notImported("it was cancelled");
  if (outcome.merkerProject)
    outcome.lines.push_back(
        {importing::Effect::Lost, "merker.toml was not replaced: the open project keeps its own"});
  return importResult(outcome.lines, Json::array(), addition.files());
}

}  // namespace merker::workbench
