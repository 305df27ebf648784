#include "workbench/operand_name.h"

#include <fmt/format.h>

#include "mc7/operand_text.h"
#include "mc7/place.h"
#include "monitor/symbol_name.h"
#include "scenario/display.h"
#include "scenario/term.h"
#include "source/symbol_text.h"

namespace merker::workbench {
namespace {

bool isData(const address::Reference& reference) {
  return reference.operand.kind == address::OperandKind::Memory &&
         reference.operand.area == Area::DataBlock;
}

// Each language has its own words for data and periphery, and counts data in its own way.
std::string step5Text(const address::Reference& reference) {
  const auto address = monitor::symbolAddress(reference.operand, false);
  if (!address) return {};
  return fmt::format("{} {}",
                     source::operandName(*address, Mnemonics::German, source::Language::Step5),
                     source::operandNumber(*address));
}

std::string step7Text(const address::Reference& reference) {
  return mc7::operandText({reference.outputSide ? mc7::Operation::TRANSFER : mc7::Operation::LOAD,
                           mc7::operandAt(reference.operand)},
                          Mnemonics::German);
}

// A DATE_AND_TIME or STRING has no address of its own width, a local variable none at all; the
// partner of a coupling has the same operands.
std::string addressText(const address::Reference& reference, source::Language language) {
  const bool named = reference.bytes > 0 || reference.nc != 0 || reference.partner ||
                     reference.text.starts_with('#');
  if (named) return reference.text;
  const bool step5 = language == source::Language::Step5;
  const std::string text = step5 ? step5Text(reference) : step7Text(reference);
  if (text.empty()) return reference.text;
  return isData(reference) ? fmt::format("DB{}.{}", reference.db, text) : text;
}

}  // namespace

namespace {

// Of an absolute operand: what its width alone says.
std::string_view plainType(const address::Reference& reference) {
  if (reference.nc != 0) return "NC";
  if (reference.operand.kind == address::OperandKind::Timer) return "TIMER";
  if (reference.operand.kind == address::OperandKind::Counter) return "COUNTER";
  switch (reference.operand.width) {
    case Width::Bit:
      return "BOOL";
    case Width::Byte:
      return "BYTE";
    case Width::Word:
      return "WORD";
    default:
      return "DWORD";
  }
}

}  // namespace

OperandName operandName(const address::Reference& reference, const source::SymbolTable& symbols) {
  OperandName result;
  result.operand = addressText(reference, symbols.language());
  TypeCode type = simulator::isStep5Cell(reference) ? TypeCode::Void : reference.type;
  result.bits = reference.nc != 0     ? 32
                : reference.bytes > 0 ? 8 * reference.bytes
                                      : simulator::bitWidth(reference);
  const source::Symbol* symbol =
      monitor::findSymbol(reference.operand, reference.outputSide, symbols);
  if (symbol != nullptr) {
    result.symbol = symbol->name;
    result.comment = symbol->comment;
    if (type == TypeCode::Void) type = symbol->type;
  } else if (reference.text.starts_with('"')) {
    result.symbol = reference.text;
  }
  result.type = type == TypeCode::Void ? plainType(reference) : name(type);
  return result;
}

}  // namespace merker::workbench
