// The variables of one block by their names, and its parameters in the order of a call. Looked up
// for every operand, so no list is searched.
#pragma once

#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "block/block.h"

namespace merker::step7 {

class BlockNames {
 public:
  // The block must outlive it and keep its variables.
  explicit BlockNames(const block::Block& block);

  // In any case of letters; null if the block declares no such name.
  const block::Variable* find(std::string_view name) const;
  const std::vector<const block::Variable*>& parameters() const { return parameters_; }
  // Place of a parameter in the list of a call.
  std::uint32_t parameterIndex(const block::Variable& variable) const;

 private:
  std::unordered_map<std::string, const block::Variable*> byName_;
  std::vector<const block::Variable*> parameters_;
  std::unordered_map<const block::Variable*, std::uint32_t> places_;
};

}  // namespace merker::step7
