#include "tags/names.h"

#include <fmt/format.h>

namespace merker::tags {
namespace {

std::string lower(std::string text) {
  for (char& c : text)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return text;
}

}  // namespace

std::string cleaned(std::string_view name, const std::function<bool(char)>& allowed) {
  std::string result;
  for (const char c : name) result += static_cast<unsigned char>(c) > 127 || allowed(c) ? c : '_';
  return result;
}

bool isWordCharacter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

std::string UniqueNames::operator()(const std::string& name) {
  std::string result = name;
  for (unsigned n = 2; !taken_.insert(lower(result)).second; ++n)
    result = fmt::format("{}_{}", name, n);
  return result;
}

}  // namespace merker::tags
