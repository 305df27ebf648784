#include "step5/data_block.h"

#include <algorithm>
#include <charconv>

#include "step5/constant_operand.h"

namespace merker::step5 {
namespace {

using mc5::Format;

constexpr std::size_t kWords = 2048;  // S5-DB-01

bool isComment(const Scanner& scanner) {
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
    if (isComment(scanner) || endsBlock(scanner)) return;
    number(scanner);
    if (!value(scanner)) problems_.add(ProblemCode::P1131, at(line.offset, line.text.size()));
  }

  // A printed listing may close the block with BE.
  static bool endsBlock(Scanner scanner) {
    scanner.accept(':');
    scanner.skipBlanks();
    return upper(scanner.peek()) == 'B' && upper(scanner.peek(1)) == 'E' &&
           !isLetter(scanner.peek(2));
  }

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
    std::string text(scanner.rest());
    const std::size_t equals = text.find('=');
    if (equals != std::string::npos && equals < 5) text[equals] = ' ';
    if (text.rfind("  ", 2) == 2) text.erase(2, text.find_first_not_of(' ', 2) - 3);
    Scanner constant(text, offset);
    Failure failure;
    const auto operand = parseConstant(constant, failure);
    if (!operand) {
      problems_.add(failure.code, at(failure.offset, failure.length), failure.what,
                    failure.expected);
      return true;
    }
    append(*operand, offset);
    return true;
  }

  void append(const Operand& operand, std::size_t offset) {
    const Position place = at(offset, 1);
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
    scanner.skip(2);
    scanner.skipBlanks();
    scanner.accept('=');
    scanner.skipBlanks();
    std::string text(scanner.rest());
    if (text.starts_with('\'')) {
      const std::size_t end = text.find('\'', 1);
      if (end == std::string::npos) return false;
      text = text.substr(1, end - 1);
    } else {
      text = text.substr(0, text.find_first_of(";!"));
      while (!text.empty() && isBlank(text.back())) text.pop_back();
    }
    if (text.size() % 2 != 0) text += ' ';
    for (std::size_t i = 0; i < text.size(); i += 2) {
      const auto high = static_cast<std::uint8_t>(text[i]);
      const auto low = static_cast<std::uint8_t>(text[i + 1]);
      block_.words.push_back(static_cast<std::uint16_t>(high << 8 | low));
      block_.formats.push_back(Format::Characters);
    }
    return true;
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
