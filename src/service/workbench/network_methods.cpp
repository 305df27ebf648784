// The networks of a text as KOP and FUP: shown and edited.
#include "graph/edit.h"
#include "graph5/rules.h"
#include "graph7/rules.h"
#include "networks/source_edit.h"
#include "workbench/elsewhere.h"
#include "workbench/network_rows.h"

namespace merker::workbench {
namespace network_methods {
namespace {

// The text that the request is about, with what its words may refer to.
struct Text {
  source::SourceFile file;
  networks::Surroundings around;
};

Result<std::string, Problems> textOf(const Aside& aside, const std::string& path) {
  if (aside.fields.has("text")) return aside.fields.text("text");
  auto content = aside.folder.read(path);
  if (!content) return one(content.error());
  return std::move(content->text);
}

Result<Text, Problems> readText(const Aside& aside, const compilation::Build& build) {
  const std::string path = aside.fields.text("file");
  if (!aside.fields.good()) return aside.fields.problems();
  auto text = textOf(aside, path);
  if (!text) return text.error();
  if (!aside.fields.good()) return aside.fields.problems();
  networks::Surroundings around{.language = build.project.symbols.language(),
                                .symbols = &build.project.symbols,
                                .program = build.program.get(),
                                .library = build.library.get(),
                                .mnemonics = build.project.mnemonics};
  if (build.isListing()) around.language = source::Language::Step5;
  return Text{source::SourceFile(path, std::move(*text)), around};
}

Result<networks::Block, Problems> blockAt(const Text& text, std::int64_t line) {
  auto block = networks::blockAt(text.file, static_cast<std::uint32_t>(line), text.around);
  if (!block)
    return refused(ProblemCode::P1308, fmt::format("line {}", line),
                   "there is no block with networks");
  return std::move(*block);
}

std::int64_t lineField(const Fields& fields) {
  return fields.integer("line", 1, std::numeric_limits<std::int32_t>::max());
}

graph::Language languageOf(const Fields& fields) {
  return static_cast<graph::Language>(fields.choice("language", {"german", "english"}, 0));
}

constexpr std::string_view kMnemonics[] = {"german", "international"};

NetworkDisplay displayOf(const Fields& fields, const source::SymbolTable& symbols) {
  return {
      static_cast<NetworkView>(fields.choice("view", {"kop", "fup"}, 0)), languageOf(fields),
      static_cast<OperandDisplay>(fields.choice("display", {"written", "symbolic", "absolute"}, 0)),
      &symbols};
}

Answer shown(const Aside& aside, const compilation::Build& build) {
  const std::int64_t line = lineField(aside.fields);
  NetworkDisplay display = displayOf(aside.fields, build.project.symbols);
  const auto text = readText(aside, build);
  if (!text) return text.error();
  const auto block = blockAt(*text, line);
  if (!block) return block.error();
  display.mnemonics = block->mnemonics;
  return Json{{"block", block->name},
              {"line", block->line},
              {"end", block->end - 1},
              {"mnemonics", kMnemonics[static_cast<std::size_t>(block->mnemonics)]},
              {"networks", networkRows(*block, display)}};
}

Answer show(const Call& call) {
  return elsewhere(call, call.shared.clerk,
                   [offline = call.shared.offlineRef()](const Aside& aside) {
                     return shown(aside, *offline->build);
                   });
}

// The words of the protocol in the order of graph::Action; behind them what changes networks.
constexpr std::int64_t kMostNetworks = 100'000;
constexpr std::size_t kNewNetwork = 7, kDeleteNetwork = 8, kHeading = 9, kLabel = 10;
std::size_t actionOf(const Fields& edit) {
  return edit.choice(
      "action", {"insert", "addInput", "negate", "closeBranch", "setOperand", "delete", "newRung",
                 "newNetwork", "deleteNetwork", "heading", "label"});
}

graph::Edit editOf(const Fields& fields, std::size_t action) {
  constexpr std::int64_t kMostStatements = 1'000'000, kMostPins = 1000;
  constexpr std::size_t kMostOperands = 1000;
  const auto number = [&fields](std::string_view key, std::int64_t low, std::int64_t high) {
    return static_cast<int>(fields.integer(key, low, high, -1));
  };
  graph::Edit edit;
  edit.action = static_cast<graph::Action>(action);
  edit.at = {number("node", -1, kMostStatements), number("pin", -2, kMostPins),
             number("first", -1, kMostStatements)};
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

networks::Edited changed(const Text& text, const Fields& fields, std::uint32_t line,
                         std::size_t network) {
  const std::size_t action = actionOf(fields);
  switch (action) {
    case kNewNetwork:
      return networks::insertNetwork(text.file, line, network,
                                     fields.choice("place", {"before", "behind"}, 1) == 0,
                                     headingOf(fields), text.around);
    case kDeleteNetwork:
      return networks::removeNetwork(text.file, line, network, text.around);
    case kHeading:
      return networks::changeHeading(text.file, line, network, headingOf(fields), text.around);
    case kLabel:
      return networks::changeLabel(text.file, line, network, fields.text("label", ""), text.around);
    default:
      return networks::edit(text.file, line, network, editOf(fields, action), text.around);
  }
}

Answer edited(const Aside& aside, const compilation::Build& build) {
  const Fields& fields = aside.fields;
  fields.text("text");
  const auto line = static_cast<std::uint32_t>(lineField(fields));
  const auto network = static_cast<std::size_t>(fields.integer("network", 0, kMostNetworks));
  const graph::Language language = languageOf(fields);
  const Fields edit = fields.object("edit");
  const auto text = readText(aside, build);
  if (!text) return text.error();
  const networks::Edited result = changed(*text, edit, line, network);
  if (!fields.good()) return aside.wrong();
  if (!result)
    return refused(
        ProblemCode::P1308,
        fmt::format("{} {}", language == graph::Language::German ? "Netzwerk" : "network", network),
        networks::text(result.error(), language));
  return editRow(*result);
}

Answer edit(const Call& call) {
  return elsewhere(call, call.shared.clerk,
                   [offline = call.shared.offlineRef()](const Aside& aside) {
                     return edited(aside, *offline->build);
                   });
}

// What is no row of a family's table: in KOP, in FUP, its key in STEP 7; whether STEP 5 lacks it.
struct BitElement {
  std::string_view id, kop, fup, key;
  bool extended = false;
};
constexpr BitElement kBits[] = {
    {graph::element::kContact, "-| |-", "", "F2"},
    {graph::element::kContactNot, "-|/|-", "", "F3"},
    {graph::element::kAnd, "", "&", "F2"},
    {graph::element::kOr, "", ">=1", "F3"},
    {graph::element::kXor, "", "XOR", "", true},
    {graph::element::kNot, "-|NOT|-", "NOT", "", true},
    {graph::element::kConnector, "-(#)-", "#", ""},
    {graph::element::kRisingEdge, "-(P)-", "P", "", true},
    {graph::element::kFallingEdge, "-(N)-", "N", "", true},
    {graph::element::kRisingOperand, "POS", "POS", "", true},
    {graph::element::kFallingOperand, "NEG", "NEG", "", true},
};

std::string_view groupOf(graph::ElementClass kind) {
  constexpr std::string_view kGroups[] = {"compare", "box", "move", "call", "coil", "coil"};
  return kGroups[static_cast<std::size_t>(kind)];
}

Json elementRow(std::string_view id, std::string_view kop, std::string_view fup,
                std::string_view group, std::string_view key) {
  Json row = {{"id", id}, {"kop", kop}, {"fup", fup}, {"group", group}};
  if (!key.empty()) row["key"] = key;
  return row;
}

// With its names in the other mnemonics, for who knows only those.
Json elementRow(const graph::ElementRow& row, Mnemonics mnemonics) {
  const std::string_view group = groupOf(row.kind);
  if (row.kind == graph::ElementClass::Call) return elementRow(row.id, "CALL", "CALL", group, "");
  std::pair german{row.kop, row.fup}, english{row.kopEnglish, row.fupEnglish};
  if (mnemonics != Mnemonics::German) std::swap(german, english);
  const auto& [own, other] = std::pair{german, english};
  Json out = elementRow(row.id, own.first, own.second, group, row.id == "COIL" ? "F7" : "");
  if (own != other) out["other"] = {{"kop", other.first}, {"fup", other.second}};
  return out;
}

Answer elements(const Call& call) {
  const auto mnemonics =
      static_cast<Mnemonics>(call.fields.choice("mnemonics", {kMnemonics[0], kMnemonics[1]}, 0));
  if (!call.fields.good()) return call.fields.problems();
  const graph::Rules& rules = call.plc().build().isListing() ? graph5::rules() : graph7::rules();
  Json rows = Json::array();
  for (const BitElement& bit : kBits)
    if (rules.extended || !bit.extended)
      rows.push_back(elementRow(bit.id, bit.kop, bit.fup, "bit", bit.key));
  // JMP and CALL are one entry each: what stands before them decides.
  for (const graph::Element& element : rules.elements->elements())
    if (&rules.elements->counterpart(element, true) == &element)
      rows.push_back(elementRow(element.row, mnemonics));
  return Json{{"elements", std::move(rows)}};
}

constexpr Method kMethods[] = {
    {"networks.edit", Needs::Plc, edit, Kind::Compiled},
    {"networks.elements", Needs::Plc, elements},
    {"networks.show", Needs::Plc, show, Kind::Compiled},
};

}  // namespace
}  // namespace network_methods

std::span<const Method> networkMethods() { return network_methods::kMethods; }

}  // namespace merker::workbench
