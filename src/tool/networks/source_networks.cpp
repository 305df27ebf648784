#include "networks/source_networks.h"

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

std::optional<Block> blockAt(const source::SourceFile& file, std::uint32_t line,
                             const Surroundings& around) {
  const auto text = textOf(file, around);
  for (std::size_t i = 0; i < text->blocks().size(); ++i) {
    const Block& found = text->blocks()[i];
    if (line < found.line || line >= found.end) continue;
    Block block = found;
    read(block, text->networks(i));
    return block;
  }
  return std::nullopt;
}

}  // namespace merker::networks
