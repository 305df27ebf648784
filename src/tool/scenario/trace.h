// Records how operands, terminals and signals of plants change, one line of CSV per change: time in
// seconds, what it is, value (docs/formats/scenario.md).
#pragma once

#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "plant/field.h"
#include "scenario/axis_term.h"
#include "scenario/plant_value.h"
#include "scenario/terminal_value.h"

namespace merker::simulator {

struct Watched {
  std::vector<address::Reference> operands;
  std::vector<PlantValue> plants;          // resolved
  std::vector<TerminalValue> terminals{};  // the same
  std::vector<AxisTerm> axis{};            // the same

  // Whether some of it may change beside a cycle that changes nothing: plants, what they wire to
  // terminals, and inputs of the periphery.
  bool movesByItself() const;
};

class Trace {
 public:
  // The values now are what the first changes are compared with. `plc` must outlive it.
  Trace(std::ostream& out, Watched watched, const controller::Controller& plc);
  void sample(const controller::Controller& plc);

 private:
  void write(Instant now, const std::string& name, const std::string& value);
  std::vector<std::string> outside() const;
  std::string nameOutside(std::size_t index) const;

  std::ostream& out_;
  Watched watched_;
  const plant::Field* field_;                     // null: nothing of it is watched
  const positioning::AxisOwner* axis_;            // the same
  std::vector<std::optional<std::string>> last_;  // bits or content, not shown
  std::vector<std::string> lastOutside_;          // signals of plants, terminals, axis
};

}  // namespace merker::simulator
