#include "step5/data_block.h"

#include <algorithm>
#include <charconv>

#include "mc5/constant.h"
#include "step5/comment.h"
#include "step5/constant_operand.h"
#include "step5/line_end.h"

namespace merker::step5 {
namespace {

using mc5::Format;

constexpr std::size_t kWords = 2048;  // S5-DB-01

bool beginsComment(const Scanner& scanner) {
  const char c = scanner.peek();
  return scanner.atEnd() || c == '!' || c == ';' || c == '*' ||
         (c == '/' && scanner.peek(1) == '/');
}

class DataCompiler {
 public:
  DataCompiler(const BlockSource& source, mc5::Block& block, Problems& problems)
      : source_(source), block_(block), problems_(problems) {}

  void compile() {
    for (const Line& text : source_.lines) line(text);
    if (block_.words.size() <= kWords) return;
    problems_.add(ProblemCode::P1133, at(source_.offset, source_.length));
  }

 private:
  void line(const Line& line) {
    Scanner scanner(line.text, line.offset);
    scanner.skipBlanks();
    if (beginsComment(scanner)) return keepComment(block_, next(), false, scanner.rest());
    if (endsBlock(scanner) || closes(scanner)) return;
    number(scanner);
    const std::size_t offset = scanner.offset();
    if (value(scanner)) return;
    problems_.add(ProblemCode::P1131, at(line.offset, line.text.size()));
    append(faulty(), at(offset, 1));
  }

  // A printed listing may close the block with BE.
  static bool endsBlock(Scanner scanner) {
    scanner.accept(':');
    scanner.skipBlanks();
    return upper(scanner.peek()) == 'B' && upper(scanner.peek(1)) == 'E' &&
           !isLetter(scanner.peek(2));
  }

  // "12:" behind the last word of a print: the word that would come next.
  bool closes(Scanner scanner) const {
    const std::string_view digits = scanner.take(isDigit);
    std::size_t number = 0;
    std::from_chars(digits.data(), digits.data() + digits.size(), number);
    scanner.skipBlanks();
    const bool colon = scanner.accept(':');
    scanner.skipBlanks();
    return !digits.empty() && number == block_.words.size() && colon && scanner.atEnd();
  }

  std::uint32_t next() const { return static_cast<std::uint32_t>(block_.words.size()); }

  // "DW 3", "3:" before the value: must be the next word (S5-DB-02).
  void number(Scanner& scanner) {
    const std::size_t mark = scanner.mark();
    if (upper(scanner.peek()) == 'D' && upper(scanner.peek(1)) == 'W') {
      scanner.skip(2);
      scanner.skipBlanks();
    }
    const std::size_t offset = scanner.offset();
    const std::string_view digits = scanner.take(isDigit);
    if (digits.empty()) return scanner.back(mark);
    std::size_t wanted = 0;
    std::from_chars(digits.data(), digits.data() + digits.size(), wanted);
    if (wanted != block_.words.size())
      problems_.add(ProblemCode::P1132, at(offset, digits.size()), block_.words.size());
    scanner.skipBlanks();
    scanner.accept(':');
    scanner.skipBlanks();
  }

  bool value(Scanner& scanner) {
    if (upper(scanner.peek()) == 'K' && upper(scanner.peek(1)) == 'S') return characters(scanner);
    if (!isConstant(scanner)) return false;
    // "KH = 1F00": the listing writes an equals sign, a statement none.
    const std::size_t offset = scanner.offset();
    const bool pair = upper(scanner.peek(1)) == 'G';
    Failure failure;
    auto operand = parseConstant(scanner, failure, true);
    if (!operand || !commentFollows(scanner, failure))
      problems_.add(failure.code, at(failure.offset, failure.length), failure.what,
                    failure.expected);
    keepComment(block_, next(), true, scanner.rest());
    append(operand ? *operand : faulty(pair), at(offset, 1));
    return true;
  }

  // Takes the place of a faulty word, so that the next one has its number.
  static Operand faulty(bool pair = false) {
    Operand operand;
    operand.value.format = pair ? Format::Float : Format::Hex;
    return operand;
  }

  void append(const Operand& operand, const Position& place) {
    block_.lines.push_back(
        {static_cast<std::uint32_t>(block_.words.size()), place.line, place.column});
    if (operand.value.format == Format::Float) {
      block_.words.push_back(static_cast<std::uint16_t>(operand.value.value >> 16));
      block_.formats.push_back(Format::Float);
    }
    block_.words.push_back(static_cast<std::uint16_t>(operand.value.value));
    block_.formats.push_back(operand.value.format);
  }

  // KS: a text, two characters a word, filled up with a blank.
  bool characters(Scanner& scanner) {
    const std::size_t offset = scanner.offset();
    scanner.skip(2);
    scanner.skipBlanks();
    scanner.accept('=');
    scanner.skipBlanks();
    auto text = scanner.peek() == '\'' ? quoted(scanner) : unquoted(scanner);
    if (!text) return false;
    if (std::any_of(text->begin(), text->end(), [](char c) { return c < ' ' || c > '~'; }))
      problems_.add(ProblemCode::P1108, at(offset, 2), "KS", "ASCII characters, TEXT or 'TEXT'");
    if (text->size() % 2 != 0) *text += ' ';
    keepComment(block_, next(), true, scanner.rest());
    const bool quotable = text->find('\'') == std::string::npos;  // as a print shows it
    if (!text->empty() && quotable)
      block_.texts[next()] = static_cast<std::uint32_t>(text->size() / 2);
    const Position place = at(offset, 1);
    for (std::size_t i = 0; i < text->size(); i += 2) pair(text->substr(i, 2), place);
    return true;
  }

  static std::optional<std::string> quoted(Scanner& scanner) {
    scanner.skip();
    std::string text(scanner.take([](char c) { return c != '\''; }));
    return scanner.accept('\'') ? std::optional(text) : std::nullopt;
  }

  static std::optional<std::string> unquoted(Scanner& scanner) {
    std::string text(scanner.take([](char c) { return c != ';' && c != '!'; }));
    while (!text.empty() && isBlank(text.back())) text.pop_back();
    return text;
  }

  void pair(const std::string& text, const Position& place) {
    Operand operand;
    operand.value.format = Format::Characters;
    operand.value.value = mc5::constantBits(Format::Characters, text).value_or(0);
    append(operand, place);
  }

  Position at(std::size_t offset, std::size_t length) const {
    return source_.file->position(offset, std::max<std::size_t>(length, 1));
  }

  const BlockSource& source_;
  mc5::Block& block_;
  Problems& problems_;
};

}  // namespace

void compileData(const BlockSource& source, mc5::Block& block, Problems& problems) {
  DataCompiler(source, block, problems).compile();
}

}  // namespace merker::step5
