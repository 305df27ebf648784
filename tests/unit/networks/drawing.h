// Somebody draws a network element by element in a text.
#pragma once

#include "networks/source_edit.h"

namespace merker::networks {

// The first network of the first block, or another one, while somebody draws it.
class Drawing {
 public:
  explicit Drawing(std::string_view text, source::Language language = source::Language::Step7)
      : file_("drawing", std::string(text)), around_{language} {}
  Drawing(source::SourceFile file, const Surroundings& around)
      : file_(std::move(file)), around_(around) {}

  Drawing& at(std::string_view block, std::size_t network) {
    for (const Block& one : blocks(file_, around_))
      if (one.symbol == block || one.name == block) line_ = one.line;
    network_ = network;
    return *this;
  }

  // Behind all that is there.
  Drawing& add(const std::string& element, const std::vector<std::string>& operands) {
    return insert(last(), graph::Place::Behind, element, operands);
  }
  // As the first element of a rung of its own.
  Drawing& rung(const std::string& element, const std::vector<std::string>& operands) {
    return insert({}, graph::Place::Behind, element, operands);
  }
  // Before a pin of the box that stands last: numbers as it shows them, inputs first; 0: EN.
  Drawing& add(int pin, const std::string& contact) {
    return insert(last(pin == 0 ? graph::kEnable : graph::kFirstPin + pin - 1), graph::Place::AtPin,
                  "CONTACT", {contact});
  }
  Drawing& insert(graph::Selection at, graph::Place place, const std::string& element,
                  const std::vector<std::string>& operands) {
    return apply(graph::Action::Insert, at, operands, element, place);
  }
  Drawing& negate(int contact) { return apply(graph::Action::Negate, {contact}, {}); }
  Drawing& addInput() { return apply(graph::Action::AddInput, selected_, {}); }
  Drawing& closeBranch() { return apply(graph::Action::CloseBranch, {selected_.node}, {}); }
  // What waits for an operand: of the element that was put in last, of another contact, at a pin.
  Drawing& name(const std::string& operand) {
    return apply(graph::Action::SetOperand, selected_, {operand});
  }
  Drawing& name(int contact, const std::string& operand) {
    return apply(graph::Action::SetOperand, {contact, graph::kOwn}, {operand});
  }
  Drawing& give(int pin, const std::string& operand) {
    return apply(graph::Action::SetOperand, last(graph::kFirstPin + pin - 1), {operand});
  }

  Drawing& label(const std::string& label) {
    return take(changeLabel(file_, line_, network_, label, around_));
  }

  const source::SourceFile& file() const { return file_; }
  const std::string& refusal() const { return refusal_; }
  // "U E 0.0; = A 0.0", as the text has them; or why it was refused.
  std::string text() const {
    if (!refusal_.empty()) return refusal_;
    std::string out;
    for (const graph::Written& place : network().source.places) {
      out += out.empty() ? "" : "; ";
      if (!place.label.empty()) out += place.label + ": ";
      for (const char c : place.text)
        if ((c != ' ' && c != '\n') || out.back() != ' ') out += c == '\n' ? ' ' : c;
    }
    return out;
  }

 private:
  Network network() const {
    const auto block = blockAt(file_, line_, around_);
    return block ? block->networks[network_ - 1] : Network{};
  }
  graph::Selection last(int pin = graph::kNoPin) const {
    return {static_cast<int>(network().source.statements.size()) - 1, pin};
  }

  Drawing& apply(graph::Action action, graph::Selection at,
                 const std::vector<std::string>& operands, const std::string& element = {},
                 graph::Place place = {}) {
    graph::Edit edit{action, at, place, element, {}, {}};
    for (const std::string& operand : operands) edit.operands.emplace_back().text = operand;
    return take(networks::edit(file_, line_, network_, edit, around_));
  }
  Drawing& take(const Edited& done) {
    if (!done) {
      refusal_ = networks::text(done.error(), graph::Language::English);
      return *this;
    }
    file_ = source::SourceFile(file_.name(), applied(file_, *done));
    selected_ = done->select;
    return *this;
  }

  source::SourceFile file_;
  Surroundings around_;
  std::uint32_t line_ = 1;  // of the block
  std::size_t network_ = 1;
  graph::Selection selected_;
  std::string refusal_;
};

}  // namespace merker::networks
