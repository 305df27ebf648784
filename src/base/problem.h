// What a user is told about bad input: one code, one place, one sentence. The texts live once, in
// problems.inc; a compiler collects problems and goes on.
#pragma once

#include <fmt/format.h>

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace merker {

enum class Severity : std::uint8_t { Error, Warning };

// Rows of problems.inc; P0214 has the value 214.
enum class ProblemCode : std::uint16_t {
#define PROBLEM(code, severity, text) code,
#include "base/problems.inc"
#undef PROBLEM
};

struct ProblemInfo {
  std::string_view name;  // "P0214"
  Severity severity;
  std::string_view text;  // fmt pattern; its places are {} or {0}, never with a format
};
const ProblemInfo& info(ProblemCode code);

// Lines and columns count from 1; 0 means "the whole file". Columns count characters, not bytes.
struct Position {
  std::string file;
  std::uint32_t line = 0;
  std::uint32_t column = 0;
  std::uint32_t length = 1;
  bool operator==(const Position&) const = default;
};

struct Problem {
  ProblemCode code;
  Position position;
  std::string message;
  std::vector<std::string> arguments = {};  // in the places of the text, for other languages
  Severity severity() const { return info(code).severity; }
  std::string_view name() const { return info(code).name; }
};

Problem composeProblem(ProblemCode code, Position position, std::vector<std::string> arguments);

template <typename... Arguments>
Problem makeProblem(ProblemCode code, Position position, const Arguments&... arguments) {
  return composeProblem(code, std::move(position), {fmt::format("{}", arguments)...});
}

class Problems {
 public:
  template <typename... Arguments>
  void add(ProblemCode code, Position position, const Arguments&... arguments) {
    list_.push_back(makeProblem(code, std::move(position), arguments...));
  }
  void add(Problem problem) { list_.push_back(std::move(problem)); }
  void append(const Problems& other) {
    list_.insert(list_.end(), other.list_.begin(), other.list_.end());
  }
  bool hasErrors() const;
  bool empty() const { return list_.empty(); }
  std::size_t size() const { return list_.size(); }
  const std::vector<Problem>& list() const { return list_; }
  // By file, line, column: the order in which a reader mends them.
  void sort();

 private:
  std::vector<Problem> list_;
};

}  // namespace merker
