// What differs between the texts of the two families.
#pragma once

#include <memory>

#include "networks/source_networks.h"

namespace merker::networks {

// A text of one family, taken apart into its blocks.
class Text {
 public:
  virtual ~Text() = default;

  // Blocks with code in their order, without networks.
  virtual const std::vector<Block>& blocks() const = 0;
  // As they are written, of the block with this index.
  virtual std::vector<graph::SourceNetwork> networks(std::size_t block) = 0;
};

std::unique_ptr<Text> step7Text(const source::SourceFile& file, const Surroundings& around);
std::unique_ptr<Text> step5Text(const source::SourceFile& file, const Surroundings& around);
std::unique_ptr<Text> textOf(const source::SourceFile& file, const Surroundings& around);

}  // namespace merker::networks
