#include "monitor/symbol_name.h"

namespace merker::monitor {
namespace {

using Address = source::SymbolAddress;

Address memoryAddress(const address::Operand& operand, bool output) {
  Address address;
  address.kind = Address::Kind::Memory;
  address.area = operand.area;
  address.width = operand.width;
  address.address = operand.value;
  address.peripheralOutput = operand.area == Area::Peripheral && output;
  return address;
}

Address numbered(Address::Kind kind, std::uint32_t number) {
  Address address;
  address.kind = kind;
  address.number = static_cast<std::uint16_t>(number);
  return address;
}

}  // namespace

std::optional<Address> symbolAddress(const address::Operand& operand, bool output) {
  switch (operand.kind) {
    case address::OperandKind::Memory:
      return memoryAddress(operand, output);
    case address::OperandKind::Timer:
      return numbered(Address::Kind::Timer, operand.value);
    case address::OperandKind::Counter:
      return numbered(Address::Kind::Counter, operand.value);
    case address::OperandKind::None:
      break;
  }
  return std::nullopt;
}

const source::Symbol* findSymbol(const address::Operand& operand, bool output,
                                 const source::SymbolTable& symbols) {
  const auto address = symbolAddress(operand, output);
  return address ? symbols.findAddress(*address) : nullptr;
}

const source::Symbol* findSymbol(BlockId block, const source::SymbolTable& symbols) {
  Address address;
  address.kind = Address::Kind::Block;
  address.block = block;
  return symbols.findAddress(address);
}

const source::Symbol* writtenSymbol(std::string_view text, const source::SymbolTable& symbols) {
  if (text.size() > 2 && text.front() == '"' && text.back() == '"')
    return symbols.find(text.substr(1, text.size() - 2));
  const bool step5 = symbols.language() == source::Language::Step5;
  return step5 && text.starts_with('-') ? symbols.find(text.substr(1)) : nullptr;
}

}  // namespace merker::monitor
