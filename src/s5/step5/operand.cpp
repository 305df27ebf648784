#include "step5/operand.h"

#include <algorithm>
#include <array>
#include <charconv>

#include "mc5/constant.h"
#include "step5/constant_operand.h"
#include "step5/symbol.h"

namespace merker::step5 {
namespace {

using mc5::Area;
using mc5::BlockType;
using mc5::OperandKind;
using mc5::Width;

struct Word {
  std::string_view name;
  mc5::Operand operand;
  bool bit;  // has a bit address
};

constexpr mc5::Operand memory(Area area, Width width) {
  return {.kind = OperandKind::Memory, .area = area, .width = width};
}
constexpr mc5::Operand cell(OperandKind kind) { return {.kind = kind, .width = Width::Word}; }
constexpr mc5::Operand block(BlockType type) { return {.kind = OperandKind::Block, .block = type}; }

// PB is the periphery byte behind L and T, the program block behind SPA and SPB: the operation
// decides (statement.cpp).
constexpr std::array kWords{Word{"E", memory(Area::Input, Width::Bit), true},
                            Word{"EB", memory(Area::Input, Width::Byte), false},
                            Word{"EW", memory(Area::Input, Width::Word), false},
                            Word{"ED", memory(Area::Input, Width::Double), false},
                            Word{"A", memory(Area::Output, Width::Bit), true},
                            Word{"AB", memory(Area::Output, Width::Byte), false},
                            Word{"AW", memory(Area::Output, Width::Word), false},
                            Word{"AD", memory(Area::Output, Width::Double), false},
                            Word{"M", memory(Area::Flag, Width::Bit), true},
                            Word{"MB", memory(Area::Flag, Width::Byte), false},
                            Word{"MW", memory(Area::Flag, Width::Word), false},
                            Word{"MD", memory(Area::Flag, Width::Double), false},
                            Word{"D", memory(Area::Data, Width::Bit), true},
                            Word{"DL", memory(Area::Data, Width::Left), false},
                            Word{"DR", memory(Area::Data, Width::Right), false},
                            Word{"DW", memory(Area::Data, Width::Word), false},
                            Word{"DD", memory(Area::Data, Width::Double), false},
                            Word{"PB", memory(Area::Peripheral, Width::Byte), false},
                            Word{"PY", memory(Area::Peripheral, Width::Byte), false},
                            Word{"PW", memory(Area::Peripheral, Width::Word), false},
                            Word{"T", cell(OperandKind::Timer), false},
                            Word{"Z", cell(OperandKind::Counter), false},
                            Word{"OB", block(BlockType::Ob), false},
                            Word{"SB", block(BlockType::Sb), false},
                            Word{"FB", block(BlockType::Fb), false},
                            Word{"DB", block(BlockType::Db), false}};

std::optional<std::uint32_t> number(Scanner& scanner) {
  const std::string_view digits = scanner.take(isDigit);
  std::uint32_t value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (digits.empty() || error != std::errc{} || end == digits.data()) return std::nullopt;
  return value;
}

// "=1AB"
std::optional<Operand> noName(Scanner& scanner, std::size_t start, std::size_t offset,
                              Failure& failure) {
  scanner.take(isNameCharacter);
  const std::string text(scanner.since(start));
  failure = {ProblemCode::P1147, offset, text.size(), text, ""};
  return std::nullopt;
}

// "=EIN", "=M001"; a number stands for itself: "=+4" as distance, "=1" as index.
std::optional<Operand> formal(Scanner& scanner, Failure& failure) {
  Operand result;
  scanner.skipBlanks();
  result.offset = scanner.offset();
  const std::size_t start = scanner.mark();
  const bool sign = scanner.peek() == '+' || scanner.peek() == '-';
  if (sign || isDigit(scanner.peek())) {
    const bool negative = scanner.peek() == '-';
    if (sign) scanner.skip();
    const auto value = number(scanner);
    if (!value) {
      failure = {ProblemCode::P1105, result.offset, 1, "=", ""};
      return std::nullopt;
    }
    if (isNameCharacter(scanner.peek())) return noName(scanner, start, result.offset, failure);
    result.value = {.kind = sign ? OperandKind::Jump : OperandKind::Formal,
                    .value = negative ? 0 - *value : *value};
    return result;
  }
  result.name = uppercase(scanner.take(isNameCharacter));
  result.length = result.name.size();
  if (result.name.empty()) failure = {ProblemCode::P1105, result.offset, 1, "=", ""};
  return result.name.empty() ? std::nullopt : std::optional(result);
}

// Letters of any alphabet and digits: START, ÖLPUMPE, 1S3.
bool beginsName(char c) {
  return isLetter(c) || isDigit(c) || static_cast<unsigned char>(c) >= 0x80;
}

constexpr std::string_view kNameEnds = " \t!;,";

// A name up to a blank or the mark of a comment.
std::string_view bareName(Scanner& scanner) {
  const std::size_t start = scanner.mark();
  while (!scanner.atEnd() && kNameEnds.find(scanner.peek()) == std::string_view::npos &&
         !scanner.rest().starts_with("//"))
    scanner.skip();
  return scanner.since(start);
}

std::string_view quotedName(Scanner& scanner) {
  const std::string_view name = scanner.take([](char c) { return c != '"'; });
  scanner.accept('"');
  return name;
}

// The symbol of this name; of "DATEN.DW", where there is no such one, that of a block DATEN. The
// scanner then stands in front of the point.
const source::Symbol* find(std::string_view name, Scanner& scanner, std::size_t start,
                           const source::SymbolTable* symbols) {
  if (symbols == nullptr) return nullptr;
  const source::Symbol* const found = symbols->find(name);
  const std::size_t point = name.rfind('.');
  if (found != nullptr || point == std::string_view::npos) return found;
  const source::Symbol* const block = symbols->find(name.substr(0, point));
  if (block == nullptr || block->address.kind != source::SymbolAddress::Kind::Block) return nullptr;
  scanner.back(start + point);
  return block;
}

// -START, "START": a name of the assignment list.
std::optional<Operand> symbol(Scanner& scanner, std::size_t offset, Failure& failure,
                              const source::SymbolTable* symbols) {
  const std::size_t start = scanner.mark();
  const bool quoted = scanner.peek() == '"';
  scanner.skip();
  if (!quoted) scanner.skipBlanks();
  const std::size_t begin = scanner.mark();
  const std::string_view name = quoted ? quotedName(scanner) : bareName(scanner);
  Operand result;
  result.offset = offset;
  result.length = scanner.since(start).size();
  result.symbol = true;
  const source::Symbol* const found = find(name, scanner, begin, symbols);
  const auto value = found == nullptr ? std::nullopt : operandOf(found->address);
  failure = {ProblemCode::P0303, offset, result.length, std::string(name), ""};
  if (!value) return std::nullopt;
  result.value = *value;
  return result;
}

// Number and bit behind the word of an area.
bool address(Scanner& scanner, const Word& word, Operand& result, Failure& failure) {
  const auto value = number(scanner);
  if (!value) {
    failure = {ProblemCode::P1106, scanner.offset(), 1, std::string(word.name), ""};
    return false;
  }
  result.value.value = *value;
  const bool cellBit =
      word.operand.kind == OperandKind::Timer || word.operand.kind == OperandKind::Counter;
  if (scanner.peek() == '.' && isDigit(scanner.peek(1)) && (word.bit || cellBit)) {
    scanner.skip();
    result.value.bit = static_cast<std::uint8_t>(std::min<std::uint32_t>(*number(scanner), 255));
    result.value.width = Width::Bit;
    return true;
  }
  if (!word.bit) return true;
  failure = {ProblemCode::P1107, scanner.offset(), 1, std::string(word.name), ""};
  return false;
}

}  // namespace

std::string symbolText(std::string_view name) {
  const bool plain = !name.empty() && beginsName(name.front()) &&
                     name.find_first_of(kNameEnds) == std::string_view::npos &&
                     name.find("//") == std::string_view::npos;
  return plain ? '-' + std::string(name) : '"' + std::string(name) + '"';
}

bool isSymbolMark(Scanner scanner) {
  if (!scanner.accept('-') && !scanner.accept('"')) return false;
  scanner.skipBlanks();
  return beginsName(scanner.peek());
}

bool beginsSymbol(const Scanner& scanner) {
  return scanner.peek() == '-' && beginsName(scanner.peek(1));
}

bool beginsOperand(Scanner scanner) {
  if (scanner.peek() == '=') return true;
  if (isConstant(scanner)) return !isLetter(scanner.peek(2));
  const std::string_view word = scanner.take(isLetter);
  const std::string capital = uppercase(word);
  const bool known = std::any_of(kWords.begin(), kWords.end(),
                                 [&](const Word& row) { return row.name == capital; });
  scanner.skipBlanks();
  return known && (capital == word || isDigit(scanner.peek()));
}

std::optional<Operand> parseOperand(Scanner& scanner, Failure& failure,
                                    const source::SymbolTable* symbols) {
  if (scanner.accept('=')) return formal(scanner, failure);
  Operand result;
  result.offset = scanner.offset();
  const std::size_t start = scanner.mark();
  if (isDigit(scanner.peek())) {
    result.value = {.kind = OperandKind::Count, .value = number(scanner).value_or(0xFFFFFFFF)};
    result.length = scanner.since(start).size();
    return result;
  }
  if (isConstant(scanner)) return parseConstant(scanner, failure);
  const std::string word = uppercase(scanner.take(isLetter));
  for (const Word& row : kWords) {
    if (row.name != word) continue;
    result.value = row.operand;
    scanner.skipBlanks();
    if (!address(scanner, row, result, failure)) return std::nullopt;
    result.length = scanner.since(start).size();
    return result;
  }
  if (word.empty() && isSymbolMark(scanner))
    return symbol(scanner, result.offset, failure, symbols);
  failure = {ProblemCode::P1104, result.offset, std::max<std::size_t>(word.size(), 1), word, ""};
  return std::nullopt;
}

}  // namespace merker::step5
