#include "graph/picture.h"

#include <algorithm>

#include "base/text.h"

namespace merker::graph {

int columns(std::string_view text) { return static_cast<int>(characterCount(text)); }

void Picture::add(Shape shape) { shapes.push_back(std::move(shape)); }

void Picture::wire(int x, int y, int count, Ends ends) {
  if (count > 0) add({ShapeKind::Wire, x, y, count, 0, {}, 0, ends, {}, flow});
}

void Picture::down(int x, int y, int rows) {
  if (rows > 0) add({ShapeKind::Wire, x, y, 0, rows, {}, 0, Ends::AtEdges, {}, flow});
}

void Picture::place(const Picture& other, int x, int y) {
  for (Shape shape : other.shapes) {
    shape.x += x;
    shape.y += y;
    add(std::move(shape));
  }
  w = std::max(w, x + other.w);
  h = std::max(h, y + other.h);
}

Picture attached(const Picture& before, const std::vector<Picture>& parts) {
  const int need = std::max(parts.front().in, 0);  // rows above the signal
  const int row = std::max(before.h == 0 ? 0 : before.out, need);
  const int lower = before.h == 0 ? 0 : row - before.out, x = before.w;
  Picture out;
  out.flow = before.flow;
  out.place(before, 0, lower);
  out.in = before.in < 0 ? -1 : before.in + lower;
  if (before.h == 0) out.in = row;
  int y = row - need, last = row;
  for (const Picture& part : parts) {
    const bool first = &part == &parts.front();
    last = y + std::max(part.in, 0);
    out.place(part, x + kJoint, y);
    out.wire(x, last, kJoint, first ? Ends::AtEdges : Ends::BeginsInside);
    y += part.h;
  }
  out.down(x, row, last - row);
  out.out = row;
  return out;
}

}  // namespace merker::graph
