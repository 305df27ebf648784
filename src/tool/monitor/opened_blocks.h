// Which data blocks are open at an instruction, as far as the code itself tells: a number that AUF
// names, up to the next place that something jumps to.
#pragma once

#include <cstdint>
#include <set>

#include "block/block.h"
#include "mc7/instruction.h"

namespace merker::monitor {

class OpenedBlocks {
 public:
  explicit OpenedBlocks(const block::Block& block);

  void arrived(std::uint32_t offset) {
    if (targets_.contains(offset)) db_ = di_ = -1;
  }
  void executed(const mc7::Instruction& instruction);
  std::int32_t db() const { return db_; }  // -1: not known
  std::int32_t di() const { return di_; }

 private:
  std::set<std::uint32_t> targets_;  // statements that are jumped to
  std::int32_t db_ = -1, di_ = -1;
};

}  // namespace merker::monitor
