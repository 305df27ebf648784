// The curves of a trace file: what Trace wrote, read again for drawing.
#pragma once

#include <string>
#include <vector>

#include "source/source_file.h"

namespace merker::simulator {

struct Change {
  double seconds = 0, value = 0;
};

struct Curve {
  std::string operand;
  bool binary = true;  // only 0 and 1
  std::vector<Change> changes;
};

// In the order of first appearance. Times count in seconds; texts and dates cannot be drawn and are
// left out.
std::vector<Curve> readCurves(const source::SourceFile& file, Problems& problems);

}  // namespace merker::simulator
