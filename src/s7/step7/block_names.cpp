#include "step7/block_names.h"

#include "base/text.h"

namespace merker::step7 {

BlockNames::BlockNames(const block::Block& block) : parameters_(block::parameters(block)) {
  for (const block::Variable& variable : block.variables)
    byName_.emplace(upper(variable.name), &variable);  // of two equal names the first
  for (const block::Variable* parameter : parameters_)
    places_.emplace(parameter, static_cast<std::uint32_t>(places_.size()));
}

const block::Variable* BlockNames::find(std::string_view name) const {
  const auto found = byName_.find(upper(name));
  return found == byName_.end() ? nullptr : found->second;
}

std::uint32_t BlockNames::parameterIndex(const block::Variable& variable) const {
  const auto found = places_.find(&variable);
  return found == places_.end() ? static_cast<std::uint32_t>(parameters_.size()) : found->second;
}

}  // namespace merker::step7
