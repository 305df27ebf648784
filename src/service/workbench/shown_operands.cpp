#include "workbench/shown_operands.h"

#include <fmt/format.h>

#include "source/symbol_text.h"

namespace merker::workbench {
namespace {

class Showing {
 public:
  explicit Showing(const NetworkDisplay& display) : display_(display) {}

  void rung(graph::Rung& rung) {
    for (graph::Node& node : rung.logic) this->node(node);
    for (graph::Coil& coil : rung.coils) {
      text(coil.operand.text);
      for (graph::Operand& value : coil.values) text(value.text);
    }
  }
  WrittenOperands written() { return std::move(written_); }

 private:
  void node(graph::Node& node) {
    text(node.operand.text);
    text(node.memory.text);
    for (graph::Node& child : node.children) this->node(child);
    for (graph::Node& enable : node.enable) this->node(enable);
    for (auto* pins : {&node.pins, &node.parameters})
      for (graph::Pin& pin : *pins) {
        for (graph::Node& logic : pin.logic) this->node(logic);
        text(pin.operand.text);
      }
    for (graph::Argument& argument : node.arguments) text(argument.text);
  }

  void text(std::string& text) {
    std::string other =
        display_.operands == OperandDisplay::Symbolic ? symbolOf(text) : addressOf(text);
    if (other.empty() || other == text) return;
    written_.emplace(other, text);
    text = std::move(other);
  }

  std::string symbolOf(std::string_view text) const {
    if (text.empty() || text.front() == '"' || text.front() == '#') return {};
    const auto address = source::parseSymbolAddress(text, nowhere(), display_.symbols->language());
    const source::Symbol* symbol = address ? display_.symbols->findAddress(*address) : nullptr;
    return symbol == nullptr ? std::string() : '"' + symbol->name + '"';
  }

  std::string addressOf(std::string_view text) const {
    if (text.size() < 2 || text.front() != '"' || text.back() != '"') return {};
    const source::Symbol* symbol = display_.symbols->find(text.substr(1, text.size() - 2));
    return symbol == nullptr ? std::string()
                             : fmt::format("{} {}",
                                           source::operandName(symbol->address, display_.mnemonics,
                                                               display_.symbols->language()),
                                           source::operandNumber(symbol->address));
  }

  const NetworkDisplay& display_;
  WrittenOperands written_;
};

}  // namespace

WrittenOperands showOperands(graph::Network& network, const NetworkDisplay& display) {
  if (display.operands == OperandDisplay::Written || display.symbols == nullptr) return {};
  Showing showing(display);
  for (graph::Rung& rung : network.rungs) showing.rung(rung);
  return showing.written();
}

}  // namespace merker::workbench
