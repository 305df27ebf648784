#include "step7/mnemonic.h"

#include <algorithm>
#include <span>

#include "base/text.h"
#include "step7/operand_words.h"

namespace merker::step7 {

using mc7::Operand;
using mc7::OperandKind;
using mc7::Operation;

// The I, D or R of ==I, >R, +D; 0 if none. It may stand apart, as in the manual's "> I", if nothing
// follows it.
static char acceptTypeLetter(Cursor& cursor) {
  const std::size_t saved = cursor.pos();
  cursor.skipBlanks();
  const bool apart = cursor.pos() != saved;
  const char c = static_cast<char>(std::toupper(static_cast<unsigned char>(cursor.peek())));
  if ((c == 'I' || c == 'D' || c == 'R') && !isWordChar(cursor.peek(1))) {
    cursor.take();
    if (!apart || cursor.atStatementEnd()) return c;
  }
  cursor.seek(saved);
  return '\0';
}

std::string readMnemonic(Cursor& cursor) {
  const char c = cursor.peek();
  if (isWordStart(c)) {
    std::string word = upper(cursor.word());
    if (word == "RND" && (cursor.peek() == '+' || cursor.peek() == '-'))
      return word + cursor.take();
    const std::size_t saved = cursor.pos();
    cursor.skipBlanks();
    static constexpr std::string_view kBrackets[] = {"U",  "UN", "O",  "ON", "X",
                                                     "XN", "A",  "AN", "MCR"};
    const bool bracket =
        std::find(std::begin(kBrackets), std::end(kBrackets), word) != std::end(kBrackets);
    if (bracket && cursor.peek() == '(') return word + cursor.take();
    if (word == "NOP" && (cursor.peek() == '0' || cursor.peek() == '1'))
      return word + ' ' + cursor.take();
    cursor.seek(saved);
    return word;
  }
  if (c == ')') {
    cursor.take();
    return cursor.acceptWord("MCR") ? ")MCR" : ")";
  }
  std::string text;
  if (c == '+' || c == '-' || c == '*' || c == '/') {
    text = cursor.take();
    if (const char letter = acceptTypeLetter(cursor)) return text + letter;
    const std::size_t saved = cursor.pos();
    const std::string word = upper(cursor.word());
    if (c == '+' && (word == "AR1" || word == "AR2")) return text + word;
    cursor.seek(saved);
    return text;
  }
  while (cursor.peek() == '=' || cursor.peek() == '<' || cursor.peek() == '>')
    text += cursor.take();
  if (text.empty()) text = cursor.take();
  if (text != "=")
    if (const char letter = acceptTypeLetter(cursor)) text += letter;
  return text;
}

bool worksWithoutOperand(Operation operation) {
  std::vector<std::uint8_t> code;
  return operation == Operation::OR || mc7::encode({operation, {}}, code);
}

bool isJump(Operation operation) {
  return operation >= Operation::SPA && operation <= Operation::LOOP;
}

namespace {

// Notations of plain bits that fill a word or a double word (S7-INSTR-12 to 17).
constexpr ConstantFormat kWordPatterns[] = {ConstantFormat::Byte,    ConstantFormat::Binary,
                                            ConstantFormat::Integer, ConstantFormat::Characters,
                                            ConstantFormat::Bytes,   ConstantFormat::Word,
                                            ConstantFormat::Counter};
constexpr ConstantFormat kDoubleWordPatterns[] = {
    ConstantFormat::LongBinary, ConstantFormat::LongInteger, ConstantFormat::LongCharacters,
    ConstantFormat::LongBytes, ConstantFormat::DWord};

// Some operations know a constant only in one notation: SLW 4, UW W#16#F0F0, + L#5, BLD 7.
enum class Notation : std::uint8_t { Count, Word, DoubleWord, Summand, Pointer, Offset };

struct FittedRow {
  Operation operation;
  Notation notation;
  std::uint32_t highest = 0;  // of a count
};
constexpr FittedRow kFitted[] = {
    {Operation::SLW, Notation::Count, 15},    {Operation::SRW, Notation::Count, 15},
    {Operation::SSI, Notation::Count, 15},    {Operation::SLD, Notation::Count, 32},
    {Operation::SRD, Notation::Count, 32},    {Operation::SSD, Notation::Count, 32},
    {Operation::RLD, Notation::Count, 32},    {Operation::RRD, Notation::Count, 32},
    {Operation::INC, Notation::Count, 255},   {Operation::DEC, Notation::Count, 255},
    {Operation::BLD, Notation::Count, 255},   {Operation::AND_W, Notation::Word},
    {Operation::OR_W, Notation::Word},        {Operation::XOR_W, Notation::Word},
    {Operation::AND_D, Notation::DoubleWord}, {Operation::OR_D, Notation::DoubleWord},
    {Operation::XOR_D, Notation::DoubleWord}, {Operation::ADD_CONSTANT, Notation::Summand},
    {Operation::LAR1, Notation::Pointer},     {Operation::LAR2, Notation::Pointer},
    {Operation::ADD_AR1, Notation::Offset},   {Operation::ADD_AR2, Notation::Offset}};

Operand countOf(const FittedRow& row, Operand operand, const Position& place, Problems& problems,
                Limits limits) {
  // INC B#16#5: these three take a byte.
  if (row.highest == 255 && operand.format == ConstantFormat::Byte)
    operand.format = ConstantFormat::Integer;
  if (limits == Limits::OfCode && operand.format == ConstantFormat::Integer)
    return mc7::number(OperandKind::ShiftCount, operand.value);
  if (operand.format != ConstantFormat::Integer || operand.value > row.highest)
    problems.add(ProblemCode::P0342, place, mc7::info(row.operation).de, row.highest);
  return mc7::number(OperandKind::ShiftCount, std::min(operand.value, row.highest));
}

Operand patternOf(std::span<const ConstantFormat> allowed, ConstantFormat format, Operand operand,
                  const Position& place, Problems& problems) {
  if (std::ranges::find(allowed, operand.format) == allowed.end())
    problems.add(ProblemCode::P0343, place, bitWidth(format));
  operand.format = format;
  return operand;
}

// S7-INSTR-71.
Operand summandOf(Operand operand, const Position& place, Problems& problems) {
  if (operand.format != ConstantFormat::Integer && operand.format != ConstantFormat::LongInteger)
    problems.add(ProblemCode::P0348, place);
  operand.format =
      bitWidth(operand.format) > 16 ? ConstantFormat::LongInteger : ConstantFormat::Integer;
  return operand;
}

Operand offsetOf(const Operand& operand, const Position& place, Problems& problems, Limits limits) {
  if (operand.format != ConstantFormat::Pointer ||
      operand.value > (limits == Limits::OfLanguage ? 0x7FFFu : 0xFFFFu))
    problems.add(ProblemCode::P0322, place);
  return mc7::number(OperandKind::Pointer, operand.value & 0xFFFF);
}

}  // namespace

Operand fittedConstant(Operation operation, Operand operand, const Position& place,
                       Problems& problems, Limits limits) {
  const auto* const row = std::ranges::find(kFitted, operation, &FittedRow::operation);
  if (row == std::end(kFitted)) return operand;
  switch (row->notation) {
    case Notation::Count:
      return countOf(*row, operand, place, problems, limits);
    case Notation::Word:
      return patternOf(kWordPatterns, ConstantFormat::Word, operand, place, problems);
    case Notation::DoubleWord:
      return patternOf(kDoubleWordPatterns, ConstantFormat::DWord, operand, place, problems);
    case Notation::Summand:
      return summandOf(operand, place, problems);
    case Notation::Pointer:  // one that cannot exist shows as DW#16#
      if (limits == Limits::OfCode) operand.format = ConstantFormat::Pointer;
      return operand;
    case Notation::Offset:
      return offsetOf(operand, place, problems, limits);
  }
  return operand;
}

namespace {

struct Votes {
  unsigned german = 0, international = 0;
  void add(std::optional<Mnemonics> which, unsigned weight) {
    if (which) (*which == Mnemonics::German ? german : international) += weight;
  }
  void add(const Votes& other) {
    german += other.german;
    international += other.international;
  }
};

// A mnemonic that exists in one setting only says which.
std::optional<Mnemonics> settingOf(const std::string& mnemonic) {
  const bool german = mc7::findOperation(mnemonic, Mnemonics::German).has_value();
  const bool international = mc7::findOperation(mnemonic, Mnemonics::International).has_value();
  if (german == international) return std::nullopt;
  return german ? Mnemonics::German : Mnemonics::International;
}

void voteOnOperand(Cursor& cursor, Votes& votes) {
  cursor.accept('%');
  cursor.skipBlanks();
  std::string_view word = cursor.word();
  const std::size_t letters = word.find_first_of("0123456789");
  if (letters != std::string_view::npos &&
      word.find_first_not_of("0123456789", letters) == std::string_view::npos)
    word = word.substr(0, letters);
  else if (cursor.skipBlanks(), !isDigit(cursor.peek()))
    return;
  std::optional<Mnemonics> which;
  findMemoryWord(word, which);
  if (equalsIgnoreCase(word, "Z")) which = Mnemonics::German;
  if (equalsIgnoreCase(word, "C")) which = Mnemonics::International;
  votes.add(which, 1);
}

// One character of a parameter list; behind := the operand that is supplied votes.
void passSupplied(Cursor& cursor, Votes& supplied) {
  if (cursor.peek() == '\'') return cursor.passText();
  if (cursor.take() != ':' || cursor.peek() != '=') return;
  cursor.take();
  voteOnOperand(cursor, supplied);
}

// The bracket of a CALL's list, behind the block's name or on the next line.
bool opensList(Cursor& cursor) {
  const std::size_t start = cursor.pos();
  cursor.skipSpace();
  if (cursor.accept('(')) return true;
  cursor.seek(start);
  return false;
}

// CALL with its list in brackets. The names in it look like operations (A, I, U), so they are no
// votes.
void passCall(Cursor& cursor, Votes& supplied) {
  while (!cursor.atStatementEnd() && cursor.peek() != '(') cursor.take();
  if (!opensList(cursor)) return;
  for (int depth = 1; depth > 0;) {
    cursor.skipSpace();
    if (cursor.atEnd() || cursor.peek() == ';') return;
    depth += cursor.peek() == '(' ? 1 : cursor.peek() == ')' ? -1 : 0;
    passSupplied(cursor, supplied);
  }
}

// "name := operand", a line of a list without brackets.
bool isParameterLine(Cursor& cursor) {
  const std::size_t start = cursor.pos();
  cursor.accept('#');
  const bool quoted = cursor.accept('"');
  cursor.word();
  if (quoted) cursor.accept('"');
  cursor.skipBlanks();
  const bool found = cursor.peek() == ':' && cursor.peek(1) == '=';
  if (!found) cursor.seek(start);
  return found;
}

struct Voter {
  Cursor cursor;
  Votes statements{}, supplied{};  // the latter count only where statements say nothing

  void statement() {
    if (isParameterLine(cursor)) {
      while (!cursor.atStatementEnd()) passSupplied(cursor, supplied);
      return;
    }
    passLabel();
    const std::string name = readMnemonic(cursor);
    statements.add(settingOf(name), 2);
    if (name == "CALL") return passCall(cursor, supplied);
    if (name == "TITLE") return cursor.skipLine();
    voteOnOperand(cursor, statements);
    while (!cursor.atStatementEnd()) cursor.take();
  }

  void passLabel() {
    const std::size_t begin = cursor.pos();
    cursor.word();
    cursor.skipBlanks();
    if (cursor.peek() != ':') return cursor.seek(begin);
    cursor.take();
    cursor.skipSpace();
  }
};

}  // namespace

Mnemonics detectMnemonics(std::string_view text, const std::vector<BlockSource>& blocks) {
  Votes statements, supplied;
  for (const BlockSource& block : blocks) {
    if (block.id.kind == BlockKind::DB || block.id.kind == BlockKind::UDT) continue;
    Voter voter{Cursor(text, block.codeBegin, block.codeEnd)};
    // A few thousand statements tell enough.
    for (int i = 0; i < 5000; ++i) {
      voter.cursor.skipSpace();
      if (voter.cursor.accept(';')) continue;
      if (voter.cursor.atEnd()) break;
      voter.statement();
    }
    statements.add(voter.statements);
    supplied.add(voter.supplied);
  }
  const Votes& votes = statements.german == statements.international ? supplied : statements;
  return votes.international > votes.german ? Mnemonics::International : Mnemonics::German;
}

}  // namespace merker::step7
