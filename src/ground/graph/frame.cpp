#include "graph/frame.h"

#include <algorithm>

namespace merker::graph {
namespace {

constexpr int kShortestWire = 2;  // columns

class Framer {
 public:
  explicit Framer(const FrameText& text) : text_(text) {}

  Picture draw() {
    placeRows();
    placeColumns();
    for (std::size_t i = 0; i < text_.left.size(); ++i) left(text_.left[i], rows_[i]);
    for (std::size_t i = 0; i < text_.right.size(); ++i) right(text_.right[i], outRow(i));
    box();
    picture_.flow = text_.flow;
    picture_.w = x_ + width_;
    for (const FramePin& pin : text_.right)
      if (!pin.text.empty()) picture_.w = std::max(picture_.w, x_ + width_ + 1 + columns(pin.text));
    picture_.out = text_.hasOut ? outRow(0) : rows_.empty() ? top_ + 1 : rows_.front();
    if (text_.hasOut) picture_.wire(x_ + width_, picture_.out, picture_.w - x_ - width_);
    picture_.h = std::max(bottom_ + 1, picture_.h);
    return std::move(picture_);
  }

 private:
  bool hasAbove() const { return !text_.above.empty(); }

  // Each pin is a row; one with logic stands where its logic goes out.
  void placeRows() {
    const int titleRow = text_.title.empty() ? 0 : 1;
    int used = 0;  // rows of the logic so far
    int next = (hasAbove() ? 1 : 0) + 1 + titleRow;
    for (const FramePin& pin : text_.left) {
      int row = next;
      if (pin.logic) {
        row = std::max(row, used + pin.logic->out);
        used = row - pin.logic->out + pin.logic->h;
      } else if (!pin.text.empty()) {
        row = std::max(row, used);  // beside logic there is no room for its operand
        used = row + 1;
      }
      if (rows_.empty()) used = std::max(used, row + 1);  // the signal comes in
      rows_.push_back(row);
      next = row + 1;
    }
    top_ = (rows_.empty() ? 1 + titleRow + (hasAbove() ? 1 : 0) : rows_.front()) - titleRow - 1;
    const int last = rows_.empty() ? top_ + titleRow : rows_.back();
    bottom_ = std::max(last, lastRight()) + 1;
  }

  int lastRight() const { return text_.right.empty() ? 0 : outRow(text_.right.size() - 1); }
  int outRow(std::size_t pin) const {
    if (rows_.empty()) return top_ + 1 + static_cast<int>(pin);
    const int first = text_.outLast ? rows_.back() : rows_.front();
    return first + static_cast<int>(pin);
  }

  void placeColumns() {
    int names = 0, outNames = 0;
    for (const FramePin& pin : text_.left) {
      names = std::max(names, columns(pin.name));
      int needs = pin.text.empty() ? 0 : text_.blank + columns(pin.text) + 1;
      if (pin.logic) needs = pin.logic->w + kShortestWire;
      x_ = std::max(x_, needs + (pin.negated ? 1 : 0));
    }
    for (const FramePin& pin : text_.right) outNames = std::max(outNames, columns(pin.name));
    if (text_.title.empty()) names += 2;
    const int inside =
        std::max(names + outNames + (outNames > 0 ? 1 : 0), columns(text_.title) + 2);
    width_ = std::max({inside, 3, columns(text_.above) - 2}) + 2;
  }

  void left(const FramePin& pin, int row) {
    const bool alone = text_.title.empty() && &pin == text_.left.data();  // "=" in its small box
    if (!pin.name.empty()) write(alone ? centred(pin.name) : x_ + 1, row, pin.name);
    if (isOpen(pin)) field(x_ + 1, row, pin);
    const int end = pin.negated ? x_ - 1 : x_;
    if (pin.negated)
      picture_.add(
          {ShapeKind::Negation, end, row, 1, 0, {}, text_.statement, Ends::AtEdges, {}, pin.flow});
    if (pin.logic) {
      const Picture& logic = *pin.logic;
      picture_.place(logic, 0, row - logic.out);
      picture_.flow = logic.flow;
      picture_.wire(logic.w, row, end - logic.w);
      if (&pin == text_.left.data() && logic.in >= 0) picture_.in = row - logic.out + logic.in;
      if (pin.fromRail)
        picture_.add({ShapeKind::Rail, 0, row - logic.out + std::max(logic.in, 0), 0, 0, {}, 0});
    } else if (!pin.text.empty()) {
      const int begin = end - 1 - columns(pin.text);
      operand(begin, row, pin);
      wire(end - 1, row, pin);
    }
  }

  void operand(int x, int row, const FramePin& pin) {
    write(x, row, pin.text, selection(pin));
    if (!pin.moved) return;
    picture_.shapes.back().value = true;
    picture_.shapes.back().statement = *pin.moved;
  }

  static bool isOpen(const FramePin& pin) {
    return pin.field != kNoPin && !pin.logic && pin.text.empty();
  }
  void field(int x, int row, const FramePin& pin) {
    picture_.add({ShapeKind::Field,
                  x,
                  row,
                  std::max(columns(pin.name), 1),
                  0,
                  {},
                  text_.statement,
                  Ends::AtEdges,
                  selection(pin)});
  }
  Selection selection(const FramePin& pin) const {
    if (pin.of.node >= 0 || pin.field == kNoPin) return pin.of;
    return {text_.of.node, pin.field, text_.of.first};
  }
  void wire(int x, int row, const FramePin& pin) {
    picture_.flow = pin.negated ? pin.before : pin.flow;
    picture_.wire(x, row, 1);
    picture_.shapes.back().value = pin.value;
  }

  void right(const FramePin& pin, int row) {
    if (!pin.name.empty()) write(x_ + width_ - 1 - columns(pin.name), row, pin.name);
    if (isOpen(pin)) field(x_ + width_ - 1 - columns(pin.name), row, pin);
    if (pin.text.empty()) return;
    wire(x_ + width_, row, pin);
    operand(x_ + width_ + 1, row, pin);
  }

  void box() {
    picture_.add({ShapeKind::Frame,
                  x_,
                  top_,
                  width_,
                  bottom_ - top_ + 1,
                  {},
                  text_.statement,
                  Ends::AtEdges,
                  text_.of});
    if (!text_.title.empty())
      write(centred(text_.title), top_ + 1, text_.title, text_.ownInside ? own() : Selection{});
    if (text_.ownInside) picture_.shapes.back().whole = text_.whole;
    if (hasAbove()) write(std::max(0, centred(text_.above)), top_ - 1, text_.above, own());
    if (hasAbove()) picture_.shapes.back().whole = text_.whole;
  }
  int centred(const std::string& text) const { return x_ + (width_ - columns(text)) / 2; }
  Selection own() const { return {text_.of.node, kOwn, text_.of.first}; }
  void write(int x, int y, const std::string& text, const Selection& of = {}) {
    picture_.add(
        {ShapeKind::Text, x, y, columns(text), 0, text, text_.statement, Ends::AtEdges, of});
  }

  const FrameText& text_;
  Picture picture_;
  std::vector<int> rows_;
  int top_ = 0, bottom_ = 0, x_ = 0, width_ = 0;
};

}  // namespace

Picture frame(const FrameText& text) { return Framer(text).draw(); }

}  // namespace merker::graph
