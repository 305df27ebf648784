#include "workbench/shown_operands.h"

namespace merker::workbench {
namespace {

class Showing {
 public:
  explicit Showing(const NetworkDisplay& display)
      : names_{display.operands, display.symbols, display.mnemonics} {}

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
    std::string other = names_.of(text);
    if (other.empty() || other == text) return;
    written_.emplace(other, text);
    text = std::move(other);
  }

  const networks::OperandNames names_;
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
