#include "itcp/page_files.h"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <fstream>

namespace merker::itcp {
namespace {

namespace fs = std::filesystem;

struct PageType {
  std::string_view extension, type;
  Escape escape = Escape::None;
};
constexpr PageType kPageTypes[] = {
    {".html", "text/html; charset=utf-8", Escape::Html},
    {".htm", "text/html; charset=utf-8", Escape::Html},
    {".json", "application/json", Escape::Json},
    {".xml", "application/xml", Escape::Html},
    {".css", "text/css; charset=utf-8"},
    {".js", "text/javascript; charset=utf-8"},
    {".txt", "text/plain; charset=utf-8"},
    {".svg", "image/svg+xml"},
    {".png", "image/png"},
    {".jpg", "image/jpeg"},
    {".gif", "image/gif"},
    {".ico", "image/x-icon"},
};
constexpr PageType kAnyType{"", "application/octet-stream"};

// %20 and the like; nothing: wrong.
std::optional<std::string> decoded(std::string_view text) {
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '%') {
      out += text[i];
      continue;
    }
    unsigned value = 0;
    const std::string_view digits = text.substr(i + 1, 2);
    const auto [end, error] =
        std::from_chars(digits.data(), digits.data() + digits.size(), value, 16);
    if (digits.size() != 2 || error != std::errc() || end != digits.data() + 2) return std::nullopt;
    out += static_cast<char>(value);
    i += 2;
  }
  return out;
}

// Neither ".." nor hidden, on no system.
bool isGoodPath(std::string_view path) {
  const bool plain = std::ranges::none_of(
      path, [](char c) { return static_cast<unsigned char>(c) < ' ' || c == '\\' || c == ':'; });
  return plain && !path.starts_with('/') && !path.starts_with('.') &&
         path.find("/.") == path.npos && path.find("//") == path.npos;
}

// Links may lead somewhere else.
bool liesIn(const fs::path& folder, const fs::path& file) {
  std::error_code error;
  const fs::path root = fs::canonical(folder, error), real = fs::canonical(file, error);
  if (error || !fs::is_regular_file(real, error)) return false;
  return std::ranges::mismatch(root, real).in1 == root.end();
}

}  // namespace

std::optional<std::string> pathOf(std::string_view target) {
  auto path = decoded(target.substr(0, target.find_first_of("?#")));
  if (!path || !path->starts_with('/')) return std::nullopt;
  path->erase(0, 1);
  if (path->empty() || path->ends_with('/')) *path += "index.html";
  return isGoodPath(*path) ? path : std::nullopt;
}

std::optional<PageFile> pageFile(const std::string& folder, const std::string& path) {
  const fs::path place = fs::path(folder) / path;
  std::error_code error;
  if (folder.empty() || !liesIn(folder, place) || fs::file_size(place, error) > PageFile::kLargest)
    return std::nullopt;
  std::ifstream in(place, std::ios::binary);
  if (!in) return std::nullopt;
  const std::string extension = place.extension().string();
  const auto* const found = std::ranges::find(kPageTypes, extension, &PageType::extension);
  const PageType& type = found == std::end(kPageTypes) ? kAnyType : *found;
  std::string bytes(PageFile::kLargest, '\0');
  in.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  bytes.resize(static_cast<std::size_t>(in.gcount()));
  return PageFile{type.type, type.escape, std::move(bytes)};
}

}  // namespace merker::itcp
