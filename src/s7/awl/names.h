// The variable of a block behind an operand of its machine code.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "block/block.h"
#include "mc7/instruction.h"

namespace merker::awl {

class Names {
 public:
  // The block must outlive it; it is one with the names of its source.
  explicit Names(const block::Block& block);

  bool isFb() const { return fb_; }
  // "#START" for a parameter, a local operand or one of the instance; empty if no variable has
  // this place and width.
  std::string of(const mc7::Operand& operand) const;
  // A variable of any type that begins at this place of the local data or of the instance.
  const block::Variable* local(BitAddress address) const;
  const block::Variable* instance(BitAddress address) const;
  const block::Block& block() const { return block_; }
  std::string parameter(std::uint32_t index) const;

 private:
  using Key = std::pair<BitAddress, Width>;
  void add(const block::Variable& variable, const std::string& path, BitAddress at,
           std::map<Key, std::string>& to, int depth);

  std::map<Key, std::string> local_, instance_;
  std::vector<std::string> parameters_;
  const block::Block& block_;
  bool fb_;
};

// The member of a structure that begins at `address` and is elementary of this width: "a.b[2]".
std::string memberAt(const std::vector<block::Variable>& variables, BitAddress address,
                     Width width);

// The part of the variables that begins at `address` and has this type, and is no elementary one:
// "a.b[2]". With `anyType` the outermost one that begins there.
std::string partAt(const std::vector<block::Variable>& variables, BitAddress address,
                   const block::Type& type, bool anyType = false);

}  // namespace merker::awl
