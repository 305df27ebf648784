#include "exporting/awl_edits.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "base/text.h"
#include "exporting/awl_operands.h"
#include "exporting/awl_statements.h"
#include "source/symbol_text.h"

namespace merker::exporting {
namespace {

// AUF DI "Motor": the word before says what it is.
bool behindDataBlockWord(std::string_view text, std::size_t begin) {
  while (begin > 0 && (text[begin - 1] == ' ' || text[begin - 1] == '\t')) --begin;
  if (begin < 2 || (begin > 2 && step7::isWordChar(text[begin - 3]))) return false;
  const std::string_view word = text.substr(begin - 2, 2);
  return equalsIgnoreCase(word, "DI") || equalsIgnoreCase(word, "DB");
}

std::string absoluteText(const source::SymbolAddress& address, Mnemonics mnemonics) {
  return fmt::format("{} {}", source::operandName(address, mnemonics),
                     source::operandNumber(address));
}

// FC 5 of CALL FC 5, also by its symbol.
std::optional<BlockId> calledBlock(const step7::BlockSource& block, const Statement& statement,
                                   const source::SymbolTable& symbols) {
  std::optional<BlockId> called;
  const auto first = [&](const Operand& operand) {
    const source::Symbol* symbol = operand.symbol.empty() ? nullptr : symbols.find(operand.symbol);
    const source::SymbolAddress* address = symbol != nullptr ? &symbol->address
                                           : operand.address ? &*operand.address
                                                             : nullptr;
    if (!called && address != nullptr && address->kind == source::SymbolAddress::Kind::Block)
      called = address->block;
  };
  eachOperand(block.file->text(), statement.operands, statement.parameters.front().begin, first);
  return called;
}

}  // namespace

std::vector<Edit> renamedParameters(const step7::BlockSource& block,
                                    const source::SymbolTable& symbols,
                                    const ParameterNames& names) {
  std::vector<Edit> edits;
  if (names.empty() || block.id.kind == BlockKind::DB || block.id.kind == BlockKind::UDT)
    return edits;
  for (const Statement& statement : statements(block)) {
    const auto called =
        statement.parameters.empty() ? std::nullopt : calledBlock(block, statement, symbols);
    const auto of = called ? names.find(*called) : names.end();
    if (of == names.end()) continue;
    for (const Statement::Name& name : statement.parameters)
      if (const auto other = of->second.find(upper(name.text)); other != of->second.end())
        edits.push_back({name.begin, name.end, other->second});
  }
  return edits;
}

std::string edited(std::string_view text, std::size_t begin, std::size_t end,
                   std::vector<Edit> edits) {
  std::stable_sort(edits.begin(), edits.end(),
                   [](const Edit& a, const Edit& b) { return a.begin < b.begin; });
  std::string out;
  for (const Edit& edit : edits) {
    out += text.substr(begin, edit.begin - begin);
    out += edit.text;
    begin = edit.end;
  }
  out += text.substr(begin, end - begin);
  return out;
}

std::vector<Edit> punctuation(const step7::BlockSource& block) {
  std::vector<Edit> edits;
  if (block.id.kind == BlockKind::UDT) return edits;
  for (const Statement& statement : statements(block))
    for (const Statement::Insertion& insertion : statement.missing)
      edits.push_back({insertion.at, insertion.at, insertion.text});
  return edits;
}

std::vector<Edit> absoluteOperands(const step7::BlockSource& block,
                                   const source::SymbolTable& symbols, Mnemonics mnemonics) {
  std::vector<Edit> edits;
  const std::string_view text = block.file->text();
  eachOperand(text, block.name.begin, block.codeEnd, [&](const Operand& operand) {
    const source::Symbol* symbol = operand.symbol.empty() ? nullptr : symbols.find(operand.symbol);
    if (symbol == nullptr || operand.member ||
        symbol->address.kind == source::SymbolAddress::Kind::VariableTable)
      return;
    edits.push_back({operand.begin, operand.end,
                     behindDataBlockWord(text, operand.begin)
                         ? source::operandNumber(symbol->address)
                         : absoluteText(symbol->address, mnemonics)});
  });
  return edits;
}

std::vector<Edit> symbolicOperands(const step7::BlockSource& block,
                                   const source::SymbolTable& symbols) {
  std::vector<Edit> edits;
  if (block.id.kind == BlockKind::DB || block.id.kind == BlockKind::UDT) return edits;
  for (const Statement& statement : statements(block)) {
    if (statement.jump) continue;  // T1 is a label there
    const auto replace = [&](const Operand& operand) {
      if (!operand.address || operand.pointer || operand.absoluteData) return;
      const source::Symbol* symbol = symbols.findAddress(*operand.address);
      if (symbol != nullptr)
        edits.push_back({operand.begin, operand.end, fmt::format("\"{}\"", symbol->name)});
    };
    eachOperand(block.file->text(), statement.operands, statement.end, replace);
  }
  return edits;
}

}  // namespace merker::exporting
