// What an import tells its user: rows of one table, in the order in which they happened.
#pragma once

#include <fmt/format.h>

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "archive/tree.h"
#include "base/problem.h"
#include "s7p/fault.h"

namespace merker::importing {

enum class Note : std::uint8_t {
#define NOTE(id, effect, text) id,
#include "importing/notes.inc"
#undef NOTE
};

// Information; what came in another form; what did not come.
// Beside: a file of another kind, which is no part of a program and no loss.
enum class Effect : std::uint8_t { Info, Changed, Lost, Beside };

class Report {
 public:
  template <typename... Arguments>
  void add(Note note, const Arguments&... arguments) {
    addText(note, {fmt::format("{}", arguments)...});
  }
  // The last line quotes it: a program in another language has the sentence in its own.
  void quotes(const Problem& problem) {
    if (!lines_.empty()) lines_.back().problem = problem;
  }
  void add(const s7p::Fault& fault);
  void add(const archive::Refused& refused);

  struct Line {
    Effect effect;
    std::string text;
    std::string file{};                // that the line says to have come
    std::optional<Problem> problem{};  // whose sentence it quotes
  };
  // Lines for a file or a terminal: what is lost stands behind what came.
  std::string text() const;
  const std::vector<Line>& lines() const { return lines_; }
  std::size_t count(Effect effect) const;
  // Something did not come that an import is for: a letter beside it is named and no loss.
  bool lost() const { return lost_; }

 private:
  void addText(Note note, const std::vector<std::string>& arguments);
  std::vector<Line> lines_;
  std::array<std::size_t, 4> counts_{};
  bool lost_ = false;
};

// Sentences about what nobody can read in a tree.
std::vector<std::string> reasons(const archive::Tree& tree);

}  // namespace merker::importing
