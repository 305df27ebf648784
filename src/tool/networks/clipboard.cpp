// Elements and networks as lines of AWL, and such lines in a block.
#include <algorithm>

#include "base/text.h"
#include "graph/read.h"
#include "networks/free_labels.h"
#include "networks/tree_edit.h"
#include "networks/whole_edit.h"

namespace merker::networks {
namespace {

using Lines = std::vector<std::string>;

Lines linesOf(std::string_view text) {
  const source::SourceFile file("", std::string(text));
  Lines out;
  for (std::uint32_t line = 1; line <= file.lineCount(); ++line) out.emplace_back(file.line(line));
  while (!out.empty() && trim(out.back()).empty()) out.pop_back();
  return out;
}

Lines wholeNetwork(const source::SourceFile& file, const Found& found, const Network& network) {
  Lines out;
  if (!network.source.headed) out = found.text->heading(network.number, {});
  const std::uint32_t end = behindNetwork(file, network.source);
  for (std::uint32_t line = network.source.line; line < end; ++line)
    out.emplace_back(file.line(line));
  return out;
}

// The block with the lines as networks of their own.
struct Trial {
  source::SourceFile file;
  Block block;
  std::size_t first = 0, count = 0;  // of the new networks
  std::uint32_t at = 1;              // their first line
  bool whole = false;                // the lines have heads of their own
};

bool sameNetworks(const Block& old, const Trial& trial, std::size_t replaced) {
  for (std::size_t i = 0; i < old.networks.size(); ++i) {
    if (i == trial.first && replaced > 0) continue;
    const std::size_t now = i < trial.first ? i : i + trial.count - replaced;
    if (old.networks[i].source.statements != trial.block.networks[now].source.statements)
      return false;
  }
  return true;
}

std::optional<Trial> tried(const source::SourceFile& file, const Found& found, std::size_t network,
                           bool before, const Lines& lines, Surroundings around) {
  const Network& at = found.block.networks[network - 1];
  const bool replaces = isReplaced(at.source);
  const std::size_t first = before || replaces ? network - 1 : network;
  Lines all = found.text->heading(first + 1, {});
  const std::size_t heads = all.size();
  all.insert(all.end(), lines.begin(), lines.end());
  // Code without a head would belong to the new networks.
  if (before && !at.source.headed && !replaces)
    for (std::string& own : found.text->heading(network + 1, {})) all.push_back(std::move(own));
  TextEdit edit;
  edit.from = edit.to = before ? at.source.line : behindNetwork(file, at.source);
  edit.lines = std::move(all);
  around.mnemonics = found.block.mnemonics;
  source::SourceFile text(file.name(), applied(file, edit));
  auto block = blockAt(text, found.block.line, around);
  const std::size_t replaced = replaces ? 1 : 0, old = found.block.networks.size() - replaced;
  if (!block || block->networks.size() <= old) return std::nullopt;
  Trial out{std::move(text), std::move(*block), first, 0, edit.from, false};
  out.count = out.block.networks.size() - old;
  if (!sameNetworks(found.block, out, replaced)) return std::nullopt;
  out.whole = out.count > 1 && out.block.networks[first].source.statements.empty();
  if (!out.whole) return out;
  TextEdit head;
  head.from = edit.from;
  head.to = edit.from + static_cast<std::uint32_t>(heads);
  out.file = source::SourceFile(file.name(), applied(out.file, head));
  block = blockAt(out.file, found.block.line, around);
  if (!block || block->networks.size() + 1 != out.block.networks.size()) return std::nullopt;
  out.block = std::move(*block);
  --out.count;
  return out;
}

Edited pasteNetworks(const source::SourceFile& file, const Found& found, const Trial& trial,
                     const Surroundings& around) {
  const bool step7 = around.language == source::Language::Step7;
  const source::SourceFile after(
      file.name(),
      step7 ? withFreeLabels(trial.file, trial.block, trial.first, trial.first + trial.count)
            : std::string(trial.file.text()));
  TextEdit out;
  out.network = trial.first + 1;
  out.from = out.to = trial.at;
  const std::uint32_t behind = trial.at + after.lineCount() - file.lineCount();
  for (std::uint32_t line = trial.at; line < behind; ++line)
    out.lines.emplace_back(after.line(line));
  return withNumbers(file, found, std::move(out), around);
}

Edited pasteElements(const source::SourceFile& file, Found& found, std::size_t network,
                     graph::Edit edit, const graph::Statements& pasted,
                     const Surroundings& around) {
  if (!found.block.networks[network - 1].tree) return Refusal{Obstacle::Awl};
  auto part = graph::read(pasted, *found.block.rules, graph::Unfinished::Part);
  if (!part || pasted.empty()) return Refusal{Obstacle::Clipboard};
  edit.action = graph::Action::Paste;
  edit.pasted = std::move(*part);
  return treeEdit(file, found, network, edit, around);
}

}  // namespace

Result<Lines, Refusal> copy(const source::SourceFile& file, std::uint32_t line, std::size_t network,
                            const std::vector<graph::Selection>& elements,
                            const Surroundings& around) {
  auto found = findBlock(file, line, around);
  const Network* from = networkOf(found, network);
  if (from == nullptr) return Refusal{};
  if (elements.empty()) return wholeNetwork(file, *found, *from);
  if (!from->tree) return Refusal{Obstacle::Awl};
  const std::uint32_t wire = found->text->firstWire(found->block, found->index, network);
  auto statements = graph::copy(*from->tree, elements, *found->block.rules, wire);
  if (!statements) return Refusal{Obstacle::Tree, statements.error()};
  for (graph::Statement& statement : *statements) found->text->fit(statement);
  const Style style = styleOf(file, *found, *from);
  return spliced({file, {}, *statements, style, found->text->writer(style), {}}).lines;
}

Edited paste(const source::SourceFile& file, std::uint32_t line, std::size_t network,
             const graph::Edit& place, std::string_view lines, const Surroundings& around) {
  auto found = findBlock(file, line, around);
  if (networkOf(found, network) == nullptr) return Refusal{};
  const bool before = place.at.node < 0 && place.place == graph::Place::Before;
  const auto trial = tried(file, *found, network, before, linesOf(lines), around);
  if (!trial) return Refusal{Obstacle::Clipboard};
  if (trial->whole || trial->count > 1) return pasteNetworks(file, *found, *trial, around);
  return pasteElements(file, *found, network, place,
                       trial->block.networks[trial->first].source.statements, around);
}

}  // namespace merker::networks
