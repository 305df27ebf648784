#include "networks/tree_edit.h"

#include <algorithm>

#include "graph/canonical.h"
#include "graph/write.h"
#include "networks/alignment.h"

namespace merker::networks {
namespace {

std::set<std::string> labelsOf(const Block& block) {
  std::set<std::string> labels;
  for (const Network& network : block.networks) {
    labels.insert(network.source.label);
    for (const graph::Written& place : network.source.places) labels.insert(place.label);
    for (const graph::Statement& statement : network.source.statements)
      if (isJump(statement.op)) labels.insert(statement.operand.text);
  }
  return labels;
}

// A statement that stands alone on its line and has an operand shows how the others are written.
std::optional<Style> styleOf(const source::SourceFile& file, const graph::SourceNetwork& network) {
  for (std::size_t i = 0; i < network.places.size(); ++i) {
    const graph::Written& place = network.places[i];
    const std::string_view line = file.line(place.line);
    const auto start = static_cast<std::size_t>(line.data() - file.text().data());
    const bool alone = (i == 0 || network.places[i - 1].end <= place.line) &&
                       place.end == place.line + 1 && place.label.empty();
    const bool call = network.statements[i].op == graph::Op::CALL;
    if (!alone || call || place.operand <= place.begin || place.begin < start) continue;
    const bool semicolon = file.text().substr(place.begin, place.length).ends_with(';');
    return Style{std::string(line.substr(0, place.begin - start)), place.operand - place.begin,
                 semicolon ? ";" : ""};
  }
  return std::nullopt;
}

// What a CALL is about stands in its text and its arguments.
bool reads(const graph::Statement& wanted, graph::Statement read) {
  if (wanted.op == graph::Op::CALL && read.op == graph::Op::CALL) {
    read.operand.code = wanted.operand.code;
    return wanted.operand.text == read.operand.text;
  }
  return sameStatement(wanted, read) && wanted.target == read.target;
}

bool reads(const graph::Statements& wanted, const graph::Statements& read) {
  return std::equal(wanted.begin(), wanted.end(), read.begin(), read.end(),
                    [](const auto& a, const auto& b) { return reads(a, b); });
}

bool same(const graph::Statements& wanted, const graph::Statements& old) {
  const auto arguments = [](const auto& a, const auto& b) { return a.arguments == b.arguments; };
  return reads(wanted, old) && std::equal(wanted.begin(), wanted.end(), old.begin(), arguments);
}

// The network is another one only if its tree is: then it is written as STEP 7 would.
TextEdit unchanged(const Network& network, const graph::Edit& wish) {
  TextEdit out;
  out.from = out.to = network.source.code;
  out.network = network.number;
  out.select = wish.at;
  return out;
}

}  // namespace

Style styleOf(const source::SourceFile& file, const Found& found, const Network& network) {
  if (auto style = styleOf(file, network.source)) return *style;
  for (const Network& other : found.block.networks)
    if (auto style = styleOf(file, other.source)) return *style;
  return found.text->style();
}

Edited treeEdit(const source::SourceFile& file, Found& found, std::size_t network,
                const graph::Edit& edit, const Surroundings& around) {
  const Network& old = found.block.networks[network - 1];
  const graph::Rules& rules = *found.block.rules;
  const std::uint32_t wire = found.text->firstWire(found.block, found.index, network);
  auto done = graph::apply(*old.tree, edit, rules, wire);
  if (!done) return Refusal{Obstacle::Tree, done.error()};
  for (graph::Statement& statement : done->statements) found.text->fit(statement);
  if (same(done->statements, graph::write(graph::canonical(*old.tree, rules, wire), rules)))
    return unchanged(old, edit);
  const Style style = styleOf(file, found, old);
  TextEdit out = spliced({file, old.source, done->statements, style, found.text->writer(style),
                          labelsOf(found.block)});
  out.network = network;
  out.select = done->select;
  // What cannot be read again as what it is must not be written.
  const source::SourceFile after(file.name(), applied(file, out));
  const auto block = blockAt(after, found.block.line, around);
  const bool good = block && block->networks.size() == found.block.networks.size() &&
                    reads(done->statements, block->networks[network - 1].source.statements);
  if (!good) return Refusal{Obstacle::Tree, graph::EditProblem::Ambiguous};
  return out;
}

}  // namespace merker::networks
