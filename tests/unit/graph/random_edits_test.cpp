// Any edits in any order: what they leave is read again as it was written.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "graph/canonical.h"
#include "graph/edit.h"
#include "graph/fup.h"
#include "graph/kop.h"
#include "graph/locate.h"
#include "graph/read.h"
#include "graph/wires.h"
#include "graph/write.h"
#include "graph5/rules.h"
#include "graph7/rules.h"
#include "random_networks.h"
#include "statement_text.h"

namespace merker::graph {
namespace {

using test::kFirstWire;

int below(int limit) { return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(0, limit)); }

std::string element(const Rules& rules) {
  constexpr std::string_view kOwn[] = {"CONTACT", "CONTACT_NOT", "NOT", "P",  "N",   "POS",
                                       "NEG",     "CONNECTOR",   "AND", "OR", "XOR", "COIL"};
  const auto rows = rules.elements->elements();
  if (below(3) > 0) return std::string(kOwn[below(std::size(kOwn))]);
  return std::string(rows[static_cast<std::size_t>(below(static_cast<int>(rows.size())))].row.id);
}

Operand anyOperand() {
  if (below(3) == 0) return {};
  Operand operand = test::bit(static_cast<std::uint32_t>(below(6)));
  if (below(3) == 0) operand.kind = OperandKind::Value;
  return operand;
}

// Mostly of something that is there.
Selection anySelection(const Network& network) {
  std::vector<Selection> all{{}};
  const auto add = [&all](std::size_t first, std::size_t last) {
    all.push_back({static_cast<int>(last) - 1, kNoPin, -1});
    all.push_back({static_cast<int>(last) - 1, kNoPin, static_cast<int>(first)});
  };
  for (const Rung& rung : network.rungs) {
    for (const Node& logic : rung.logic)
      visit(logic, [&add](const Node& node) { add(node.first, node.last); });
    for (const Coil& coil : rung.coils) all.push_back({static_cast<int>(coil.last) - 1});
  }
  Selection out = all[static_cast<std::size_t>(below(static_cast<int>(all.size())))];
  if (below(10) == 0) out.node += below(3) - 1;
  if (below(3) == 0) out.pin = below(6) - 2;
  return out;
}

// What could be on the clipboard: a copy, or another network.
Network anyPasted(const Network& network, const Rules& rules) {
  if (below(2) == 0) return canonical(*test::networks(rules), rules, kFirstWire);
  std::vector<Selection> some;
  for (int i = 1 + below(3); i > 0; --i) some.push_back(anySelection(network));
  const auto copied = copy(network, some, rules, kFirstWire);
  if (!copied) return {};
  const auto again = read(*copied, rules, Unfinished::Part);
  RC_ASSERT(again.has_value());
  return *again;
}

Edit anyEdit(const Network& network, const Rules& rules) {
  Edit edit;
  constexpr Action kActions[] = {
      Action::Insert,      Action::Insert,     Action::Insert, Action::AddInput, Action::Negate,
      Action::CloseBranch, Action::SetOperand, Action::Delete, Action::Paste,    Action::Move,
      Action::NewRung,     Action::DeleteRung, Action::Insert};
  edit.action = kActions[below(below(4) == 0 ? std::size(kActions) : 11)];
  edit.at = anySelection(network);
  edit.place = static_cast<Place>(below(5));
  edit.element = element(rules);
  edit.from = anySelection(network);
  if (edit.action == Action::Paste) edit.pasted = anyPasted(network, rules);
  for (int i = below(4); i > 0; --i) edit.operands.push_back(anyOperand());
  if (edit.element == "CALL_BOX")
    edit.arguments = {
        {"A", "", false, -1, true}, {"B", "MW 1", false, -1, false}, {"C", "", true, -1, true}};
  return edit;
}

// What can be selected, in its order.
std::vector<int> symbolsIn(const Picture& picture) {
  std::vector<int> found;
  for (const Shape& shape : picture.shapes)
    if (shape.kind == ShapeKind::Contact || shape.kind == ShapeKind::Coil)
      found.push_back(shape.of.node);
  return found;
}

void expectWhole(const Edited& edited, const Rules& rules) {
  RC_ASSERT(write(edited.network, rules) == edited.statements);
  const auto again = read(edited.statements, rules, Unfinished::Allowed);
  RC_ASSERT(again.has_value());
  RC_ASSERT(*again == edited.network);
  Network copy = edited.network;
  if (edited.select.node >= 0) RC_ASSERT(locate(copy, edited.select).has_value());
  RC_ASSERT(!toText(fup(copy, {}))->empty() || edited.statements.empty());
  if (!fitsKop(copy, rules)) return;
  const Picture wide = kop(copy, {});
  RC_ASSERT(!toText(wide)->empty());
  RC_ASSERT(symbolsIn(kop(copy, {Language::German, 30})) == symbolsIn(wide));
}

void editAtRandom(const Rules& rules) {
  Network network = canonical(*test::networks(rules), rules, kFirstWire);
  Statements statements = write(network, rules);
  const auto start = read(statements, rules, Unfinished::Allowed);
  network = start ? *start : Network{};
  if (!start) statements.clear();
  for (int count = below(20); count > 0; --count) {
    const Edit edit = anyEdit(network, rules);
    RC_LOG() << test::text(statements) << "\n  action " << static_cast<int>(edit.action) << " at "
             << edit.at.node << ":" << edit.at.pin << "/" << edit.at.first << " place "
             << static_cast<int>(edit.place) << " " << edit.element << "\n";
    const auto edited = apply(network, edit, rules, kFirstWire);
    if (!edited) continue;
    RC_LOG() << "    " << test::text(edited->statements) << "\n";
    expectWhole(*edited, rules);
    network = edited->network;
    statements = edited->statements;
  }
}

RC_GTEST_PROP(RandomEdits, LeaveWholeNetworksInStep7, ()) { editAtRandom(graph7::rules()); }
RC_GTEST_PROP(RandomEdits, LeaveWholeNetworksInStep5, ()) { editAtRandom(graph5::rules()); }

}  // namespace
}  // namespace merker::graph
