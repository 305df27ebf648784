// Any edits of the networks of the examples, one after the other, in their texts: what stays, what
// the compiler makes of it, and the way back.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <memory>

#include "compiled.h"
#include "graph/locate.h"
#include "graph/missing.h"
#include "graph/write.h"
#include "networks/source_edit.h"
#include "projects.h"

namespace merker::networks {
namespace {

// A network with a picture in a file of a program.
struct Place {
  std::shared_ptr<const compilation::Build> build;
  const source::SourceFile* file = nullptr;
  std::string block;
  std::uint32_t line = 1;  // of the block
  std::size_t network = 1;
};

std::vector<Place> placesOf(const char* extension) {
  std::vector<Place> places;
  forEachProject("examples", extension, [&](compilation::Build built) {
    const auto build = std::make_shared<const compilation::Build>(std::move(built));
    const Surroundings around = surroundingsOf(*build);
    for (const source::SourceFile& file : build->project.sources)
      for (const Block& found : blocks(file, around)) {
        const auto block = blockAt(file, found.line, around);
        for (const Network& network : block->networks)
          if (network.tree)
            places.push_back({build, &file, found.name, found.line, network.number});
      }
  });
  return places;
}

int below(std::size_t limit) {
  return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(0, static_cast<int>(limit)));
}

// One that the network has, or one that every program may have.
graph::Operand anyOperand(const graph::Statements& statements) {
  static constexpr const char* kTexts[] = {"E 0.0", "M 1.0", "A 4.0", "MW 10", "5",
                                           "T 1",   "Z 1",   "M001",  "FC 1",  ""};
  graph::Operand operand;
  const auto own = static_cast<std::size_t>(below(statements.size() + 6));
  if (own < statements.size())
    operand.text = statements[own].operand.text;
  else
    operand.text = kTexts[below(std::size(kTexts))];
  return operand;
}

graph::Edit anyEdit(const graph::Statements& statements, const graph::Rules& rules) {
  static constexpr const char* kElements[] = {"CONTACT",   "CONTACT_NOT", "NOT",  "P",    "POS",
                                              "AND",       "OR",          "XOR",  "COIL", "S",
                                              "CONNECTOR", "SR",          "EQ_I", "EQ_F", "MOVE"};
  graph::Edit edit;
  edit.action = static_cast<graph::Action>(below(9));  // but for Paste
  if (below(3) == 0) edit.action = graph::Action::Insert;
  edit.at = {below(statements.size() + 1) - 1, below(5) - 2, -1};
  edit.from = {below(statements.size() + 1) - 1, -1, -1};
  edit.place = static_cast<graph::Place>(below(5));
  edit.element = kElements[below(std::size(kElements))];
  const auto rows = rules.elements->elements();
  if (below(4) == 0) edit.element = rows[static_cast<std::size_t>(below(rows.size()))].row.id;
  for (int count = 1 + below(3); count > 0; --count)
    edit.operands.push_back(anyOperand(statements));
  return edit;
}

TextEdit undone(const source::SourceFile& before, const TextEdit& edit) {
  TextEdit out;
  out.from = edit.from;
  out.to = edit.from + static_cast<std::uint32_t>(edit.lines.size());
  for (std::uint32_t line = edit.from; line < edit.to; ++line)
    out.lines.emplace_back(before.line(line));
  return out;
}

// What an edit of one network may do to the text of a block.
void checkText(const source::SourceFile& before, const Block& block, std::size_t at,
               const TextEdit& edit, const source::SourceFile& after, const Block& now) {
  const graph::SourceNetwork& old = block.networks[at].source;
  RC_ASSERT(edit.from >= old.line && edit.to <= old.end);
  RC_ASSERT(applied(after, undone(before, edit)) == before.text());
  RC_ASSERT(now.networks.size() == block.networks.size());
  for (std::size_t i = 0; i < block.networks.size(); ++i)
    RC_ASSERT(i == at || now.networks[i].source.statements == block.networks[i].source.statements);
  const Network& network = now.networks[at];
  RC_ASSERT(network.source.title == old.title);
  RC_ASSERT(network.source.comment == old.comment);
  RC_ASSERT(network.source.label == old.label || network.source.statements.empty());
  RC_ASSERT(network.tree.has_value());
  RC_ASSERT(graph::write(*network.tree, *now.rules) == network.source.statements);
  if (edit.select.node < 0) return;
  graph::Network tree = *network.tree;
  RC_ASSERT(graph::locate(tree, edit.select).has_value());
}

// The text compiles to the statements of the tree. True: it compiles.
bool compiles(const Place& place, const source::SourceFile& file, const graph::Statements& wanted) {
  const auto& project = place.build->project;
  const auto build = compilation::build(
      project::load(project.path, "", {{file.name(), std::string(file.text())}}), false);
  if (!build.ok()) return false;
  const auto compiled = compiledNetworks(build, place.block);
  if (place.network > compiled.size()) return false;
  RC_ASSERT(Outline().of(compiled[place.network - 1].statements) == Outline().of(wanted));
  return true;
}

class Draughtsman {
 public:
  explicit Draughtsman(const Place& place)
      : place_(place), around_(surroundingsOf(*place.build)), file_(*place.file) {}

  // True: an edit was done.
  bool edit() {
    const auto block = blockAt(file_, place_.line, around_);
    const std::size_t at = place_.network - 1;
    const graph::Edit wish = anyEdit(block->networks[at].source.statements, *block->rules);
    RC_LOG() << text(*block) << "action " << static_cast<int>(wish.action) << " at " << wish.at.node
             << ":" << wish.at.pin << " place " << static_cast<int>(wish.place) << " "
             << wish.element << "\n";
    const auto done = below(6) == 0 && wish.at.node >= 0
                          ? copied(wish)
                          : networks::edit(file_, place_.line, place_.network, wish, around_);
    if (!done) return false;
    source::SourceFile after(file_.name(), applied(file_, *done));
    const auto now = blockAt(after, place_.line, around_);
    RC_ASSERT(now.has_value());
    checkText(file_, *block, at, *done, after, *now);
    file_ = std::move(after);
    return true;
  }

  bool compiles() const {
    const auto block = blockAt(file_, place_.line, around_);
    RC_LOG() << text(*block);
    return networks::compiles(place_, file_, block->networks[place_.network - 1].source.statements);
  }

 private:
  // An element comes from the clipboard again.
  Edited copied(const graph::Edit& wish) const {
    const auto lines = copy(file_, place_.line, place_.network, {wish.from}, around_);
    if (!lines) return lines.error();
    std::string text;
    for (const std::string& line : *lines) text += line + "\n";
    RC_LOG() << "pastes " << text;
    return paste(file_, place_.line, place_.network, wish, text, around_);
  }

  std::string text(const Block& block) const {
    const graph::SourceNetwork& network = block.networks[place_.network - 1].source;
    std::string out = file_.name() + " " + block.name + "\n";
    for (std::uint32_t line = network.line; line < network.end; ++line)
      out += std::string(file_.line(line)) + "\n";
    return out;
  }

  const Place& place_;
  Surroundings around_;
  source::SourceFile file_;
};

void drawAtRandom(const char* extension) {
  const std::vector<Place> places = placesOf(extension);
  std::size_t edits = 0, compiled = 0;
  EXPECT_TRUE(rc::check([&] {
    Draughtsman draughtsman(places[static_cast<std::size_t>(below(places.size()))]);
    for (int count = 1 + below(8); count > 0; --count) edits += draughtsman.edit() ? 1 : 0;
    compiled += draughtsman.compiles() ? 1 : 0;
  }));
  EXPECT_GE(edits, 100u);
  EXPECT_GE(compiled, 20u);
}

// S7-EDIT-14
TEST(RandomEdits, ofTextsOfStep7) { drawAtRandom(".awl"); }
TEST(RandomEdits, ofTextsOfStep5) { drawAtRandom(".s5"); }

// Where an operand is written that stands there already, whatever the tree would be written as.
void changeNothing(const char* extension, std::size_t atLeast) {
  std::size_t count = 0;
  for (const Place& place : placesOf(extension)) {
    const Surroundings around = surroundingsOf(*place.build);
    const auto block = blockAt(*place.file, place.line, around);
    const graph::Statements& all = block->networks[place.network - 1].source.statements;
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (all[i].operand.text.empty()) continue;
      graph::Edit edit;
      edit.action = graph::Action::SetOperand;
      edit.at = {static_cast<int>(i), graph::kOwn, -1};
      edit.operands.push_back(all[i].operand);
      const auto done = networks::edit(*place.file, place.line, place.network, edit, around);
      if (!done) continue;
      ++count;
      EXPECT_TRUE(done->from == done->to && done->lines.empty())
          << place.file->name() << " " << place.block << " " << place.network << " " << i;
    }
  }
  EXPECT_GE(count, atLeast);
}

TEST(NoEdit, changesNoTextOfStep7) { changeNothing(".awl", 100); }
TEST(NoEdit, changesNoTextOfStep5) { changeNothing(".s5", 20); }

}  // namespace
}  // namespace merker::networks
