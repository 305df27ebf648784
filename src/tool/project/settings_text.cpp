#include "project/settings_text.h"

#include "base/text.h"

namespace merker::project {
namespace {

// The byte at which a column of a line begins.
std::size_t byteAt(std::string_view line, std::uint32_t column) {
  std::size_t at = 0;
  for (std::uint32_t left = column - 1; left > 0 && at < line.size(); --left) {
    ++at;
    while (at < line.size() && (static_cast<unsigned char>(line[at]) & 0xC0) == 0x80) ++at;
  }
  return at;
}

}  // namespace

SettingsText::SettingsText(std::string_view text) {
  if (text.find("\r\n") != std::string_view::npos) end_ = "\r\n";
  lastEnds_ = text.empty() || text.ends_with('\n');
  while (!text.empty()) {
    const std::size_t end = text.find('\n');
    std::string_view line = text.substr(0, end);
    if (line.ends_with('\r')) line.remove_suffix(1);
    lines_.emplace_back(line);
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  }
}

std::string SettingsText::text() const {
  std::string text;
  for (const std::string& line : lines_) text += line + end_;
  if (!lastEnds_ && !lines_.empty()) text.resize(text.size() - end_.size());
  return text;
}

bool SettingsText::isBlank(std::uint32_t number) const { return trim(line(number)).empty(); }
bool SettingsText::isComment(std::uint32_t number) const {
  return trim(line(number)).starts_with('#');
}

void SettingsText::insert(std::uint32_t before, const std::vector<std::string>& fresh) {
  if (before > lines()) lastEnds_ = true;
  lines_.insert(lines_.begin() + (before - 1), fresh.begin(), fresh.end());
}

void SettingsText::erase(std::uint32_t first, std::uint32_t behind) {
  lines_.erase(lines_.begin() + (first - 1), lines_.begin() + (behind - 1));
}

void SettingsText::replace(std::uint32_t line, std::uint32_t column, std::uint32_t endLine,
                           std::uint32_t endColumn, std::string_view by) {
  const std::string& last = lines_[endLine - 1];
  const std::string rest = last.substr(byteAt(last, endColumn));
  std::string& first = lines_[line - 1];
  first = first.substr(0, byteAt(first, column)) + std::string(by) + rest;
  erase(line + 1, endLine + 1);
}

}  // namespace merker::project
