#include "workbench/import_task.h"

#include <filesystem>

#include "importing/look.h"
#include "project/files.h"

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

// Null: it was imported.
std::optional<Problems> whyNotImported(const importing::Outcome& outcome, const ImportWish& wish) {
  using importing::Result;
  switch (outcome.result) {
    case Result::Imported:
      return std::nullopt;
    case Result::Unreadable:
      return notImported("the files cannot be read");
    case Result::Nothing:
      return nothingKnown();
    case Result::NoSuchProgram:
      return refused(ProblemCode::P1316, "program", wish.program, "");
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
  }
  return {};
}

// What a browser is told of an import.
Json importResult(const std::vector<importing::Report::Line>& lines, Json folders, Json files) {
  constexpr std::size_t kMost = 5'000;
  Json rows = Json::array();
  bool lost = false;
  for (const auto& line : lines) {
    lost |= line.effect == importing::Effect::Lost;
    if (rows.size() < kMost)
      rows.push_back({{"effect", effectWord(line.effect)}, {"text", line.text}});
  }
  return {{"folders", std::move(folders)},
          {"files", std::move(files)},
          {"lost", lost},
          {"report", std::move(rows)},
          {"more", lines.size() - std::min(lines.size(), kMost)}};
}

importing::Outcome runImport(const Upload& upload, const std::string& folder,
                             const ImportWish& wish, const std::stop_token& stop) {
  return importing::importSource({upload.source(), folder, wish.program, wish.codePage, 0, stop});
}

// Files that a project of this family has; others would do nothing in it.
bool fitsFamily(const std::string& path, bool listing) {
  constexpr std::string_view kStep5[] = {".s5", ".seq", ".txt"};
  constexpr std::string_view kStep7[] = {".awl", ".mc7", ".sym", ".sdf", ".asc",
                                         ".dif", ".seq", ".vat", ".txt"};
  const auto fits = [&](std::string_view ending) { return project::hasExtension(path, ending); };
  return listing ? std::ranges::any_of(kStep5, fits) : std::ranges::any_of(kStep7, fits);
}

bool isOfTheImport(const std::string& path) {
  return path == "merker.toml" || path == "import-report.txt";
}

// Nothing: the file is in the open project now.
std::optional<std::string> whyNotAdded(const ProjectFolder& folder, const ProjectFolder& made,
                                       const std::string& path, bool listing) {
  const auto file = fitsFamily(path, listing) ? made.file(path) : nullptr;
  if (!file) return fmt::format("{} does not belong in a project of this PLC", path);
  const auto problem = folder.create(path, file->text(kLargestFile));
  if (!problem) return std::nullopt;
  if (problem->code != ProblemCode::P1312) return problem->message;
  return fmt::format("{} exists in the project; it was not replaced", path);
}

// A cancelled import leaves nothing behind.
Problems takenBack(const ProjectFolder& folder, const Json& files) {
  for (const Json& path : files) folder.remove(path.get<std::string>());
  return notImported("it was cancelled");
}

}  // namespace

Answer lookAt(const Upload& upload, const Workspace& workspace, std::optional<bool> listing,
              const std::stop_token& stop) {
  const importing::Contents contents = importing::look(upload.source(), stop);
  if (!contents.readable) return notImported("the files cannot be read");
  if (contents.empty()) return nothingKnown();
  const bool fits = listing && (*listing ? contents.step5 : contents.step7);
  return Json{{"programs", contents.programs},
              {"name", workspace.freeName(upload.name())},
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
  Json files = Json::array();
  const ProjectFolder made(upload.output());
  for (const std::string& path : project::listFiles(upload.output())) {
    if (isOfTheImport(path)) continue;
    if (stop.stop_requested()) return takenBack(folder, files);
    if (const auto why = whyNotAdded(folder, made, path, wish.listing))
      outcome.lines.push_back({importing::Effect::Lost, *why});
    else
      files.push_back(path);
  }
  return importResult(outcome.lines, Json::array(), std::move(files));
}

}  // namespace merker::workbench
