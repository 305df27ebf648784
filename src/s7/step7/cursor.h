// Walks over source text. AWL has no fixed token set (U(, ==I, P##x, S5T#1H, DB10.DBX 0.0), so the
// parsers read characters and words as their place demands.
#pragma once

#include <cctype>
#include <cstddef>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

namespace merker::step7 {

// A //= comment that was passed on the way.
struct CheckComment {
  std::size_t begin = 0, end = 0;  // of the text behind //=
};

class Cursor {
 public:
  // For who does not want to go on the text ends at the next word.
  Cursor(std::string_view text, std::size_t begin, std::size_t end, std::stop_token stop = {})
      : text_(text), pos_(begin), end_(end), stop_(std::move(stop)) {}

  std::size_t pos() const { return pos_; }
  void seek(std::size_t pos) { pos_ = pos; }
  std::size_t end() const { return end_; }
  bool atEnd() const { return pos_ >= end_; }
  char peek(std::size_t ahead = 0) const {
    return pos_ + ahead < end_ ? text_[pos_ + ahead] : '\0';
  }
  char take() { return pos_ < end_ ? text_[pos_++] : '\0'; }
  std::string_view text() const { return text_; }
  std::string_view slice(std::size_t begin, std::size_t end) const {
    return text_.substr(begin, end - begin);
  }

  // Blanks and (* comments *) of the same line.
  void skipBlanks();
  // All white space and comments; //= comments are noted.
  void skipSpace();
  void skipLine();
  // A text in single quotation marks, $ before a quotation mark inside; the cursor stands on the
  // first one.
  void passText();
  // At the end of a statement: end of text, end of line, ';' or a comment to the end of the line.
  bool atStatementEnd();
  // The next line's first word stays; true if only white space or a comment is left on this line.
  bool atLineEnd();

  bool accept(char c);                     // after blanks
  bool acceptWord(std::string_view word);  // whole word in any case, after blanks
  bool peekWord(std::string_view word);
  // Letters, digits, underscores and bytes above 7Fh; empty if there is none here.
  std::string_view word();

  std::vector<CheckComment>& checks() { return checks_; }
  // Where a (* comment begins that has no end; all behind it belongs to it.
  std::optional<std::size_t> unclosedComment() const { return unclosedComment_; }

 private:
  void endIfStopped();
  bool skipBlockComment();
  void passLineComment();

  std::string_view text_;
  std::size_t pos_, end_;
  std::stop_token stop_;
  std::vector<CheckComment> checks_;
  std::optional<std::size_t> unclosedComment_;
};

inline bool isWordStart(char c) {
  return std::isalpha(static_cast<unsigned char>(c)) || c == '_' ||
         static_cast<unsigned char>(c) >= 0x80;
}
inline bool isDigit(char c) { return c >= '0' && c <= '9'; }
inline bool isWordChar(char c) { return isWordStart(c) || isDigit(c); }

}  // namespace merker::step7
