#include "simulator/coverage.h"

#include <fmt/format.h>

#include <algorithm>
#include <ostream>

namespace merker::simulator {

void Coverage::add(const station::Station& station) {
  const auto executed = station.executed();
  for (const auto& [id, block] : station.program()) {
    if (block.code.empty() || block.file.empty()) continue;
    const auto counts = executed.find(id);
    addBlock(block, counts == executed.end() ? decltype(counts->second){} : counts->second);
  }
}

void Coverage::addBlock(const block::Block& block,
                        const std::map<std::uint32_t, std::uint64_t>& counts) {
  std::map<std::uint32_t, std::uint64_t> best;
  for (const block::LineEntry& entry : block.lines)
    if (entry.line != 0) best[entry.line];
  for (const auto& [offset, count] : counts) {
    const auto line = best.find(block.line(offset));
    if (line != best.end()) line->second = std::max(line->second, count);
  }
  auto& file = lines_[block.file];
  for (const auto& [line, count] : best) file[line] += count;
}

void Coverage::write(std::ostream& out) const {
  for (const auto& [file, lines] : lines_) {
    const auto hit =
        std::count_if(lines.begin(), lines.end(), [](const auto& l) { return l.second > 0; });
    out << fmt::format("TN:\nSF:{}\n", file);
    for (const auto& [line, count] : lines) out << fmt::format("DA:{},{}\n", line, count);
    out << fmt::format("LF:{}\nLH:{}\nend_of_record\n", lines.size(), hit);
  }
}

}  // namespace merker::simulator
