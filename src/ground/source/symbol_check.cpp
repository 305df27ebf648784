// From four texts to a symbol: lengths, operand, type, uniqueness.
#include <fmt/format.h>

#include <array>
#include <span>

#include "base/text.h"
#include "source/symbol_text.h"

namespace merker::source {
namespace {

using Kind = SymbolAddress::Kind;

constexpr std::array kBitTypes{TypeCode::Bool};
constexpr std::array kByteTypes{TypeCode::Byte, TypeCode::Char};
constexpr std::array kWordTypes{TypeCode::Word, TypeCode::Int, TypeCode::S5Time, TypeCode::Date};
constexpr std::array kDWordTypes{TypeCode::DWord, TypeCode::DInt, TypeCode::Real, TypeCode::Time,
                                 TypeCode::TimeOfDay};
constexpr std::array kTimerTypes{TypeCode::Timer};
constexpr std::array kCounterTypes{TypeCode::Counter};

// S7-SYM-16. The first type is the one that a table without types means.
std::span<const TypeCode> allowedTypes(const SymbolAddress& address) {
  switch (address.kind) {
    case Kind::Timer:
      return kTimerTypes;
    case Kind::Counter:
      return kCounterTypes;
    case Kind::Block:
    case Kind::VariableTable:
      return {};
    case Kind::Memory:
      break;
  }
  switch (address.width) {
    case Width::Bit:
      return kBitTypes;
    case Width::Byte:
      return kByteTypes;
    case Width::Word:
      return kWordTypes;
    case Width::DWord:
      break;
  }
  return kDWordTypes;
}

std::string listOf(std::span<const TypeCode> types) {
  std::string text;
  for (const TypeCode type : types)
    text += fmt::format("{}{}", text.empty() ? "" : ", ", name(type));
  return text;
}

// A DB may have the type of an FB, SFB (instance) or UDT; every other block only its own.
bool isBlockType(BlockId block, BlockId type) {
  if (type == block) return true;
  return block.kind == BlockKind::DB &&
         (type.kind == BlockKind::FB || type.kind == BlockKind::SFB || type.kind == BlockKind::UDT);
}

Problem wrongType(const SymbolLine& line, const std::string& allowed) {
  return makeProblem(ProblemCode::P0806, line.at(line.type), line.type, line.address, allowed);
}

Result<Symbol> withBlockType(Symbol symbol, const SymbolLine& line, Language language) {
  symbol.type = TypeCode::Void;
  const bool isBlock = symbol.address.kind == Kind::Block;
  const bool isData = isBlock && symbol.address.block.kind == BlockKind::DB;
  const std::string allowed = typeText(symbol) + (isData ? ", FB n, SFB n, UDT n" : "");
  const auto type = parseSymbolAddress(line.type, {}, language);
  if (!type || type->kind != symbol.address.kind) return wrongType(line, allowed);
  if (!isBlock && *type != symbol.address) return wrongType(line, allowed);
  if (isBlock && !isBlockType(symbol.address.block, type->block)) return wrongType(line, allowed);
  if (isBlock && type->block != symbol.address.block) symbol.blockType = type->block;
  return symbol;
}

// TIME_OF_DAY is longer than the column of a STEP 7 export.
std::optional<TypeCode> typeOf(std::string_view text) {
  return equalsIgnoreCase(text, "TIME_OF_DA") ? TypeCode::TimeOfDay : typeFromName(text);
}

Result<Symbol> withType(Symbol symbol, const SymbolLine& line, Language language) {
  const auto allowed = allowedTypes(symbol.address);
  symbol.type = allowed.empty() ? TypeCode::Void : allowed.front();
  if (line.type.empty()) return symbol;
  if (allowed.empty()) return withBlockType(std::move(symbol), line, language);
  const auto type = typeOf(line.type);
  for (const TypeCode candidate : allowed) {
    if (type != candidate) continue;
    symbol.type = candidate;
    return symbol;
  }
  return wrongType(line, listOf(allowed));
}

void checkTexts(const SymbolLine& line, std::string_view comment, Problems& problems) {
  const std::size_t nameLength = characterCount(line.name);
  const std::size_t commentLength = characterCount(comment);
  const Position place = line.at(line.name);
  if (nameLength > kNameWidth) problems.add(ProblemCode::P0802, place, line.name, nameLength);
  if (line.name.find('"') != std::string_view::npos)
    problems.add(ProblemCode::P0809, place, line.name);
  if (commentLength > kCommentWidth)
    problems.add(ProblemCode::P0803, line.at(line.comment), line.name, commentLength);
}

std::string lineOf(const Symbol& symbol) {
  return fmt::format("{}:{}", symbol.position.file, symbol.position.line);
}

}  // namespace

void addSymbol(const SymbolLine& line, std::string comment, SymbolTable& table,
               Problems& problems) {
  if (line.name.empty())
    return problems.add(ProblemCode::P0801, line.at(line.address), line.address);
  checkTexts(line, comment, problems);
  const auto address = parseSymbolAddress(line.address, line.at(line.address), table.language());
  if (!address) return problems.add(address.error());
  Symbol symbol;
  symbol.name = line.name;
  symbol.address = *address;
  symbol.comment = std::move(comment);
  symbol.position = line.at(line.name);
  const auto typed = withType(std::move(symbol), line, table.language());
  if (!typed) return problems.add(typed.error());
  // S7-SYM-03, S7-OPEN-31: unique ignoring case. Two names for one operand are only doubtful.
  if (const Symbol* const first = table.find(line.name))
    return problems.add(ProblemCode::P0807, line.at(line.name), line.name, lineOf(*first));
  if (const Symbol* const first = table.findAddress(*address))
    problems.add(ProblemCode::P0808, line.at(line.address), line.address, first->name);
  table.add(*typed);
}

std::string typeText(const Symbol& symbol) {
  if (symbol.blockType) return toString(*symbol.blockType);
  if (symbol.type != TypeCode::Void) return std::string(name(symbol.type));
  if (symbol.address.kind == Kind::Block) return toString(symbol.address.block);
  return fmt::format("{} {}", operandName(symbol.address, Mnemonics::German),
                     operandNumber(symbol.address));
}

}  // namespace merker::source
