#include "diagram/written_blocks.h"

#include <set>

#include "networks/source_networks.h"

namespace merker::diagram {
namespace {

NetworkDiagram asWritten(networks::Network network, const networks::Block& block) {
  NetworkDiagram out;
  out.number = network.number;
  out.title = std::move(network.source.title);
  out.label = std::move(network.source.label);
  out.network = std::move(network.tree);
  out.rules = block.rules;
  out.mnemonics = block.mnemonics;
  out.refusal = network.refusal;
  for (const graph::Written& place : network.source.places)
    out.statements.push_back(place.label.empty() || &place == network.source.places.data()
                                 ? place.text
                                 : place.label + ": " + place.text);
  return out;
}

BlockDiagram asWritten(networks::Block block) {
  BlockDiagram out{block.name, block.symbol, {}};
  for (networks::Network& network : block.networks)
    out.networks.push_back(asWritten(std::move(network), block));
  return out;
}

std::set<std::uint32_t> linesWithErrors(const compilation::Build& build, const std::string& file) {
  std::set<std::uint32_t> lines;
  for (const Problem& problem : build.problems.list())
    if (problem.severity() == Severity::Error && problem.position.file == file)
      lines.insert(problem.position.line);
  return lines;
}

}  // namespace

WrittenBlocks writtenBlocks(const compilation::Build& build) {
  WrittenBlocks out;
  const networks::Surroundings around{
      .language = build.isListing() ? source::Language::Step5 : build.project.symbols.language(),
      .symbols = &build.project.symbols,
      .program = build.program.get(),
      .library = build.library.get(),
      .mnemonics = build.project.mnemonics};
  for (const source::SourceFile& file : build.project.sources) {
    const auto lines = linesWithErrors(build, file.name());
    for (const networks::Block& block : networks::blocks(file, around)) {
      out.mnemonics.try_emplace(block.name, block.mnemonics);
      const auto line = lines.lower_bound(block.line);
      if (line == lines.end() || *line >= block.end) continue;
      if (auto found = networks::blockAt(file, block.line, around))
        out.faulty.try_emplace(block.name, asWritten(std::move(*found)));
    }
  }
  return out;
}

}  // namespace merker::diagram
