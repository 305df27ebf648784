#include "monitor/symbol_name.h"

namespace merker::monitor {
namespace {

using mc7::Operand;
using mc7::OperandKind;

std::optional<source::SymbolAddress> symbolAddress(const Operand& key, bool output) {
  using Kind = source::SymbolAddress::Kind;
  source::SymbolAddress address;
  address.kind = key.kind == OperandKind::Timer     ? Kind::Timer
                 : key.kind == OperandKind::Counter ? Kind::Counter
                 : key.kind == OperandKind::Block   ? Kind::Block
                                                    : Kind::Memory;
  if (address.kind == Kind::Memory) {
    if (key.area == Area::DataBlock) return std::nullopt;
    address.area = key.area;
    address.width = key.width;
    address.address = key.value;
    address.peripheralOutput = key.area == Area::Peripheral && output;
  } else if (address.kind == Kind::Block) {
    address.block = {key.blockKind, static_cast<std::uint16_t>(key.value)};
  } else {
    address.number = static_cast<std::uint16_t>(key.value);
  }
  return address;
}

}  // namespace

const source::Symbol* findSymbol(const Operand& operand, bool output,
                                 const source::SymbolTable& symbols) {
  const auto address = symbolAddress(operand, output);
  return address ? symbols.findAddress(*address) : nullptr;
}

}  // namespace merker::monitor
