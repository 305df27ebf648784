#include "importing/unused.h"

#include <algorithm>
#include <set>

#include "importing/recognise.h"
#include "s7p/sources.h"
#include "source/source_file.h"

namespace merker::importing {
namespace {

constexpr std::size_t kShown = 3;
constexpr std::uint64_t kLargest = std::uint64_t{source::kLargestSource} << 20;

// "a, b, c, ..."
class Names {
 public:
  void add(const std::string& name) {
    if (++count_ <= kShown) text_ += (count_ == 1 ? "" : ", ") + name;
  }
  std::size_t count() const { return count_; }
  std::string text() const { return text_ + (count_ > kShown ? ", ..." : ""); }

 private:
  std::size_t count_ = 0;
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
    Names names;
    for (const s7p::SourceRow& row : s7p::readSources(tree, folder, project->page, faults))
      names.add(row.name);
    for (const s7p::Fault& fault : faults) report.add(fault);
    if (names.count() > 0) report.add(Note::UnusedSources, folder, names.text());
  }
}

// The folders inside a project belong to it; what STEP 7 does not put there lies beside them.
bool isBeside(const std::vector<s7p::Project>& projects, const std::string& path) {
  const s7p::Project* project = projectOf(projects, path);
  return project == nullptr ||
         archive::folded(archive::folderOf(path)) == archive::folded(project->folder);
}

void reportFiles(const archive::Tree& tree, const std::vector<s7p::Project>& projects,
                 Report& report) {
  Names names;
  for (const auto& entry : tree.files()) {
    if (entry.size > kLargest || !isBeside(projects, entry.path)) continue;
    const auto file = tree.open(entry);
    if (file && recognise(*file) != Kind::Unknown) names.add(entry.path);
  }
  if (names.count() > 0) report.add(Note::FilesBeside, names.count(), names.text());
}

}  // namespace

void reportUnused(const archive::Tree& tree, const std::vector<s7p::Project>& projects,
                  Report& report) {
  if (projects.empty()) return;
  reportSources(tree, projects, report);
  reportFiles(tree, projects, report);
}

}  // namespace merker::importing
