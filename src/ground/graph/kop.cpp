#include "graph/kop.h"

#include <algorithm>

#include "graph/branches.h"
#include "graph/ladder_elements.h"
#include "graph/ladder_parts.h"

namespace merker::graph {
namespace {

class Ladder {
 public:
  explicit Ladder(const Style& style) : style_(style), elements_(style) {}

  Picture draw(const Network& network) {
    Picture picture;
    const auto roots = paths(network);
    int width = 0, bottom = 0;
    for (const auto& root : roots) width = std::max(width, widthOfRung(*root));
    lines_ = 0;
    for (const auto& root : roots) {
      const Picture rung = this->rung(*root, width);
      picture.place(rung, 1, picture.h);
      bottom = picture.h;
      picture.h += kGap;
    }
    picture.add({ShapeKind::Rail, 0, 0, 0, std::max(bottom - 1, 1), {}, 0});
    picture.h = std::max(bottom, 2);
    return picture;
  }

 private:
  // Paths

  int widthBehind(const Path& path) {
    int behind = 0;
    for (const auto& tail : path.tails) behind = std::max(behind, kJoint + widthOf(*tail));
    for (const Coil& coil : path.coils) behind = std::max(behind, kJoint + elements_.coil(coil).w);
    return behind;
  }
  int widthOf(const Path& path) {
    return (path.logic.empty() ? 0 : elements_.node(path.logic.front()).w) + widthBehind(path);
  }
  int widthOfRung(const Path& path) {
    const Lines lines = linesOf(path);
    int width = lines.last.w + widthBehind(path);
    for (const Picture& line : lines.full) width = std::max(width, line.w);
    return width;
  }

  Picture path(const Path& path, int width) {
    elements_.signals().begin();
    return ended(path.logic.empty() ? Picture{} : elements_.node(path.logic.front()), path, width);
  }

  Picture rung(const Path& path, int width) {
    const Lines lines = linesOf(path);
    Picture out;
    for (const Picture& line : lines.full) out.place(line, 0, out.h);
    out.place(ended(lines.last, path, width), 0, out.h);
    return out;
  }

  // `out` with what goes on behind it.
  Picture ended(Picture out, const Path& path, int width) {
    const Flows flow = elements_.signals().now();
    const int left = width - out.w - kJoint;
    std::vector<Picture> parts;
    for (const Coil& coil : path.coils) parts.push_back(atEnd(elements_.coil(coil), left));
    for (const auto& tail : path.tails) parts.push_back(this->path(*tail, left));
    out.flow = flow;
    return parts.empty() ? out : attached(out, parts);
  }

  // Lines

  // The logic of a rung that is wider than the page.
  struct Lines {
    std::vector<Picture> full;  // each ends with a mark, with which the next one begins
    Picture last;
  };

  Lines linesOf(const Path& path) {
    Lines out;
    const int room = style_.widest - widthBehind(path) - 2 * kMark;
    elements_.signals().begin();
    if (path.logic.empty()) return out;
    const Node& logic = path.logic.front();
    if (style_.widest == 0 || logic.kind != NodeKind::Series || logic.bracketed)
      out.last = elements_.node(logic, Begin::AtRail);
    else
      wrap(logic, room, out);
    return out;
  }

  void wrap(const Node& series, int room, Lines& out) {
    Signals outer = elements_.signals().enter(series);
    std::vector<Picture> parts;
    int width = 0;
    for (const Node& child : series.children) {
      const Flows before = elements_.signals().now();
      Picture part =
          elements_.node(child, &child == &series.children.front() ? Begin::AtRail : Begin::Inside);
      if (width > 0 && width + part.w > room) {
        parts.push_back(goesOn(++lines_, before));
        out.full.push_back(beside(parts));
        parts = {comesFrom(lines_, before)};
        width = 0;
      }
      width += part.w;
      parts.push_back(std::move(part));
    }
    elements_.signals().leave(series, std::move(outer));
    out.last = beside(parts);
    out.last.flow = elements_.signals().now();
  }

  const Style& style_;
  LadderElements elements_;
  int lines_ = 0;  // that go on below, so far
};

}  // namespace

Picture kop(const Network& network, const Style& style) { return Ladder(style).draw(network); }

}  // namespace merker::graph
