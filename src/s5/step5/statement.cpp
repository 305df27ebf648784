#include "step5/statement.h"

#include <algorithm>
#include <array>

#include "mc5/operand_text.h"
#include "step5/operation_word.h"

namespace merker::step5 {
namespace {

using mc5::OperandKind;
using mc5::Operation;

bool isJumpWord(std::string_view word) {
  constexpr std::array<std::string_view, 8> kJumps{"SPA", "SPB", "SPZ", "SPN",
                                                   "SPP", "SPM", "SPO", "SPS"};
  return std::find(kJumps.begin(), kJumps.end(), word) != kJumps.end();
}

// The first operation of this name whose table has the operand.
std::optional<mc5::Instruction> fit(std::string_view word, const mc5::Operand& operand) {
  std::vector<std::uint16_t> code;
  for (std::size_t i = 0; i < mc5::operations().size(); ++i) {
    const mc5::OperationInfo& row = mc5::operations()[i];
    if (row.name != word && row.other != word) continue;
    const mc5::Instruction instruction{static_cast<Operation>(i), operand};
    if (mc5::encode(instruction, code)) return instruction;
  }
  return std::nullopt;
}

// Numbers too large for their field are told as such (P1112), so the operand is tried with 0.
std::optional<mc5::Instruction> fitKind(std::string_view word, mc5::Operand operand) {
  if (auto instruction = fit(word, operand)) return instruction;
  const std::uint32_t value = operand.value;
  const std::uint8_t bit = operand.bit;
  operand.value = operand.bit = 0;
  auto instruction = fit(word, operand);
  if (!instruction) return std::nullopt;
  instruction->operand.value = value;
  instruction->operand.bit = bit;
  return instruction;
}

// PB behind a block call is a program block.
mc5::Operand adjusted(std::string_view word, const Operand& written) {
  const mc5::Operand& operand = written.value;
  const bool call = (word == "SPA" || word == "SPB") && !written.symbol;
  if (call && operand.kind == OperandKind::Memory && operand.area == mc5::Area::Peripheral)
    return {.kind = OperandKind::Block, .block = mc5::BlockType::Pb, .value = operand.value};
  return operand;
}

mc5::Operand placeholder(std::string_view word) {
  if (isJumpWord(word)) return {.kind = OperandKind::Jump, .value = 1};
  return {.kind = OperandKind::Formal, .value = 1};
}

std::string hint(std::string_view word) {
  if (word == "D" || word == "I") return "; valid: a number 1 to 255";
  if (word == "U" || word == "UN" || word == "O" || word == "ON")
    return "; valid: E, A, M, D with bit, T or Z";
  if (word == "L" || word == "T") return "; valid: bytes, words, double words";
  return {};
}

// O, BE, +F, TAK …; O can also have an operand.
std::optional<Statement> withoutOperand(Scanner& scanner, const std::string& word,
                                        std::size_t offset) {
  const auto plain = fit(word, {});
  if (!plain) return std::nullopt;
  const std::size_t mark = scanner.mark();
  scanner.skipBlanks();
  const bool both = fitKind(word, {.kind = OperandKind::Timer, .width = mc5::Width::Word}) &&
                    (beginsOperand(scanner) || beginsSymbol(scanner));
  scanner.back(mark);
  if (both) return std::nullopt;
  Statement result;
  result.instruction = *plain;
  result.offset = offset;
  return result;
}

Failure doesNotFit(const std::string& word, const Operand& operand, std::string_view text) {
  const std::size_t length = std::max<std::size_t>(operand.length, 1);
  if (operand.value.kind == OperandKind::Block && operand.value.block == mc5::BlockType::Ob)
    return {ProblemCode::P1139, operand.offset, length, "", ""};
  return {ProblemCode::P1109, operand.offset, length, word, std::string(text)};
}

// "-MOTOR = MW 10": of a symbol also what it stands for.
std::string shown(const Operand& operand, std::string_view text) {
  std::string result(text);
  return operand.symbol ? result + " = " + mc5::operandText(operand.value) : result;
}

std::optional<Statement> withOperand(Scanner& scanner, const std::string& word, std::size_t offset,
                                     Failure& failure, const source::SymbolTable* symbols) {
  scanner.skipBlanks();
  // Question marks stand where an operand of KOP and FUP is not yet written.
  if (scanner.atEnd() || scanner.peek() == '!' || scanner.peek() == '?') {
    failure = {ProblemCode::P1110, offset, word.size(), word, hint(word)};
    return std::nullopt;
  }
  const std::size_t mark = scanner.mark();
  const auto operand = parseOperand(scanner, failure, symbols);
  if (!operand) return std::nullopt;
  const auto instruction =
      fitKind(word, operand->name.empty() ? adjusted(word, *operand) : placeholder(word));
  if (instruction)
    return Statement{*instruction, operand->name, offset, operand->offset, operand->length, {}};
  failure = doesNotFit(word, *operand, shown(*operand, scanner.since(mark)));
  return std::nullopt;
}

}  // namespace

void skipColon(Scanner& scanner) {
  if (scanner.peek() != ':') return;
  const char next = upper(scanner.peek(1));
  const std::size_t mark = scanner.mark();
  if (next == 'F' || next == 'G') {
    scanner.skip(2);
    const bool separate = scanner.atEnd() || isBlank(scanner.peek());
    scanner.skipBlanks();
    const char operand = upper(scanner.peek());
    const bool cell = (operand == 'T' || operand == 'Z') && next == 'F';
    scanner.back(mark);
    if (separate && !cell) return;
  }
  scanner.skip();
  scanner.skipBlanks();
}

std::optional<Statement> parseStatement(Scanner& scanner, Failure& failure,
                                        const source::SymbolTable* symbols) {
  const std::size_t offset = scanner.offset(), start = scanner.mark();
  std::optional<Failure> warning;
  const std::string word = operationWord(scanner, warning);
  if (!isOperation(word)) {
    if (word.empty()) scanner.take([](char c) { return !isBlank(c); });
    const auto text = scanner.since(start);
    failure = {ProblemCode::P1103, offset, std::max<std::size_t>(text.size(), 1), std::string(text),
               ""};
    return std::nullopt;
  }
  auto plain = withoutOperand(scanner, word, offset);
  if (plain) plain->warning = warning;
  return plain ? plain : withOperand(scanner, word, offset, failure, symbols);
}

}  // namespace merker::step5
