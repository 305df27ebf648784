#include "graph/edit.h"

#include <algorithm>

#include "graph/canonical.h"
#include "graph/edit_branches.h"
#include "graph/edit_change.h"
#include "graph/edit_delete.h"
#include "graph/edit_insert.h"
#include "graph/edit_paste.h"
#include "graph/kinds.h"
#include "graph/kop.h"
#include "graph/locate.h"
#include "graph/missing.h"
#include "graph/read.h"
#include "graph/wires.h"
#include "graph/write.h"

namespace merker::graph {
namespace {

// More than anybody draws in one network.
constexpr std::size_t kMostStatements = 4000;

using Refused = std::optional<EditProblem>;

Refused change(Network& network, const std::optional<Location>& at, const Edit& edit,
               const Rules& rules) {
  if (!at && edit.at.node >= 0) return EditProblem::NoNode;
  switch (edit.action) {
    case Action::Insert:
      return insert({network, edit, rules}, at);
    case Action::Paste:
      return paste({network, edit, rules}, at);
    case Action::Move:
      return move({network, edit, rules});
    case Action::NewRung:
      newRung(network, at, rules);
      return std::nullopt;
    case Action::AddInput:
    case Action::Negate:
    case Action::CloseBranch:
    case Action::SetOperand:
      return at ? change(*at, edit) : EditProblem::NoNode;
    case Action::Delete:
      return at ? remove(network, *at, edit.at.pin) : EditProblem::NoNode;
    case Action::DeleteRung:
      if (!at) return EditProblem::NoNode;
      removeRung(network, *at->rung);
      return std::nullopt;
  }
  return std::nullopt;
}

bool has(const Statements& statements, Op op) {
  return std::any_of(statements.begin(), statements.end(),
                     [op](const Statement& statement) { return statement.op == op; });
}

EditProblem problemOf(Reason reason) {
  if (reason == Reason::Brackets) return EditProblem::Brackets;
  if (reason == Reason::OneBox) return EditProblem::OneBox;
  return reason == Reason::Size ? EditProblem::Size : EditProblem::Ambiguous;
}

// The field that waits for its operand.
int emptyField(const Node& node) {
  if (isMissing(node.operand) || (node.kind == NodeKind::Edge && isMissing(node.memory)))
    return kOwn;
  for (std::size_t i = 0; i < node.pins.size(); ++i)
    if (isMissing(node.pins[i].operand)) return kFirstPin + static_cast<int>(i);
  return kNoPin;
}
int emptyField(const Coil& coil) {
  if (isMissing(coil.operand)) return kOwn;
  for (std::size_t i = 0; i < coil.values.size(); ++i)
    if (isMissing(coil.values[i])) return kFirstPin + static_cast<int>(i);
  return kNoPin;
}

Selection selected(const Network& network) {
  Selection out;
  const auto take = [&out](std::size_t last, int pin) { out = {static_cast<int>(last) - 1, pin}; };
  for (const Rung& rung : network.rungs) {
    for (const Node& logic : rung.logic)
      visit(logic, [&take, &out](const Node& node) {
        if (!node.selected) return;
        take(node.last, emptyField(node));
        if (isUnbracketedGroup(node)) out.first = static_cast<int>(node.first);
      });
    for (const Coil& coil : rung.coils)
      if (coil.selected) take(coil.last, emptyField(coil));
  }
  return out;
}

// `= M 1.0` and the `U M 1.0` of the next rung are one element, a connector.
Selection found(Network& network, Selection selection) {
  if (selection.node < 0 || locate(network, selection)) return selection;
  ++selection.node;
  return locate(network, selection) ? selection : Selection{};
}

}  // namespace

Result<Edited, EditProblem> apply(const Network& network, const Edit& edit, const Rules& rules,
                                  std::uint32_t firstWire) {
  Network changed = network;
  if (const Refused refused = change(changed, locate(changed, edit.at), edit, rules))
    return *refused;
  tidyBranches(changed, network);
  changed = canonical(std::move(changed), rules, firstWire);
  Edited out;
  out.statements = writeNumbered(changed, rules);
  if (out.statements.size() > kMostStatements) return EditProblem::Size;
  if (!rules.extended && has(out.statements, Op::NOT)) return EditProblem::NoNegation;
  out.select = selected(changed);
  if (edit.action == Action::SetOperand) out.select.pin = edit.at.pin;
  auto again = read(out.statements, rules, Unfinished::Allowed);
  if (!again) return problemOf(again.error().reason);
  out.network = std::move(*again);
  if (edit.ladder && fitsKop(network, rules) && !fitsKop(out.network, rules))
    return EditProblem::Ladder;
  out.select = found(out.network, out.select);
  return out;
}

Result<Statements, EditProblem> copy(const Network& network, std::span<const Selection> elements,
                                     const Rules& rules, std::uint32_t firstWire) {
  const auto copy = copied(network, elements, rules, firstWire);
  if (!copy) return EditProblem::NoNode;
  Statements statements = write(*copy, rules);
  if (const auto again = read(statements, rules, Unfinished::Part); !again)
    return problemOf(again.error().reason);
  return statements;
}

}  // namespace merker::graph
