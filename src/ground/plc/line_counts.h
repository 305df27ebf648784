// Coverage of instructions as coverage of source lines.
#pragma once

#include <algorithm>
#include <cstdint>
#include <map>

namespace merker::controller {

using Counts = std::map<std::uint32_t, std::uint64_t>;

// Adds to `file` how often each line of a block ran: the most executed instruction of a line
// counts, a line that never ran is there with 0. `entries` have the lines of the block, `lineAt`
// finds that of an offset, `counts` go by offset.
template <typename Entries, typename LineAt>
void addLineCounts(const Entries& entries, LineAt lineAt, const Counts& counts, Counts& file) {
  Counts best;
  for (const auto& entry : entries)
    if (entry.line != 0) best[entry.line];
  for (const auto& [offset, count] : counts) {
    const auto line = best.find(lineAt(offset));
    if (line != best.end()) line->second = std::max(line->second, count);
  }
  for (const auto& [line, count] : best) file[line] += count;
}

}  // namespace merker::controller
