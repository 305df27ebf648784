#include "graph/sentence.h"

#include <fmt/format.h>

namespace merker::graph {
namespace {

struct Words {
  std::string_view conjunction, disjunction, exclusive, negation, rising, falling, opposite;
};
constexpr Words kGerman{" und ",
                        " oder ",
                        " exklusiv oder ",
                        "nicht ",
                        "steigende Flanke von {}",
                        "fallende Flanke von {}",
                        "nicht ({})"};
constexpr Words kEnglish{
    " and ",   " or ", " exclusive or ", "not ", "rising edge of {}", "falling edge of {}",
    "not ({})"};

class Speaker {
 public:
  explicit Speaker(Language language)
      : german_(language == Language::German), words_(german_ ? kGerman : kEnglish) {}

  std::string logic(const std::vector<Node>& nodes) const {
    return nodes.empty() ? std::string() : text(nodes.front());
  }

  std::string coil(const Coil& coil, const std::string& logic) const {
    const std::string value = coil.values.empty() ? std::string() : coil.values.front().text;
    const ElementRow& row = coil.element->row;
    return fmt::format(fmt::runtime(german_ ? row.say : row.sayEnglish), coil.operand.text, logic,
                       value);
  }

  std::string text(const Node& node) const {
    switch (node.kind) {
      case NodeKind::Series:
        return series(node);
      case NodeKind::Parallel:
        return parallel(node);
      case NodeKind::Xor:
        return joined(node, words_.exclusive);
      case NodeKind::Contact:
        return fmt::format("{}{}", node.negated ? words_.negation : "", node.operand.text);
      case NodeKind::OperandEdge:
        return edge(node, node.operand.text);
      case NodeKind::Connector:
        return node.operand.text;
      case NodeKind::Box:
        return box(node);
      case NodeKind::Not:
      case NodeKind::Edge:
        break;
    }
    return {};
  }

 private:
  std::string edge(const Node& node, const std::string& of) const {
    return fmt::format(fmt::runtime(node.falling ? words_.falling : words_.rising), of);
  }

  static bool isChoice(const Node& node) {
    return (node.kind == NodeKind::Parallel || node.kind == NodeKind::Xor) &&
           node.children.size() > 1;
  }
  static bool isChain(const Node& node) {
    return node.kind == NodeKind::Series && node.children.size() > 1;
  }

  // NOT and an edge speak of everything before them.
  std::string series(const Node& node) const {
    std::string out;
    bool several = false;
    for (const Node& child : node.children) {
      if (child.kind == NodeKind::Not) {
        out = fmt::format(fmt::runtime(words_.opposite), out);
        several = false;
      } else if (child.kind == NodeKind::Edge) {
        out = edge(child, several ? fmt::format("({})", out) : out);
        several = false;
      } else if (child.kind == NodeKind::Connector) {
        out = fmt::format("({} = {})", child.operand.text, out);
      } else {
        several = !out.empty();
        if (!out.empty()) out += words_.conjunction;
        out += isChoice(child) && node.children.size() > 1 ? fmt::format("({})", text(child))
                                                           : text(child);
      }
    }
    return out;
  }

  // "E 0.0 and E 0.1, or M 1.0": a comma where a term has several words of its own.
  std::string parallel(const Node& node) const {
    bool chains = false;
    for (const Node& child : node.children) chains = chains || isChain(child);
    return joined(
        node, chains ? fmt::format(",{}", words_.disjunction) : std::string(words_.disjunction));
  }

  std::string joined(const Node& node, std::string_view word) const {
    std::string out;
    for (const Node& child : node.children) {
      if (!out.empty()) out += word;
      const bool apart = isChoice(child) || (node.kind == NodeKind::Xor && isChain(child));
      out += apart ? fmt::format("({})", text(child)) : text(child);
    }
    return out;
  }

  // "S_EVERZ T 1 (S: E 0.0, TW: S5T#2S)"
  std::string box(const Node& node) const {
    const ElementRow& row = node.element->row;
    if (row.kind == ElementClass::Compare) return compare(node);
    std::string pins;
    const auto add = [&pins](std::string_view name, const std::string& value) {
      pins += fmt::format("{}{}: {}", pins.empty() ? "" : ", ", name, value);
    };
    if (!node.enable.empty()) add("EN", logic(node.enable));
    for (std::size_t i = 0; i < node.pins.size(); ++i)
      if (const std::string value = pin(node.pins[i]); !value.empty())
        add(german_ ? node.element->pins[i].name : node.element->pins[i].english, value);
    for (const Argument& argument : node.arguments) add(argument.name, given(node, argument));
    std::string_view name = german_ ? row.kop : row.kopEnglish;
    return fmt::format("{}{}{}{}", name, name.empty() || node.operand.text.empty() ? "" : " ",
                       node.operand.text, pins.empty() ? "" : fmt::format(" ({})", pins));
  }

  std::string compare(const Node& node) const {
    std::string_view relation = node.element->row.kop;  // "CMP ==I"
    relation.remove_prefix(relation.find(' ') + 1);
    return fmt::format("{} {} {}", node.pins[0].operand.text, relation, node.pins[1].operand.text);
  }

  std::string pin(const Pin& pin) const {
    return pin.logic.empty() ? pin.operand.text : text(pin.logic.front());
  }

  // Logic where the parameter has some.
  std::string given(const Node& node, const Argument& argument) const {
    for (const Pin& parameter : node.parameters)
      if (parameter.operand.number == argument.wire && !parameter.logic.empty())
        return text(parameter.logic.front());
    return argument.text;
  }

  bool german_;
  const Words& words_;
};

}  // namespace

std::vector<std::string> sentences(const Network& network, Language language) {
  const Speaker speaker(language);
  std::vector<std::string> out;
  for (const Rung& rung : network.rungs) {
    const std::string logic = speaker.logic(rung.logic);
    for (const Coil& coil : rung.coils) out.push_back(speaker.coil(coil, logic));
    if (rung.coils.empty()) out.push_back(logic);
  }
  return out;
}

}  // namespace merker::graph
