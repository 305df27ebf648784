#include "diagram/faulty_blocks.h"

#include <set>

#include "networks/source_networks.h"

namespace merker::diagram {
namespace {

NetworkDiagram asWritten(networks::Network network, const graph::Rules* rules) {
  NetworkDiagram out;
  out.number = network.number;
  out.title = std::move(network.source.title);
  out.label = std::move(network.source.label);
  out.network = std::move(network.tree);
  out.rules = rules;
  out.refusal = network.refusal;
  for (const graph::Written& place : network.source.places)
    out.statements.push_back(place.label.empty() || &place == network.source.places.data()
                                 ? place.text
                                 : place.label + ": " + place.text);
  return out;
}

BlockDiagram asWritten(networks::Block block) {
  BlockDiagram out{std::move(block.name), std::move(block.symbol), {}};
  for (networks::Network& network : block.networks)
    out.networks.push_back(asWritten(std::move(network), block.rules));
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

std::map<std::string, BlockDiagram> faultyBlocks(const compilation::Build& build) {
  std::map<std::string, BlockDiagram> out;
  const networks::Surroundings around{
      .language = build.isListing() ? source::Language::Step5 : build.project.symbols.language(),
      .symbols = &build.project.symbols,
      .program = build.program.get(),
      .library = build.library.get(),
      .mnemonics = {}};
  for (const source::SourceFile& file : build.project.sources) {
    const auto lines = linesWithErrors(build, file.name());
    if (lines.empty()) continue;
    for (const networks::Block& block : networks::blocks(file, around)) {
      const auto line = lines.lower_bound(block.line);
      if (line == lines.end() || *line >= block.end) continue;
      if (auto found = networks::blockAt(file, block.line, around))
        out.try_emplace(block.name, asWritten(std::move(*found)));
    }
  }
  return out;
}

}  // namespace merker::diagram
