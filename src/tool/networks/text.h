// What differs between the texts of the two families.
#pragma once

#include <memory>

#include "networks/source_networks.h"
#include "networks/splice.h"

namespace merker::networks {

// A text of one family, taken apart into its blocks.
class Text {
 public:
  virtual ~Text() = default;

  // Blocks with code in their order, without networks.
  virtual const std::vector<Block>& blocks() const = 0;
  // As they are written, of the block with this index.
  virtual std::vector<graph::SourceNetwork> networks(std::size_t block) = 0;

  // An operand that a user writes; nothing if it is none, or more than one.
  virtual std::optional<graph::Operand> operand(std::size_t block, std::string_view text) = 0;
  // Its operand, which came without an operation, as its operation takes it: PB 5 is a byte or a
  // block.
  virtual void fit(graph::Statement& statement) = 0;
  // The parameters of a block that is called.
  virtual std::vector<graph::Argument> parameters(std::size_t block, std::string_view called) = 0;
  // The first temporary bit that no other network of the block needs.
  virtual std::uint32_t firstWire(const Block& block, std::size_t index, std::size_t network) = 0;

  // Where the block shows no other.
  virtual Style style() const = 0;
  virtual WriteStatement writer(const Style& style) const = 0;
  // The lines that begin a network.
  virtual std::vector<std::string> heading(std::size_t network, const Heading& heading) const = 0;
  // The line that begins a network, with its number, if it has one.
  virtual std::string numbered(std::string_view line, std::size_t network) const = 0;
};

std::unique_ptr<Text> step7Text(const source::SourceFile& file, const Surroundings& around);
std::unique_ptr<Text> step5Text(const source::SourceFile& file, const Surroundings& around);

// What a jump of STEP 7 may lead to.
bool isLabel(std::string_view text);

// The block at a line with its networks.
struct Found {
  std::unique_ptr<Text> text;
  std::size_t index = 0;
  Block block;
};
std::optional<Found> findBlock(const source::SourceFile& file, std::uint32_t line,
                               const Surroundings& around);
// null: there is none of this number.
const Network* networkOf(const std::optional<Found>& found, std::size_t network);
std::unique_ptr<Text> textOf(const source::SourceFile& file, const Surroundings& around);

}  // namespace merker::networks
