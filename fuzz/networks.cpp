// The networks of any text open or stay AWL, for a reason that names a statement of theirs; written
// anew they give the same lines, and edits leave a text in which the others are what they were.
// None takes longer than half a second. The first byte: language, which edits.
#include <map>

#include "graph/edit.h"
#include "graph/fup.h"
#include "graph/kop.h"
#include "graph/sentence.h"
#include "graph/write.h"
#include "networks/source_edit.h"
#include "networks/text.h"
#include "time_limit.h"

using namespace merker;

namespace {

constexpr std::size_t kLongest = 64 << 10;  // bytes
constexpr std::size_t kMostBlocks = 3, kMostNetworks = 20;
constexpr std::size_t kActions = 10;  // of graph/edit.h
constexpr int kEdits = 24;            // of each block
constexpr double kTime = 0.5;

double slowness() {
  static const double factor = fuzz::slowness(0.010, [] {
    std::map<std::string, std::size_t> words;
    for (std::size_t i = 0; i < 30'000; ++i) words[std::to_string(i * 7919)] = i;
    fuzz::require(words.size() == 30'000, "the reference counts words");
  });
  return factor;
}

template <typename Do>
auto within(const char* property, Do&& work) {
  return fuzz::within(kTime * slowness(), property, std::forward<Do>(work));
}

class Numbers {
 public:
  explicit Numbers(std::uint32_t seed) : state_(seed) {}
  std::uint32_t below(std::size_t limit) {
    state_ = state_ * 1664525 + 1013904223;
    return static_cast<std::uint32_t>((state_ >> 8) % limit);
  }

 private:
  std::uint32_t state_;
};

// What a user does next.
graph::Edit editOf(Numbers& numbers, std::size_t statements) {
  static constexpr const char* kElements[] = {
      "CONTACT", "CONTACT_NOT", "NOT",  "P", "POS",   "AND",       "OR",       "XOR", "SR",
      "EQ_I",    "MOVE",        "COIL", "S", "S_ODT", "CONNECTOR", "CALL_BOX", "JMP"};
  static constexpr const char* kOperands[] = {"E 0.0", "\"x\"", "#a",  "MW 10",
                                              "FC 1",  "5",     "; U", "??.?"};
  const auto number = [&numbers](int from, int to) {
    return from + static_cast<int>(numbers.below(static_cast<std::size_t>(to - from)));
  };
  graph::Edit edit;
  edit.action = static_cast<graph::Action>(numbers.below(kActions));
  if (numbers.below(3) == 0) edit.action = graph::Action::Insert;
  edit.place = static_cast<graph::Place>(numbers.below(5));
  edit.at = {number(-1, static_cast<int>(statements)), number(-2, 3), -1};
  edit.from = {number(-1, static_cast<int>(statements)), -1, -1};
  edit.element = kElements[numbers.below(std::size(kElements))];
  for (int count = number(0, 3); count > 0; --count)
    edit.operands.emplace_back().text = kOperands[numbers.below(std::size(kOperands))];
  return edit;
}

void draw(const networks::Network& network) {
  for (const graph::Language language : {graph::Language::German, graph::Language::English}) {
    (void)graph::sentences(*network.tree, language, language);
    (void)graph::kop(*network.tree, {language});
    (void)graph::fup(*network.tree, {language});
  }
}

void rewrite(const source::SourceFile& file, const networks::Found& found,
             const networks::Network& network) {
  const graph::Statements same = graph::write(*network.tree, *found.block.rules);
  const networks::Style style = found.text->style();
  const auto edit =
      networks::spliced({file, network.source, same, style, found.text->writer(style), {}});
  fuzz::require(edit.from == edit.to && edit.lines.empty(), "what does not change stays");
}

// Everything that can be seen of a block.
void look(const source::SourceFile& file, const networks::Found& found) {
  const std::size_t count = std::min(found.block.networks.size(), kMostNetworks);
  for (std::size_t i = 0; i < count; ++i) {
    const networks::Network& network = found.block.networks[i];
    const std::size_t statements = network.source.statements.size();
    fuzz::require(network.source.places.size() == statements, "each statement has a place");
    if (network.tree) {
      draw(network);
      rewrite(file, found, network);
    } else {
      fuzz::require(network.refusal.statement < statements, "a refusal names a statement");
    }
  }
}

// An element comes from the clipboard again, with a line that is in the text.
networks::Edited pasted(const source::SourceFile& file, const networks::Block& block,
                        std::size_t at, const graph::Edit& edit,
                        const networks::Surroundings& around) {
  const std::size_t number = block.networks[at].number;
  const auto lines = networks::copy(file, block.line, number, {edit.from}, around);
  if (!lines) return lines.error();
  std::string text;
  for (const std::string& line : *lines) text += line + "\n";
  const auto elements = networks::paste(file, block.line, number, edit, text, around);
  const std::string_view any =
      file.line(1 + static_cast<std::uint32_t>(edit.at.node + 1) % file.lineCount());
  (void)networks::paste(file, block.line, number, edit, any, around);
  return elements;
}

// The text after one edit of a network; empty: it was refused.
std::string changed(const source::SourceFile& file, const networks::Block& block, std::size_t at,
                    const graph::Edit& edit, const networks::Surroundings& around) {
  const auto done = within("an edit takes no longer than half a second", [&] {
    if (edit.action == graph::Action::Paste) return pasted(file, block, at, edit, around);
    return networks::edit(file, block.line, block.networks[at].number, edit, around);
  });
  if (!done) return {};
  std::string text = networks::applied(file, *done);
  const source::SourceFile after(file.name(), text);
  const auto now = networks::blockAt(after, block.line, around);
  fuzz::require(now && now->networks.size() == block.networks.size(), "an edit leaves the others");
  fuzz::require(now->networks[at].tree.has_value(), "what was edited has a picture");
  for (std::size_t i = 0; i < block.networks.size(); ++i)
    fuzz::require(
        i == at || now->networks[i].source.statements == block.networks[i].source.statements,
        "other networks keep their statements");
  return text;
}

// Edits one after the other, as somebody draws.
void change(source::SourceFile file, std::uint32_t line, Numbers& numbers,
            const networks::Surroundings& around) {
  for (int count = 0; count < kEdits; ++count) {
    const auto block = networks::blockAt(file, line, around);
    if (!block || block->networks.empty()) return;
    const std::size_t at = numbers.below(std::min(block->networks.size(), kMostNetworks));
    const auto edit = editOf(numbers, block->networks[at].source.statements.size());
    const std::string text = changed(file, *block, at, edit, around);
    if (!text.empty()) file = source::SourceFile(file.name(), text);
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size < 2 || size > kLongest) return 0;
  networks::Surroundings around;
  around.language = (data[0] & 1) != 0 ? source::Language::Step5 : source::Language::Step7;
  Numbers numbers(data[0]);
  const source::SourceFile file("fuzz", std::string(fuzz::text(data + 1, size - 1)));
  const auto blocks = within("a text takes no longer than half a second",
                             [&] { return networks::blocks(file, around); });
  for (std::size_t i = 0; i < std::min(blocks.size(), kMostBlocks); ++i) {
    const auto found = within("a block takes no longer than half a second",
                              [&] { return networks::findBlock(file, blocks[i].line, around); });
    const bool empty = blocks[i].line == blocks[i].end;  // the next one begins on its line
    fuzz::require(found.has_value() || empty, "a block is found again");
    if (!found || found->block.line != blocks[i].line) continue;
    look(file, *found);
    change(file, blocks[i].line, numbers, around);
  }
  return 0;
}
