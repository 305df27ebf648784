#include "project/discovery.h"

#include <algorithm>
#include <filesystem>

#include "base/text.h"
#include "project/files.h"

namespace merker::project {
namespace fs = std::filesystem;
namespace {

bool isProject(const std::string& folder) { return isFile(join(folder, "merker.toml")); }

fs::path parent(const fs::path& folder) {
  const fs::path above = (folder / "..").lexically_normal();
  return above.has_filename() ? above : above.parent_path();  // without a slash at the end
}

// The nearest folder above that is a project, empty if there is none. Relative paths stay relative.
std::string projectAround(const std::string& file) {
  std::error_code error;
  fs::path folder = folderOf(file);
  fs::path above = fs::absolute(file, error).lexically_normal().parent_path();
  for (;; above = above.parent_path(), folder = parent(folder)) {
    if (isProject(above.string()))
      return isProject(folder.string()) ? folder.string() : above.string();
    if (above == above.parent_path()) return {};
  }
}

TestTarget projectTarget(const std::string& folder) {
  TestTarget target{folder, {}, {}, true};
  for (const std::string& file : listFiles(folder))
    if (hasExtension(file, ".scn")) target.scenarios.push_back(join(folder, file));
  return target;
}

// What a folder holds, read once.
struct Content {
  explicit Content(std::string path) : folder(std::move(path)), entries(project::entries(folder)) {}

  std::vector<std::string> files(std::string_view extension) const {
    std::vector<std::string> found;
    for (const Entry& entry : entries)
      if (!entry.folder && hasExtension(entry.name, extension))
        found.push_back(join(folder, entry.name));
    return found;
  }

  std::string folder;
  std::vector<Entry> entries;
};

// The program that a loose scenario runs with.
TestTarget looseTarget(const std::string& scenario, const Content& content) {
  for (const char* extension : {".awl", ".s5"})
    for (const std::string& source : content.files(extension))
      if (stemOf(source) == stemOf(scenario)) return {source, {}, {scenario}, false};
  auto sources = content.files(".awl");
  if (sources.empty()) sources = content.files(".s5");
  return {content.folder, sources, {scenario}, false};
}

void addLoose(std::vector<TestTarget>& targets, const std::string& scenario,
              const Content& content) {
  TestTarget target = looseTarget(scenario, content);
  for (TestTarget& known : targets) {
    if (known.path != target.path || known.sources != target.sources) continue;
    known.scenarios.push_back(scenario);
    return;
  }
  targets.push_back(std::move(target));
}

void addFolder(std::vector<TestTarget>& targets, const std::string& folder, std::size_t depth);

// The stations of a project of several are projects below it.
void addProjectsBelow(std::vector<TestTarget>& targets, const std::string& folder,
                      std::size_t depth) {
  for (const Entry& entry : entries(folder)) {
    const std::string path = join(folder, entry.name);
    if (!entry.folder) continue;
    if (isProject(path))
      addFolder(targets, path, depth + 1);
    else if (depth < kDeepestFolder)
      addProjectsBelow(targets, path, depth + 1);
  }
}

void addFolder(std::vector<TestTarget>& targets, const std::string& folder, std::size_t depth) {
  if (isProject(folder)) {
    targets.push_back(projectTarget(folder));
    if (depth < kDeepestFolder) addProjectsBelow(targets, folder, depth);
    return;
  }
  const Content content(folder);
  std::vector<TestTarget> here;
  for (const char* extension : {".awl", ".s5"})
    for (const std::string& source : content.files(extension))
      here.push_back({source, {}, {}, true});
  for (const std::string& scenario : content.files(".scn")) addLoose(here, scenario, content);
  targets.insert(targets.end(), here.begin(), here.end());
  if (depth == kDeepestFolder) return;
  for (const Entry& entry : content.entries)
    if (entry.folder) addFolder(targets, join(folder, entry.name), depth + 1);
}

TestTarget sourceTarget(const std::string& source) {
  TestTarget target{source, {}, {}, true};
  const std::string scenario = fs::path(source).replace_extension(".scn").string();
  if (isFile(scenario)) target.scenarios.push_back(scenario);
  return target;
}

}  // namespace

// Only endings that are used for symbols and nothing else: a .txt may be anything.
bool isSymbolExport(const std::string& path) {
  for (const char* extension : {".sdf", ".asc", ".seq", ".dif", ".sym"})
    if (hasExtension(path, extension)) return true;
  return false;
}

std::vector<std::string> symbolsBeside(const std::string& source) {
  std::vector<std::string> same, all;
  for (const Entry& entry : entries(folderOf(source))) {
    if (!isSymbolExport(entry.name)) continue;
    all.push_back(entry.name);
    const std::string stem = stemOf(source);
    const bool assignments =
        hasExtension(source, ".s5") && equalsIgnoreCase(stemOf(entry.name), stem + "Z0");
    if (stemOf(entry.name) == stem || assignments) same.push_back(entry.name);
  }
  return same.empty() && all.size() == 1 ? all : same;
}

std::vector<TestTarget> findTests(const std::string& path, bool& missing) {
  std::vector<TestTarget> targets;
  missing = !isFolder(path) && !isFile(path);
  if (isFolder(path)) {
    addFolder(targets, path, 0);
  } else if (fs::path(path).filename() == "merker.toml") {
    targets.push_back(projectTarget(folderOf(path)));
  } else if (hasExtension(path, ".scn")) {
    const std::string project = projectAround(path);
    targets.push_back(project.empty() ? looseTarget(path, Content(folderOf(path)))
                                      : TestTarget{project, {}, {path}, false});
  } else if (!missing) {
    targets.push_back(sourceTarget(path));
  }
  return targets;
}

}  // namespace merker::project
