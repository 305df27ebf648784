// Records how operands change, one line of CSV per change: time in seconds, operand, value
// (docs/formats/scenario.md).
#pragma once

#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "controller/controller.h"

namespace merker::simulator {

class Trace {
 public:
  // The values now are what the first changes are compared with.
  Trace(std::ostream& out, std::vector<mc7::Reference> watched, const controller::Controller& plc);
  void sample(const controller::Controller& plc);

 private:
  std::ostream& out_;
  std::vector<mc7::Reference> watched_;
  std::vector<std::optional<std::string>> last_;  // bits or content, not shown
};

}  // namespace merker::simulator
