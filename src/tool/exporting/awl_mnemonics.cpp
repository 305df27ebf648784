#include "exporting/awl_mnemonics.h"

#include "base/text.h"
#include "exporting/awl_statements.h"
#include "step7/mnemonic.h"
#include "step7/operand_words.h"

namespace merker::exporting {
namespace {

std::string_view of(std::string_view german, std::string_view international, Mnemonics mnemonics) {
  return mnemonics == Mnemonics::German ? german : international;
}

// EW -> IW, Z -> C, BIE -> BR; empty for what is the same in both.
std::string_view otherWord(std::string_view word, bool numbered, Mnemonics to) {
  std::optional<Mnemonics> which;
  if (numbered) {
    if (const step7::MemoryWord* row = step7::findMemoryWord(word, which))
      return of(row->de, row->en, to);
    return equalsIgnoreCase(word, "Z") || equalsIgnoreCase(word, "C") ? of("Z", "C", to) : "";
  }
  return equalsIgnoreCase(word, "BIE") || equalsIgnoreCase(word, "BR") ? of("BIE", "BR", to) : "";
}

class Translator {
 public:
  Translator(const step7::BlockSource& block, Mnemonics to)
      : text_(block.file->text()), from_(block.mnemonics), to_(to) {}

  void statement(const Statement& statement) {
    mnemonic(statement);
    if (statement.jump) return;  // a label
    step7::Cursor cursor(text_, statement.operands, statement.end);
    for (cursor.skipSpace(); !cursor.atEnd(); cursor.skipSpace()) {
      const char c = cursor.peek();
      if (c == '\'')
        cursor.passText();
      else if (step7::isWordStart(c))
        word(cursor);
      else if (other(cursor) == '"')
        while (!cursor.atEnd() && cursor.take() != '"') continue;
    }
  }

  std::vector<Edit> edits;

 private:
  void mnemonic(const Statement& statement) {
    step7::Cursor cursor(text_, statement.begin, statement.end);
    const std::string name = step7::readMnemonic(cursor);
    const auto operation = mc7::findOperation(name, from_);
    if (!operation) return;
    const std::string_view wanted = of(mc7::info(*operation).de, mc7::info(*operation).en, to_);
    if (wanted != name) edits.push_back({statement.begin, cursor.pos(), std::string(wanted)});
  }

  // Names of variables: #speed, .speed, and digits with what belongs to them.
  char other(step7::Cursor& cursor) {
    const char c = cursor.take();
    if (c == '#' || c == '.') cursor.word();
    if (step7::isDigit(c))
      while (step7::isWordChar(cursor.peek()) || cursor.peek() == '#') cursor.take();
    return c;
  }

  void word(step7::Cursor& cursor) {
    const std::size_t begin = cursor.pos();
    const std::string_view whole = cursor.word();
    if (cursor.peek() == '#') return constant(cursor, whole);
    const std::string_view letters = whole.substr(0, whole.find_first_of("0123456789"));
    step7::Cursor next = cursor;
    next.skipBlanks();
    const bool numbered =
        letters.size() < whole.size() || step7::isDigit(next.peek()) || next.peek() == '[';
    const std::string_view wanted = otherWord(letters, numbered, to_);
    if (!wanted.empty() && !equalsIgnoreCase(wanted, letters))
      edits.push_back({begin, begin + letters.size(), std::string(wanted)});
  }

  // Of constants only a pointer has an operand in it: P#E 1.0.
  static void constant(step7::Cursor& cursor, std::string_view prefix) {
    cursor.take();
    if (equalsIgnoreCase(prefix, "P") && cursor.peek() != '#') return;
    while (step7::isWordChar(cursor.peek()) || cursor.peek() == '#') cursor.take();
  }

  std::string_view text_;
  Mnemonics from_, to_;
};

}  // namespace

std::vector<Edit> translation(const step7::BlockSource& block, Mnemonics to) {
  const bool code = block.id.kind != BlockKind::DB && block.id.kind != BlockKind::UDT;
  if (!code || block.mnemonics == to) return {};
  Translator translator(block, to);
  for (const Statement& statement : statements(block)) translator.statement(statement);
  return std::move(translator.edits);
}

}  // namespace merker::exporting
