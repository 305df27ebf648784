#include "workbench/file_watch.h"

#include "project/files.h"

namespace merker::workbench {
namespace {

struct Row {
  std::string_view ending, kind;
};
constexpr Row kRows[] = {{".awl", "source"},   {".s5", "source"},           {".sym", "symbols"},
                         {".sdf", "symbols"},  {".asc", "symbols"},         {".seq", "symbols"},
                         {".dif", "symbols"},  {"merker.toml", "hardware"}, {".vat", "table"},
                         {".scn", "scenario"}, {".state", "state"},         {".rec", "recording"}};

bool isLoaded(std::string_view path) {
  const std::string_view kind = kindOfFile(path);
  return kind == "source" || kind == "symbols" || kind == "hardware";
}

}  // namespace

std::string_view kindOfFile(std::string_view path) {
  for (const Row& row : kRows)
    if (path == row.ending || project::hasExtension(path, row.ending)) return row.kind;
  return "other";
}

bool FileWatch::take(Listing files) {
  if (files == seen_) return false;
  seen_ = std::move(files);
  compare();
  return true;
}

void FileWatch::loaded() {
  loaded_ = seen_;
  compare();
}

void FileWatch::nothingLoaded() {
  std::erase_if(loaded_, [](const auto& file) { return kindOfFile(file.first) != "hardware"; });
  compare();
}

// Once for all frames: every browser is told of it, and a folder may hold thousands of files.
void FileWatch::compare() {
  constexpr std::size_t kMost = 200;
  changed_.clear();
  const auto note = [&](const std::string& path) {
    if (changed_.size() < kMost) changed_.push_back(path);
  };
  for (const auto& [path, stamp] : seen_) {
    const auto old = loaded_.find(path);
    if (isLoaded(path) && (old == loaded_.end() || !(old->second == stamp))) note(path);
  }
  for (const auto& [path, stamp] : loaded_)
    if (isLoaded(path) && !seen_.contains(path)) note(path);
}

}  // namespace merker::workbench
