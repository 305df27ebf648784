#include "importing/unused.h"

#include <algorithm>
#include <set>

#include "base/text.h"
#include "importing/recognise.h"
#include "s7p/sources.h"
#include "source/source_file.h"

namespace merker::importing {
namespace {

constexpr std::size_t kSources = 3, kFiles = 200;  // names in one line
constexpr std::uint64_t kLargestBeside = std::uint64_t{source::kLargestSource} << 20;

// "a, b, c, ..."
class Names {
 public:
  explicit Names(std::size_t most) : most_(most) {}
  void add(const std::string& name) {
    if (++count_ <= most_) text_ += (count_ == 1 ? "" : ", ") + name;
  }
  std::size_t count() const { return count_; }
  std::string text() const { return text_ + (count_ > most_ ? ", ..." : ""); }

 private:
  std::size_t most_, count_ = 0;
  std::string text_;
};

// The project that a path lies in; of projects within each other the innermost.
const s7p::Project* projectOf(const std::vector<s7p::Project>& projects, std::string_view path) {
  const s7p::Project* found = nullptr;
  const std::string key = archive::folded(path);
  for (const s7p::Project& project : projects) {
    const bool in =
        project.folder.empty() || key.starts_with(archive::folded(project.folder) + "/");
    if (in && (found == nullptr || project.folder.size() > found->folder.size())) found = &project;
  }
  return found;
}

void reportSources(const archive::Tree& tree, const std::vector<s7p::Project>& projects,
                   Report& report) {
  std::set<std::string> used;
  for (const s7p::Project& project : projects)
    for (const s7p::Program& program : project.programs)
      used.insert(archive::folded(program.sources));
  for (const auto& entry : tree.files()) {
    if (archive::folded(archive::nameOf(entry.path)) != "s7contai.dbf") continue;
    const std::string folder(archive::folderOf(entry.path));
    const s7p::Project* project = projectOf(projects, entry.path);
    if (project == nullptr || used.contains(archive::folded(folder))) continue;
    s7p::Faults faults;
    Names names(kSources);
    for (const s7p::SourceRow& row : s7p::readSources(tree, folder, project->page, faults))
      names.add(row.name);
    for (const s7p::Fault& fault : faults) report.add(fault);
    if (names.count() > 0) report.add(Note::UnusedSources, folder, names.text());
  }
}

struct Known {
  const std::vector<s7p::Project>& projects;
  const std::vector<Step5Program>& step5;
  const std::vector<MerkerProject>& merker;
};

// A program of STEP 5, or a file that STEP 5 names after it and keeps beside it.
bool isOfStep5(const Step5Program& program, std::string_view path) {
  if (archive::folderOf(path) != archive::folderOf(program.file->path)) return false;
  return upper(archive::nameOf(path)).starts_with(upper(program.name));
}

bool isOfMerker(const MerkerProject& project, std::string_view path) {
  return project.folder.empty() ||
         archive::folded(path).starts_with(archive::folded(project.folder) + "/");
}

enum class Place : std::uint8_t { Inside, Top, Outside };

// The folders inside a project of STEP 7 belong to it; what STEP 7 does not put into its own folder
// lies beside them.
Place placeOf(const Known& known, const std::string& path) {
  const bool ours =
      std::ranges::any_of(known.merker, [&](const auto& one) { return isOfMerker(one, path); }) ||
      (known.merker.empty() &&
       std::ranges::any_of(known.step5, [&](const auto& one) { return isOfStep5(one, path); }));
  if (ours) return Place::Inside;
  const s7p::Project* project = projectOf(known.projects, path);
  if (project == nullptr) return Place::Outside;
  const bool top = archive::folded(archive::folderOf(path)) == archive::folded(project->folder);
  return top ? Place::Top : Place::Inside;
}

// An import of the file alone would take it.
bool isImportable(const Known& known, const archive::Tree& tree,
                  const archive::Tree::Entry& entry) {
  if (entry.size > kLargestBeside) return false;
  const auto program = [&](const Step5Program& one) { return one.file == &entry; };
  if (std::ranges::any_of(known.step5, program)) return true;
  const auto file = tree.open(entry);
  return file && (recognise(*file, entry.path) != Kind::Unknown || isOwnFile(entry.path, *file));
}

void reportFiles(const archive::Tree& tree, const Known& known, Report& report) {
  Names names(kFiles);
  for (const auto& entry : tree.files()) {
    const Place place = placeOf(known, entry.path);
    if (place == Place::Inside) continue;
    if (isImportable(known, tree, entry))
      names.add(entry.path);
    else if (place == Place::Outside)
      report.add(Note::UnknownFile, entry.path);
  }
  if (names.count() > 0) report.add(Note::FilesBeside, names.count(), names.text());
}

}  // namespace

void reportUnused(const archive::Tree& tree, const std::vector<s7p::Project>& projects,
                  const std::vector<Step5Program>& step5, const std::vector<MerkerProject>& merker,
                  Report& report) {
  if (projects.empty() && step5.empty() && merker.empty()) return;
  reportSources(tree, projects, report);
  reportFiles(tree, {projects, step5, merker}, report);
}

}  // namespace merker::importing
