#include "importing/merker_project.h"

#include <algorithm>

namespace merker::importing {
namespace {

constexpr std::string_view kSettings = "merker.toml";
constexpr std::string_view kReport = "import-report.txt";  // of the import before; a new one comes
constexpr std::size_t kMega = 1 << 20, kLargestCopy = 64 * kMega;

// Also the folder itself.
bool isIn(std::string_view path, const std::string& folder) {
  return folder.empty() || (archive::folded(path) + "/").starts_with(archive::folded(folder) + "/");
}

// A hidden file or folder, or a name that a file system may take for something else.
bool isPlain(std::string_view path) {
  const bool hidden = path.starts_with('.') || path.find("/.") != std::string_view::npos;
  return !hidden && std::ranges::none_of(path, [](char c) {
    return static_cast<unsigned char>(c) < ' ' || c == '\x7F';
  });
}

}  // namespace

std::vector<MerkerProject> merkerProjects(const archive::Tree& tree, const std::string& source) {
  std::vector<std::string> folders;
  for (const auto& entry : tree.files())
    if (archive::nameOf(entry.path) == kSettings)
      folders.emplace_back(archive::folderOf(entry.path));
  std::ranges::sort(folders, {}, &std::string::size);
  std::vector<MerkerProject> list;
  for (const std::string& folder : folders)
    if (std::ranges::none_of(list, [&](const auto& one) { return isIn(folder, one.folder); }))
      list.push_back(
          {folder.empty() ? stemOf(source) : std::string(archive::nameOf(folder)), folder});
  return list;
}

void copyMerkerProject(const archive::Tree& tree, const MerkerProject& project, Output& output,
                       Report& report) {
  std::size_t count = 0;
  for (const auto& entry : tree.below(project.folder)) {
    if (output.stopped()) return;
    const std::string path =
        entry.path.substr(project.folder.empty() ? 0 : project.folder.size() + 1);
    if (!isPlain(path) || archive::folded(path) == kReport) continue;
    const auto file = tree.open(entry);
    if (!file) continue;  // the tree says why
    if (file->size() > kLargestCopy)
      report.add(Note::LongSource, path, kLargestCopy / kMega);
    else if (output.write(path, file->text(kLargestCopy)))
      ++count;
  }
  report.add(Note::MerkerFiles, count);
}

}  // namespace merker::importing
