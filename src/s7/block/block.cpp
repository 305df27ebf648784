#include "block/block.h"

#include <algorithm>
#include <array>

namespace merker::block {

std::uint32_t Block::line(std::uint32_t offset) const {
  const auto next =
      std::upper_bound(lines.begin(), lines.end(), offset,
                       [](std::uint32_t at, const LineEntry& entry) { return at < entry.offset; });
  return next == lines.begin() ? 0 : std::prev(next)->line;
}

std::vector<const Variable*> parameters(const Block& block) {
  static constexpr std::array kOrder{Section::Input, Section::Return, Section::Output,
                                     Section::InOut};
  std::vector<const Variable*> result;
  for (const Section section : kOrder)
    for (const Variable& variable : block.variables)
      if (variable.section == section) result.push_back(&variable);
  return result;
}

}  // namespace merker::block
