#include "workbench/network_edits.h"

#include "networks/source_edit.h"
#include "workbench/network_text.h"

namespace merker::workbench {
namespace network_edits {
namespace {

// What an edit of the protocol is: one of a tree, or of networks.
enum class Wish : std::uint8_t { Tree, Paste, Move, NewNetwork, DeleteNetwork, Heading, Label };
struct ActionRow {
  Wish wish;
  graph::Action action = graph::Action::Insert;  // Wish::Tree
};
constexpr ActionRow kActions[] = {{Wish::Tree, graph::Action::Insert},
                                  {Wish::Tree, graph::Action::AddInput},
                                  {Wish::Tree, graph::Action::Negate},
                                  {Wish::Tree, graph::Action::CloseBranch},
                                  {Wish::Tree, graph::Action::SetOperand},
                                  {Wish::Tree, graph::Action::Delete},
                                  {Wish::Tree, graph::Action::NewRung},
                                  {Wish::Paste},
                                  {Wish::Move},
                                  {Wish::NewNetwork},
                                  {Wish::DeleteNetwork},
                                  {Wish::Heading},
                                  {Wish::Label}};
ActionRow actionOf(const Fields& edit) {
  return kActions[edit.choice(
      "action", {"insert", "addInput", "negate", "closeBranch", "setOperand", "delete", "newRung",
                 "paste", "move", "newNetwork", "deleteNetwork", "heading", "label"})];
}

constexpr std::int64_t kMostNetworks = 100'000, kMostStatements = 1'000'000;

int statementField(const Fields& fields, std::string_view key) {
  return static_cast<int>(fields.integer(key, -1, kMostStatements, -1));
}

// An element, without a pin of it.
graph::Selection elementOf(const Fields& fields) {
  return {statementField(fields, "node"), graph::kNoPin, statementField(fields, "first")};
}

graph::Edit editOf(const Fields& fields, graph::Action action, bool ladder) {
  constexpr std::int64_t kMostPins = 1000;
  constexpr std::size_t kMostOperands = 1000;
  graph::Edit edit;
  edit.action = action;
  edit.ladder = ladder;
  edit.at = elementOf(fields);
  edit.at.pin = static_cast<int>(fields.integer("pin", -2, kMostPins, -1));
  edit.place = static_cast<graph::Place>(
      fields.choice("place", {"before", "behind", "parallel", "branch", "atPin"}, 1));
  edit.element = fields.text("element", "");
  if (!fields.has("operands")) return edit;
  for (std::string& text : fields.texts("operands", kMostOperands)) {
    graph::Operand& operand = edit.operands.emplace_back();
    operand.kind = text.empty() ? graph::OperandKind::None : graph::OperandKind::Value;
    operand.text = std::move(text);
  }
  return edit;
}

networks::Origin originOf(const Fields& edit) {
  const Fields from = edit.object("from");
  return {static_cast<std::size_t>(from.integer("network", 0, kMostNetworks)), elementOf(from)};
}

networks::Heading headingOf(const Fields& fields) {
  constexpr std::size_t kMostLines = 1000;
  networks::Heading heading{fields.text("title", ""), {}};
  if (fields.has("comment")) heading.comment = fields.texts("comment", kMostLines);
  return heading;
}

Json editRow(const networks::TextEdit& edit) {
  return {{"from", edit.from},         {"to", edit.to},
          {"lines", edit.lines},       {"network", edit.network},
          {"node", edit.select.node},  {"pin", edit.select.pin},
          {"first", edit.select.first}};
}

// The network of a request.
struct Asked {
  std::uint32_t line;  // of its block
  std::size_t network;
  graph::Language language;
  bool ladder = false;  // it is edited in
};
Asked askedOf(const Fields& fields) {
  fields.text("text");
  return {static_cast<std::uint32_t>(networkLine(fields)),
          static_cast<std::size_t>(fields.integer("network", 0, kMostNetworks)),
          networkLanguage(fields)};
}

networks::Edited changed(const NetworkText& text, const Fields& fields, const Asked& asked) {
  const ActionRow row = actionOf(fields);
  const std::uint32_t line = asked.line;
  const std::size_t network = asked.network;
  const auto wish = [&] { return editOf(fields, row.action, asked.ladder); };
  switch (row.wish) {
    case Wish::Tree:
      return networks::edit(text.file, line, network, wish(), text.around);
    case Wish::Paste:
      return networks::paste(text.file, line, network, wish(), fields.text("text", ""),
                             text.around);
    case Wish::Move:
      return networks::move(text.file, line, network, wish(), originOf(fields), text.around);
    case Wish::NewNetwork:
      return networks::insertNetwork(text.file, line, network,
                                     fields.choice("place", {"before", "behind"}, 1) == 0,
                                     headingOf(fields), text.around);
    case Wish::DeleteNetwork:
      return networks::removeNetwork(text.file, line, network, text.around);
    case Wish::Heading:
      return networks::changeHeading(text.file, line, network, headingOf(fields), text.around);
    case Wish::Label:
      return networks::changeLabel(text.file, line, network, fields.text("label", ""), text.around);
  }
  return networks::Refusal{};
}

Problems impossible(const Asked& asked, const networks::Refusal& refusal) {
  const bool german = asked.language == graph::Language::German;
  return refused(ProblemCode::P1308,
                 fmt::format("{} {}", german ? "Netzwerk" : "network", asked.network),
                 networks::text(refusal, asked.language));
}

Answer edited(const Aside& aside, const compilation::Build& build) {
  Asked asked = askedOf(aside.fields);
  asked.ladder = aside.fields.choice("view", {"kop", "fup"}, 1) == 0;
  const Fields edit = aside.fields.object("edit");
  const auto text = networkText(aside, build);
  if (!text) return text.error();
  const auto result = changed(*text, edit, asked);
  if (!aside.fields.good()) return aside.wrong();
  if (!result) return impossible(asked, result.error());
  return editRow(*result);
}

Answer copied(const Aside& aside, const compilation::Build& build) {
  constexpr std::size_t kMostElements = 1000;
  const Asked asked = askedOf(aside.fields);
  std::vector<graph::Selection> elements;
  if (aside.fields.has("elements"))
    for (const Fields& element : aside.fields.objects("elements", kMostElements))
      elements.push_back(elementOf(element));
  const auto text = networkText(aside, build);
  if (!text) return text.error();
  const auto lines = networks::copy(text->file, asked.line, asked.network, elements, text->around);
  if (!lines) return impossible(asked, lines.error());
  return Json{{"lines", *lines}};
}

}  // namespace
}  // namespace network_edits

Answer editNetwork(const Call& call) {
  return elsewhere(call, call.shared.clerk,
                   [offline = call.shared.offlineRef()](const Aside& aside) {
                     return network_edits::edited(aside, *offline->build);
                   });
}

Answer copyElements(const Call& call) {
  return elsewhere(call, call.shared.clerk,
                   [offline = call.shared.offlineRef()](const Aside& aside) {
                     return network_edits::copied(aside, *offline->build);
                   });
}

}  // namespace merker::workbench
