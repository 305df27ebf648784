#include "step5/code_block.h"

#include <fmt/format.h>

#include <algorithm>

#include "mc5/constant.h"
#include "mc5/range.h"
#include "step5/actual_operand.h"
#include "step5/check_comment.h"
#include "step5/code_builder.h"
#include "step5/comment.h"
#include "step5/formal_use.h"
#include "step5/line_end.h"
#include "step5/line_start.h"
#include "step5/statement.h"
#include "step5/statement_check.h"

namespace merker::step5 {
namespace {

using mc5::BlockType;
using mc5::OperandKind;
using mc5::Operation;

constexpr std::string_view kCheck = "//=";

class CodeCompiler {
 public:
  CodeCompiler(const BlockSource& source, std::size_t firstLine, const Callable& known, bool checks,
               mc5::Block& block, Problems& problems)
      : source_(source),
        at_(firstLine),
        known_(known),
        checks_(checks),
        block_(block),
        problems_(problems),
        builder_(source, block, problems),
        check_(source, known.blocks, problems),
        words_(parameterWords(block.parameters)) {}

  void compile() {
    while (at_ < source_.lines.size() && !problems_.cancelled()) line(source_.lines[at_++]);
    if (!ended_) add(ProblemCode::P1121, source_.offset, source_.length, toString(source_.id));
    builder_.finish();
  }

 private:
  template <typename... Arguments>
  void add(ProblemCode code, std::size_t offset, std::size_t length,
           const Arguments&... arguments) {
    problems_.add(code, source_.file->position(offset, std::max<std::size_t>(length, 1)),
                  arguments...);
  }
  void add(const Failure& failure) {
    add(failure.code, failure.offset, failure.length, failure.what, failure.expected);
  }

  void line(const Line& line) {
    Scanner scanner(line.text, line.offset);
    scanner.skipBlanks();
    if (isNetworkEnd(line.text)) return builder_.endNetwork();
    if (network(scanner)) return;
    std::size_t blanks = 0;
    if (!isComment(scanner)) blanks = label(scanner);
    if (isComment(scanner) || continuesComment(scanner, blanks))
      keepComment(block_, builder_.next(), false, scanner.rest());
    else
      statement(scanner);
    check(line);
  }

  // NETZWERK 2 title, SEGMENT 2; *** ends one.
  bool network(Scanner scanner) {
    const std::string word = uppercase(scanner.take(isLetter));
    if (word != "NETZWERK" && word != "SEGMENT") return false;
    scanner.skipBlanks();
    scanner.take([](char c) { return isDigit(c) || c == ':'; });
    scanner.skipBlanks();
    if (!ended_) builder_.network(std::string(scanner.rest()));
    return true;
  }

  // "GLCH: L DW 1" and ": L DW 1"; a statement may also stand without colon. Gives the columns
  // between the colon and what follows.
  std::size_t label(Scanner& scanner) {
    skipAddress(scanner);
    if (scanner.peek() == ':') return colon(scanner);
    const std::size_t mark = scanner.mark(), offset = scanner.offset();
    const std::string name = uppercase(scanner.take(isNameCharacter));
    scanner.skipBlanks();
    if (name.empty() || !isLetter(name.front()) || scanner.peek() != ':') {
      scanner.back(mark);
      return 0;
    }
    builder_.label(name, offset);
    return colon(scanner);
  }

  static std::size_t colon(Scanner& scanner) {
    const std::size_t mark = scanner.mark();
    skipColon(scanner);
    return scanner.mark() - mark;
  }

  void statement(Scanner& scanner) {
    Failure failure;
    if (ended_) return add(ProblemCode::P1122, scanner.offset(), scanner.rest().size());
    auto parsed = parseStatement(scanner, failure, known_.symbols);
    if (!parsed) return add(failure);
    if (!commentFollows(scanner, failure)) return add(failure);
    if (parsed->warning) add(*parsed->warning);
    if (!check_.allowed(*parsed)) return;
    if (!parsed->name.empty() && !resolve(*parsed)) return;
    check_.inspect(*parsed);
    const std::string_view comment = scanner.rest();
    emit(*parsed);
    keepComment(block_, builder_.last().value_or(0), true, comment);
  }

  // A formal operand becomes its word in the list; labels wait for the end of the block.
  bool resolve(Statement& s) {
    if (s.instruction.operand.kind != OperandKind::Formal) return true;
    for (std::size_t i = 0; i < block_.parameters.size(); ++i)
      if (block_.parameters[i].name == s.name) {
        s.instruction.operand.value = words_[i];
        return fits(s, block_.parameters[i]);
      }
    add(ProblemCode::P1114, s.operandOffset, s.operandLength, s.name, source_.id.number);
    return false;
  }

  bool fits(const Statement& s, const mc5::Parameter& parameter) {
    const auto kinds = kindsInstead(s.instruction.operation, parameter);
    if (!kinds.empty())
      add(ProblemCode::P1145, s.operandOffset, s.operandLength,
          mc5::info(s.instruction.operation).name, s.name, typeText(parameter), kinds);
    return kinds.empty();
  }

  void emit(const Statement& s) {
    const bool label = !s.name.empty() && s.instruction.operand.kind == OperandKind::Jump;
    if (label)
      builder_.jump(s.instruction, s.name, s.offset, s.operandOffset);
    else
      builder_.instruction(s.instruction, s.offset);
    if (s.instruction.operation == Operation::END) ended_ = true;
    const mc5::Operand& operand = s.instruction.operand;
    if (operand.kind == OperandKind::Block && operand.block == BlockType::Fb) call(s);
  }

  // Behind SPA FB and SPB FB: a jump over the list, then a word for each parameter (S5-FB-06).
  void call(const Statement& s) {
    const auto& blocks = known_.functionBlocks;
    const auto found = blocks.find(static_cast<std::uint16_t>(s.instruction.operand.value));
    if (found == blocks.end() || found->second == nullptr) {
      if (found == blocks.end())
        add(ProblemCode::P1123, s.operandOffset, s.operandLength, s.instruction.operand.value);
      skipList();
      return;
    }
    std::vector<std::uint16_t> words;
    listed_ = builder_.next() + 1;
    nameLine(found->second);
    std::size_t read = 0;
    for (; read < found->second->parameters.size(); ++read)
      if (!parameter(s, *found->second, read, words)) break;
    if (read == found->second->parameters.size()) surplus(*found->second);
    const mc5::Operand distance{.kind = OperandKind::Jump,
                                .value = static_cast<std::uint32_t>(words.size() + 1)};
    (void)mc5::encode({Operation::JUMP, distance}, block_.words);
    for (const std::uint16_t word : words) builder_.word(word);
  }

  // The next line with contents, if it is "WORD : rest"; its scanner stands behind the colon.
  std::optional<Scanner> listLine(std::string& word, std::size_t& offset) {
    while (at_ < source_.lines.size() && !isNetworkEnd(source_.lines[at_].text)) {
      Scanner scanner(source_.lines[at_].text, source_.lines[at_].offset);
      scanner.skipBlanks();
      if (!isComment(scanner)) {
        skipAddress(scanner);
        offset = scanner.offset();
        word = uppercase(scanner.take(isNameCharacter));
        scanner.skipBlanks();
        if (word.empty() || !scanner.accept(':')) return std::nullopt;
        scanner.skipBlanks();
        return scanner;
      }
      keepComment(block_, listed_, false, scanner.rest());
      check(source_.lines[at_++]);
    }
    return std::nullopt;
  }

  // "NAME : TEST"; a programmer prints the name of the block that it found.
  void nameLine(const mc5::Block* fb) {
    std::string word;
    std::size_t offset = 0;
    auto scanner = listLine(word, offset);
    if (!scanner || word != "NAME") return;
    check(source_.lines[at_++]);
    const std::size_t start = scanner->offset();
    const std::string name(scanner->take([](char c) { return c != '!' && c != ';' && c != '/'; }));
    keepComment(block_, listed_, false, scanner->rest());
    if (fb == nullptr || letters(name).empty() || isNameOf(*fb, letters(name))) return;
    add(ProblemCode::P1150, start, name.find_last_not_of(' ') + 1, fb->id.number, fb->name,
        name.substr(0, name.find_last_not_of(' ') + 1));
  }

  // An FB without a name matches all.
  bool isNameOf(const mc5::Block& fb, const std::string& name) const {
    const auto line = known_.names.find(fb.id.number);
    const bool declared = line != known_.names.end() && letters(line->second) == name;
    return fb.name.empty() || name == letters(fb.name) || declared;
  }

  // "NCD  LESE" is the NCD-LESE of the printed listings.
  static std::string letters(const std::string& name) {
    std::string result;
    for (const char c : name)
      if (isLetter(c) || isDigit(c)) result += upper(c);
    return result;
  }

  // Lines "A2 : E 0.1" behind the last parameter are neither labels nor statements.
  void surplus(const mc5::Block& fb) {
    std::string word;
    std::size_t offset = 0;
    for (auto scanner = listLine(word, offset); scanner; scanner = listLine(word, offset)) {
      Scanner statement = *scanner;
      Failure ignored;
      const bool symbol = isSymbolMark(*scanner);
      const bool isOperand = symbol || (beginsOperand(*scanner) && parseOperand(*scanner, ignored));
      if (!isOperand || parseStatement(statement, ignored)) return;
      const std::string list = fb.parameters.empty() ? "it has none" : "it has: " + names(fb);
      add(ProblemCode::P1146, offset, word.size(), fb.id.number, word, list);
      ++at_;
    }
  }

  // Lines that look like a list of a block that is not known.
  void skipList() {
    nameLine(nullptr);
    std::string word;
    std::size_t offset = 0;
    for (auto scanner = listLine(word, offset); scanner; scanner = listLine(word, offset)) {
      Failure failure;
      if (!isSymbolMark(*scanner) && !parseOperand(*scanner, failure)) return;
      ++at_;
    }
  }

  bool parameter(const Statement& s, const mc5::Block& fb, std::size_t index,
                 std::vector<std::uint16_t>& words) {
    const mc5::Parameter& wanted = fb.parameters[index];
    std::string word;
    std::size_t offset = 0;
    auto scanner = listLine(word, offset);
    if (!scanner || !isParameter(fb, word)) {
      add(ProblemCode::P1125, s.operandOffset, s.operandLength, wanted.name, fb.id.number,
          names(fb));
      return false;
    }
    const Line& line = source_.lines[at_++];
    if (word != wanted.name)
      add(ProblemCode::P1124, offset, word.size(), fb.id.number, wanted.name,
          fmt::format(", not {}", word));
    actual(*scanner, wanted, words);
    keepComment(block_, listed_, true, scanner->rest());
    listed_ = builder_.next() + 1 + static_cast<std::uint32_t>(words.size());
    check(line);
    return true;
  }

  void actual(Scanner& scanner, const mc5::Parameter& wanted, std::vector<std::uint16_t>& words) {
    Failure failure;
    const std::size_t offset = scanner.offset();
    const std::size_t mark = scanner.mark();
    const auto operand = parseOperand(scanner, failure, known_.symbols);
    if (!operand) {
      if (scanner.atEnd() && scanner.mark() == mark)
        failure = {ProblemCode::P1104, offset, 1, "", ""};
      return add(failure);
    }
    const std::string text(scanner.since(mark));
    mc5::Range range;
    check_.constant(operand->value, offset, operand->length);
    if (outOfRange(wanted, *operand, range))
      check_.outside(operand->value, range, offset, operand->length);
    else if (!appendActual(wanted, *operand, words))
      add(ProblemCode::P1126, offset, operand->length, text, wanted.name, typeText(wanted),
          possibleOperands(wanted));
    else if (wanted.kind == mc5::ParameterKind::Block)
      withoutParameters(*operand, wanted);
    if (!commentFollows(scanner, failure)) add(failure);
  }

  // B =X calls without a list (S5-FB-14).
  void withoutParameters(const Operand& operand, const mc5::Parameter& wanted) {
    if (operand.value.block != BlockType::Fb) return;
    const auto fb = known_.functionBlocks.find(static_cast<std::uint16_t>(operand.value.value));
    const bool known = fb != known_.functionBlocks.end() && fb->second != nullptr;
    if (known && !fb->second->parameters.empty())
      add(ProblemCode::P1141, operand.offset, operand.length, fb->first, wanted.name);
  }

  static bool isParameter(const mc5::Block& fb, const std::string& word) {
    return std::any_of(fb.parameters.begin(), fb.parameters.end(),
                       [&](const mc5::Parameter& p) { return p.name == word; });
  }

  static std::string names(const mc5::Block& fb) {
    std::string list;
    for (const mc5::Parameter& p : fb.parameters)
      list += (list.empty() ? "" : ", ") + fmt::format("{} ({})", p.name, typeText(p));
    return list;
  }

  void check(const Line& line) {
    const std::size_t start = line.text.find(kCheck);
    if (!checks_ || start == std::string_view::npos) return;
    const std::size_t offset = line.offset + start;
    const auto last = builder_.last();
    if (!last) return add(ProblemCode::P1143, offset, kCheck.size());
    Scanner scanner(line.text.substr(start + kCheck.size()), offset + kCheck.size());
    auto terms = parseChecks(scanner, block_, words_, known_.symbols);
    for (const Failure& failure : terms.failures) add(failure);
    block_.checks.push_back(
        {*last, source_.file->position(offset, kCheck.size()), std::move(terms.terms)});
  }

  const BlockSource& source_;
  std::size_t at_;
  const Callable& known_;
  bool checks_;
  mc5::Block& block_;
  Problems& problems_;
  CodeBuilder builder_;
  StatementCheck check_;
  std::vector<std::uint32_t> words_;
  std::uint32_t listed_ = 0;  // where the next parameter of a call will lie
  bool ended_ = false;
};

}  // namespace

void compileCode(const BlockSource& source, std::size_t firstLine, const Callable& known,
                 bool checks, mc5::Block& block, Problems& problems) {
  CodeCompiler(source, firstLine, known, checks, block, problems).compile();
}

}  // namespace merker::step5
