// Steps that put a signal on terminals: `pulses`, a pulse generator, and `encoder`, an incremental
// encoder on a moving axis (docs/formats/scenario.md).
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "io/rack.h"
#include "signal/encoder.h"
#include "signal/pulse_train.h"
#include "simulator/terminal_steps.h"

namespace merker::simulator {

struct SignalStep {
  std::vector<TerminalValue> terminals;  // pulses: one; encoder: track A, track B
  bool encoder = false;
  bool off = false;                      // the terminal is 0 from now on; the axis stands
  std::int64_t millihertz = 0;           // encoder: negative is backward
  std::int64_t high = 0, low = 0;        // ns, instead of a frequency
  std::uint32_t duty = 500, jitter = 0;  // thousandths
  std::int64_t count = 0;                // pulses, or quarters of an encoder's period; 0: endless
  std::uint64_t seed = 1;
};

// Texts are views into the file. False, and a problem, if they are wrong.
bool parseSignal(std::string_view text, bool encoder, SignalStep& step, const PositionOf& at,
                 Problems& problems);
void resolve(SignalStep& step, const io::Configuration* hardware, Problems& problems);

// The axes of encoders, by the terminal of track A: an axis stays where it was left.
using Axes = std::map<std::string, signal::Motion>;
void apply(const SignalStep& step, Axes& axes, io::Rack& rack, Instant now);

}  // namespace merker::simulator
