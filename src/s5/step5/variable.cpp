#include "step5/variable.h"

#include <fmt/format.h>

#include "mc5/place.h"
#include "mc5/range.h"
#include "step5/constant_operand.h"
#include "step5/operand.h"

namespace merker::step5 {
namespace {

using mc5::OperandKind;

constexpr std::uint32_t kLastBlock = 255;

std::optional<mc5::Operand> operandAt(Scanner& scanner, const source::SymbolTable* symbols) {
  Failure failure;
  const auto operand = parseOperand(scanner, failure, symbols);
  if (!operand || !operand->name.empty()) return std::nullopt;
  return operand->value;
}

bool isDataBlock(const mc5::Operand& operand) {
  return operand.kind == OperandKind::Block && operand.block == mc5::BlockType::Db &&
         operand.value <= kLastBlock;
}

bool hasValue(const mc5::Operand& operand) {
  return operand.kind == OperandKind::Memory || operand.kind == OperandKind::Timer ||
         operand.kind == OperandKind::Counter;
}

}  // namespace

std::optional<mc5::Operand> parseConstant(std::string_view text) {
  Scanner scanner(text, 0);
  scanner.skipBlanks();
  if (!isConstant(scanner)) return std::nullopt;
  Failure failure;
  const auto constant = parseConstant(scanner, failure);
  scanner.skipBlanks();
  if (!constant || !scanner.atEnd()) return std::nullopt;
  return constant->value;
}

namespace {

struct NamedOperand {
  mc5::Operand operand;
  std::int32_t db = -1;
};

std::optional<NamedOperand> parseNamed(std::string_view text, const source::SymbolTable* symbols) {
  Scanner scanner(text, 0);
  NamedOperand named;
  scanner.skipBlanks();
  auto operand = operandAt(scanner, symbols);
  const bool inBlock = operand && isDataBlock(*operand) && scanner.accept('.');
  if (inBlock) {
    named.db = static_cast<std::int32_t>(operand->value);
    operand = operandAt(scanner, symbols);
  }
  scanner.skipBlanks();
  if (!operand || !scanner.atEnd() || !hasValue(*operand)) return std::nullopt;
  if ((operand->area == mc5::Area::Data) != inBlock) return std::nullopt;
  named.operand = *operand;
  return named;
}

}  // namespace

std::optional<address::Reference> parseVariable(std::string_view text,
                                                const source::SymbolTable* symbols) {
  const auto named = parseNamed(text, symbols);
  if (!named) return std::nullopt;
  address::Reference variable;
  variable.text = text;
  variable.db = named->db;
  variable.operand = mc5::placeOf(named->operand);
  if (!isMemory(variable.operand)) variable.type = TypeCode::Word;  // what LC loads
  return variable;
}

std::optional<Problem> checkRange(std::string_view text, const source::SymbolTable* symbols,
                                  const Position& at) {
  const auto named = parseNamed(text, symbols);
  if (!named) return std::nullopt;
  const mc5::Operand& operand = named->operand;
  const mc5::Range range = mc5::rangeOf({mc5::Operation::LOAD, operand});
  if (named->db < 0 && operand.value > range.highest)
    return makeProblem(ProblemCode::P1112, at, "number", operand.value,
                       fmt::format("{}..{}", range.lowest, range.highest));
  if (operand.bit <= range.highestBit) return std::nullopt;
  return makeProblem(ProblemCode::P1112, at, "bit", operand.bit,
                     fmt::format("0..{}", range.highestBit));
}

std::string symbolName(std::string_view text) {
  Scanner scanner(text, 0);
  scanner.skipBlanks();
  Failure failure;
  if (!isSymbolMark(scanner)) return {};
  (void)parseOperand(scanner, failure);
  return failure.what;  // no table, so it is not found
}

}  // namespace merker::step5
