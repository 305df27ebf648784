// What a user is told about bad input: one code, one place, one sentence. The texts live once, in
// problems.inc; a compiler collects problems and goes on.
#pragma once

#include <fmt/format.h>

#include <array>
#include <cstdint>
#include <stop_token>
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

// Bytes of a text in a message: it may quote a source of a million characters.
constexpr std::size_t kLongestArgument = 1000;

Problem composeProblem(ProblemCode code, Position position, std::vector<std::string> arguments);

template <typename... Arguments>
Problem makeProblem(ProblemCode code, Position position, const Arguments&... arguments) {
  return composeProblem(code, std::move(position), {fmt::format("{}", arguments)...});
}

class Problems {
 public:
  // More than anybody reads. Of each severity the first ones are kept, the others are counted.
  static constexpr std::size_t kMostKept = 10'000;

  Problems() = default;
  // Those of work that may be cancelled from outside; who does the work looks at it often.
  explicit Problems(std::stop_token stop) : stop_(std::move(stop)) {}
  const std::stop_token& stop() const { return stop_; }
  bool cancelled() const { return stop_.stop_requested(); }

  template <typename... Arguments>
  void add(ProblemCode code, Position position, const Arguments&... arguments) {
    if (roomFor(info(code).severity))
      list_.push_back(makeProblem(code, std::move(position), arguments...));
  }
  void add(Problem problem) {
    if (roomFor(problem.severity())) list_.push_back(std::move(problem));
  }
  void append(const Problems& other);
  void remove(ProblemCode code);
  bool hasErrors() const { return count(Severity::Error) > 0; }
  bool empty() const { return size() == 0; }
  // All that were added.
  std::size_t size() const { return count(Severity::Error) + count(Severity::Warning); }
  std::size_t count(Severity severity) const { return counts_[static_cast<std::size_t>(severity)]; }
  const std::vector<Problem>& list() const { return list_; }
  // By file, line, column: the order in which a reader mends them.
  void sort();
  // The last of the list says how many were not kept, if any (P0105). It does not count.
  void tellRest(const Position& position);

 private:
  std::size_t& number(Severity severity) { return counts_[static_cast<std::size_t>(severity)]; }
  bool roomFor(Severity severity) { return ++number(severity) <= kMostKept; }
  std::size_t kept(Severity severity) const;

  std::vector<Problem> list_;
  std::array<std::size_t, 2> counts_{};  // by severity
  std::stop_token stop_;
};

}  // namespace merker
