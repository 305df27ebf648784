// Lines that a user types: with editing and history on a terminal, as they come from a pipe.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace merker::app {

class LineEditor {
 public:
  // `words` are what the tabulator key completes at the beginning of a line.
  explicit LineEditor(std::vector<std::string> words);
  bool onTerminal() const { return terminal_; }
  // Without its end; nothing at the end of the input.
  std::optional<std::string> read(const std::string& prompt);

 private:
  bool terminal_;
};

}  // namespace merker::app
