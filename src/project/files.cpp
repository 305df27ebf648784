#include "project/files.h"

#include <algorithm>
#include <filesystem>

#include "base/text.h"

namespace merker::project {
namespace fs = std::filesystem;
namespace {

bool matchesUpper(std::string_view pattern, std::string_view path) {
  if (pattern.empty()) return path.empty();
  if (pattern.starts_with("**/")) {
    const auto slash = path.find('/');
    return matchesUpper(pattern.substr(3), path) ||
           (slash != std::string_view::npos && matchesUpper(pattern, path.substr(slash + 1)));
  }
  if (pattern[0] == '*') {
    return matchesUpper(pattern.substr(1), path) ||
           (!path.empty() && path[0] != '/' && matchesUpper(pattern, path.substr(1)));
  }
  if (path.empty() || (pattern[0] != path[0] && (pattern[0] != '?' || path[0] == '/')))
    return false;
  return matchesUpper(pattern.substr(1), path.substr(1));
}

void collect(const std::string& folder, const std::string& prefix,
             std::vector<std::string>& files) {
  for (const Entry& entry : entries(folder)) {
    const std::string path = join(folder, entry.name);
    if (!entry.folder) files.push_back(prefix + entry.name);
    if (entry.folder && !isFile(join(path, "merker.toml")))
      collect(path, prefix + entry.name + "/", files);
  }
}

}  // namespace

std::vector<Entry> entries(const std::string& folder) {
  std::error_code error;
  std::vector<Entry> list;
  for (fs::directory_iterator i(folder, error), end; !error && i != end; i.increment(error)) {
    std::error_code ignored;
    Entry entry{i->path().filename().string(), i->is_directory(ignored)};
    const bool link = entry.folder && i->is_symlink(ignored);
    if (!link && !entry.name.starts_with('.')) list.push_back(std::move(entry));
  }
  std::sort(list.begin(), list.end(),
            [](const Entry& a, const Entry& b) { return a.name < b.name; });
  return list;
}

bool matches(std::string_view pattern, std::string_view path) {
  return matchesUpper(upper(pattern), upper(path));
}

std::vector<std::string> listFiles(const std::string& folder) {
  std::vector<std::string> files;
  collect(folder, "", files);
  std::sort(files.begin(), files.end());
  return files;
}

bool isFolder(const std::string& path) {
  std::error_code error;
  return fs::is_directory(path, error);
}

bool isFile(const std::string& path) {
  std::error_code error;
  return fs::exists(path, error) && !fs::is_directory(path, error);
}

bool hasExtension(std::string_view path, std::string_view extension) {
  return path.size() > extension.size() &&
         equalsIgnoreCase(path.substr(path.size() - extension.size()), extension);
}

std::string join(const std::string& folder, const std::string& name) {
  return (fs::path(folder == "." ? "" : folder) / name).string();
}

std::string folderOf(const std::string& path) {
  const std::string folder = fs::path(path).parent_path().string();
  return folder.empty() ? "." : folder;
}

std::string stemOf(const std::string& path) { return fs::path(path).stem().string(); }

}  // namespace merker::project
