// The fields of a request, typed: each wrong or missing one is a problem.
#pragma once

#include <initializer_list>
#include <optional>
#include <string>
#include <vector>

#include "workbench/json.h"

namespace merker::workbench {

class Fields {
 public:
  // `path` stands before the names in problems: "items[3].".
  Fields(const Json& object, Problems& problems, std::string path = {})
      : object_(object), problems_(problems), path_(std::move(path)) {}

  bool good() const { return !problems_.hasErrors(); }
  void add(const Problem& problem) const { problems_.add(problem); }
  Problems problems() const { return problems_; }
  std::string path(std::string_view key) const { return path_ + std::string(key); }

  // A field that is null is missing. Without `otherwise` that is a problem.
  bool has(std::string_view key) const { return find(key) != nullptr; }
  std::string text(std::string_view key, std::optional<std::string> otherwise = {}) const;
  // What names something or is typed: longer ones are wrong.
  static constexpr std::size_t kLongestName = 400, kLongestValue = 2000;
  std::string name(std::string_view key, std::size_t most = kLongestName) const;
  bool flag(std::string_view key, std::optional<bool> otherwise = {}) const;
  std::int64_t integer(std::string_view key, std::int64_t low, std::int64_t high,
                       std::optional<std::int64_t> otherwise = {}) const;
  double number(std::string_view key, double low, double high,
                std::optional<double> otherwise = {}) const;
  // A text, a number, true, false or a list of these, as TOML has it.
  std::string literal(std::string_view key) const;
  // The position of the word.
  std::size_t choice(std::string_view key, std::initializer_list<std::string_view> words,
                     std::optional<std::size_t> otherwise = {}) const;
  Fields object(std::string_view key) const;
  // At most `most` of them.
  std::vector<Fields> objects(std::string_view key, std::size_t most) const;
  std::vector<std::string> texts(std::string_view key, std::size_t most) const;
  std::vector<std::int64_t> integers(std::string_view key, std::int64_t low, std::int64_t high,
                                     std::size_t most) const;

 private:
  const Json* find(std::string_view key) const;
  void wrong(std::string_view key, std::string_view expected) const;
  const Json* list(std::string_view key, std::size_t most, std::string_view expected) const;

  const Json& object_;
  Problems& problems_;
  std::string path_;
};

}  // namespace merker::workbench
