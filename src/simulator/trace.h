// Records how operands change, one line of CSV per change: time in seconds, operand, value
// (docs/formats/scenario.md).
#pragma once

#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "station/station.h"

namespace merker::simulator {

class Trace {
 public:
  // The values now are what the first changes are compared with.
  Trace(std::ostream& out, std::vector<mc7::Reference> watched, const station::Station& station);
  void sample(const station::Station& station);

 private:
  std::ostream& out_;
  std::vector<mc7::Reference> watched_;
  std::vector<std::optional<std::string>> last_;  // bits or content, not shown
};

}  // namespace merker::simulator
