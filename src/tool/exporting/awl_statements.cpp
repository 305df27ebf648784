#include "exporting/awl_statements.h"

#include <optional>

#include "base/text.h"
#include "step7/cursor.h"
#include "step7/mnemonic.h"

namespace merker::exporting {
namespace {

using step7::Cursor;

class StatementReader {
 public:
  explicit StatementReader(const step7::BlockSource& block)
      : block_(block),
        data_(block.id.kind == BlockKind::DB),
        cursor_(block.file->text(), block.codeBegin, block.codeEnd) {}

  std::vector<Statement> read() {
    for (cursor_.skipSpace(); !cursor_.atEnd(); cursor_.skipSpace())
      if (data_)
        plain();
      else if (!cursor_.accept(';') && !label() && !header())
        instruction();
    return std::move(list_);
  }

 private:
  bool label() {
    const std::size_t begin = cursor_.pos();
    const bool word = !cursor_.word().empty();
    cursor_.skipBlanks();
    if (word && cursor_.peek() == ':' && cursor_.peek(1) != '=') {
      cursor_.take();
      return true;
    }
    cursor_.seek(begin);
    return false;
  }

  bool header() {
    const std::size_t begin = cursor_.pos();
    const std::string_view word = cursor_.word();
    if (equalsIgnoreCase(word, "NETWORK")) return true;
    cursor_.skipBlanks();
    if (equalsIgnoreCase(word, "TITLE") && cursor_.peek() == '=') {
      cursor_.skipLine();
      return true;
    }
    cursor_.seek(begin);
    return false;
  }

  void instruction() {
    first_ = cursor_.pos();
    const std::string name = step7::readMnemonic(cursor_);
    if (cursor_.pos() == first_) cursor_.take();
    if (name == "CALL") return call();
    if (name.ends_with('(')) {  // U( O E 0.0 may stand on one line
      begin();
      return finish(cursor_.pos());
    }
    const auto operation = mc7::findOperation(name, block_.mnemonics);
    const bool jump = operation && step7::isJump(*operation);
    if (jump && cursor_.atLineEnd()) jumpLabel();
    plain();
    list_.back().jump = jump;
  }

  // The label may stand alone on the next line.
  void jumpLabel() {
    const std::size_t end = cursor_.pos();
    cursor_.skipSpace();
    if (cursor_.word().empty() || !cursor_.atStatementEnd()) cursor_.seek(end);
  }

  void begin() {
    list_.emplace_back();
    list_.back().begin = first_;
    list_.back().operands = cursor_.pos();
  }

  void missing(std::size_t at, std::string text) {
    list_.back().missing.push_back({at, std::move(text)});
  }

  // `last` is behind the last character that belongs to the statement.
  void finish(std::size_t last) {
    list_.back().end = last;
    if (!cursor_.accept(';')) missing(last, ";");
  }

  void plain() {
    begin();
    finish(pass({}));
  }

  // Up to the end of the statement or one of these characters outside of brackets; behind what.
  std::size_t pass(std::string_view stops) {
    std::size_t last = cursor_.pos();
    for (int depth = 0; !cursor_.atStatementEnd();) {
      const char c = cursor_.peek();
      if (depth == 0 && stops.find(c) != std::string_view::npos) break;
      depth += c == '(' || c == '[' ? 1 : c == ')' || c == ']' ? -1 : 0;
      if (c == '\'')
        cursor_.passText();
      else if (c == '"')
        quoted();
      else
        cursor_.take();
      last = cursor_.pos();
    }
    return last;
  }

  void quoted() {
    cursor_.take();
    while (!cursor_.atEnd() && cursor_.peek() != '\n' && cursor_.take() != '"') continue;
  }

  // At "name :=", also #name and "name".
  std::optional<Statement::Name> parameterName() const {
    Cursor next = cursor_;
    next.skipSpace();
    next.accept('#');
    Statement::Name name;
    name.begin = next.pos();
    const bool mark = next.accept('"');
    name.text = next.word();
    if (mark) next.accept('"');
    name.end = next.pos();
    next.skipBlanks();
    const bool assigned = next.peek() == ':' && next.peek(1) == '=';
    return name.text.empty() || !assigned ? std::nullopt : std::optional(std::move(name));
  }
  bool atParameter() const { return parameterName().has_value(); }

  bool acceptBracket() {
    Cursor next = cursor_;
    next.skipSpace();
    if (next.peek() != '(') return false;
    cursor_ = next;
    cursor_.take();
    return true;
  }

  void call() {
    begin();
    std::size_t last = pass("(");
    const bool bracket = acceptBracket();
    if (!bracket && (!cursor_.atLineEnd() || !atParameter())) return finish(last);
    if (!bracket) missing(last, " (");
    const std::size_t end = parameters(bracket);
    if (!bracket) missing(end, ")");
    finish(end);
  }

  std::size_t parameters(bool bracket) {
    std::size_t last = cursor_.pos();
    for (bool comma = true;;) {
      const std::size_t end = cursor_.pos();
      cursor_.skipSpace();
      if (bracket && cursor_.accept(')')) return cursor_.pos();
      if (cursor_.peek() == ',') {
        cursor_.take();
        comma = true;
      } else if (!atParameter() && (!bracket || cursor_.atEnd() || cursor_.peek() == ';')) {
        if (cursor_.peek() != ';') cursor_.seek(end);
        return last;
      } else {
        if (!comma) missing(last, ",");
        comma = false;
        if (auto name = parameterName()) list_.back().parameters.push_back(std::move(*name));
        last = pass(bracket ? ",)" : ",");
      }
    }
  }

  const step7::BlockSource& block_;
  bool data_;
  Cursor cursor_;
  std::size_t first_ = 0;  // of the instruction
  std::vector<Statement> list_;
};

}  // namespace

std::vector<Statement> statements(const step7::BlockSource& block) {
  return StatementReader(block).read();
}

}  // namespace merker::exporting
