#include "exporting/awl_operands.h"

#include "base/text.h"
#include "step7/cursor.h"

namespace merker::exporting {
namespace {

using step7::Cursor;

bool assigned(Cursor cursor) {
  cursor.skipBlanks();
  return cursor.peek() == ':' && cursor.peek(1) == '=';
}

// DB5.DBW 2 is absolute as a whole.
bool beginsAbsoluteData(std::string_view word) {
  return word.size() >= 3 && equalsIgnoreCase(word.substr(0, 2), "DB") &&
         std::string_view("XBWDxbwd").find(word[2]) != std::string_view::npos &&
         word.find_first_not_of("0123456789", 3) == std::string_view::npos;
}

class Scanner {
 public:
  Scanner(std::string_view text, std::size_t begin, std::size_t end,
          const std::function<void(const Operand&)>& visit)
      : cursor_(text, begin, end), visit_(visit) {}

  void scan() {
    for (cursor_.skipSpace(); !cursor_.atEnd(); cursor_.skipSpace()) {
      const char c = cursor_.peek();
      if (c == '\'')
        cursor_.passText();
      else if (c == '"')
        quoted();
      else if (c == '#')
        local();
      else if (step7::isWordStart(c))
        word();
      else if (step7::isDigit(c))
        while (step7::isWordChar(cursor_.peek()) || isOneOf(cursor_.peek(), ".#")) cursor_.take();
      else
        other();
    }
  }

 private:
  static bool isOneOf(char c, std::string_view set) {
    return c != '\0' && set.find(c) != std::string_view::npos;
  }

  void other() {
    const char c = cursor_.take();
    if (c == '[') ++depth_;
    if (c == ']' && depth_ > 0) --depth_;
    // Components of a variable are names of their own.
    if (c == '.') cursor_.word();
  }

  void local() {
    cursor_.take();
    if (cursor_.peek() == '"')
      name();
    else
      cursor_.word();
  }

  // Between quotation marks.
  std::string name() {
    cursor_.take();
    const std::size_t begin = cursor_.pos();
    while (!cursor_.atEnd() && !isOneOf(cursor_.peek(), "\"\n")) cursor_.take();
    std::string name(cursor_.slice(begin, cursor_.pos()));
    cursor_.take();
    return name;
  }

  void quoted() {
    Operand operand;
    operand.begin = cursor_.pos();
    operand.symbol = name();
    finish(operand);
  }

  void word() {
    Operand operand;
    operand.begin = cursor_.pos();
    const std::string_view word = cursor_.word();
    if (cursor_.peek() == '#') return constant();
    if (equalsIgnoreCase(word, "TITLE") && isTitle()) return cursor_.skipLine();
    const std::size_t digits = word.find_first_of("0123456789");
    if (digits == std::string_view::npos) {
      const std::size_t end = cursor_.pos();
      cursor_.skipBlanks();
      if (!step7::isDigit(cursor_.peek())) return cursor_.seek(end);
      while (step7::isDigit(cursor_.peek())) cursor_.take();
    }
    if (cursor_.peek() == '.' && step7::isDigit(cursor_.peek(1))) {
      cursor_.take();
      while (step7::isDigit(cursor_.peek())) cursor_.take();
    }
    auto address = source::parseSymbolAddress(cursor_.slice(operand.begin, cursor_.pos()), {});
    if (!address) return;
    operand.address = *address;
    finish(operand);
  }

  bool isTitle() {
    cursor_.skipBlanks();
    return cursor_.peek() == '=';
  }

  // W#16#F0, P#M 10.0, DT#1998-04-14-17:53:17
  void constant() {
    while (!cursor_.atEnd() && !isOneOf(cursor_.peek(), " \t\r\n;,)]")) cursor_.take();
  }

  void finish(Operand& operand) {
    operand.end = cursor_.pos();
    operand.pointer = depth_ > 0;
    if (cursor_.peek() == '.') {
      Cursor behind = cursor_;
      behind.take();
      operand.absoluteData = beginsAbsoluteData(behind.word());
      operand.member = !operand.absoluteData;
    }
    if (!assigned(cursor_)) visit_(operand);
  }

  Cursor cursor_;
  const std::function<void(const Operand&)>& visit_;
  int depth_ = 0;
};

}  // namespace

void eachOperand(std::string_view text, std::size_t begin, std::size_t end,
                 const std::function<void(const Operand&)>& visit) {
  Scanner(text, begin, end, visit).scan();
}

}  // namespace merker::exporting
