// Records how operands and signals of plants change, one line of CSV per change: time in seconds,
// operand or signal, value (docs/formats/scenario.md).
#pragma once

#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "controller/controller.h"
#include "simulator/plant_steps.h"

namespace merker::simulator {

struct Watched {
  std::vector<mc7::Reference> operands;
  std::vector<PlantValue> plants;  // resolved
};

class Trace {
 public:
  // The values now are what the first changes are compared with. `plants` must outlive it; null if
  // none is watched.
  Trace(std::ostream& out, Watched watched, const controller::Controller& plc,
        const plant::Plants* plants = nullptr);
  void sample(const controller::Controller& plc);

 private:
  void write(Instant now, const std::string& name, const std::string& value);

  std::ostream& out_;
  Watched watched_;
  const plant::Plants* plants_;
  std::vector<std::optional<std::string>> last_;  // bits or content, not shown
  std::vector<std::string> lastSignals_;
};

}  // namespace merker::simulator
