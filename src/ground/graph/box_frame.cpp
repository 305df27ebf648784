#include "graph/box_frame.h"

#include "base/text.h"
#include "graph/flow.h"

namespace merker::graph {
namespace {

std::size_t outsideQuotes(std::string_view text, char wanted) {
  bool quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '"') quoted = !quoted;
    if (text[i] == wanted && !quoted) return i;
  }
  return std::string::npos;
}

class BoxFramer {
 public:
  BoxFramer(const Node& box, const Style& style, const DrawPin& draw)
      : box_(box), german_(style.names == Language::German), draw_(draw) {}

  FrameText frame() {
    const ElementRow& row = box_.element->row;
    out_.title = german_ ? row.kop : row.kopEnglish;
    out_.statement = box_.first;
    out_.of = selectionOf(box_);
    out_.ownInside = row.kind == ElementClass::Call;
    out_.hasOut = box_.continues;
    const bool call = row.kind == ElementClass::Call;
    if (call)
      called(box_.operand.text);
    else
      out_.above = box_.operand.text;
    const bool works = call || row.kind == ElementClass::Move;
    if (works) {
      out_.left.push_back(logicPin("EN", box_.enable, kEnable));
      out_.right.push_back({.name = "ENO"});
    } else if (row.kind == ElementClass::Compare) {
      out_.right.push_back({});
    }
    pins();
    for (const Argument& argument : box_.arguments) this->argument(argument);
    return std::move(out_);
  }

 private:
  // "FB 1, DB 1": the instance stands above the box, as in STEP 7.
  void called(const std::string& operand) {
    const std::size_t comma = outsideQuotes(operand, ',');
    out_.title = trim(std::string_view(operand).substr(0, comma));
    if (comma == std::string::npos) return;
    out_.above = trim(std::string_view(operand).substr(comma + 1));
    out_.whole = operand;
  }

  FramePin logicPin(std::string_view name, const std::vector<Node>& logic, int field) const {
    FramePin pin;
    if (!logic.empty()) pin = draw_(logic.front());
    pin.name = name;
    pin.field = field;
    return pin;
  }

  // The signal goes out at the first pin on the right.
  void pins() {
    for (std::size_t i = 0; i < box_.pins.size(); ++i) {
      const PinRow& row = box_.element->pins[i];
      const std::string_view name = german_ ? row.name : row.english;
      const Pin& pin = box_.pins[i];
      const int field = kFirstPin + static_cast<int>(i);
      if (row.kind == PinKind::Logic)
        out_.left.push_back(logicPin(name, pin.logic, field));
      else if (row.kind == PinKind::Output)
        out_.right.insert(out_.right.begin(), {.name = std::string(name)});
      else
        side(row.kind == PinKind::ValueOut)
            .push_back({.name = std::string(name),
                        .text = pin.operand.text,
                        .field = field,
                        .value = true,
                        .moved = pin.statement});
    }
  }

  void argument(const Argument& argument) {
    const int field = kFirstPin + static_cast<int>(&argument - box_.arguments.data());
    FramePin pin{.name = argument.name, .text = argument.text, .field = field, .value = true};
    for (const Pin& parameter : box_.parameters)
      if (parameter.operand.number == argument.wire && !parameter.logic.empty())
        pin = logicPin(argument.name, parameter.logic, field);
    side(argument.output).push_back(std::move(pin));
  }

  std::vector<FramePin>& side(bool right) { return right ? out_.right : out_.left; }

  const Node& box_;
  bool german_;
  const DrawPin& draw_;
  FrameText out_;
};

}  // namespace

FrameText boxFrame(const Node& box, const Style& style, const DrawPin& draw) {
  return BoxFramer(box, style, draw).frame();
}

}  // namespace merker::graph
