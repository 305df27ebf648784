// A merker.toml with its tables and the lines in which their headers stand.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/text.h"
#include "project/deep_key.h"
#include "project/readers.h"
#include "project/settings_text.h"

namespace merker::project {

// One look at the text: its tables, and in which lines their headers stand.
class SettingsView {
 public:
  // What is too deep for the library is an error like any other; take() says which.
  explicit SettingsView(const std::string& text)
      : text_(text), parsed_(toml::parse(deepKey(text) ? "=" : text)) {
    if (parsed_) collect(parsed_.table());
    std::sort(headers_.begin(), headers_.end());
  }

  bool good() const { return static_cast<bool>(parsed_); }
  const toml::parse_error& error() const { return parsed_.error(); }
  const toml::table& root() const { return parsed_.table(); }
  SettingsText& text() { return text_; }

  static std::uint32_t lineOf(const toml::table& table) { return table.source().begin.line; }
  bool hasHeader(const toml::table& table) const {
    return std::binary_search(headers_.begin(), headers_.end(), lineOf(table));
  }
  // The header behind this line, or the line behind the last one.
  std::uint32_t nextHeader(std::uint32_t line) const {
    const auto next = std::upper_bound(headers_.begin(), headers_.end(), line);
    return next == headers_.end() ? text_.lines() + 1 : *next;
  }
  // The last line of what stands directly in the table.
  std::uint32_t lastLine(std::uint32_t header) const {
    std::uint32_t line = nextHeader(header) - 1;
    while (line > header && (text_.isBlank(line) || text_.isComment(line))) --line;
    return line;
  }
  // Behind the table and those below it.
  std::uint32_t behind(const toml::table& table) const {
    std::uint32_t line = lineOf(table);
    for (const auto& [key, value] : table) {
      if (const auto* one = value.as_table(); one != nullptr && hasHeader(*one))
        line = std::max(line, lineOf(*one));
      if (const auto* list = value.as_array())
        for (const toml::node& one : *list)
          if (one.is_table() && hasHeader(*one.as_table()))
            line = std::max(line, lineOf(*one.as_table()));
    }
    return withComment(nextHeader(line));
  }
  // The first line of the comment right above a header.
  std::uint32_t withComment(std::uint32_t header) const {
    while (header > 1 && header <= text_.lines() && text_.isComment(header - 1)) --header;
    return header;
  }
  // A key of a table, which may have no header of its own where the key is there already; the value
  // as TOML, none takes it out.
  void set(const toml::table& table, std::string_view key,
           const std::optional<std::string>& value) {
    const toml::node* old = table.get(key);
    if (old == nullptr) {
      if (value) text_.insert(lastLine(lineOf(table)) + 1, {std::string(key) + " = " + *value});
      return;
    }
    const toml::source_region& region = old->source();
    if (value)
      text_.replace(region.begin.line, region.begin.column, region.end.line, region.end.column,
                    *value);
    else
      text_.erase(region.begin.line, region.end.line + 1);
  }

 private:
  void collect(const toml::table& table) {
    for (const auto& [key, value] : table) {
      if (const auto* one = value.as_table()) note(*one);
      if (const auto* list = value.as_array())
        for (const toml::node& item : *list)
          if (const auto* one = item.as_table()) note(*one);
    }
  }
  void note(const toml::table& table) {
    if (!table.is_inline() && trim(text_.line(lineOf(table))).starts_with('['))
      headers_.push_back(lineOf(table));
    collect(table);
  }

  SettingsText text_;
  toml::parse_result parsed_;
  std::vector<std::uint32_t> headers_;
};

}  // namespace merker::project
