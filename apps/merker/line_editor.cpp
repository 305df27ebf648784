#include "line_editor.h"

#include <editline/readline.h>
#include <unistd.h>

#include <cstdlib>
#include <cstring>
#include <iostream>

namespace merker::app {
namespace {

// The library asks with a plain function, so the words need a home: the one editor of the process.
std::vector<std::string>& words() {
  static std::vector<std::string> list;
  return list;
}

// The next word that begins with `text`; the library frees it.
char* nextWord(const char* text, int state) {
  static std::size_t at = 0;
  if (state == 0) at = 0;
  while (at < words().size()) {
    const std::string& word = words()[at++];
    if (word.compare(0, std::strlen(text), text) == 0) return strdup(word.c_str());
  }
  return nullptr;
}

char** complete(const char* text, int start, int) {
  return start == 0 ? rl_completion_matches(text, nextWord) : nullptr;
}

}  // namespace

LineEditor::LineEditor(std::vector<std::string> list)
    : terminal_(isatty(STDIN_FILENO) != 0 && isatty(STDOUT_FILENO) != 0) {
  if (!terminal_) return;
  words() = std::move(list);
  rl_readline_name = const_cast<char*>("merker");
  rl_attempted_completion_function = complete;
  using_history();
}

std::optional<std::string> LineEditor::read(const std::string& prompt) {
  std::string line;
  if (!terminal_) {
    if (!std::getline(std::cin, line)) return std::nullopt;
    return line;
  }
  std::cout << std::flush;
  char* typed = readline(prompt.c_str());
  if (typed == nullptr) return std::nullopt;
  line = typed;
  std::free(typed);
  if (!line.empty()) add_history(line.c_str());
  return line;
}

}  // namespace merker::app
