#include "workbench/project_folder.h"

#include <fcntl.h>
#include <sys/stat.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>

#include "base/code_page.h"
#include "base/text.h"
#include "project/files.h"
#include "workbench/descriptor.h"
#include "workbench/json.h"

namespace merker::workbench {
namespace {

constexpr std::size_t kLongestPath = 400;
constexpr int kFolder = O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC;
constexpr std::string_view kTemporary = ".merker-saving";

Problem noFile(const std::string& path) { return makeProblem(ProblemCode::P1310, nowhere(), path); }
Problem notWritten(const std::string& path) {
  return makeProblem(ProblemCode::P1313, nowhere(), path, std::strerror(errno));
}

bool isName(std::string_view name) {
  return !name.empty() && name.front() != '.' && std::ranges::none_of(name, [](char c) {
    return static_cast<unsigned char>(c) < 0x20 || c == 0x7F || c == '\\' || c == ':';
  });
}

// The folder that the file lies in, and the file's name.
struct Place {
  Descriptor folder;
  std::string name;
};

Place open(const std::string& root, std::string_view path, bool make) {
  Descriptor folder(::open(root.empty() ? "." : root.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  std::size_t slash = 0;
  while (folder && (slash = path.find('/')) != std::string_view::npos) {
    const std::string name(path.substr(0, slash));
    const bool made = !make || ::mkdirat(folder.number(), name.c_str(), 0777) == 0;
    if (!made && errno != EEXIST) return {Descriptor(), {}};
    folder = Descriptor(::openat(folder.number(), name.c_str(), kFolder));
    path.remove_prefix(slash + 1);
  }
  return {std::move(folder), std::string(path)};
}

// The folders of the path that nothing lies in any more, from the deepest on.
void removeEmptyFolders(const std::string& root, std::string_view path) {
  for (std::size_t slash; (slash = path.rfind('/')) != std::string_view::npos;) {
    path = path.substr(0, slash);
    const Place place = open(root, path, false);
    if (!place.folder || ::unlinkat(place.folder.number(), place.name.c_str(), AT_REMOVEDIR) != 0)
      return;
  }
}

std::optional<Stamp> stampOf(const Place& place) {
  struct stat state {};
  if (!place.folder ||
      ::fstatat(place.folder.number(), place.name.c_str(), &state, AT_SYMLINK_NOFOLLOW) != 0 ||
      !S_ISREG(state.st_mode))
    return std::nullopt;
  return Stamp{state.st_mtim.tv_sec * 1'000'000'000 + state.st_mtim.tv_nsec,
               static_cast<std::uint64_t>(state.st_size)};
}

// O_NONBLOCK: what is a pipe by now does not wait for somebody who writes.
Descriptor openToRead(const Place& place) {
  return Descriptor(::openat(place.folder.number(), place.name.c_str(),
                             O_RDONLY | O_NOFOLLOW | O_CLOEXEC | O_NONBLOCK));
}

std::optional<std::string> bytesOf(const Place& place) {
  const auto stamp = stampOf(place);
  if (!stamp || stamp->size > kLargestFile) return std::nullopt;
  const Descriptor file = openToRead(place);
  std::string bytes(file ? stamp->size : 0, '\0');
  std::size_t done = 0;
  while (file && done < bytes.size()) {
    const ssize_t got = ::read(file.number(), bytes.data() + done, bytes.size() - done);
    if (got <= 0) break;
    done += static_cast<std::size_t>(got);
  }
  bytes.resize(done);
  return file ? std::optional(std::move(bytes)) : std::nullopt;
}

// Why there are no bytes.
Problem unread(const Place& place, const std::string& path) {
  constexpr std::uint64_t kMega = 1 << 20;
  const auto stamp = stampOf(place);
  if (!stamp) return noFile(path);
  if (stamp->size <= kLargestFile && openToRead(place)) return noFile(path);  // it came just now
  if (stamp->size <= kLargestFile)
    return makeProblem(ProblemCode::P0101, nowhere(), path, std::strerror(errno));
  return makeProblem(ProblemCode::P1308, nowhere(), path,
                     fmt::format("it has {} MB; at most {} MB can be read here",
                                 stamp->size / kMega, kLargestFile / kMega));
}

// Who may read and write the file stays as it was; only root can give it to its old owner.
void keepRights(int folder, const std::string& name, int fresh) {
  struct stat old {};
  if (::fstatat(folder, name.c_str(), &old, AT_SYMLINK_NOFOLLOW) != 0 || !S_ISREG(old.st_mode))
    return;
  const bool owned = ::fchown(fresh, old.st_uid, old.st_gid) == 0 ||
                     ::fchown(fresh, static_cast<uid_t>(-1), old.st_gid) == 0;
  // Another group must not read what only the old one could.
  constexpr mode_t kAll = 07777, kOwner = 0700;
  ::fchmod(fresh, old.st_mode & (owned ? kAll : kOwner));
}

bool writeAll(int file, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t done = ::write(file, bytes.data(), bytes.size());
    if (done < 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(done));
  }
  return true;
}

// Into a file beside it that then takes its place: after a power failure there is the old text or
// the new one, and the new one once this has answered. RENAME_NOREPLACE: only if there is none yet.
bool put(const Place& place, std::string_view bytes, unsigned how) {
  constexpr mode_t kOwn = 0600, kAll = 0666;  // less the umask
  const bool replaces = how == 0;
  const std::string temporary = std::string(kTemporary) + "-" + place.name;
  const int folder = place.folder.number();
  ::unlinkat(folder, temporary.c_str(), 0);
  bool good = false;
  {
    const Descriptor file(::openat(folder, temporary.c_str(),
                                   O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC,
                                   replaces ? kOwn : kAll));
    if (file && replaces) keepRights(folder, place.name, file.number());
    good = file && writeAll(file.number(), bytes) && ::fsync(file.number()) == 0;
  }
  good = good && ::renameat2(folder, temporary.c_str(), folder, place.name.c_str(), how) == 0 &&
         (::fsync(folder) == 0 || errno == EINVAL);  // a file system that syncs no folders
  const int error = errno;
  if (!good) ::unlinkat(folder, temporary.c_str(), 0);
  errno = error;
  return good;
}

// One of many new files, with as few calls as possible: nobody reads it before it is whole.
bool putNew(const Place& place, std::string_view bytes) {
  constexpr mode_t kAll = 0666;  // less the umask
  const Descriptor file(::openat(place.folder.number(), place.name.c_str(),
                                 O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, kAll));
  if (!file) return false;
  if (writeAll(file.number(), bytes)) return true;
  const int error = errno;
  ::unlinkat(place.folder.number(), place.name.c_str(), 0);
  errno = error;
  return false;
}

}  // namespace

// FNV-1a; its upper 53 bits.
std::int64_t revisionOf(std::string_view bytes) {
  std::uint64_t hash = 0xCBF29CE484222325;
  for (const char c : bytes) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001B3;
  return static_cast<std::int64_t>(hash >> 11);
}

bool ProjectFolder::isPath(std::string_view path) {
  if (path.empty() || path.size() > kLongestPath) return false;
  while (true) {
    const std::size_t slash = path.find('/');
    if (!isName(path.substr(0, slash))) return false;
    if (slash == std::string_view::npos) return true;
    path.remove_prefix(slash + 1);
  }
}

std::optional<Problem> ProjectFolder::check(const std::string& path) const {
  if (!isPath(path)) return makeProblem(ProblemCode::P1309, nowhere(), path);
  if (!only_.empty() && !only_.contains(path)) return noFile(path);
  return std::nullopt;
}

// A program with deeper folders could not be compiled any more (P0715).
std::optional<Problem> ProjectFolder::checkNew(const std::string& path) const {
  if (auto problem = check(path)) return problem;
  const auto folders = static_cast<std::size_t>(std::ranges::count(path, '/'));
  if (folders <= project::kDeepestFolder) return std::nullopt;
  return makeProblem(ProblemCode::P1314, nowhere(), project::kDeepestFolder,
                     "folders within each other");
}

std::string ProjectFolder::relative(std::string_view path) const {
  const std::string prefix = project::join(folder_, "");
  if (!prefix.empty() && path.starts_with(prefix)) path.remove_prefix(prefix.size());
  return std::string(path);
}

std::string ProjectFolder::withoutFolder(std::string text) const {
  const std::string prefix = project::join(folder_, "");
  for (std::size_t at = 0; !prefix.empty() && (at = text.find(prefix, at)) != std::string::npos;)
    text.erase(at, prefix.size());
  return text;
}

std::string ProjectFolder::full(std::string_view path) const {
  return project::join(folder_, std::string(path));
}

std::optional<Problem> ProjectFolder::missing() const {
  if (open(folder_, "", false).folder) return std::nullopt;
  return makeProblem(ProblemCode::P0101, nowhere(), folder_, std::strerror(errno));
}

Listing ProjectFolder::list(std::size_t most) const {
  Listing files;
  const auto names = only_.empty() ? project::listFiles(folder_.empty() ? "." : folder_)
                                   : std::vector<std::string>(only_.begin(), only_.end());
  for (const std::string& name : names) {
    if (files.size() >= most) break;
    const auto stamp = isPath(name) ? stampOf(open(folder_, name, false)) : std::nullopt;
    if (stamp) files[name] = *stamp;
  }
  return files;
}

std::unique_ptr<archive::File> ProjectFolder::file(const std::string& path) const {
  if (check(path)) return nullptr;
  const Place place = open(folder_, path, false);
  if (!stampOf(place)) return nullptr;
  Descriptor file = openToRead(place);
  if (!file) return nullptr;
  auto opened = archive::fileOn(archive::Handle(::fdopen(file.number(), "rb")));
  if (opened) static_cast<void>(file.release());
  return opened;
}

Result<ProjectFolder::Content> ProjectFolder::read(const std::string& path) const {
  if (auto problem = check(path)) return *problem;
  const Place place = open(folder_, path, false);
  const auto bytes = bytesOf(place);
  if (!bytes) return unread(place, path);
  auto text = decoded(*bytes);
  if (!text) return makeProblem(ProblemCode::P0102, Position{path}, "a file of a project");
  return Content{std::move(*text), revisionOf(*bytes)};
}

std::optional<Problem> ProjectFolder::write(const std::string& path, std::string_view bytes,
                                            std::optional<std::int64_t> revision) const {
  if (auto problem = check(path)) return problem;
  const Place place = open(folder_, path, false);
  const auto before = bytesOf(place);
  if (!before) return unread(place, path);
  if (revision && revisionOf(*before) != *revision)
    return makeProblem(ProblemCode::P1311, nowhere(), path);
  return put(place, bytes, 0) ? std::nullopt : std::optional(notWritten(path));
}

std::optional<Problem> ProjectFolder::make(const std::string& path, std::string_view bytes,
                                           bool lasting) const {
  if (auto problem = checkNew(path)) return problem;
  const Place place = open(folder_, path, true);
  const auto write = [&] {
    return lasting ? put(place, bytes, RENAME_NOREPLACE) : putNew(place, bytes);
  };
  if (place.folder && write()) return std::nullopt;
  return errno == EEXIST ? makeProblem(ProblemCode::P1312, nowhere(), path) : notWritten(path);
}

std::optional<Problem> ProjectFolder::create(const std::string& path,
                                             std::string_view bytes) const {
  return make(path, bytes, true);
}

std::optional<Problem> ProjectFolder::add(const std::string& path, std::string_view bytes) const {
  return make(path, bytes, false);
}

void ProjectFolder::flush() const {
  const Place place = open(folder_, "", false);
  if (place.folder) ::syncfs(place.folder.number());
}

std::optional<Problem> ProjectFolder::remove(const std::string& path) const {
  if (auto problem = check(path)) return problem;
  const Place place = open(folder_, path, false);
  if (!stampOf(place)) return noFile(path);
  if (::unlinkat(place.folder.number(), place.name.c_str(), 0) != 0) return notWritten(path);
  removeEmptyFolders(folder_, path);
  return std::nullopt;
}

std::optional<Problem> ProjectFolder::rename(const std::string& from, const std::string& to) const {
  if (auto problem = check(from)) return problem;
  if (auto problem = checkNew(to)) return problem;
  const Place old = open(folder_, from, false);
  if (!stampOf(old)) return noFile(from);
  const Place fresh = open(folder_, to, true);
  if (fresh.folder && ::renameat2(old.folder.number(), old.name.c_str(), fresh.folder.number(),
                                  fresh.name.c_str(), RENAME_NOREPLACE) == 0) {
    removeEmptyFolders(folder_, from);
    return std::nullopt;
  }
  return errno == EEXIST ? makeProblem(ProblemCode::P1312, nowhere(), to) : notWritten(to);
}

}  // namespace merker::workbench
