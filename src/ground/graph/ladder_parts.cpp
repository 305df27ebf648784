#include "graph/ladder_parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace merker::graph {
namespace {

constexpr int kWireAtMark = kMark - 3;

Picture mark(const std::string& text, const Flows& flow, int textAt, int wireAt) {
  Picture out;
  out.flow = flow;
  out.w = columns(text) + kWireAtMark;
  out.h = 1;
  out.in = wireAt == 0 ? 0 : -1;
  out.wire(wireAt, 0, kWireAtMark);
  out.add({ShapeKind::Text, textAt, 0, columns(text), 0, text, 0});
  return out;
}

}  // namespace

Picture through(Picture box, const Flows& before) {
  const Flows behind = std::exchange(box.flow, before);
  int left = box.w;
  for (const Shape& shape : box.shapes)
    if (shape.kind == ShapeKind::Frame) left = std::min(left, shape.x);
  box.wire(0, box.out, left);
  box.flow = behind;
  box.in = box.out;
  return box;
}

Picture beside(const std::vector<Picture>& parts) {
  Picture out;
  int above = 0;
  for (const Picture& part : parts)
    above = std::max(above, &part == &parts.front() ? part.out : std::max(part.in, 0));
  for (const Picture& part : parts) {
    const int row = &part == &parts.front() ? part.out : std::max(part.in, 0);
    if (&part == &parts.front()) out.in = part.in < 0 ? -1 : above - row + part.in;
    out.place(part, out.w, above - row);
    above += part.out - row;
  }
  out.out = above;
  return out;
}

Picture atEnd(const Picture& coil, int width) {
  Picture out;
  out.flow = coil.flow;
  out.place(coil, width - coil.w, 0);
  out.wire(0, coil.in, width - coil.w);
  out.in = coil.in;
  return out;
}

Picture goesOn(int line, const Flows& flow) {
  return mark(fmt::format(">{}", line), flow, kWireAtMark, 0);
}

Picture comesFrom(int line, const Flows& flow) {
  const std::string text = fmt::format("{}>", line);
  return mark(text, flow, 0, columns(text));
}

}  // namespace merker::graph
