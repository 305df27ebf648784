#include "networks/operand_names.h"

#include <fmt/format.h>

#include "source/symbol_text.h"

namespace merker::networks {
namespace {

std::string reference(const source::Symbol& symbol, source::Language language) {
  return language == source::Language::Step5 ? '-' + symbol.name : '"' + symbol.name + '"';
}

// The name in a reference; empty: it is none.
std::string_view referenced(std::string_view text, source::Language language) {
  if (text.size() < 2) return {};
  if (language == source::Language::Step5) return text[0] == '-' ? text.substr(1) : "";
  return text.front() == '"' && text.back() == '"' ? text.substr(1, text.size() - 2) : "";
}

std::string symbolOf(std::string_view text, const source::SymbolTable& symbols) {
  if (text.empty() || text.front() == '#' || !referenced(text, symbols.language()).empty())
    return {};
  const auto address = source::parseSymbolAddress(text, Position{}, symbols.language());
  const source::Symbol* symbol = address ? symbols.findAddress(*address) : nullptr;
  return symbol == nullptr ? std::string() : reference(*symbol, symbols.language());
}

std::string addressOf(std::string_view text, const source::SymbolTable& symbols,
                      Mnemonics mnemonics) {
  const std::string_view name = referenced(text, symbols.language());
  const source::Symbol* symbol = name.empty() ? nullptr : symbols.find(name);
  if (symbol == nullptr) return {};
  return fmt::format("{} {}", source::operandName(symbol->address, mnemonics, symbols.language()),
                     source::operandNumber(symbol->address));
}

}  // namespace

// A CALL names a block and its instance: "FB 1, DB 1".
std::string OperandNames::of(std::string_view operand) const {
  if (form == OperandForm::Written || symbols == nullptr) return {};
  if (const std::size_t comma = operand.find(", "); comma != operand.npos) {
    const std::string_view block = operand.substr(0, comma), instance = operand.substr(comma + 2);
    const std::string first = of(block), second = of(instance);
    if (first.empty() && second.empty()) return {};
    return fmt::format("{}, {}", first.empty() ? block : first, second.empty() ? instance : second);
  }
  return form == OperandForm::Symbolic ? symbolOf(operand, *symbols)
                                       : addressOf(operand, *symbols, mnemonics);
}

void rename(graph::Statements& statements, const OperandNames& names) {
  const auto text = [&names](std::string& operand) {
    if (std::string other = names.of(operand); !other.empty()) operand = std::move(other);
  };
  for (graph::Statement& statement : statements) {
    text(statement.operand.text);
    for (graph::Argument& argument : statement.arguments) text(argument.text);
  }
}

}  // namespace merker::networks
