#include "importing/output.h"

#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>

#include "base/utf8.h"

namespace merker::importing {
namespace {

namespace fs = std::filesystem;
constexpr std::size_t kLongestName = 60;

bool harmless(char32_t c) {
  constexpr std::u32string_view kNot = U"<>:\"/\\|?*'`$";
  const bool control = c < 0x20 || (c >= 0x7F && c < 0xA0);
  return !control && c != kReplacement && kNot.find(c) == std::u32string_view::npos;
}

}  // namespace

std::string stemOf(const std::string& source) {
  std::error_code error;
  const fs::path path = fs::weakly_canonical(source, error);
  const fs::path name = fs::is_directory(path, error) ? path.filename() : path.stem();
  return name.empty() ? "project" : name.string();
}

bool isFree(const std::string& path) {
  std::error_code error;
  if (!fs::exists(fs::symlink_status(path, error))) return true;
  return fs::is_directory(path, error) && fs::is_empty(path, error) && !error;
}

std::string whyNotWritable(const std::string& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) return error.message();
  return ::access(folder.c_str(), W_OK | X_OK) == 0 ? "" : std::strerror(errno);
}

std::string Output::unused(std::string_view wanted, std::string_view extension) {
  std::string name;
  for (std::size_t at = 0; at < wanted.size() && name.size() < kLongestName;) {
    const char32_t c = nextCharacter(wanted, at);
    appendCharacter(name, harmless(c) ? c : U'_');
  }
  while (name.starts_with('.') || name.starts_with(' ')) name.erase(0, 1);
  while (name.ends_with('.') || name.ends_with(' ')) name.pop_back();
  if (name.empty()) name = "unnamed";
  std::string unique = name;
  for (int i = 2; !used_.insert(archive::folded(unique + std::string(extension))).second; ++i)
    unique = fmt::format("{} {}", name, i);
  return unique + std::string(extension);
}

bool Output::write(const std::string& name, std::string_view text) {
  return write(name, std::span(reinterpret_cast<const std::uint8_t*>(text.data()), text.size()));
}

bool Output::write(const std::string& name, std::span<const std::uint8_t> bytes) {
  const fs::path path = fs::path(folder_) / name;
  std::error_code error;
  fs::create_directories(path.parent_path(), error);
  const std::unique_ptr<std::FILE, archive::Close> file(std::fopen(path.c_str(), "wbxe"));
  const bool good = file &&
                    std::fwrite(bytes.data(), 1, bytes.size(), file.get()) == bytes.size() &&
                    std::fflush(file.get()) == 0;
  if (!good) report_.add(Note::NotWritten, path.string(), std::strerror(errno));
  return good;
}

}  // namespace merker::importing
