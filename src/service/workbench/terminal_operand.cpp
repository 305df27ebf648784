#include "workbench/terminal_operand.h"

#include <fmt/format.h>

#include "monitor/symbol_name.h"

namespace merker::workbench {
namespace {

// A channel of a digital module is a bit, one of an analog module a word of the periphery.
struct TerminalPlace {
  std::string text;
  address::Operand key;
};

TerminalPlace placeOf(io::Side side, std::uint32_t start, std::uint32_t channel) {
  const bool output = isOutput(side);
  if (isDigital(side))
    return {fmt::format("{} {}.{}", output ? "A" : "E", start + channel / 8, channel % 8),
            address::memory(output ? Area::Output : Area::Input, Width::Bit, 8 * start + channel)};
  const std::uint32_t byte = start + 2 * channel;
  return {fmt::format("{} {}", output ? "PAW" : "PEW", byte),
          address::memory(Area::Peripheral, Width::Word, 8 * byte)};
}

}  // namespace

TerminalOperand terminalOperand(const io::Configuration& configuration, io::Terminal terminal,
                                const source::SymbolTable& symbols) {
  const io::Module& module = configuration.modules[terminal.module];
  const bool output = isOutput(terminal.side);
  const auto start = output ? module.outputStart : module.inputStart;
  if (!start) return {};
  const TerminalPlace place = placeOf(terminal.side, *start, terminal.channel);
  const source::Symbol* symbol = monitor::findSymbol(place.key, output, symbols);
  return {place.text, symbol == nullptr ? "" : symbol->name};
}

}  // namespace merker::workbench
