#include "archive/tree.h"

#include <fmt/format.h>
#include <sys/stat.h>

#include <algorithm>

#include "archive/container.h"
#include "base/text.h"
#include "base/utf8.h"

namespace merker::archive {
namespace {

constexpr std::size_t kLongestPath = 1000;

bool isZip(const File& file) {
  std::uint8_t mark[4] = {};
  return file.read(0, mark) == 4 && mark[0] == 'P' && mark[1] == 'K' &&
         ((mark[2] == 3 && mark[3] == 4) || (mark[2] == 5 && mark[3] == 6));
}

// ".", ".." and empty names, drives and the root lead elsewhere.
bool leadsOut(std::string_view path) {
  if (path.empty() || path.size() > kLongestPath || path.find(':') != std::string_view::npos)
    return true;
  while (true) {
    const std::size_t end = path.find('/');
    const std::string_view part = path.substr(0, end);
    if (part.empty() || part == "." || part == "..") return true;
    if (end == std::string_view::npos) return false;
    path.remove_prefix(end + 1);
  }
}

// Of ASCII and of Latin-1, which a terminal obeys as well.
bool hasControls(std::string_view path) {
  for (std::size_t at = 0; at < path.size();) {
    const char32_t c = nextCharacter(path, at);
    if (c < 0x20 || (c >= 0x7F && c < 0xA0)) return true;
  }
  return false;
}

}  // namespace

std::string folded(std::string_view path) {
  std::string out(path);
  for (char& c : out) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    if (c == '\\') c = '/';
  }
  return out;
}

std::string_view nameOf(std::string_view path) {
  const std::size_t slash = path.rfind('/');
  return slash == std::string_view::npos ? path : path.substr(slash + 1);
}

std::string_view folderOf(std::string_view path) {
  const std::size_t slash = path.rfind('/');
  return slash == std::string_view::npos ? std::string_view() : path.substr(0, slash);
}

void Tree::refuse(std::string path, Refusal why) const {
  constexpr std::size_t kMostRefused = 1000;
  if (refused_.size() < kMostRefused) refused_.push_back({std::move(path), why});
}

void Tree::addEntry(Entry entry, unsigned zips, const std::shared_ptr<Budget>& budget) {
  if (hasControls(entry.path)) return refuse(std::move(entry.path), Refusal::BadName);
  if (files_.size() >= limits_.entries) {
    if (!full_) refuse(entry.path, Refusal::TooMany);
    full_ = true;
    return;
  }
  const bool zip = folded(entry.path).ends_with(".zip");
  if (zip && zips >= limits_.zips) return refuse(entry.path, Refusal::TooDeep);
  if (zip) {
    auto file = open(entry);
    if (file && isZip(*file) && addZip(std::move(file), entry.path, entry.path + "/", zips, budget))
      return;
  }
  files_.push_back(std::move(entry));
}

void Tree::addFolder(const std::string& path, const std::string& prefix, unsigned zips) {
  const auto disk = diskContainer(path);
  walkFolder(
      path, limits_.folders,
      [&](const std::string& file, std::uint64_t size) {
        addEntry({prefix + file, size, disk, 0}, zips, nullptr);
        return !full_;
      },
      [&](const std::string& file, Refusal why) { refuse(prefix + file, why); });
}

bool Tree::addZip(std::shared_ptr<const File> file, const std::string& zipPath,
                  const std::string& prefix, unsigned zips, std::shared_ptr<Budget> budget) {
  if (!budget) budget = std::make_shared<Budget>(Budget{file->size(), 0});
  std::vector<ZipEntry> entries;
  auto zip = zipContainer(file, limits_, unpacked_, budget, entries);
  if (!zip) {
    std::uint64_t end = 0;
    if (const auto whole = salvaged(file, end))
      zip = zipContainer(whole, limits_, unpacked_, budget, entries);
    refuse(fmt::format("{}, from byte {} on", zipPath, end), Refusal::Damaged);
  }
  if (!zip) return false;
  for (const ZipEntry& entry : entries) {
    std::string path = entry.path;
    std::replace(path.begin(), path.end(), '\\', '/');
    if (path.ends_with('/')) continue;  // a folder
    const auto depth = static_cast<unsigned>(std::count(path.begin(), path.end(), '/'));
    if (leadsOut(path))
      refuse(prefix + path.substr(0, kLongestPath), Refusal::LeadsOut);
    else if (!entry.named)
      refuse(prefix + path, Refusal::BadName);
    else if (entry.link)
      refuse(prefix + path, Refusal::Link);
    else if (entry.encrypted)
      refuse(prefix + path, Refusal::Encrypted);
    else if (depth >= limits_.folders)
      refuse(prefix + path, Refusal::TooDeep);
    else
      addEntry({prefix + path, entry.size, zip, entry.index}, zips + 1, budget);
    if (full_) break;
  }
  return true;
}

void Tree::finish() {
  std::sort(files_.begin(), files_.end(),
            [](const Entry& a, const Entry& b) { return folded(a.path) < folded(b.path); });
  for (const Entry& entry : files_) keys_.push_back(folded(entry.path));
}

Tree::Tree(const std::string& path, const Limits& limits) : limits_(limits) {
  struct stat status {};
  readable_ = stat(path.c_str(), &status) == 0;
  if (readable_ && S_ISDIR(status.st_mode)) {
    addFolder(path, "", 0);
  } else if (auto file = openFile(path)) {
    const std::string name(nameOf(path));
    const std::uint64_t size = file->size();
    if (!isZip(*file) || !addZip(std::move(file), name, "", 0, nullptr)) {
      single_ = true;
      const std::string folder(folderOf(path));
      const bool root = folder.empty() && path.starts_with('/');
      files_.push_back({name, size, diskContainer(root ? "/" : folder.empty() ? "." : folder), 0});
    }
  } else {
    readable_ = false;
  }
  finish();
}

namespace {

class Held final : public Container {
 public:
  explicit Held(const std::map<std::string, std::string>& files) : files_(files) {}
  std::unique_ptr<File> open(std::uint64_t, const std::string& path, Refusal&) override {
    const std::string& bytes = files_.at(path);
    return fileOf({bytes.begin(), bytes.end()});
  }

 private:
  std::map<std::string, std::string> files_;
};

}  // namespace

Tree::Tree(std::unique_ptr<File> zip, const Limits& limits) : limits_(limits), readable_(true) {
  if (isZip(*zip)) addZip(std::move(zip), "zip", "", 0, nullptr);
  finish();
}

Tree::Tree(const std::map<std::string, std::string>& files) : readable_(true) {
  const auto held = std::make_shared<Held>(files);
  for (const auto& [path, bytes] : files) files_.push_back({path, bytes.size(), held, 0});
  finish();
}

const Tree::Entry* Tree::find(std::string_view path) const {
  const std::string key = folded(path);
  const auto at = std::lower_bound(keys_.begin(), keys_.end(), key);
  return at == keys_.end() || *at != key ? nullptr
                                         : &files_[static_cast<std::size_t>(at - keys_.begin())];
}

std::span<const Tree::Entry> Tree::below(std::string_view folder) const {
  if (folder.empty()) return files_;
  const std::string first = folded(folder) + "/", behind = folded(folder) + "0";  // '0' follows '/'
  const auto from = std::lower_bound(keys_.begin(), keys_.end(), first);
  const auto to = std::lower_bound(from, keys_.end(), behind);
  return std::span(files_).subspan(static_cast<std::size_t>(from - keys_.begin()),
                                   static_cast<std::size_t>(to - from));
}

std::unique_ptr<File> Tree::open(const Entry& entry) const {
  Refusal why = Refusal::Unreadable;
  std::string path = entry.path;
  auto file = entry.in->open(entry.index, path, why);
  if (!file) refuse(entry.path, why);
  return file;
}

std::unique_ptr<File> Tree::open(std::string_view path) const {
  const Entry* entry = find(path);
  return entry == nullptr ? nullptr : open(*entry);
}

}  // namespace merker::archive
