#include "step5/variable.h"

#include "mc5/place.h"
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

std::optional<address::Reference> parseVariable(std::string_view text,
                                                const source::SymbolTable* symbols) {
  Scanner scanner(text, 0);
  address::Reference variable;
  variable.text = text;
  scanner.skipBlanks();
  auto operand = operandAt(scanner, symbols);
  const bool inBlock = operand && isDataBlock(*operand) && scanner.accept('.');
  if (inBlock) {
    variable.db = static_cast<std::int32_t>(operand->value);
    operand = operandAt(scanner, symbols);
  }
  scanner.skipBlanks();
  if (!operand || !scanner.atEnd() || !hasValue(*operand)) return std::nullopt;
  if ((operand->area == mc5::Area::Data) != inBlock) return std::nullopt;
  variable.operand = mc5::placeOf(*operand);
  if (!isMemory(variable.operand)) variable.type = TypeCode::Word;  // what LC loads
  return variable;
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
