#include <fmt/format.h>

#include <algorithm>

#include "base/xml.h"
#include "graph/picture.h"

namespace merker::graph {
namespace {

// Pixels of a column and of a row; a wire runs through the middle of its row.
constexpr int kColumn = 9, kRow = 20, kMargin = 12, kTextSize = 14;

// Colours are for whoever shows it: `currentColor` is the line.
constexpr std::string_view kStyle =
    "line,rect,path{stroke:currentColor;stroke-width:1.5;fill:none}"
    ".rail{stroke-width:3}"
    "text{font-family:'DejaVu Sans Mono',Consolas,monospace;fill:currentColor}";

class Drawing {
 public:
  std::string draw(const Picture& picture, std::string_view title) {
    for (const Shape& shape : picture.shapes) this->shape(shape);
    int right = picture.w;
    for (const Shape& shape : picture.shapes) right = std::max(right, shape.x + shape.w);
    const int width = right * kColumn + 2 * kMargin, height = picture.h * kRow + 2 * kMargin;
    return fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" "
        "height=\"{1}\" role=\"img\">\n<title>{2}</title>\n<style>{3}</style>\n{4}</svg>\n",
        width, height, xmlText(title), kStyle, out_);
  }

 private:
  static int left(int x) { return kMargin + x * kColumn; }
  static double centre(int x) { return left(x) + kColumn / 2.0; }
  static int top(int y) { return kMargin + y * kRow; }
  static int middle(int y) { return top(y) + kRow / 2; }

  void line(double x1, double y1, double x2, double y2, std::string_view more = "") {
    out_ +=
        fmt::format("<line x1=\"{}\" y1=\"{}\" x2=\"{}\" y2=\"{}\"{}/>\n", x1, y1, x2, y2, more);
  }
  void write(int x, int y, int columnCount, std::string_view text) {
    if (text.empty()) return;
    out_ += fmt::format(
        "<text x=\"{}\" y=\"{}\" font-size=\"{}\" textLength=\"{}\" "
        "lengthAdjust=\"spacingAndGlyphs\">{}</text>\n",
        left(x), middle(y) + 5, kTextSize, columnCount * kColumn, xmlText(text));
  }

  // Its statement stands in the picture, so that whoever shows it can tell them apart.
  void shape(const Shape& shape) {
    const bool named = shape.kind == ShapeKind::Contact || shape.kind == ShapeKind::Coil ||
                       shape.kind == ShapeKind::Frame;
    if (named) out_ += fmt::format("<g data-statement=\"{}\">\n", shape.statement);
    draw(shape);
    if (named) out_ += "</g>\n";
  }

  void draw(const Shape& shape) {
    const int y = middle(shape.y);
    switch (shape.kind) {
      case ShapeKind::Wire:
        wire(shape);
        break;
      case ShapeKind::Rail:
        rail(shape);
        break;
      case ShapeKind::Frame:
        out_ += fmt::format("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"/>\n", left(shape.x),
                            y, shape.w * kColumn, (shape.h - 1) * kRow);
        break;
      case ShapeKind::Text:
        write(shape.x, shape.y, shape.w, shape.text);
        break;
      case ShapeKind::Contact:
        contact(shape);
        break;
      case ShapeKind::Coil:
        coil(shape);
        break;
      case ShapeKind::Negation:
        out_ += fmt::format(
            "<circle cx=\"{}\" cy=\"{}\" r=\"4\" fill=\"none\" "
            "stroke=\"currentColor\" stroke-width=\"1.5\"/>\n",
            left(shape.x + 1) - 4.5, y);
        break;
      case ShapeKind::Field:
        break;
    }
  }

  // At the right edge of its column, where wires begin; a short one inside a picture at the left.
  void rail(const Shape& shape) {
    const int x = left(shape.h > 0 ? shape.x + 1 : shape.x);
    line(x, top(shape.y), x, top(shape.y + shape.h + 1), " class=\"rail\"");
  }

  void wire(const Shape& shape) {
    const int y = middle(shape.y);
    if (shape.w == 0) return line(centre(shape.x), y, centre(shape.x), middle(shape.y + shape.h));
    const bool begins = shape.ends == Ends::BeginsInside, ends = shape.ends == Ends::EndsInside;
    line(begins ? centre(shape.x) : left(shape.x), y,
         ends ? centre(shape.x + shape.w - 1) : left(shape.x + shape.w), y);
  }

  // Two strokes, with what stands between them.
  void contact(const Shape& shape) {
    const double from = left(shape.x) + 4, to = left(shape.x + shape.w) - 4;
    const int y = middle(shape.y), half = kRow / 2 - 2;
    line(left(shape.x), y, from, y);
    line(to, y, left(shape.x + shape.w), y);
    line(from, y - half, from, y + half);
    line(to, y - half, to, y + half);
    if (shape.text == "/")
      line(from, y + half, to, y - half);
    else
      write(shape.x + (shape.w - columns(shape.text)) / 2, shape.y, columns(shape.text),
            shape.text);
  }

  void coil(const Shape& shape) {
    const double from = left(shape.x) + 2, to = left(shape.x + shape.w) - 2;
    const int y = middle(shape.y), half = kRow / 2 - 2;
    for (const auto& [x, bend] : {std::pair{from + 4, -6.0}, std::pair{to - 4, 6.0}})
      out_ += fmt::format("<path d=\"M{0} {1} Q{2} {3} {0} {4}\"/>\n", x, y - half, x + bend, y,
                          y + half);
    line(left(shape.x), y, from + 1, y);
    line(to - 1, y, left(shape.x + shape.w), y);
    write(shape.x + (shape.w - columns(shape.text)) / 2, shape.y, columns(shape.text), shape.text);
  }

  std::string out_;
};

}  // namespace

std::string toSvg(const Picture& picture, std::string_view title) {
  return Drawing().draw(picture, title);
}

}  // namespace merker::graph
