#include "workbench/upload.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>

#include "project/files.h"
#include "workbench/json.h"
#include "workbench/project_folder.h"

namespace merker::workbench {
namespace {

namespace fs = std::filesystem;

Problem unwritten(const std::string& path) {
  return makeProblem(ProblemCode::P1313, nowhere(), path, std::strerror(errno));
}

// The only thing in a folder; empty: there are more.
fs::path onlyEntry(const fs::path& folder) {
  fs::path found;
  std::error_code error;
  for (fs::directory_iterator at(folder, error); !error && at != fs::directory_iterator();
       at.increment(error)) {
    if (!found.empty()) return {};
    found = at->path();
  }
  return found;
}

const std::string kPrefix = "merker-import-";
constexpr std::size_t kLetters = 6;  // of mkdtemp

// A folder of this user that no process uses; the lock ends with whoever holds it, however he ends.
Descriptor locked(const std::string& folder) {
  Descriptor one(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC));
  struct stat state {};
  const bool ours = one && ::fstat(one.number(), &state) == 0 && state.st_uid == ::geteuid();
  return ours && ::flock(one.number(), LOCK_EX | LOCK_NB) == 0 ? std::move(one) : Descriptor();
}

// Whether the name still means what was locked.
bool isFolder(const std::string& folder, const Descriptor& lock) {
  struct stat named {
  }, open{};
  return ::lstat(folder.c_str(), &named) == 0 && ::fstat(lock.number(), &open) == 0 &&
         named.st_dev == open.st_dev && named.st_ino == open.st_ino;
}

bool appendAll(int file, std::span<const std::uint8_t> bytes) {
  while (!bytes.empty()) {
    const ssize_t done = ::write(file, bytes.data(), bytes.size());
    if (done < 0) return false;
    bytes = bytes.subspan(static_cast<std::size_t>(done));
  }
  return true;
}

}  // namespace

std::shared_ptr<Upload> Upload::make() {
  constexpr int kTries = 3;  // somebody who sweeps may have been faster
  for (int i = 0; i < kTries; ++i) {
    std::error_code error;
    std::string folder = (fs::temp_directory_path(error) / (kPrefix + "XXXXXX")).string();
    if (error || ::mkdtemp(folder.data()) == nullptr) return nullptr;  // for this user only
    if (Descriptor lock = locked(folder); lock && isFolder(folder, lock))
      return std::shared_ptr<Upload>(new Upload(std::move(folder), std::move(lock)));
  }
  return nullptr;
}

// Links are not followed, neither here nor in what is deleted.
void Upload::sweep() {
  std::error_code error;
  const fs::path all = fs::temp_directory_path(error);
  for (fs::directory_iterator at(all, error); !error && at != fs::directory_iterator();
       at.increment(error)) {
    const std::string name = at->path().filename().string();
    if (!name.starts_with(kPrefix) || name.size() != kPrefix.size() + kLetters) continue;
    const Descriptor lock = locked(at->path().string());
    std::error_code ignored;
    if (lock && isFolder(at->path().string(), lock)) fs::remove_all(at->path(), ignored);
  }
}

Upload::~Upload() {
  std::error_code ignored;
  fs::remove_all(folder_, ignored);
}

// The folder is ours alone, and nothing in it is a link: paths without ".." cannot leave it.
std::optional<Problem> Upload::add(const std::string& path, std::span<const std::uint8_t> bytes) {
  constexpr std::uint64_t kMega = 1 << 20;
  constexpr auto kFolders = static_cast<std::ptrdiff_t>(project::kDeepestFolder);
  if (!ProjectFolder::isPath(path) || std::ranges::count(path, '/') > kFolders)
    return makeProblem(ProblemCode::P1309, nowhere(), path);
  if (bytes_ + bytes.size() > kMostBytes)
    return makeProblem(ProblemCode::P1314, nowhere(), kMostBytes / kMega, "MB to import at once");
  const fs::path full = fs::path(input()) / path;
  std::error_code error;
  fs::create_directories(full.parent_path(), error);
  const bool fresh = !fs::exists(full, error);
  if (fresh && files_ >= kMostFiles)
    return makeProblem(ProblemCode::P1314, nowhere(), kMostFiles, "files to import at once");
  constexpr mode_t kOwn = 0600;
  const Descriptor file(
      ::open(full.c_str(), O_WRONLY | O_APPEND | O_CREAT | O_NOFOLLOW | O_CLOEXEC, kOwn));
  if (!file) return unwritten(path);
  if (fresh) ++files_;
  bytes_ += bytes.size();
  return appendAll(file.number(), bytes) ? std::nullopt : std::optional(unwritten(path));
}

std::string Upload::source() const {
  const fs::path only = onlyEntry(input());
  return only.empty() ? input() : only.string();
}

std::string Upload::name() const {
  const fs::path only = onlyEntry(input());
  if (only.empty()) return {};
  std::error_code error;
  return (fs::is_directory(only, error) ? only.filename() : only.stem()).string();
}

}  // namespace merker::workbench
