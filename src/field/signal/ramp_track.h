// The tracks A, B and N of an incremental encoder on an axis that moves by a ramp. Four pulses are
// a period of A and B; N is 1 at the zero mark, once in a revolution of the encoder (POS-PLANT-10).
#pragma once

#include <memory>

#include "signal/ramp.h"
#include "signal/signal.h"

namespace merker::signal {

struct ZeroMarks {
  std::int64_t distance = 2000;  // pulses between two of them
  std::int64_t first = 0;        // a pulse in which A, B and N are 1
  bool narrow = false;           // N is 1 only there, not in the pulses beside it
};

enum class RampTrackKind : std::uint8_t { A, B, N };

class RampTrack : public Signal {
 public:
  using Kind = RampTrackKind;
  RampTrack(std::shared_ptr<const Ramp> ramp, const ZeroMarks& marks, Kind kind)
      : ramp_(std::move(ramp)), marks_(marks), kind_(kind) {}

  bool level(Instant t) const override { return levelIn(ramp_->pulseAt(t)); }
  Instant next(Instant after) const override;
  Instant last(Instant at) const override;
  Rhythm rhythm(Instant) const override { return {}; }
  Instant later(Instant edge, std::int64_t) const override { return edge; }

  const std::shared_ptr<const Ramp>& ramp() const { return ramp_; }
  const ZeroMarks& marks() const { return marks_; }
  Kind kind() const { return kind_; }

 private:
  bool levelIn(std::int64_t pulse) const;
  std::int64_t change(std::int64_t pulse, std::int64_t to) const;
  Instant changeWithin(Instant from, Instant to, std::int64_t lastPulse) const;

  std::shared_ptr<const Ramp> ramp_;
  ZeroMarks marks_;
  Kind kind_;
};

}  // namespace merker::signal
