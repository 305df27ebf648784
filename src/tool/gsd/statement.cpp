#include "gsd/statement.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>

#include "base/text.h"

namespace merker::gsd {
namespace {

constexpr std::string_view kSigns = "=(),";
// Each ends what stands before it, even in the same line.
constexpr std::array<std::string_view, 9> kEnds{
    "EndModule",         "EndPrmText",      "EndExtUserPrmData",
    "EndSlotDefinition", "EndUnitDiagType", "Unit_Diag_Area_End",
    "Data_Area_End",     "EndPrmCommand",   "End_Physical_Interface"};

class Lexer {
 public:
  Lexer(const source::SourceFile& file, std::vector<Remark>& remarks)
      : file_(file), text_(file.text()), remarks_(remarks) {}

  // The words up to the end of the next line that has any; none at the end of the file.
  std::vector<Word> line() {
    std::vector<Word> words;
    while (at_ < text_.size()) {
      const char c = text_[at_];
      if (isEnd(c)) {
        ++at_;
        if (!words.empty() && !goesOn(words)) break;
      } else if (c == ';') {
        skipComment();
      } else if (!skipBlank(c)) {
        words.push_back(word(c));
        continued_ = false;
      }
    }
    return words;
  }

 private:
  static bool isEnd(char c) { return c == '\n' || c == '\r'; }
  // Control characters, too: 1Ah ends a DOS file, and NULs stand in some.
  static bool isBlank(char c) { return static_cast<unsigned char>(c) <= ' ' || c == '\x7F'; }

  void skipComment() {
    while (at_ < text_.size() && !isEnd(text_[at_])) ++at_;
  }

  // Blanks, and a backslash with the end of the line behind it.
  bool skipBlank(char c) {
    if (c == '\\' && continues(at_)) {
      continued_ = true;
      skipComment();
      if (at_ < text_.size() && text_[at_++] == '\r' && at_ < text_.size() && text_[at_] == '\n')
        ++at_;
      return true;
    }
    if (isBlank(c)) return ++at_, true;
    return false;
  }

  // Behind the backslash there is nothing more in its line than a comment.
  bool continues(std::size_t backslash) const {
    std::size_t i = backslash + 1;
    while (i < text_.size() && !isEnd(text_[i]) && isBlank(text_[i])) ++i;
    return i >= text_.size() || isEnd(text_[i]) || text_[i] == ';';
  }

  // A list whose line ends with a comma and whose next line has more of it: the backslash was
  // forgotten.
  bool goesOn(const std::vector<Word>& words) {
    if (words.back().text != "," || words.back().kind != Word::Kind::Sign) return false;
    std::size_t i = at_;
    while (i < text_.size() && isBlank(text_[i])) ++i;
    const std::string_view next = text_.substr(i, text_.find_first_of("\r\n;", i) - i);
    if (next.empty() || next[0] < '0' || next[0] > '9') return false;
    if (continued_) return true;
    if (equalsIgnoreCase(words[0].text, "Module") && isReference(next)) return false;
    remarks_.push_back(remarkAt(file_, words.back().offset,
                                "the list goes on in the next line; this line must end with \\"));
    continued_ = true;  // said once, whatever ends the line
    return true;
  }

  // A decimal number that stands alone: the reference of a module, behind a comma too many.
  static bool isReference(std::string_view line) {
    return trim(line).find_first_not_of("0123456789") == std::string_view::npos;
  }

  Word word(char c) {
    if (c == '"') return quoted();
    const std::size_t start = at_;
    if (kSigns.find(c) != std::string_view::npos)
      return {Word::Kind::Sign, std::string(1, text_[at_++]), start};
    while (at_ < text_.size() && isPlain(text_[at_])) ++at_;
    return {Word::Kind::Plain, withDigits(std::string(text_.substr(start, at_ - start)), start),
            start};
  }

  // "0x 10" is one number: its digits are taken, too.
  std::string withDigits(std::string word, std::size_t start) {
    if (!equalsIgnoreCase(word, "0x")) return word;
    std::size_t first = at_;
    while (first < text_.size() && (text_[first] == ' ' || text_[first] == '\t')) ++first;
    std::size_t end = first;
    while (end < text_.size() && isPlain(text_[end])) ++end;
    const std::string_view digits = text_.substr(first, end - first);
    if (digits.empty() || digits.find_first_not_of("0123456789ABCDEFabcdef") != digits.npos)
      return word;
    remarks_.push_back(
        remarkAt(file_, start, fmt::format("there must be no blank in 0x{}", digits)));
    at_ = end;
    return word + std::string(digits);
  }

  bool isPlain(char c) const {
    return !isBlank(c) && c != '"' && c != ';' && kSigns.find(c) == std::string_view::npos &&
           !(c == '\\' && continues(at_));
  }

  Word quoted() {
    const std::size_t start = at_++;
    std::string text;
    for (; at_ < text_.size() && text_[at_] != '"'; ++at_) {
      if (text_[at_] == '\\' && endsLine(at_ + 1)) {
        while (at_ + 1 < text_.size() && isEnd(text_[at_ + 1])) ++at_;
        continue;
      }
      if (isEnd(text_[at_])) return unclosed(start);
      text += text_[at_];
    }
    if (at_ >= text_.size()) return unclosed(start);
    ++at_;
    return {Word::Kind::Text, std::move(text), start};
  }

  bool endsLine(std::size_t i) const { return i < text_.size() && isEnd(text_[i]); }

  // It goes up to the end of the line, but not over the bytes behind it.
  Word unclosed(std::size_t start) {
    remarks_.push_back(remarkAt(file_, start, "the text has no closing quotation mark"));
    const std::string_view rest = text_.substr(start + 1, at_ - start - 1);
    const std::size_t bytes = std::min(rest.find(" 0x"), rest.find(" 0X"));
    if (bytes != std::string_view::npos) at_ = start + 1 + bytes;
    return {Word::Kind::Text, std::string(trim(rest.substr(0, bytes))), start};
  }

  const source::SourceFile& file_;
  std::string_view text_;
  std::vector<Remark>& remarks_;
  std::size_t at_ = 0;
  bool continued_ = false;  // a backslash stands behind the last word
};

bool isSign(const std::vector<Word>& words, std::size_t i, char sign) {
  return i < words.size() && words[i].kind == Word::Kind::Sign && words[i].text[0] == sign;
}

bool isBlockEnd(const Word& word) {
  return word.kind == Word::Kind::Plain && std::ranges::any_of(kEnds, [&](std::string_view end) {
           return equalsIgnoreCase(word.text, end);
         });
}

// Keyword [(index)] [=] values
Statement statement(const std::vector<Word>& words) {
  Statement made;
  made.keyword = words[0].text;
  made.offset = words[0].offset;
  std::size_t i = 1;
  if (isSign(words, i, '(')) {
    std::string index;
    for (++i; i < words.size() && !isSign(words, i, ')'); ++i) index += words[i].text;
    made.index = std::move(index);
    i = std::min(i + 1, words.size());
  }
  if (isSign(words, i, '=')) made.assigns = true, ++i;
  made.values.assign(words.begin() + static_cast<std::ptrdiff_t>(i), words.end());
  return made;
}

}  // namespace

Remark remarkAt(const source::SourceFile& file, std::size_t offset, std::string text) {
  const Position at = file.position(std::min(offset, file.text().size()));
  return {at.line, at.column, std::move(text)};
}

std::vector<Statement> readStatements(const source::SourceFile& file,
                                      std::vector<Remark>& remarks) {
  std::vector<Statement> statements;
  Lexer lexer(file, remarks);
  for (auto words = lexer.line(); !words.empty(); words = lexer.line()) {
    for (auto rest = words.begin(); rest != words.end();) {
      const auto end = std::find_if(std::next(rest), words.end(), isBlockEnd);
      statements.push_back(statement({rest, end}));
      rest = end;
    }
  }
  return statements;
}

}  // namespace merker::gsd
