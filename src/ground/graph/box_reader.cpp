#include "graph/box_reader.h"

#include "graph/expression_reader.h"

namespace merker::graph {
namespace {

bool isValue(const Operand& operand) {
  return operand.kind == OperandKind::Value || operand.kind == OperandKind::Number;
}

}  // namespace

bool BoxReader::couldBegin(const Element& element, const Cursor& cursor) {
  std::size_t ahead = cursor.is(Op::SPBNB) ? 1 : 0;
  if (element.row.kind == ElementClass::Call) return cursor.is(Op::CALL, ahead);
  bool first = true, optional = false;
  for (const Item& item : element.items) {
    if (item.kind == ItemKind::Begin && first)
      optional = true;
    else if (item.kind == ItemKind::Logic ? !first : item.kind >= ItemKind::Begin)
      break;
    if (item.kind == ItemKind::Begin || item.kind == ItemKind::Logic) continue;
    const Op op = item.kind == ItemKind::Bld ? Op::BLD : item.op;
    if (!cursor.is(op, ahead)) return optional && first && cursor.is(Op::NOP0, ahead);
    first = false;
    ++ahead;
  }
  return true;
}

bool BoxReader::read(const Element& element, std::optional<Node>& before,
                     std::vector<Pin>& parameters, Node& box) {
  const std::size_t begin = cursor_.at();
  element_ = &element;
  box_ = {};
  box_.kind = NodeKind::Box;
  box_.element = &element;
  box_.pins.resize(element.pins.size());
  box_.first = before ? before->first : begin;
  before_ = &before;
  beforeUsed_ = false;
  const bool works =
      element.row.kind == ElementClass::Move || element.row.kind == ElementClass::Call;
  const bool fits = works ? working(parameters) : items(0, element.items.size());
  if (!fits || (before && !beforeUsed_)) {
    cursor_.back(begin);
    return false;
  }
  if (element.row.kind == ElementClass::Compare) box_.continues = true;
  if (element.row.kind == ElementClass::Call) parameters.clear();
  box_.last = cursor_.at();
  box = std::move(box_);
  before.reset();
  return true;
}

bool BoxReader::items(std::size_t from, std::size_t to) {
  for (std::size_t i = from; i < to; ++i) {
    const Item& next = element_->items[i];
    if (next.kind == ItemKind::Begin) {
      if (!group(i)) return false;
      i += next.number;
    } else if (!item(next)) {
      return false;
    }
  }
  return true;
}

bool BoxReader::item(const Item& item) {
  switch (item.kind) {
    case ItemKind::Logic:
      return logic(item.pin);
    case ItemKind::Own:
      return own(item.op);
    case ItemKind::Value:
      return value(item);
    case ItemKind::Plain:
      return cursor_.is(item.op) && cursor_.look().operand.kind == OperandKind::None &&
             cursor_.takeIf(item.op);
    case ItemKind::Bld:
      return cursor_.isBld(item.number) && cursor_.takeIf(Op::BLD);
    case ItemKind::Output:
      return output(item);
    case ItemKind::Begin:
    case ItemKind::End:
      break;
  }
  return false;
}

bool BoxReader::logic(std::size_t pin) {
  if (*before_ && !beforeUsed_) {
    box_.pins[pin].logic.push_back(**before_);
    beforeUsed_ = true;
    return true;
  }
  auto logic = expressions_.read(false);
  if (!logic || !logic->node) return false;
  box_.pins[pin].logic.push_back(std::move(*logic->node));
  return true;
}

bool BoxReader::own(Op op) {
  if (!cursor_.is(op)) return false;
  const Operand& operand = cursor_.look().operand;
  if (box_.operand.kind == OperandKind::None) {
    if (operand.kind == OperandKind::Forbidden) return false;
    box_.operand = operand;
  } else if (!(operand == box_.operand)) {
    return false;
  }
  cursor_.take();
  return true;
}

bool BoxReader::value(const Item& item) {
  if (!cursor_.is(item.op) || !isValue(cursor_.look().operand)) return false;
  box_.pins[item.pin].statement = cursor_.at();
  box_.pins[item.pin].operand = cursor_.take().operand;
  return true;
}

// What may be left out: as many statements NOP 0 stand for it.
bool BoxReader::group(std::size_t begin) {
  const std::size_t at = cursor_.at(), end = begin + element_->items[begin].number;
  const Node kept = box_;
  const bool used = beforeUsed_;
  if (items(begin + 1, end)) return true;
  cursor_.back(at);
  box_ = kept;
  beforeUsed_ = used;
  for (std::uint32_t i = 0; i < element_->items[end].number; ++i)
    if (!cursor_.takeIf(Op::NOP0)) return false;
  for (std::size_t i = begin; i < end; ++i) {
    const ItemKind kind = element_->items[i].kind;
    if (kind == ItemKind::Logic || kind == ItemKind::Value)
      box_.pins[element_->items[i].pin].open = true;
  }
  return true;
}

bool BoxReader::output(const Item& item) {
  if (cursor_.is(Op::AND) && cursor_.look().operand == box_.operand) {
    cursor_.take();
    box_.continues = true;
    return true;
  }
  box_.pins[item.pin].open = true;
  return cursor_.takeIf(Op::NOP0);
}

// [SPBNB] the work of the box, its end.
bool BoxReader::working(std::vector<Pin>& parameters) {
  std::int32_t target = -1;
  if (*before_) {
    if (!cursor_.is(Op::SPBNB) || cursor_.look().target < 0) return false;
    target = cursor_.take().target;
    box_.enable.push_back(**before_);
    beforeUsed_ = true;
  }
  const bool done = element_->row.kind == ElementClass::Call ? call(parameters)
                                                             : items(0, element_->items.size());
  return done && end(target);
}

bool BoxReader::call(std::vector<Pin>& parameters) {
  if (!cursor_.is(Op::CALL)) return false;
  const Statement& statement = cursor_.take();
  box_.operand = statement.operand;
  box_.arguments = statement.arguments;
  box_.parameters = parameters;
  if (!box_.parameters.empty() && box_.parameters[0].logic[0].first < box_.first)
    box_.first = box_.parameters[0].logic[0].first;
  return true;
}

bool BoxReader::eno(Eno how) {
  const std::size_t at = cursor_.at();
  const bool overflow = cursor_.is(Op::AND_NOT) && cursor_.look().operand == rules_.overflow;
  if (how == Eno::Overflow ? overflow : cursor_.is(Op::SET)) {
    cursor_.take();
    if (cursor_.takeIf(Op::SAVE) && cursor_.takeIf(Op::CLR)) {
      box_.eno = how;
      return true;
    }
  }
  cursor_.back(at);
  return false;
}

// [how ENO comes about] _001: U BIE, or NOP 0.
bool BoxReader::end(std::int32_t target) {
  if (element_->row.kind != ElementClass::Call && !eno(Eno::Always)) eno(Eno::Overflow);
  if (target >= 0 && static_cast<std::size_t>(target) != cursor_.at()) return false;
  if (cursor_.is(Op::AND) && cursor_.look().operand == rules_.binaryResult &&
      (box_.eno != Eno::None || element_->row.kind == ElementClass::Call)) {
    cursor_.take();
    box_.continues = true;
    return true;
  }
  return box_.eno == Eno::None && cursor_.takeIf(Op::NOP0);
}

}  // namespace merker::graph
