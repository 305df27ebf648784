// Steps that put a signal on terminals: `pulses`, a pulse generator, and `encoder`, an incremental
// encoder on a moving axis (docs/formats/scenario.md).
#pragma once

#include <cstdint>
#include <vector>

#include "scenario/steps/bare.h"
#include "scenario/terminal_value.h"

namespace merker::simulator::steps {

struct Signal {
  std::vector<TerminalValue> terminals;  // pulses: one; encoder: track A, track B
  bool encoder = false;
  bool off = false;                      // the terminal is 0 from now on; the axis stands
  std::int64_t millihertz = 0;           // encoder: negative is backward
  std::int64_t high = 0, low = 0;        // ns, instead of a frequency
  std::uint32_t duty = 500, jitter = 0;  // thousandths
  std::int64_t count = 0;                // pulses, or quarters of an encoder's period; 0: endless
  std::uint64_t seed = 1;

  bool parse(const StepLine& line);
  void resolve(const StepBinding& binding);
  bool perform(StepRun& run) const;
};

struct Pulses : Signal {
  static constexpr std::string_view kWords = "pulses";
};
struct Encoder : Signal {
  static constexpr std::string_view kWords = "encoder";

  Encoder() { encoder = true; }
};

}  // namespace merker::simulator::steps
