#include "workbench/packing.h"

#include <algorithm>
#include <filesystem>

#include "archive/zip_writer.h"
#include "base/utf8.h"
#include "base/visible.h"
#include "project/files.h"

namespace merker::workbench {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kMostMegabytes = 256, kLargestProject = kMostMegabytes << 20;

Problems notPacked(std::string_view why) {
  return refused(ProblemCode::P1308, "the project cannot be packed", why);
}

std::string tooLarge() { return fmt::format("it has more than {} MB", kMostMegabytes); }

// What belongs to this computer and not to the project: a memory card that is in use, copies that
// editors make.
bool isLeft(std::string_view path) {
  constexpr std::string_view kEndings[] = {
      ".sqlite", ".sqlite-wal", ".sqlite-shm", ".sqlite-journal", ".tmp", ".bak", "~"};
  return std::ranges::any_of(kEndings,
                             [&](std::string_view ending) { return path.ends_with(ending); });
}

// What lies in the folder and is not packed.
class Rest {
 public:
  explicit Rest(Choice& choice) : choice_(choice) {}

  // Projects inside are projects of their own; links lead anywhere.
  void walk(const fs::path& folder, const std::string& prefix, std::size_t depth) {
    std::error_code error;
    for (fs::directory_iterator at(folder, error); !error && at != fs::directory_iterator();
         at.increment(error)) {
      const std::string name = at->path().filename().string(), path = prefix + name;
      if (name.starts_with('.')) continue;
      choice_.tooMany = ++seen_ > project::kMostEntries;
      if (choice_.tooMany) return;
      std::error_code ignored;
      const bool inner = at->is_directory(ignored) && !at->is_symlink(ignored);
      const bool apart = !ProjectFolder::isPath(path) || depth == project::kDeepestFolder ||
                         project::isFile((at->path() / "merker.toml").string());
      if (inner && !apart)
        walk(at->path(), path + "/", depth + 1);
      else if (!choice_.files.contains(path))
        choice_.left.insert(visible(path) + (inner ? "/" : ""));
      if (choice_.tooMany) return;
    }
  }

 private:
  Choice& choice_;
  std::size_t seen_ = 0;
};

std::string tooMany() {
  return fmt::format("it has more than {} files and folders", project::kMostEntries);
}

// Null: all that can be read is there.
std::optional<Problems> copyFiles(const ProjectFolder& from, const ProjectFolder& to,
                                  Choice& choice, const std::stop_token& stop) {
  std::uint64_t bytes = 0;
  for (const auto& [path, stamp] : Listing(choice.files)) {
    if (stop.stop_requested()) break;
    const auto file = from.file(path);
    bytes += file ? file->size() : 0;
    if (bytes > kLargestProject) return notPacked(tooLarge());
    if (!file) {
      choice.files.erase(path);
      choice.left.insert(visible(path));
    } else if (auto problem = to.add(path, file->text(file->size()))) {
      return one(std::move(*problem));
    }
  }
  to.flush();
  return std::nullopt;
}

constexpr std::int64_t kSecond = 1'000'000'000;  // ns

archive::Zipped zipOf(const ProjectFolder& folder, const Listing& listing,
                      const std::stop_token& stop) {
  std::vector<archive::Packed> files;
  for (const auto& [path, stamp] : listing)
    files.push_back({path, stamp.size, stamp.changed / kSecond,
                     [&folder, name = path] { return folder.file(name); }});
  return archive::writeZip(files, kLargestProject, stop);
}

// A file that vanishes meanwhile is left out.
archive::Zipped zipOf(const ProjectFolder& folder, Choice& choice, const std::stop_token& stop) {
  constexpr int kTries = 20;
  archive::Zipped zip = zipOf(folder, choice.files, stop);
  for (int i = 1; i < kTries && zip.failure == archive::ZipFailure::Unreadable; ++i) {
    choice.files.erase(zip.path);
    choice.left.insert(visible(zip.path));
    zip = zipOf(folder, choice.files, stop);
  }
  return zip;
}

// Null: it was written.
std::optional<Problems> whyNot(const archive::Zipped& zip) {
  using archive::ZipFailure;
  switch (zip.failure) {
    case ZipFailure::None:
      return std::nullopt;
    case ZipFailure::TooLarge:
      return notPacked(tooLarge());
    case ZipFailure::Unreadable:
      return refused(ProblemCode::P1310, zip.path);
    case ZipFailure::Unwritable:
      return refused(ProblemCode::P1313, "the zip", "the temporary folder is full or missing");
    case ZipFailure::Stopped:
      return notPacked("it was cancelled");
  }
  return std::nullopt;
}

std::string zipName(const ProjectFolder& folder) {
  const std::string stem = project::stemOf(folder.folder());
  return (stem.empty() || stem == "." ? "project" : stem) + ".zip";
}

}  // namespace

Choice choose(const ProjectFolder& folder) {
  Choice choice;
  for (const auto& [path, stamp] : folder.list(project::kMostEntries))
    if (isValidUtf8(path) && !isLeft(path) && folder.file(path)) choice.files[path] = stamp;
  if (folder.growing()) Rest(choice).walk(folder.folder().empty() ? "." : folder.folder(), "", 0);
  return choice;
}

Answer copyProject(const ProjectFolder& from, const Workspace& workspace, const std::string& name,
                   const std::stop_token& stop) {
  if (auto gone = from.missing()) return one(std::move(*gone));
  Choice choice = choose(from);
  if (choice.tooMany) return notPacked(tooMany());
  const auto folder = workspace.makeFolder(name);
  if (!folder) return one(folder.error());
  const ProjectFolder to(*folder);
  auto problem = copyFiles(from, to, choice, stop);
  if (!problem && stop.stop_requested()) problem = notPacked("it was cancelled");
  std::error_code ignored;
  if (problem) return fs::remove_all(*folder, ignored), *problem;
  return Json{{"folder", *folder}, {"files", choice.files.size()}, {"left", choice.left}};
}

Packing pack(const ProjectFolder& folder, Choice choice, const std::stop_token& stop) {
  if (auto gone = folder.missing()) return {one(std::move(*gone)), nullptr, {}};
  if (choice.tooMany) return {notPacked(tooMany()), nullptr, {}};
  archive::Zipped zip = zipOf(folder, choice, stop);
  Packing packing{whyNot(zip), nullptr, {}};
  if (packing.wrong) return packing;
  packing.result = {{"name", zipName(folder)},
                    {"size", zip.file->size()},
                    {"files", choice.files.size()},
                    {"left", choice.left}};
  packing.file = std::move(zip.file);
  return packing;
}

}  // namespace merker::workbench
