#include "project/discovery.h"

#include <algorithm>
#include <filesystem>

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

std::vector<std::string> sourcesIn(const std::string& folder, std::string_view extension) {
  std::vector<std::string> sources;
  for (const Entry& entry : entries(folder))
    if (!entry.folder && hasExtension(entry.name, extension))
      sources.push_back(join(folder, entry.name));
  return sources;
}

// The program that a loose scenario runs with.
TestTarget looseTarget(const std::string& scenario) {
  const std::string folder = folderOf(scenario);
  for (const char* extension : {".awl", ".s5"})
    for (const std::string& source : sourcesIn(folder, extension))
      if (stemOf(source) == stemOf(scenario)) return {source, {}, {scenario}, false};
  auto sources = sourcesIn(folder, ".awl");
  if (sources.empty()) sources = sourcesIn(folder, ".s5");
  return {folder, sources, {scenario}, false};
}

void addLoose(std::vector<TestTarget>& targets, const std::string& scenario) {
  TestTarget target = looseTarget(scenario);
  for (TestTarget& known : targets) {
    if (known.path != target.path || known.sources != target.sources) continue;
    known.scenarios.push_back(scenario);
    return;
  }
  targets.push_back(std::move(target));
}

void addFolder(std::vector<TestTarget>& targets, const std::string& folder) {
  if (isProject(folder)) {
    targets.push_back(projectTarget(folder));
    return;
  }
  std::vector<TestTarget> here;
  for (const char* extension : {".awl", ".s5"})
    for (const std::string& source : sourcesIn(folder, extension))
      here.push_back({source, {}, {}, true});
  for (const Entry& entry : entries(folder))
    if (!entry.folder && hasExtension(entry.name, ".scn")) addLoose(here, join(folder, entry.name));
  targets.insert(targets.end(), here.begin(), here.end());
  for (const Entry& entry : entries(folder))
    if (entry.folder) addFolder(targets, join(folder, entry.name));
}

TestTarget sourceTarget(const std::string& source) {
  TestTarget target{source, {}, {}, true};
  const std::string scenario = fs::path(source).replace_extension(".scn").string();
  if (isFile(scenario)) target.scenarios.push_back(scenario);
  return target;
}

}  // namespace

std::vector<TestTarget> findTests(const std::string& path, bool& missing) {
  std::vector<TestTarget> targets;
  missing = !isFolder(path) && !isFile(path);
  if (isFolder(path)) {
    addFolder(targets, path);
  } else if (fs::path(path).filename() == "merker.toml") {
    targets.push_back(projectTarget(folderOf(path)));
  } else if (hasExtension(path, ".scn")) {
    const std::string project = projectAround(path);
    targets.push_back(project.empty() ? looseTarget(path) : TestTarget{project, {}, {path}, false});
  } else if (!missing) {
    targets.push_back(sourceTarget(path));
  }
  return targets;
}

}  // namespace merker::project
