#include "graph5/source_statements.h"

#include <fmt/format.h>

#include "base/text.h"
#include "graph/missing.h"
#include "graph5/operand_code.h"
#include "mc5/operand_text.h"
#include "step5/declaration.h"
#include "step5/line_end.h"
#include "step5/line_start.h"
#include "step5/operation_word.h"
#include "step5/statement.h"

namespace merker::graph5 {
namespace {

using graph::SourceNetwork;
using step5::Scanner;

constexpr std::uint32_t kNetworkEndNumber = 255;  // BLD 255 (S5-MISC-04)

bool isMark(const Scanner& scanner) {
  const char c = scanner.peek();
  return scanner.atEnd() || c == '!' || c == ';' || (c == '/' && scanner.peek(1) == '/');
}

// What cannot be resolved: up to the comment.
graph::Operand unresolved(Scanner& scanner) {
  const std::size_t begin = scanner.mark();
  while (!isMark(scanner)) scanner.skip();
  const std::string_view text = trim(scanner.since(begin));
  if (text.starts_with(graph::kMissingBegin)) return graph::missing(text);
  graph::Operand operand;
  if (text.empty()) return operand;
  operand.kind = graph::OperandKind::Number;
  operand.text = text;
  for (const char c : text)
    if (c != ' ' && c != '\t') operand.code += step5::upper(c);
  return operand;
}

std::optional<mc5::Operation> operationNamed(std::string_view word) {
  for (std::size_t i = 0; i < mc5::operations().size(); ++i)
    if (mc5::operations()[i].name == word || mc5::operations()[i].other == word)
      return static_cast<mc5::Operation>(i);
  return std::nullopt;
}

class Reader {
 public:
  Reader(const step5::BlockSource& source, const source::SymbolTable* symbols)
      : source_(source), file_(*source.file), symbols_(symbols) {}

  std::vector<SourceNetwork> read() {
    at_ = firstLine();
    begin(at_ < source_.lines.size() ? lineOf(source_.lines[at_].offset) : end(), false);
    while (at_ < source_.lines.size()) line(source_.lines[at_++]);
    networks_.back().end = end();
    std::vector<graph::Statement>& last = networks_.back().statements;
    if (ended_ && !last.empty()) {
      networks_.back().end = networks_.back().places.back().line;
      last.pop_back();
      networks_.back().places.pop_back();
    }
    return std::move(networks_);
  }

 private:
  std::uint32_t lineOf(std::size_t offset) const { return file_.position(offset).line; }
  std::uint32_t end() const {
    const std::size_t last = source_.lines.empty() ? source_.offset : source_.lines.back().offset;
    return lineOf(last) + 1;
  }

  // Behind the declaration; the head of a network at its end belongs to the code.
  std::size_t firstLine() const {
    if (source_.id.type != mc5::BlockType::Fb) return 0;
    Problems ignored;
    std::size_t first = step5::readDeclaration(source_, ignored).lines;
    for (std::size_t i = first; i > 0; --i) {
      Scanner scanner(source_.lines[i - 1].text, 0);
      scanner.skipBlanks();
      std::string ignoredTitle;
      if (head(scanner, ignoredTitle)) return i - 1;
      if (!step5::isComment(scanner)) break;
    }
    return first;
  }

  void begin(std::uint32_t line, bool headed) {
    if (!networks_.empty()) networks_.back().end = line;
    SourceNetwork& network = networks_.emplace_back();
    network.line = network.code = network.end = line;
    network.headed = headed;
    ends_ = false;
  }

  // NETZWERK 2 title, SEGMENT 2.
  static bool head(Scanner scanner, std::string& title) {
    const std::string word = step5::uppercase(scanner.take(step5::isLetter));
    if (word != "NETZWERK" && word != "SEGMENT") return false;
    scanner.skipBlanks();
    scanner.take([](char c) { return step5::isDigit(c) || c == ':'; });
    title = trim(scanner.rest());
    return true;
  }

  void line(const step5::Line& line) {
    Scanner scanner(line.text, line.offset);
    scanner.skipBlanks();
    if (step5::isNetworkEnd(line.text)) return endNetwork(line);
    if (std::string title; head(scanner, title)) return network(line, std::move(title));
    graph::Written written;
    written.start = scanner.offset();
    std::size_t blanks = 0;
    if (!step5::isComment(scanner)) blanks = label(scanner, written);
    if (step5::isComment(scanner) || step5::continuesComment(scanner, blanks)) return;
    if (ends_) begin(lineOf(line.offset), false);
    statement(scanner, std::move(written));
  }

  void endNetwork(const step5::Line& line) {
    ends_ = ends_ || !networks_.back().statements.empty();
    networks_.back().end = lineOf(line.offset) + 1;
  }

  // The first head replaces the network that is there without one.
  void network(const step5::Line& line, std::string title) {
    const std::uint32_t number = lineOf(line.offset);
    const bool replaces =
        networks_.size() == 1 && !networks_.front().headed && networks_.front().statements.empty();
    if (replaces) networks_.clear();
    begin(number, true);
    networks_.back().title = std::move(title);
    networks_.back().code = number + 1;
    comment();
  }

  void comment() {
    for (; at_ < source_.lines.size(); ++at_, ++networks_.back().code) {
      Scanner scanner(source_.lines[at_].text, 0);
      scanner.skipBlanks();
      if (scanner.atEnd() || !isMark(scanner) || scanner.rest().starts_with("//=")) return;
      scanner.skip(scanner.peek() == '/' ? 2 : 1);
      networks_.back().comment.emplace_back(scanner.rest());
    }
  }

  // "GLCH: L DW 1" and ": L DW 1"; gives the columns between the colon and what follows.
  static std::size_t label(Scanner& scanner, graph::Written& written) {
    step5::skipAddress(scanner);
    if (scanner.peek() == ':') return colon(scanner);
    const std::size_t mark = scanner.mark();
    const std::string name = step5::uppercase(scanner.take(step5::isNameCharacter));
    scanner.skipBlanks();
    if (name.empty() || !step5::isLetter(name.front()) || scanner.peek() != ':') {
      scanner.back(mark);
      return 0;
    }
    written.label = name;
    return colon(scanner);
  }

  static std::size_t colon(Scanner& scanner) {
    const std::size_t mark = scanner.mark();
    step5::skipColon(scanner);
    return scanner.mark() - mark;
  }

  void statement(Scanner& scanner, graph::Written written) {
    const std::size_t start = scanner.mark();
    written.begin = written.operand = scanner.offset();
    graph::Statement statement;
    step5::Failure failure;
    auto parsed = step5::parseStatement(scanner, failure, symbols_);
    const std::string_view own = trim(scanner.since(start));
    if (parsed && !step5::commentFollows(scanner, failure)) parsed.reset();
    if (parsed) {
      resolved(*parsed, statement, written);
    } else {
      scanner.back(start);
      unknown(scanner, statement, written);
    }
    written.text = parsed ? own : trim(scanner.since(start));
    written.length = written.text.size();
    written.line = lineOf(written.start);
    written.end = written.line + 1;
    const bool separator =
        statement.op == graph::Op::BLD && statement.operand.number == kNetworkEndNumber;
    if (separator) return endNetwork({{}, written.begin});
    networks_.back().statements.push_back(std::move(statement));
    networks_.back().places.push_back(std::move(written));
    ended_ = parsed && parsed->instruction.operation == mc5::Operation::END;
    if (parsed && callsFunctionBlock(*parsed)) passList();
  }

  void resolved(const step5::Statement& parsed, graph::Statement& statement,
                graph::Written& written) const {
    statement.op = operationOf(parsed.instruction.operation);
    statement.operand = operandOf(parsed.instruction.operand);
    if (parsed.operandLength == 0) return;
    written.operand = parsed.operandOffset;
    statement.operand.text = trim(file_.text().substr(parsed.operandOffset, parsed.operandLength));
  }

  static void unknown(Scanner& scanner, graph::Statement& statement, graph::Written& written) {
    std::optional<step5::Failure> ignored;
    const std::string word = step5::operationWord(scanner, ignored);
    if (const auto operation = operationNamed(word)) statement.op = operationOf(*operation);
    scanner.skipBlanks();
    written.operand = scanner.offset();
    statement.operand = unresolved(scanner);
  }

  static bool callsFunctionBlock(const step5::Statement& statement) {
    const mc5::Operand& operand = statement.instruction.operand;
    return operand.kind == mc5::OperandKind::Block && operand.block == mc5::BlockType::Fb;
  }

  // "NAME : TEST", "ZAHL : KF +25" behind a call (S5-FB-06).
  void passList() {
    for (; at_ < source_.lines.size(); ++at_) {
      Scanner scanner(source_.lines[at_].text, source_.lines[at_].offset);
      scanner.skipBlanks();
      if (step5::isNetworkEnd(source_.lines[at_].text)) return;
      if (step5::isComment(scanner)) continue;
      step5::skipAddress(scanner);
      const std::string word = step5::uppercase(scanner.take(step5::isNameCharacter));
      scanner.skipBlanks();
      if (word.empty() || !scanner.accept(':')) return;
      scanner.skipBlanks();
      step5::Failure ignored;
      if (word != "NAME" && !step5::isSymbolMark(scanner) && !step5::parseOperand(scanner, ignored))
        return;
      networks_.back().places.back().end = lineOf(source_.lines[at_].offset) + 1;
    }
  }

  const step5::BlockSource& source_;
  const source::SourceFile& file_;
  const source::SymbolTable* symbols_;
  std::size_t at_ = 0;
  std::vector<SourceNetwork> networks_;
  bool ends_ = false;   // *** was there: the next statement begins a network
  bool ended_ = false;  // BE was the last statement
};

}  // namespace

std::vector<SourceNetwork> sourceNetworks(const step5::BlockSource& source,
                                          const source::SymbolTable* symbols) {
  return Reader(source, symbols).read();
}

std::optional<graph::Operand> sourceBlock(std::string_view text,
                                          const source::SymbolTable* symbols) {
  const std::string call = "SPA " + std::string(text);
  Scanner scanner(call, 0);
  step5::Failure ignored;
  const auto statement = step5::parseStatement(scanner, ignored, symbols);
  if (!statement || !trim(scanner.rest()).empty()) return std::nullopt;
  graph::Operand out = operandOf(statement->instruction.operand);
  out.text = text;
  return out;
}

std::optional<graph::Operand> sourceOperand(std::string_view text,
                                            const source::SymbolTable* symbols) {
  Scanner scanner(text, 0);
  scanner.skipBlanks();
  const std::size_t begin = scanner.mark();
  step5::Failure ignored;
  const auto operand = step5::parseOperand(scanner, ignored, symbols);
  if (operand && operand->name.empty() && trim(scanner.rest()).empty()) {
    graph::Operand out = operandOf(operand->value);
    out.text = operand->symbol ? std::string(trim(scanner.since(begin)))
                               : mc5::operandText(operand->value);
    return out;
  }
  scanner.back(begin);
  if (symbols != nullptr && symbols->find(trim(text)) != nullptr)
    return sourceOperand(fmt::format("-{}", trim(text)), symbols);
  graph::Operand unknown = unresolved(scanner);
  return scanner.atEnd() ? std::optional(std::move(unknown)) : std::nullopt;
}

}  // namespace merker::graph5
