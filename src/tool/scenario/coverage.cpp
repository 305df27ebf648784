#include "scenario/coverage.h"

#include <fmt/format.h>

#include <algorithm>
#include <ostream>

namespace merker::simulator {

void Coverage::add(const controller::Controller& plc) {
  for (const auto& [file, lines] : plc.executedLines())
    for (const auto& [line, count] : lines) lines_[file][line] += count;
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
