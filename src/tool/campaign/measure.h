// What is measured during a run, read from its text: "max plant Vessel.LEVEL", "count A 1.0
// rising", "when MW 10 >= 5", "cycles" (docs/formats/campaign.md).
#pragma once

#include <optional>
#include <string>

#include "campaign/definition.h"
#include "compilation/build.h"
#include "scenario/watched.h"

namespace merker::campaign {

struct Measure {
  enum class Kind : std::uint8_t {
    Max,
    Min,
    Mean,
    Integral,  // of a value
    Rising,
    Falling,
    Changes,  // how often
    Time,
    When,  // a condition holds: how long, since when
    Last,  // what follows is looked at at the end alone
    Cycles,
    Instructions  // of the CPU
  } kind = Kind::Last;
  simulator::Watched source;                             // one thing, or nothing
  bool amount = false;                                   // |value|
  block::Relation relation = block::Relation::NotEqual;  // Time, When: of the value with `limit`
  double limit = 0;
  std::optional<MeasureText::Requirement> required;
  std::string name;

  // Whether each cycle must be looked at, also one that changes nothing in the memory of the PLC: a
  // plant or a terminal may move meanwhile.
  bool needsEachCycle() const { return source.operands.empty() && kind < Kind::Last; }
};

// Nothing, and a problem, if the text is none.
std::optional<Measure> bindMeasure(const MeasureText& text, const compilation::Build& build,
                                   Problems& problems);

}  // namespace merker::campaign
