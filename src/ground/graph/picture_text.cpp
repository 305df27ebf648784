#include <algorithm>
#include <map>

#include "graph/picture.h"

namespace merker::graph {
namespace {

enum Direction : unsigned { Left = 1, Right = 2, Up = 4, Down = 8 };

// By the directions in which lines leave a place.
constexpr std::string_view kLines[] = {" ", "─", "─", "─", "│", "┘", "└", "┴",
                                       "│", "┐", "┌", "┬", "│", "┤", "├", "┼"};

class Canvas {
 public:
  void draw(const Picture& picture) {
    for (const Shape& shape : picture.shapes)
      if (shape.kind == ShapeKind::Wire || shape.kind == ShapeKind::Rail) line(shape);
    for (const Shape& shape : picture.shapes) symbol(shape);
  }

  std::vector<std::string> lines() const {
    std::vector<std::string> out;
    for (const auto& [y, row] : rows_) {
      out.resize(static_cast<std::size_t>(y) + 1);
      int x = 0;
      for (const auto& [at, cell] : row) {
        out.back().append(static_cast<std::size_t>(std::max(at - x, 0)), ' ');
        out.back() += cell.text.empty() ? kLines[cell.lines] : std::string_view(cell.text);
        x = at + 1;
      }
      out.back().erase(out.back().find_last_not_of(' ') + 1);
    }
    return out;
  }

 private:
  struct Cell {
    unsigned lines = 0;
    std::string text;
  };

  Cell* at(int x, int y) {
    if (x < 0 || y < 0) return nullptr;
    return &rows_[y][x];
  }
  void join(int x, int y, unsigned directions) {
    if (Cell* cell = at(x, y)) cell->lines |= directions;
  }

  void line(const Shape& shape) {
    for (int i = 0; i < shape.w; ++i) {
      const bool begins = i == 0 && shape.ends == Ends::BeginsInside;
      const bool ends = i == shape.w - 1 && shape.ends == Ends::EndsInside;
      join(shape.x + i, shape.y, (begins ? 0u : unsigned{Left}) | (ends ? 0u : unsigned{Right}));
    }
    for (int i = 0; i <= shape.h && shape.w == 0; ++i)
      join(shape.x, shape.y + i, (i > 0 ? unsigned{Up} : 0u) | (i < shape.h ? unsigned{Down} : 0u));
  }

  void symbol(const Shape& shape) {
    switch (shape.kind) {
      case ShapeKind::Wire:
      case ShapeKind::Field:
        break;
      case ShapeKind::Rail:
        for (int i = 0; i <= shape.h; ++i) write(shape.x, shape.y + i, rail(shape.x, shape.y + i));
        break;
      case ShapeKind::Frame:
        frame(shape);
        break;
      case ShapeKind::Text:
        write(shape.x, shape.y, shape.text);
        break;
      case ShapeKind::Contact:
        write(shape.x, shape.y, "┤" + padded(shape) + "├");
        break;
      case ShapeKind::Coil:
        write(shape.x, shape.y, "(" + padded(shape) + ")");
        break;
      case ShapeKind::Negation:
        write(shape.x, shape.y, "o");
        break;
    }
  }

  std::string rail(int x, int y) {
    const auto row = rows_.find(y);
    if (row == rows_.end()) return "│";
    const auto next = row->second.find(x + 1);
    const bool leaves =
        next != row->second.end() && next->second.text.empty() && (next->second.lines & Left) != 0;
    return leaves ? "├" : "│";
  }

  static std::string padded(const Shape& shape) {
    const int blanks = shape.w - 2 - columns(shape.text);
    return std::string(static_cast<std::size_t>(std::max(blanks / 2 + blanks % 2, 0)), ' ') +
           shape.text + std::string(static_cast<std::size_t>(std::max(blanks / 2, 0)), ' ');
  }

  void frame(const Shape& shape) {
    const int right = shape.x + shape.w - 1, bottom = shape.y + shape.h - 1;
    for (int x = shape.x + 1; x < right; ++x) {
      write(x, shape.y, "─");
      write(x, bottom, "─");
    }
    for (int y = shape.y + 1; y < bottom; ++y) {
      side(shape.x, y, shape.x - 1, Right, "┤");
      side(right, y, right + 1, Left, "├");
    }
    write(shape.x, shape.y, "┌");
    write(right, shape.y, "┐");
    write(shape.x, bottom, "└");
    write(right, bottom, "┘");
  }

  // The side of a box, where a wire may end.
  void side(int x, int y, int beside, unsigned towards, const std::string& joined) {
    const auto row = rows_.find(y);
    bool wire = false;
    if (row != rows_.end())
      if (const auto cell = row->second.find(beside); cell != row->second.end())
        wire = (cell->second.lines & towards) != 0 || cell->second.text == "o";
    write(x, y, wire ? joined : "│");
  }

  void write(int x, int y, std::string_view text) {
    while (!text.empty()) {
      std::size_t length = 1;
      while (length < text.size() && (static_cast<unsigned char>(text[length]) & 0xC0) == 0x80)
        ++length;
      if (Cell* cell = at(x++, y)) cell->text = text.substr(0, length);
      text.remove_prefix(length);
    }
  }

  std::map<int, std::map<int, Cell>> rows_;
};

}  // namespace

Result<std::vector<std::string>, Reason> toText(const Picture& picture) {
  if (std::int64_t{picture.w} * picture.h > kMostCells) return Reason::Size;
  Canvas canvas;
  canvas.draw(picture);
  return canvas.lines();
}

}  // namespace merker::graph
