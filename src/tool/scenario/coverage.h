// Which instructions ran, per source line, over all tests of a run; written as an lcov tracefile,
// which editors and CI servers show (docs/formats/scenario.md).
#pragma once

#include <iosfwd>

#include "plc/controller.h"

namespace merker::simulator {

class Coverage {
 public:
  // Adds what ran since the PLC was built.
  void add(const controller::Controller& plc);
  void write(std::ostream& out) const;

 private:
  controller::ExecutedLines lines_;
};

}  // namespace merker::simulator
