// The text of a merker.toml by lines, with the places that toml++ gives: lines and columns from 1,
// columns in characters.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace merker::project {

class SettingsText {
 public:
  explicit SettingsText(std::string_view text);

  std::string text() const;
  std::uint32_t lines() const { return static_cast<std::uint32_t>(lines_.size()); }
  // Without its end.
  const std::string& line(std::uint32_t number) const { return lines_[number - 1]; }
  // Blank, or nothing but a comment.
  bool isBlank(std::uint32_t number) const;
  bool isComment(std::uint32_t number) const;

  // New lines before this one; lines() + 1 for the end.
  void insert(std::uint32_t before, const std::vector<std::string>& fresh);
  void erase(std::uint32_t first, std::uint32_t behind);
  // What stands between two places, the second one not included.
  void replace(std::uint32_t line, std::uint32_t column, std::uint32_t endLine,
               std::uint32_t endColumn, std::string_view by);

 private:
  std::vector<std::string> lines_;
  std::string end_ = "\n";  // of lines: "\r\n" if the file has them
  bool lastEnds_ = true;    // the last line has one
};

}  // namespace merker::project
