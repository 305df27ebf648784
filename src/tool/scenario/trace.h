// Records how operands, terminals and signals of plants change, one line of CSV per change: time in
// seconds, what it is, value (docs/formats/scenario.md).
#pragma once

#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "plc/controller.h"
#include "scenario/plant_value.h"
#include "scenario/terminal_value.h"

namespace merker::simulator {

struct Watched {
  std::vector<address::Reference> operands;
  std::vector<PlantValue> plants;          // resolved
  std::vector<TerminalValue> terminals{};  // the same
};

class Trace {
 public:
  // The values now are what the first changes are compared with. `plants` and `rack` must outlive
  // it; null if nothing of them is watched.
  Trace(std::ostream& out, Watched watched, const controller::Controller& plc,
        const plant::Plants* plants = nullptr, const io::Rack* rack = nullptr);
  void sample(const controller::Controller& plc);

 private:
  void write(Instant now, const std::string& name, const std::string& value);
  std::vector<std::string> outside() const;
  std::string nameOutside(std::size_t index) const;

  std::ostream& out_;
  Watched watched_;
  const plant::Plants* plants_;
  const io::Rack* rack_;
  std::vector<std::optional<std::string>> last_;  // bits or content, not shown
  std::vector<std::string> lastOutside_;          // signals of plants, then terminals
};

}  // namespace merker::simulator
