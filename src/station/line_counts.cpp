#include "station/line_counts.h"

#include <algorithm>

namespace merker::station {
namespace {

using Counts = std::map<std::uint32_t, std::uint64_t>;

Counts ofBlock(const block::Block& block, const Counts& counts) {
  Counts best;
  for (const block::LineEntry& entry : block.lines)
    if (entry.line != 0) best[entry.line];
  for (const auto& [offset, count] : counts) {
    const auto line = best.find(block.line(offset));
    if (line != best.end()) line->second = std::max(line->second, count);
  }
  return best;
}

}  // namespace

controller::ExecutedLines lineCounts(const block::Program& program,
                                     const ExecutedInstructions& executed) {
  controller::ExecutedLines lines;
  for (const auto& [id, block] : program) {
    if (block.code.empty() || block.file.empty()) continue;
    const auto counts = executed.find(id);
    auto& file = lines[block.file];
    for (const auto& [line, count] :
         ofBlock(block, counts == executed.end() ? Counts{} : counts->second))
      file[line] += count;
  }
  return lines;
}

}  // namespace merker::station
