// Whatever a picture shows can be named in an edit: what a click selects, the text must know.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "graph/fup.h"
#include "graph/kop.h"
#include "networks/source_edit.h"
#include "projects.h"

namespace merker::networks {
namespace {

using graph::Shape;
using graph::ShapeKind;

// Calls `visit` for all shapes of all networks with a picture, as KOP and as FUP.
using VisitShape = std::function<void(const source::SourceFile&, const Surroundings&, const Block&,
                                      const Network&, const Shape&)>;
void forEachShape(const char* extension, const VisitShape& visit) {
  forEachProject("examples", extension, [&](const compilation::Build& build) {
    const Surroundings around = surroundingsOf(build);
    for (const source::SourceFile& file : build.project.sources)
      for (const Block& one : blocks(file, around)) {
        const auto block = blockAt(file, one.line, around);
        for (const Network& network : block->networks) {
          if (!network.tree) continue;
          std::vector<graph::Picture> pictures{graph::fup(*network.tree, {})};
          if (graph::fitsKop(*network.tree, *block->rules))
            pictures.push_back(graph::kop(*network.tree, {}));
          for (const graph::Picture& picture : pictures)
            for (const Shape& shape : picture.shapes)
              if (shape.of.node >= 0) visit(file, around, *block, network, shape);
        }
      }
  });
}

std::string where(const source::SourceFile& file, const Network& network, const Shape& shape) {
  return fmt::format("{}:{} \"{}\" {}:{}/{}", file.name(), network.source.line, shape.text,
                     shape.of.node, shape.of.pin, shape.of.first);
}

void expectOperands(const char* extension, std::size_t atLeast) {
  std::size_t count = 0;
  forEachShape(extension, [&](const source::SourceFile& file, const Surroundings& around,
                              const Block& block, const Network& network, const Shape& shape) {
    if (shape.kind != ShapeKind::Text || shape.of.pin < graph::kOwn) return;
    graph::Edit edit;
    edit.action = graph::Action::SetOperand;
    edit.at = shape.of;
    edit.operands.emplace_back().text = shape.whole.empty() ? shape.text : shape.whole;
    const auto done = networks::edit(file, block.line, network.number, edit, around);
    ASSERT_TRUE(done) << where(file, network, shape) << ": "
                      << text(done.error(), graph::Language::English);
    EXPECT_TRUE(done->from == done->to && done->lines.empty()) << where(file, network, shape);
    ++count;
  });
  EXPECT_GE(count, atLeast);
}

TEST(Selections, ofOperandsAreTheirs) {
  expectOperands(".awl", 500);
  expectOperands(".s5", 100);
}

std::vector<graph::Edit> usualEdits(const graph::Selection& at) {
  std::vector<graph::Edit> edits;
  for (const char* element : {"CONTACT", "COIL", "AND", "OR"}) {
    graph::Edit& edit = edits.emplace_back();
    edit.element = element;
    edit.operands.emplace_back().text = "E 5.5";
  }
  for (const graph::Action action :
       {graph::Action::AddInput, graph::Action::Negate, graph::Action::Delete}) {
    graph::Edit& edit = edits.emplace_back();
    edit.action = action;
  }
  for (graph::Edit& edit : edits) edit.at = at;
  return edits;
}

// Of every third element: all of them take half a minute under sanitizers.
void expectEdits(const char* extension) {
  std::set<std::string> seen;
  std::size_t number = 0;
  forEachShape(extension, [&](const source::SourceFile& file, const Surroundings& around,
                              const Block& block, const Network& network, const Shape& shape) {
    if (shape.of.pin != graph::kNoPin || !seen.insert(where(file, network, shape)).second) return;
    if (number++ % 3 != 0) return;
    for (const graph::Edit& edit : usualEdits(shape.of)) {
      const auto done = networks::edit(file, block.line, network.number, edit, around);
      if (done) continue;
      const graph::EditProblem problem = done.error().problem;
      EXPECT_NE(problem, graph::EditProblem::NoNode) << where(file, network, shape);
      EXPECT_NE(problem, graph::EditProblem::Ambiguous) << where(file, network, shape);
      EXPECT_NE(edit.action, graph::Action::Delete) << where(file, network, shape);
    }
  });
}

// What cannot be done has a reason that a user understands.
TEST(Selections, ofEverythingCanBeEdited) {
  expectEdits(".awl");
  expectEdits(".s5");
}

}  // namespace
}  // namespace merker::networks
