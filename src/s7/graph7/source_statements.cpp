#include "graph7/source_statements.h"

#include <algorithm>

#include "base/text.h"
#include "graph7/operand_kind.h"
#include "graph7/source_call.h"
#include "graph7/source_jumps.h"
#include "step7/mnemonic.h"

namespace merker::graph7 {
namespace {

using graph::Op;
using graph::SourceNetwork;
using mc7::Operation;

bool isComment(std::string_view line) {
  return line.starts_with("//") && !line.starts_with("//=") && !line.starts_with("//#");
}

// "TITLE = text"; nothing if the line is none.
std::optional<std::string_view> titleOf(std::string_view line) {
  step7::Cursor cursor(line, 0, line.size());
  if (!cursor.acceptWord("TITLE") || !cursor.accept('=')) return std::nullopt;
  return trim(line.substr(cursor.pos()));
}

class Reader {
 public:
  Reader(const step7::BlockSource& source, const SourceOperands& operands)
      : file_(*source.file),
        mnemonics_(operands.scope().mnemonics),
        operands_(operands),
        cursor_(file_.text(), source.codeBegin, source.codeEnd),
        end_(lineOf(source.codeEnd)) {
    if (source.codeEnd == file_.text().size()) ++end_;  // the word that ends it is missing
  }

  std::vector<SourceNetwork> read() {
    begin(std::min(lineOf(cursor_.pos()) + 1, end_), false);
    for (;;) {
      cursor_.skipSpace();
      cursor_.checks().clear();
      if (cursor_.atEnd()) break;
      statement();
    }
    networks_.back().end = end_;
    labels_.resolve(networks_);
    return std::move(networks_);
  }

 private:
  std::uint32_t lineOf(std::size_t offset) const { return file_.position(offset).line; }

  void begin(std::uint32_t line, bool headed) {
    SourceNetwork& network = networks_.emplace_back();
    network.line = network.code = network.end = line;
    network.headed = headed;
  }

  // What stands before the first NETWORK is a network of its own only if there is something.
  void head(std::size_t at) {
    const std::uint32_t line = lineOf(at);
    const SourceNetwork& first = networks_.front();
    const bool replaces = networks_.size() == 1 && !first.headed && first.statements.empty();
    if (replaces) networks_.clear();
    if (!networks_.empty()) networks_.back().end = line;
    begin(line, true);
    label_.clear();
    if (cursor_.atLineEnd()) heading(line + 1);
  }

  // TITLE and comment below the word NETWORK; `line`: where they would begin.
  void heading(std::uint32_t line) {
    SourceNetwork& network = networks_.back();
    std::uint32_t at = line;
    while (at < end_ && trim(file_.line(at)).empty()) ++at;
    if (const auto title = at < end_ ? titleOf(trim(file_.line(at))) : std::nullopt) {
      network.title = *title;
      line = at + 1;
    }
    for (; line < end_ && isComment(trim(file_.line(line))); ++line)
      network.comment.emplace_back(trim(file_.line(line)).substr(2));
    network.code = line;
    if (line > end_ || line > file_.lineCount()) return cursor_.seek(cursor_.end());
    const std::string_view next = file_.line(line);
    const auto offset = static_cast<std::size_t>(next.data() - file_.text().data());
    cursor_.seek(std::min(offset, cursor_.end()));
  }

  void statement() {
    if (cursor_.accept(';') || label()) return;
    const std::size_t begin = cursor_.pos();
    if (cursor_.acceptWord("NETWORK")) {
      cursor_.accept(';');
      return head(begin);
    }
    if (titleOf(cursor_.slice(begin, cursor_.end()))) return title(begin);
    cursor_.seek(begin);
    instruction(begin);
  }

  void title(std::size_t begin) {
    cursor_.seek(begin);
    cursor_.skipLine();
    SourceNetwork& network = networks_.back();
    network.title = *titleOf(cursor_.slice(begin, cursor_.pos()));
    if (network.headed || !network.statements.empty()) return;
    network.headed = true;
    network.line = lineOf(begin);
    heading(network.line + 1);
  }

  bool label() {
    const std::size_t begin = cursor_.pos();
    const std::string_view word = cursor_.word();
    cursor_.skipBlanks();
    if (word.empty() || cursor_.peek() != ':' || cursor_.peek(1) == '=') {
      cursor_.seek(begin);
      return false;
    }
    cursor_.take();
    labels_.add(word, networks_);
    if (label_.empty()) labelBegin_ = begin;
    label_ = word;
    SourceNetwork& network = networks_.back();
    if (!network.statements.empty()) return true;
    network.label = word;
    network.labelLine = lineOf(begin);
    return true;
  }

  std::optional<Operation> operationOf(const std::string& name) const {
    const auto own = mc7::findOperation(name, mnemonics_);
    return own ? own
               : mc7::findOperation(name, mnemonics_ == Mnemonics::German ? Mnemonics::International
                                                                          : Mnemonics::German);
  }

  void instruction(std::size_t begin) {
    SourceNetwork& network = networks_.back();
    network.labelLine = 0;
    graph::Statement& statement = network.statements.emplace_back();
    graph::Written& written = network.places.emplace_back();
    written.begin = written.operand = begin;
    written.start = label_.empty() ? begin : labelBegin_;
    written.label = std::exchange(label_, {});
    const std::string name = step7::readMnemonic(cursor_);
    const auto operation = operationOf(name);
    if (name == "CALL")
      call(statement);
    else if (operation)
      operate(*operation, statement, written);
    const std::size_t end = endOfStatement(operation);
    written.text = trim(cursor_.slice(begin, end));
    written.length = cursor_.pos() - begin;
    written.line = lineOf(written.start);
    written.end = lineOf(std::max(cursor_.pos(), begin + 1) - 1) + 1;
    if (network.statements.size() > 1) joinDataBlock(network);
  }

  // A block of a CPU has far fewer parameters in all its CALLs; with more of them a CALL has no
  // picture.
  void call(graph::Statement& statement) {
    constexpr std::size_t kMostArguments = 100'000;
    const bool few = arguments_ < kMostArguments;
    readCall(cursor_, operands_, few, statement);
    arguments_ += statement.arguments.size();
    if (!few) statement.op = Op::OTHER;
  }

  // Where the statement ends without its semicolon.
  std::size_t endOfStatement(std::optional<Operation> operation) {
    const bool bracket =
        operation && *operation >= Operation::AND_OPEN && *operation <= Operation::XOR_NOT_OPEN;
    if (!bracket)
      while (!cursor_.atStatementEnd()) passCharacter();
    const std::size_t end = cursor_.pos();
    if (!cursor_.accept(';')) cursor_.seek(end);
    return end;
  }

  void passCharacter() {
    const char c = cursor_.take();
    if (c == '\'' || c == '"')
      while (!cursor_.atEnd() && cursor_.peek() != '\n' && cursor_.take() != c) continue;
  }

  // AUF DB 5; L DBW 2 is what L DB5.DBW 2 is, in machine code and in pictures.
  void joinDataBlock(SourceNetwork& network) const {
    const graph::Statement& open = network.statements.end()[-2];
    graph::Statement& access = network.statements.back();
    const graph::Written second = network.places.back();
    const auto db = dataBlockOf(open);
    if (!db || second.start != second.begin || !openDataBlock(access.operand, *db)) return;
    network.statements.erase(network.statements.end() - 2);
    network.places.pop_back();
    graph::Written& first = network.places.back();
    first.text = second.text.substr(0, second.text.find_first_of(" \t")) + "  " +
                 network.statements.back().operand.text;
    first.length = second.begin + second.length - first.begin;
    first.operand = second.operand;
    first.end = second.end;
  }

  void operate(Operation operation, graph::Statement& statement, graph::Written& written) {
    statement.op = graph7::operationOf(operation);
    const bool bracket = operation >= Operation::AND_OPEN && operation <= Operation::AND_BEFORE_OR;
    if (step7::isJump(operation)) return jump(operation, statement, written);
    if (step7::worksWithoutOperand(operation)) {
      if (bracket) return;
      if (!cursor_.atStatementEnd()) return operand(operation, statement, written);
      if (operation == Operation::OR) statement.op = Op::AND_BEFORE_OR;
      return;
    }
    if (!cursor_.atLineEnd() || operandBelow()) operand(operation, statement, written);
  }

  void operand(Operation operation, graph::Statement& statement, graph::Written& written) {
    cursor_.skipBlanks();
    written.operand = cursor_.pos();
    statement.operand = operands_.read(cursor_, operation);
    if (isStatusWord(statement.operand)) statement.op = Op::OTHER;
  }

  // The operand may stand on the next line. What is no operand there is the next statement.
  bool operandBelow() {
    const std::size_t begin = cursor_.pos();
    cursor_.skipSpace();
    const std::size_t below = cursor_.pos();
    const bool found = operands_.parse(cursor_) && cursor_.atStatementEnd();
    cursor_.seek(found ? below : begin);
    return found;
  }

  // Where it leads is known behind the last network.
  void jump(Operation operation, graph::Statement& statement, graph::Written& written) {
    const std::size_t end = cursor_.pos();
    if (cursor_.atLineEnd()) cursor_.skipSpace();
    written.operand = cursor_.pos();
    std::string_view word = cursor_.word();
    if (word.empty()) word = missingLabel();
    if (!cursor_.atStatementEnd()) cursor_.seek(end);
    statement.operand.kind = graph::OperandKind::Label;
    statement.operand.text = statement.operand.code = word;
    if (operation != Operation::SPL) labels_.jump(networks_);
  }

  // Where the user has not yet written one.
  std::string_view missingLabel() {
    const std::size_t begin = cursor_.pos();
    while (cursor_.peek() == '?') cursor_.take();
    return cursor_.slice(begin, cursor_.pos());
  }

  const source::SourceFile& file_;
  Mnemonics mnemonics_;
  const SourceOperands& operands_;
  step7::Cursor cursor_;
  std::uint32_t end_;  // the line of the word that ends the block
  std::vector<SourceNetwork> networks_;
  Labels labels_;
  std::string label_;  // that waits for its statement
  std::size_t labelBegin_ = 0;
  std::size_t arguments_ = 0;  // of all CALLs
};

}  // namespace

std::vector<SourceNetwork> sourceNetworks(const step7::BlockSource& source,
                                          const SourceOperands& operands) {
  return Reader(source, operands).read();
}

}  // namespace merker::graph7
