// The rows of a cross reference while the code of a block is gone through: each gets the place and
// the statement where the walk is. What one statement uses twice is one row.
#pragma once

#include "monitor/cross_reference.h"

namespace merker::monitor {

class ReferenceRows {
 public:
  ReferenceRows(const BlockCode& block, const source::SymbolTable& symbols,
                std::vector<CrossReference>& out)
      : block_(block), symbols_(symbols), out_(out), first_(out.size()) {}

  void arrive(std::uint32_t offset);  // the next instruction
  void add(CrossReference row, Use use, std::string instruction);

 private:
  bool merged(const CrossReference& row);
  const source::Symbol* symbolOf(const CrossReference& row) const;

  BlockCode block_;
  const source::SymbolTable& symbols_;
  std::vector<CrossReference>& out_;
  std::size_t first_;  // row of the statement
  std::uint32_t offset_ = 0, statement_ = UINT32_MAX;
};

}  // namespace merker::monitor
