// A table of merker.toml with the questions its readers ask: each wrong answer is one problem with
// its place.
#pragma once

#ifndef TOML_EXCEPTIONS
#define TOML_EXCEPTIONS 0
#endif
#include <toml++/toml.h>

#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/problem.h"
#include "clock/instant.h"

namespace merker::project {

class Table {
 public:
  // `title` as the user knows it: "[cpu]". `place`: of the table itself.
  Table(const toml::table& table, std::string title, Position place, Problems& problems)
      : table_(table), title_(std::move(title)), place_(std::move(place)), problems_(problems) {}

  // A problem for each key that is not among these; then it is false.
  bool allow(const std::vector<std::string_view>& keys) const;
  bool has(std::string_view key) const { return table_.contains(key); }
  const Position& place() const { return place_; }
  Position at(std::string_view key) const;  // of a value; of the table if the key is missing
  const std::string& title() const { return title_; }
  Problems& problems() const { return problems_; }
  // "'input' must be a whole number"
  void mustBe(std::string_view key, std::string_view what) const;

  // Nothing if the key is missing, or wrong, which then is a problem.
  std::optional<std::string> text(std::string_view key, std::string_view what) const;
  std::optional<bool> flag(std::string_view key) const;
  std::optional<std::int64_t> integer(std::string_view key, std::int64_t low, std::int64_t high,
                                      std::string_view unit = {}) const;
  std::optional<std::uint32_t> number(std::string_view key, std::int64_t low, std::int64_t high,
                                      std::string_view unit = {}) const;
  std::optional<double> real(std::string_view key, double low, double high) const;
  std::optional<Duration> length(std::string_view key, Duration low, Duration high) const;
  // The same in whole milliseconds.
  std::optional<std::uint32_t> milliseconds(std::string_view key, std::uint32_t low,
                                            std::uint32_t high) const;
  // The position of the word in `words`.
  std::optional<std::size_t> choice(std::string_view key,
                                    std::initializer_list<std::string_view> words) const;

  // Whole numbers with their places: [0, 1]. A single number is a list of one.
  struct Number {
    std::uint32_t value;
    Position position;
  };
  std::vector<Number> numbers(std::string_view key, std::string_view what) const;
  struct Text {
    std::string text;
    Position position;
  };
  std::optional<std::vector<Text>> texts(std::string_view key, std::string_view what) const;

  std::optional<Table> table(std::string_view key) const;  // [title.key]
  static constexpr std::size_t kMostTables = 500;  // of one kind; a station has a tenth of it
  // [[title.key]]
  std::vector<Table> tables(std::string_view key, std::size_t most = kMostTables) const;
  std::vector<std::string> keys() const;         // as written, in the order of the file
  Position placeOf(std::string_view key) const;  // of the key itself
  const toml::node* node(std::string_view key) const { return table_.get(key); }

 private:
  Position position(const toml::source_region& region, std::size_t length = 1) const;
  Position valuePosition(const toml::node& node) const;
  std::string titleOf(std::string_view key) const;

  const toml::table& table_;
  std::string title_;
  Position place_;
  Problems& problems_;
};

}  // namespace merker::project
