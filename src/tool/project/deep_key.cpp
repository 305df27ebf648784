#include "project/deep_key.h"

#include <algorithm>
#include <string>

namespace merker::project {
namespace {

bool isBareKey(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
         c == '-';
}

// Behind the text in quotation marks that begins at `at`: one mark or three on each side, with \ in
// double ones.
std::size_t behindText(std::string_view toml, std::size_t at) {
  const char mark = toml[at];
  const bool lines = toml.substr(at, 3) == std::string(3, mark);
  const std::string end(lines ? 3 : 1, mark);
  for (at += end.size(); at < toml.size(); ++at) {
    if (toml[at] == '\\' && mark == '"')
      ++at;
    else if (toml.substr(at, end.size()) == end)
      return at + end.size();
    else if (toml[at] == '\n' && !lines)
      return at;
  }
  return toml.size();
}

}  // namespace

std::optional<std::size_t> deepKey(std::string_view toml) {
  std::size_t parts = 1, begin = 0;
  for (std::size_t at = 0; at < toml.size();) {
    const char c = toml[at];
    if (c == '"' || c == '\'') {
      at = behindText(toml, at);
      continue;
    }
    if (c == '#')
      at = std::min(toml.find('\n', at), toml.size());
    else
      ++at;
    if (c == '.' && ++parts > kDeepestKey) return begin;
    if (c == '.' || c == ' ' || c == '\t' || isBareKey(c)) continue;
    parts = 1;
    begin = at;
  }
  return std::nullopt;
}

}  // namespace merker::project
