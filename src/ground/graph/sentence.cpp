#include "graph/sentence.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>

#include "graph/branches.h"

namespace merker::graph {
namespace {

struct Words {
  std::string_view conjunction, disjunction, exclusive, negation, rising, falling, opposite;
};
constexpr Words kGerman{" und ",
                        " oder ",
                        " exklusiv oder ",
                        "nicht ",
                        "steigende Flanke von {} (Flankenmerker {})",
                        "fallende Flanke von {} (Flankenmerker {})",
                        "nicht ({})"};
constexpr Words kEnglish{" and ",
                         " or ",
                         " exclusive or ",
                         "not ",
                         "rising edge of {} (edge memory bit {})",
                         "falling edge of {} (edge memory bit {})",
                         "not ({})"};

// What holds the words together, the closest first.
enum class Bond : std::uint8_t { Word, Chain, Choice };

struct Phrase {
  std::string text = {};
  Bond bond = Bond::Word;
};

// In brackets if something looser than `most` holds it together.
std::string closed(const Phrase& phrase, Bond most) {
  return phrase.bond > most ? fmt::format("({})", phrase.text) : phrase.text;
}

class Speaker {
 public:
  Speaker(Language language, Language names)
      : german_(language == Language::German),
        germanNames_(names == Language::German),
        words_(german_ ? kGerman : kEnglish) {}

  // A branch goes on with what stands before it: nobody hears of its temporary bit.
  void path(const Path& path, const Phrase& before) {
    before_ = before;
    const Phrase logic = path.logic.empty() ? Phrase{} : phrase(path.logic.front());
    for (const Coil& coil : path.coils) said_.push_back(this->coil(coil, logic.text));
    for (const auto& tail : path.tails) this->path(*tail, logic);
    if (path.coils.empty() && path.tails.empty()) said_.push_back(logic.text);
  }

  std::vector<std::string> said() { return std::move(said_); }

 private:
  std::string coil(const Coil& coil, const std::string& logic) const {
    const std::string value = coil.values.empty() ? std::string() : coil.values.front().text;
    const ElementRow& row = coil.element->row;
    return fmt::format(fmt::runtime(german_ ? row.say : row.sayEnglish), coil.operand.text, logic,
                       value);
  }

  std::string text(const Node& node) const { return phrase(node).text; }

  Phrase phrase(const Node& node) const {
    switch (node.kind) {
      case NodeKind::Series:
        return series(node);
      case NodeKind::Parallel:
        return parallel(node);
      case NodeKind::Xor:
        return joined(phrases(node.children), words_.exclusive, Bond::Word);
      case NodeKind::Contact:
        return contact(node);
      case NodeKind::OperandEdge:
        return {edge(node, node.operand.text)};
      case NodeKind::Connector:
        return {node.operand.text};
      case NodeKind::Box:
        return {box(node)};
      case NodeKind::Not:
      case NodeKind::Edge:
        break;
    }
    return {};
  }

  Phrase contact(const Node& node) const {
    if (!node.continues)
      return {fmt::format("{}{}", node.negated ? words_.negation : "", node.operand.text)};
    return node.negated ? opposite(before_) : before_;
  }
  Phrase opposite(const Phrase& phrase) const {
    if (phrase.bond == Bond::Word && !phrase.text.starts_with(words_.negation))
      return {fmt::format("{}{}", words_.negation, phrase.text)};
    return {fmt::format(fmt::runtime(words_.opposite), phrase.text)};
  }

  std::string edge(const Node& node, const std::string& of) const {
    return fmt::format(fmt::runtime(node.falling ? words_.falling : words_.rising), of,
                       node.memory.text);
  }

  // NOT, an edge and a connector speak of everything before them.
  Phrase series(const Node& node) const {
    Phrase out;
    for (const Node& child : node.children) {
      if (child.kind == NodeKind::Not)
        out = opposite(out);
      else if (child.kind == NodeKind::Edge)
        out = {edge(child, closed(out, Bond::Word))};
      else if (child.kind == NodeKind::Connector)
        out = {fmt::format("({} = {})", child.operand.text, out.text)};
      else
        out = both(out, phrase(child));
    }
    return out;
  }

  Phrase both(const Phrase& first, const Phrase& second) const {
    if (first.text.empty()) return second;
    return {fmt::format("{}{}{}", closed(first, Bond::Chain), words_.conjunction,
                        closed(second, Bond::Chain)),
            Bond::Chain};
  }

  std::vector<Phrase> phrases(const std::vector<Node>& nodes) const {
    std::vector<Phrase> out;
    for (const Node& node : nodes) out.push_back(phrase(node));
    return out;
  }

  // "E 0.0 and E 0.1, or M 1.0": a comma where a term has several words of its own.
  Phrase parallel(const Node& node) const {
    const std::vector<Phrase> terms = phrases(node.children);
    const bool chains = std::any_of(terms.begin(), terms.end(),
                                    [](const Phrase& term) { return term.bond == Bond::Chain; });
    return joined(terms, fmt::format("{}{}", chains ? "," : "", words_.disjunction), Bond::Chain);
  }

  static Phrase joined(const std::vector<Phrase>& terms, std::string_view word, Bond most) {
    if (terms.size() == 1) return terms.front();
    Phrase out{{}, Bond::Choice};
    for (const Phrase& term : terms) {
      if (!out.text.empty()) out.text += word;
      out.text += closed(term, most);
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
    if (!node.enable.empty()) add("EN", text(node.enable.front()));
    for (std::size_t i = 0; i < node.pins.size(); ++i)
      if (const std::string value = pin(node.pins[i]); !value.empty())
        add(germanNames_ ? node.element->pins[i].name : node.element->pins[i].english, value);
    for (const Argument& argument : node.arguments) add(argument.name, given(node, argument));
    std::string_view name = germanNames_ ? row.kop : row.kopEnglish;
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

  bool german_, germanNames_;
  const Words& words_;
  Phrase before_;  // the branch from which the path goes on
  std::vector<std::string> said_;
};

}  // namespace

std::vector<std::string> sentences(const Network& network, Language language, Language names) {
  Speaker speaker(language, names);
  for (const auto& path : paths(network)) speaker.path(*path, {});
  return speaker.said();
}

}  // namespace merker::graph
