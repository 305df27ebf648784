#include "step5/symbol.h"

#include "mc5/block_id.h"
#include "mc5/operand_text.h"
#include "source/symbol_text.h"
#include "step5/operand.h"

namespace merker::step5 {
namespace {

using Kind = source::SymbolAddress::Kind;
using mc5::OperandKind;
using source::Language;

std::optional<mc5::Operand> blockOf(merker::BlockId id) {
  const auto block = mc5::step5Id(id);
  if (!block) return std::nullopt;
  return mc5::Operand{.kind = OperandKind::Block, .block = block->type, .value = block->number};
}

bool hasSymbol(const mc5::Operand& operand) {
  return operand.kind == OperandKind::Memory || operand.kind == OperandKind::Block ||
         ((operand.kind == OperandKind::Timer || operand.kind == OperandKind::Counter) &&
          operand.width == mc5::Width::Word);
}

// PB is a program block in an assignment list, PY the periphery byte.
std::string textOf(const mc5::Operand& operand) {
  std::string text = mc5::operandText(operand);
  const bool byte = operand.kind == OperandKind::Memory && operand.area == mc5::Area::Peripheral &&
                    operand.width == mc5::Width::Byte;
  if (byte) text[1] = 'Y';
  return text;
}

}  // namespace

std::optional<mc5::Operand> operandOf(const source::SymbolAddress& address) {
  if (address.kind == Kind::Block) return blockOf(address.block);
  const std::string text =
      std::string(source::operandName(address, Mnemonics::German, Language::Step5)) + ' ' +
      source::operandNumber(address);
  Scanner scanner(text, 0);
  Failure ignored;
  const auto operand = parseOperand(scanner, ignored);
  return operand ? std::optional(operand->value) : std::nullopt;
}

const source::Symbol* symbolOf(const mc5::Operand& operand, const source::SymbolTable* symbols) {
  if (symbols == nullptr || !hasSymbol(operand)) return nullptr;
  const auto address = source::parseSymbolAddress(textOf(operand), {}, Language::Step5);
  return address ? symbols->findAddress(*address) : nullptr;
}

}  // namespace merker::step5
