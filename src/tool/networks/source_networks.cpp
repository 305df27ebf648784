#include "networks/source_networks.h"

#include <algorithm>

#include "graph/read.h"
#include "networks/text.h"

namespace merker::networks {
namespace {

void read(Block& block, std::vector<graph::SourceNetwork> written) {
  for (graph::SourceNetwork& source : written) {
    Network& network = block.networks.emplace_back();
    network.number = block.networks.size();
    network.source = std::move(source);
    auto tree = graph::read(network.source.statements, *block.rules, graph::Unfinished::Allowed);
    if (tree)
      network.tree = std::move(*tree);
    else
      network.refusal = tree.error();
    // What is missing at the end is told of the last statement.
    const std::size_t count = network.source.statements.size();
    if (!network.tree && count > 0)
      network.refusal.statement = std::min(network.refusal.statement, count - 1);
  }
}

}  // namespace

std::unique_ptr<Text> textOf(const source::SourceFile& file, const Surroundings& around) {
  return around.language == source::Language::Step7 ? step7Text(file, around)
                                                    : step5Text(file, around);
}

std::vector<Block> blocks(const source::SourceFile& file, const Surroundings& around) {
  return textOf(file, around)->blocks();
}

std::optional<Found> findBlock(const source::SourceFile& file, std::uint32_t line,
                               const Surroundings& around) {
  Found found{textOf(file, around), 0, {}};
  const std::vector<Block>& all = found.text->blocks();
  for (; found.index < all.size(); ++found.index) {
    const Block& block = all[found.index];
    if (line < block.line || line >= block.end) continue;
    found.block = block;
    read(found.block, found.text->networks(found.index));
    return found;
  }
  return std::nullopt;
}

const Network* networkOf(const std::optional<Found>& found, std::size_t network) {
  if (!found || network == 0 || network > found->block.networks.size()) return nullptr;
  return &found->block.networks[network - 1];
}

std::optional<Block> blockAt(const source::SourceFile& file, std::uint32_t line,
                             const Surroundings& around) {
  auto found = findBlock(file, line, around);
  return found ? std::optional(std::move(found->block)) : std::nullopt;
}

std::vector<graph::Argument> parametersOf(std::string_view called, const source::SourceFile& file,
                                          std::uint32_t line, const Surroundings& around) {
  const auto found = findBlock(file, line, around);
  return found ? found->text->parameters(found->index, called) : std::vector<graph::Argument>();
}

}  // namespace merker::networks
