#include "step7/cursor.h"

#include <algorithm>

#include "base/text.h"

namespace merker::step7 {

void Cursor::endIfStopped() {
  if (stop_.stop_requested()) pos_ = end_;
}

bool Cursor::skipBlockComment() {
  if (peek() != '(' || peek(1) != '*') return false;
  const std::size_t close = text_.find("*)", pos_ + 2);
  const bool closed = close != std::string_view::npos && close + 2 <= end_;
  if (!closed) unclosedComment_ = pos_;
  pos_ = closed ? close + 2 : end_;
  return true;
}

void Cursor::skipBlanks() {
  for (;;) {
    const char c = peek();
    if (c == ' ' || c == '\t')
      ++pos_;
    else if (!skipBlockComment())
      return;
  }
}

void Cursor::passLineComment() {
  const std::size_t begin = pos_;
  skipLine();
  // A line of equals signs is a separator.
  if (begin + 2 < end_ && text_[begin + 2] == '=' && text_[std::min(begin + 3, end_ - 1)] != '=')
    checks_.push_back({begin + 3, pos_});
}

void Cursor::skipSpace() {
  endIfStopped();
  for (;;) {
    skipBlanks();
    const char c = peek();
    if (c == '\n' || c == '\r' || c == '\f' || c == '\v')
      ++pos_;
    else if (c == '/' && peek(1) == '/')
      passLineComment();
    else
      return;
  }
}

void Cursor::skipLine() {
  while (pos_ < end_ && text_[pos_] != '\n' && text_[pos_] != '\r') ++pos_;
}

void Cursor::passText() {
  take();
  while (!atEnd() && peek() != '\n' && peek() != '\r') {
    const char c = take();
    if (c == '$' && peek() != '\n') take();
    if (c == '\'') return;
  }
}

bool Cursor::atLineEnd() {
  endIfStopped();
  skipBlanks();
  const char c = peek();
  return atEnd() || c == '\n' || c == '\r' || (c == '/' && peek(1) == '/');
}

bool Cursor::atStatementEnd() { return atLineEnd() || peek() == ';'; }

bool Cursor::accept(char c) {
  skipBlanks();
  if (peek() != c) return false;
  ++pos_;
  return true;
}

bool Cursor::peekWord(std::string_view wanted) {
  skipBlanks();
  const std::size_t saved = pos_;
  const bool same = equalsIgnoreCase(word(), wanted);
  pos_ = saved;
  return same;
}

bool Cursor::acceptWord(std::string_view wanted) {
  if (!peekWord(wanted)) return false;
  word();
  return true;
}

std::string_view Cursor::word() {
  endIfStopped();
  const std::size_t begin = pos_;
  if (isWordStart(peek()))
    while (isWordChar(peek())) ++pos_;
  return text_.substr(begin, pos_ - begin);
}

}  // namespace merker::step7
