// The networks of a text as KOP and FUP: shown and edited.
#include "graph/edit.h"
#include "graph5/rules.h"
#include "graph7/rules.h"
#include "workbench/elsewhere.h"
#include "workbench/network_edits.h"
#include "workbench/network_rows.h"
#include "workbench/network_text.h"

namespace merker::workbench {
namespace network_methods {
namespace {

Result<networks::Block, Problems> blockAt(const NetworkText& text, std::int64_t line) {
  auto block = networks::blockAt(text.file, static_cast<std::uint32_t>(line), text.around);
  if (!block)
    return refused(ProblemCode::P1308, fmt::format("line {}", line),
                   "there is no block with networks");
  return std::move(*block);
}

constexpr std::string_view kMnemonics[] = {"german", "international"};

NetworkDisplay displayOf(const Fields& fields, const source::SymbolTable& symbols) {
  return {
      static_cast<NetworkView>(fields.choice("view", {"kop", "fup"}, 0)), networkLanguage(fields),
      static_cast<OperandDisplay>(fields.choice("display", {"written", "symbolic", "absolute"}, 0)),
      &symbols};
}

const block::Block* compiledBlock(const compilation::Build& build, std::string_view name) {
  if (build.program == nullptr) return nullptr;
  const auto at = std::ranges::find_if(
      *build.program, [name](const auto& one) { return toString(one.first) == name; });
  return at == build.program->end() ? nullptr : &at->second;
}

Answer shown(const Aside& aside, const compilation::Build& build) {
  const std::int64_t line = networkLine(aside.fields);
  NetworkDisplay display = displayOf(aside.fields, build.project.symbols);
  const auto text = networkText(aside, build);
  if (!text) return text.error();
  const auto block = blockAt(*text, line);
  if (!block) return block.error();
  display.mnemonics = block->mnemonics;
  display.compiled = compiledBlock(build, block->name);
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

// What jumps lead to: no element of the network's tree, but its label.
constexpr std::string_view kLabel = "LABEL";

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
  for (const graph::Element& element : rules.elements->elements()) {
    if (&rules.elements->counterpart(element, true) != &element) continue;
    rows.push_back(elementRow(element.row, mnemonics));
    if (element.row.id == "JMPN") rows.push_back(elementRow(kLabel, "LABEL", "LABEL", "coil", ""));
  }
  return Json{{"elements", std::move(rows)}};
}

constexpr Method kMethods[] = {
    {"networks.copy", Needs::Plc, copyElements, Kind::Compiled},
    {"networks.edit", Needs::Plc, editNetwork, Kind::Compiled},
    {"networks.elements", Needs::Plc, elements},
    {"networks.show", Needs::Plc, show, Kind::Compiled},
};

}  // namespace
}  // namespace network_methods

std::span<const Method> networkMethods() { return network_methods::kMethods; }

}  // namespace merker::workbench
