#include "project/files.h"

#include <algorithm>
#include <filesystem>

#include "base/text.h"

namespace merker::project {
namespace fs = std::filesystem;
namespace {

// Walks down until there is too much.
class Walk {
 public:
  explicit Walk(Problems* problems) : problems_(problems) {}

  void collect(const std::string& folder, const std::string& prefix, std::size_t depth) {
    for (const Entry& entry : entries(folder)) {
      const std::string path = join(folder, entry.name);
      if (++seen_ > kMostEntries) return tooMuch(ProblemCode::P0714, folder, kMostEntries);
      if (!entry.folder) files.push_back(prefix + entry.name);
      if (!entry.folder || isFile(join(path, "merker.toml"))) continue;
      if (depth == kDeepestFolder) {
        tooMuch(ProblemCode::P0715, path, kDeepestFolder);
        continue;
      }
      collect(path, prefix + entry.name + "/", depth + 1);
      if (seen_ > kMostEntries) return;
    }
  }

  std::vector<std::string> files;

 private:
  void tooMuch(ProblemCode code, const std::string& folder, std::size_t limit) const {
    if (problems_ != nullptr) problems_->add(code, Position{folder}, limit);
  }

  Problems* problems_;
  std::size_t seen_ = 0;
};

}  // namespace

std::vector<Entry> entries(const std::string& folder) {
  std::error_code error;
  std::vector<Entry> list;
  fs::directory_iterator i(folder, error);
  for (const fs::directory_iterator end; !error && i != end; i.increment(error)) {
    if (list.size() > kMostEntries) break;
    std::error_code ignored;
    Entry entry{i->path().filename().string(), i->is_directory(ignored)};
    const bool link = entry.folder && i->is_symlink(ignored);
    if (!link && !entry.name.starts_with('.')) list.push_back(std::move(entry));
  }
  std::sort(list.begin(), list.end(),
            [](const Entry& a, const Entry& b) { return a.name < b.name; });
  return list;
}

std::vector<std::string> listFiles(const std::string& folder, Problems* problems) {
  Walk walk(problems);
  walk.collect(folder, "", 0);
  std::sort(walk.files.begin(), walk.files.end());
  return std::move(walk.files);
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
