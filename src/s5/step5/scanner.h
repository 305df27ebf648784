// Reads a piece of one line from left to right. Offsets count bytes from the beginning of the
// file, for the positions of problems.
#pragma once

#include <cctype>
#include <cstddef>
#include <string>
#include <string_view>

namespace merker::step5 {

class Scanner {
 public:
  Scanner(std::string_view text, std::size_t offset) : text_(text), offset_(offset) {}

  bool atEnd() const { return at_ >= text_.size(); }
  char peek(std::size_t ahead = 0) const {
    return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\0';
  }
  void skip(std::size_t count = 1) {
    at_ = at_ + count < text_.size() ? at_ + count : text_.size();
  }
  // Returns how many blanks there were.
  std::size_t skipBlanks() {
    const std::size_t before = at_;
    while (peek() == ' ' || peek() == '\t') ++at_;
    return at_ - before;
  }
  bool accept(char c) {
    if (peek() != c) return false;
    ++at_;
    return true;
  }
  // The longest piece whose characters satisfy the condition.
  template <typename Condition>
  std::string_view take(Condition condition) {
    const std::size_t start = at_;
    while (!atEnd() && condition(text_[at_])) ++at_;
    return text_.substr(start, at_ - start);
  }
  std::string_view rest() const { return text_.substr(at_); }
  std::size_t offset() const { return offset_ + at_; }
  std::size_t mark() const { return at_; }
  void back(std::size_t mark) { at_ = mark; }
  std::string_view since(std::size_t mark) const { return text_.substr(mark, at_ - mark); }

 private:
  std::string_view text_;
  std::size_t offset_, at_ = 0;
};

inline bool isHexDigit(char c) { return std::isxdigit(static_cast<unsigned char>(c)) != 0; }

inline bool isLetter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }
inline bool isDigit(char c) { return c >= '0' && c <= '9'; }
inline bool isBlank(char c) { return c == ' ' || c == '\t'; }
inline char upper(char c) { return static_cast<char>(std::toupper(static_cast<unsigned char>(c))); }
inline std::string uppercase(std::string_view text) {
  std::string result(text);
  for (char& c : result) c = upper(c);
  return result;
}
// Names of formal operands and labels: EIN, P-NR, DZ/A.
inline bool isNameCharacter(char c) {
  return isLetter(c) || isDigit(c) || c == '-' || c == '/' || c == '_';
}

}  // namespace merker::step5
