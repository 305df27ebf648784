#include "workbench/import_into.h"

#include <algorithm>

#include "importing/check.h"
#include "project/files.h"
#include "project/settings_edit.h"
#include "workbench/hardware_plan.h"

namespace merker::workbench {
namespace {

using importing::Effect;
using Lines = std::vector<importing::Report::Line>;

constexpr const char* kMerkerToml = "merker.toml";

// Files that a project of this family has; others would do nothing in it.
bool fitsFamily(const std::string& path, bool listing) {
  constexpr std::string_view kBoth[] = {".seq", ".vat", ".hmi", ".scn", ".state", ".rec", ".txt"};
  constexpr std::string_view kStep5[] = {".s5"};
  constexpr std::string_view kStep7[] = {".awl", ".mc7", ".sym", ".sdf", ".asc", ".dif"};
  const auto fits = [&](std::string_view ending) { return project::hasExtension(path, ending); };
  return std::ranges::any_of(kBoth, fits) ||
         (listing ? std::ranges::any_of(kStep5, fits) : std::ranges::any_of(kStep7, fits));
}

bool isOfTheImport(const std::string& path) {
  return path == kMerkerToml || path == "import-report.txt";
}

// Whether a line says that this file has come.
void forget(Lines& lines, const std::string& path) {
  std::erase_if(lines, [&](const auto& line) { return line.file == path; });
}

}  // namespace

// Nothing: the file is in the open project now. Names that differ in capital letters only are one
// for a user, and on most other systems.
std::optional<std::string> Addition::whyNot(const std::string& path) {
  const auto file = fitsFamily(path, open_.listing) ? made_.file(path) : nullptr;
  if (!file) return fmt::format("{} does not belong in a project of this PLC", path);
  const auto [there, fresh] = there_.try_emplace(upper(path), path);
  if (!fresh) return fmt::format("{} exists in the project; it was not replaced", there->second);
  const auto problem = to_.add(path, file->text(kLargestFile));
  return problem ? std::optional(problem->message) : std::nullopt;
}

bool Addition::add(Lines& lines, const std::stop_token& stop) {
  for (const auto& [path, stamp] : to_.list(project::kMostEntries))
    there_.emplace(upper(path), path);
  for (const std::string& path : project::listFiles(made_.folder())) {
    if (isOfTheImport(path)) continue;
    if (stop.stop_requested()) break;
    if (const auto why = whyNot(path)) {
      forget(lines, path);
      lines.push_back({Effect::Lost, *why});
    } else {
      files_.push_back(path);
    }
  }
  if (!stop.stop_requested()) {
    to_.flush();
    list(lines, stop);
    check(lines, stop);
  }
  if (!stop.stop_requested()) return true;
  for (const std::string& path : files_) to_.remove(path);
  return false;
}

// A merker.toml that lists its sources or symbols lists the new ones, too.
void Addition::list(Lines& lines, const std::stop_token& stop) const {
  const auto settings = to_.read(kMerkerToml);
  if (!settings || settings->text.size() > kLongestSettings) return;
  project::SettingsEdit edit(kMerkerToml, settings->text);
  std::vector<std::string> listed;
  for (const std::string& path : files_) {
    if (stop.stop_requested()) return;
    if (edit.addFile(path)) listed.push_back(path);
  }
  if (listed.empty()) return;
  const auto problem = to_.write(kMerkerToml, edit.text(), settings->revision);
  lines.push_back(
      problem ? importing::Report::Line{Effect::Changed, problem->message}
              : importing::Report::Line{
                    Effect::Info, fmt::format("merker.toml lists {}", fmt::join(listed, ", "))});
}

void Addition::check(Lines& lines, const std::stop_token& stop) const {
  if (files_.empty() || stop.stop_requested()) return;
  importing::Report report;
  importing::reportCheck(open_.path, stop, report);
  for (importing::Report::Line line : report.lines()) {
    line.text = to_.withoutFolder(line.text);
    lines.push_back(std::move(line));
  }
}

}  // namespace merker::workbench
