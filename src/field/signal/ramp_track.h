// The tracks A, B and N of an incremental encoder on an axis that moves by a ramp. Four pulses are
// a period of A and B; N is 1 at the zero mark, once in a revolution of the encoder (POS-PLANT-10).
#pragma once

#include "signal/ramp_signal.h"

namespace merker::signal {

struct ZeroMarks {
  std::int64_t distance = 2000;  // pulses between two of them
  std::int64_t first = 0;        // a pulse in which A, B and N are 1
  bool narrow = false;           // N is 1 only there, not in the pulses beside it
};

enum class RampTrackKind : std::uint8_t { A, B, N };

class RampTrack : public RampSignal {
 public:
  using Kind = RampTrackKind;
  RampTrack(std::shared_ptr<const Ramp> ramp, const ZeroMarks& marks, Kind kind)
      : RampSignal(std::move(ramp)), marks_(marks), kind_(kind) {}

  bool neverLasts(Duration length, Instant from, Instant to) const override;

  const ZeroMarks& marks() const { return marks_; }
  Kind kind() const { return kind_; }

 protected:
  bool levelIn(std::int64_t pulse) const override;
  std::int64_t change(std::int64_t pulse, std::int64_t to) const override;

 private:
  ZeroMarks marks_;
  Kind kind_;
};

// Track A or B of an encoder that loses pulses: from one pulse on, in its direction, so many of
// them change nothing. They are whole periods, so that the track is the usual one behind them.
class LosingTrack : public RampSignal {
 public:
  struct Gap {
    std::int64_t from = 0;
    std::int64_t pulses = 0;  // negative: in direction minus
    bool holds(std::int64_t pulse) const {
      return pulses > 0 ? pulse > from && pulse <= from + pulses
                        : pulse < from && pulse >= from + pulses;
    }
  };
  LosingTrack(std::shared_ptr<const Ramp> ramp, const ZeroMarks& marks, RampTrackKind kind, Gap gap)
      : RampSignal(std::move(ramp)), marks_(marks), kind_(kind), gap_(gap) {}

 protected:
  bool levelIn(std::int64_t pulse) const override;
  std::int64_t change(std::int64_t pulse, std::int64_t to) const override;

 private:
  ZeroMarks marks_;
  RampTrackKind kind_;
  Gap gap_;
};

// A switch beside the axis: 1 from one pulse up to before another one. On a rotary axis it is there
// once in each revolution.
class RampZone : public RampSignal {
 public:
  RampZone(std::shared_ptr<const Ramp> ramp, std::int64_t from, std::int64_t to,
           std::int64_t revolution)
      : RampSignal(std::move(ramp)), from_(from), to_(to), revolution_(revolution) {}

 protected:
  bool levelIn(std::int64_t pulse) const override;
  std::int64_t change(std::int64_t pulse, std::int64_t to) const override;

 private:
  std::int64_t from_, to_, revolution_;
};

}  // namespace merker::signal
