#include "graph/read.h"

#include <algorithm>
#include <optional>

#include "graph/bld.h"
#include "graph/expression_reader.h"
#include "graph/wires.h"
#include "graph/write.h"

namespace merker::graph {
namespace {

constexpr std::size_t kLongestWork = 12;  // statements of a box without logic

// A jump that stays inside the network, or comes into it.
std::optional<Refusal> misledJump(std::span<const Statement> statements) {
  for (std::size_t i = 0; i < statements.size(); ++i)
    if (isJump(statements[i].op) && statements[i].operand.kind == OperandKind::Forbidden)
      return Refusal{i, Reason::Jump};
  for (std::size_t i = 0; i < statements.size(); ++i)
    if (statements[i].intruded) return Refusal{i, Reason::JumpInto};
  return std::nullopt;
}

class NetworkReader {
 public:
  NetworkReader(std::span<const Statement> statements, const Rules& rules, Unfinished unfinished)
      : cursor_(statements), rules_(rules), unfinished_(unfinished), expressions_(cursor_, rules) {}

  Result<Network, Refusal> read() {
    while (!cursor_.atEnd())
      if (!rung()) return cursor_.refusal();
    return std::move(network_);
  }

 private:
  bool rung() {
    cursor_.forget();
    auto logic = expressions_.read(true);
    if (!logic) return false;
    Rung rung;
    if (logic->node) rung.logic.push_back(std::move(*logic->node));
    if (!logic->ended) {
      rung.straight = cursor_.isBld(bld::kStraight) && cursor_.takeIf(Op::BLD);
      while (coil(rung)) {
      }
      if (rung.coils.empty() && (unfinished_ == Unfinished::Refused || !cursor_.atEnd()))
        return blame(rung);
    }
    network_.rungs.push_back(std::move(rung));
    return true;
  }

  bool coil(Rung& rung) {
    if (cursor_.atEnd()) return false;
    for (const Element& element : rules_.elements->elements())
      if (canFollow(element.row.kind, rung) && coil(element, rung)) return true;
    return false;
  }

  // Coils without logic stand only at the beginning of a part, else they would belong to the rung
  // before.
  bool canFollow(ElementClass kind, const Rung& rung) const {
    if (kind == ElementClass::RailCoil) return rung.logic.empty() && rung.coils.empty();
    if (kind != ElementClass::Coil) return false;
    if (!rung.logic.empty()) return true;
    const bool atRail =
        !rung.coils.empty() && rung.coils.front().element->row.kind == ElementClass::RailCoil;
    return unfinished_ == Unfinished::Part && network_.rungs.empty() && !atRail;
  }

  bool coil(const Element& element, Rung& rung) {
    Coil coil;
    coil.element = &element;
    coil.first = cursor_.at();
    coil.values.resize(element.pins.size());
    for (const Item& item : element.items)
      if (!take(item, coil)) {
        cursor_.back(coil.first);
        return false;
      }
    coil.last = cursor_.at();
    rung.coils.push_back(std::move(coil));
    return true;
  }

  bool take(const Item& item, Coil& coil) {
    if (!cursor_.is(item.op)) return false;
    const Statement& statement = cursor_.look();
    const Operand& operand = statement.operand;
    if (operand.kind == OperandKind::Forbidden || statement.target >= 0) return false;
    if (item.kind == ItemKind::Own)
      coil.operand = operand;
    else if (item.kind == ItemKind::Value)
      coil.values[item.pin] = operand;
    else if (operand.kind != OperandKind::None)
      return false;
    cursor_.take();
    return true;
  }

  // Why it does not go on here.
  bool blame(const Rung& rung) {
    if (cursor_.atEnd()) return cursor_.refuse(Reason::NoCoil, cursor_.at() - 1);
    const Op op = cursor_.op();
    if (unknown(0)) return false;
    if (op == Op::CLOSE) return cursor_.refuse(Reason::Brackets);
    if (rung.logic.empty() && beginsCoil()) return cursor_.refuse(Reason::NoLogic);
    if (op == Op::LOAD || op == Op::LOAD_BCD || op == Op::TRANSFER) return accumulator();
    if (!rung.logic.empty() || op == Op::CALL) return cursor_.refuse(Reason::Box);
    return cursor_.refuse(Reason::Operation);
  }

  // Also of several statements: the value and the timer.
  bool beginsCoil() {
    const auto elements = rules_.elements->elements();
    const std::size_t at = cursor_.at();
    return std::any_of(elements.begin(), elements.end(), [this, at](const Element& element) {
      Rung alone;
      const bool found = element.row.kind == ElementClass::Coil && coil(element, alone);
      cursor_.back(at);
      return found;
    });
  }

  // What no picture has, so many statements ahead.
  bool unknown(std::size_t ahead) {
    const std::size_t at = cursor_.at() + ahead;
    const Statement& statement = cursor_.look(ahead);
    const bool forbidden = statement.operand.kind == OperandKind::Forbidden;
    if (statement.op == Op::OTHER)
      cursor_.refuse(Reason::Operation, at);
    else if (forbidden)
      cursor_.refuse(isJump(statement.op) ? Reason::Jump : Reason::Operand, at);
    return forbidden || statement.op == Op::OTHER;
  }

  // A value is loaded and no box takes it: an operation on it that has no box, or its end is
  // missing.
  bool accumulator() {
    for (std::size_t ahead = 1; cursor_.op(ahead) != Op::NOP0 && ahead < kLongestWork; ++ahead)
      if (cursor_.has(ahead) && unknown(ahead)) return false;
    return cursor_.refuse(Reason::Accumulator);
  }

  Cursor cursor_;
  const Rules& rules_;
  Unfinished unfinished_;
  ExpressionReader expressions_;
  Network network_;
};

std::size_t firstDifference(std::span<const Statement> a, const Statements& b) {
  const auto [at, ignored] = std::mismatch(a.begin(), a.end(), b.begin(), b.end());
  return static_cast<std::size_t>(at - a.begin());
}

// The second box of a network.
std::optional<std::size_t> secondBox(const Network& network) {
  std::vector<std::size_t> boxes;
  for (const Rung& rung : network.rungs)
    for (const Node& logic : rung.logic)
      visit(logic, [&boxes](const Node& node) {
        if (node.kind == NodeKind::Box) boxes.push_back(node.last - 1);
      });
  std::sort(boxes.begin(), boxes.end());
  return boxes.size() < 2 ? std::nullopt : std::optional(boxes[1]);
}

}  // namespace

Result<Network, Refusal> read(std::span<const Statement> statements, const Rules& rules,
                              Unfinished unfinished) {
  if (const auto refusal = misledJump(statements)) return *refusal;
  auto network = NetworkReader(statements, rules, unfinished).read();
  if (!network) return network;
  if (const auto box = rules.oneBox ? secondBox(*network) : std::nullopt)
    return Refusal{*box, Reason::OneBox};
  const Statements written = write(*network, rules);
  if (std::equal(statements.begin(), statements.end(), written.begin(), written.end()))
    return network;
  const std::size_t at = firstDifference(statements, written);
  return Refusal{std::min(at, statements.size() - 1), Reason::Order};
}

}  // namespace merker::graph
