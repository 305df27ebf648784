#include "station/line_counts.h"

#include "plc/line_counts.h"

namespace merker::station {

controller::ExecutedLines lineCounts(const block::Program& program,
                                     const ExecutedInstructions& executed) {
  static const controller::Counts kNone;
  controller::ExecutedLines lines;
  for (const auto& [id, block] : program) {
    if (block.code.empty() || block.file.empty()) continue;
    const auto counts = executed.find(id);
    const auto lineAt = [&code = block](std::uint32_t offset) { return code.line(offset); };
    controller::addLineCounts(block.lines, lineAt,
                              counts == executed.end() ? kNone : counts->second, lines[block.file]);
  }
  return lines;
}

}  // namespace merker::station
