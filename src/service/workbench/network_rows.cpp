#include "workbench/network_rows.h"

#include "graph/fup.h"
#include "graph/kop.h"
#include "graph/sentence.h"
#include "graph7/rules.h"
#include "workbench/declared_types.h"
#include "workbench/shown_operands.h"

namespace merker::workbench {
namespace {

constexpr std::string_view kShapeKinds[] = {"wire",    "rail", "frame",    "text",
                                            "contact", "coil", "negation", "field"};
constexpr std::string_view kEnds[] = {"", "begins", "ends"};
constexpr std::string_view kBits[] = {"vke", "sta", "notSta"};

template <typename Enum>
std::string_view word(std::span<const std::string_view> words, Enum value) {
  return words[static_cast<std::size_t>(value)];
}

class NetworkRow {
 public:
  NetworkRow(const networks::Network& network, const graph::Rules& rules,
             const NetworkDisplay& display)
      : network_(network),
        source_(network.source),
        rules_(rules),
        display_(display),
        types_(display.symbols, display.compiled) {}

  Json row() {
    Json row = {{"number", network_.number},
                {"title", source_.title},
                {"comment", comment()},
                {"label", source_.label},
                {"line", source_.line},
                {"end", source_.end - 1},
                {"first", source_.places.empty() ? 0 : source_.places.front().line},
                {"shapes", Json::array()},
                {"sentences", Json::array()},
                {"w", 0},
                {"h", 0}};
    if (network_.tree)
      draw(row);
    else
      refuse(row);
    return row;
  }

 private:
  std::string comment() const {
    std::string text;
    for (const std::string& line : source_.comment) text += (text.empty() ? "" : "\n") + line;
    return text;
  }

  // Counted from the first line of the network, so that it looks the same wherever it stands.
  std::int64_t lineOf(std::size_t statement) const {
    if (statement >= source_.places.size()) return 0;
    return std::int64_t{source_.places[statement].line} - source_.line;
  }

  void refuse(Json& row) const {
    row["view"] = "awl";
    row["reason"] = graph::text(network_.refusal.reason, display_.language);
    if (network_.refusal.statement < source_.places.size())
      row["reasonLine"] = lineOf(network_.refusal.statement);
  }

  // What KOP cannot draw is FUP.
  void draw(Json& row) {
    graph::Network shown = *network_.tree;
    written_ = showOperands(shown, display_);
    const bool kop = display_.view == NetworkView::Kop && graph::fitsKop(shown, rules_);
    const graph::Style style{graph7::namesIn(display_.mnemonics)};
    const graph::Picture picture = kop ? graph::kop(shown, style) : graph::fup(shown, style);
    row["view"] = kop ? "kop" : "fup";
    row["h"] = picture.h;
    int right = picture.w;
    for (const graph::Shape& shape : picture.shapes) {
      right = std::max(right, shape.x + shape.w);
      row["shapes"].push_back(shapeRow(shape));
    }
    row["w"] = right;
    row["sentences"] = graph::sentences(shown, display_.language, style.names);
  }

  Json shapeRow(const graph::Shape& shape) const {
    Json row = {{"kind", word(kShapeKinds, shape.kind)},
                {"x", shape.x},
                {"y", shape.y},
                {"w", shape.w},
                {"h", shape.h}};
    if (!shape.text.empty()) row["text"] = shape.text;
    const std::string& operand = shape.whole.empty() ? shape.text : shape.whole;
    if (const auto at = written_.find(operand); at != written_.end())
      row["written"] = at->second;
    else if (!shape.whole.empty())
      row["written"] = shape.whole;
    if (shape.ends != graph::Ends::AtEdges) row["ends"] = word(kEnds, shape.ends);
    if (shape.of.node >= 0) name(row, shape);
    if (shape.kind == graph::ShapeKind::Text && shape.value) value(row, shape.statement);
    if (shape.kind == graph::ShapeKind::Text && !shape.value) argument(row, shape.of);
    const bool carries =
        shape.kind == graph::ShapeKind::Wire || shape.kind == graph::ShapeKind::Negation;
    if (carries && !shape.value && graph::isKnown(shape.flow)) row["flow"] = flow(shape);
    return row;
  }

  // The value of a constant is its text: "5", "-1", "S5T#2S", "'A'", "KT 10.1".
  static bool isConstant(std::string_view text) {
    const std::size_t mark = text.find('#');
    const bool step5 = text.size() > 2 && text[0] == 'K' && text[2] == ' ';
    return step5 || text.find_first_of("0123456789+-'") == 0 || (mark != text.npos && mark > 0);
  }

  // What LC gives is BCD.
  void value(Json& row, std::size_t index) const {
    const graph::Statements& all = source_.statements;
    if (index >= all.size() || isConstant(all[index].operand.text)) return;
    row["value"] = lineOf(index);
    if (const auto type = types_.of(all[index].operand.text)) row["type"] = merker::name(*type);
    if (index > 0 && all[index - 1].op == graph::Op::LOAD_BCD) row["bcd"] = true;
  }

  // A box of CALL ends with it, or with what the jump to its end needs.
  const graph::Statement* callOf(int node, std::size_t& index) const {
    const graph::Statements& all = source_.statements;
    for (int at = node; at >= 0 && at >= node - 1; --at)
      if (index = static_cast<std::size_t>(at);
          index < all.size() && all[index].op == graph::Op::CALL)
        return &all[index];
    return nullptr;
  }

  void argument(Json& row, const graph::Selection& of) const {
    std::size_t index = 0;
    const int number = of.pin - graph::kFirstPin;
    const graph::Statement* call = number < 0 ? nullptr : callOf(of.node, index);
    if (call == nullptr || static_cast<std::size_t>(number) >= call->arguments.size()) return;
    row["value"] = lineOf(index);
    row["parameter"] = call->arguments[static_cast<std::size_t>(number)].name;
  }

  void name(Json& row, const graph::Shape& shape) const {
    row["node"] = shape.of.node;
    if (shape.of.first >= 0) row["first"] = shape.of.first;
    const bool element = shape.of.pin == graph::kNoPin;
    if (!element) row["pin"] = shape.of.pin;
    row["line"] = lineOf(element ? static_cast<std::size_t>(shape.of.node) : shape.statement);
  }

  Json flow(const graph::Shape& shape) const {
    Json list = Json::array();
    for (const graph::Flow& flow : shape.flow)
      list.push_back({lineOf(flow.statement), word(kBits, flow.bit)});
    return list;
  }

  const networks::Network& network_;
  const graph::SourceNetwork& source_;
  const graph::Rules& rules_;
  const NetworkDisplay& display_;
  DeclaredTypes types_;
  WrittenOperands written_;
};

}  // namespace

Json networkRows(const networks::Block& block, const NetworkDisplay& display) {
  Json rows = Json::array();
  for (const networks::Network& network : block.networks)
    rows.push_back(NetworkRow(network, *block.rules, display).row());
  return rows;
}

}  // namespace merker::workbench
