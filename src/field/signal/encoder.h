// An incremental encoder: two tracks shifted by 90 degrees on an axis that stands or moves evenly.
// Positions count quarters of the signal period, so four of them are one increment (CNT-ENC-01).
#pragma once

#include "signal/signal.h"

namespace merker::signal {

// A movement of the axis: from a position in one direction, endless or so many quarters.
struct Motion {
  Instant start;
  std::int64_t position = 0;   // quarters, at the start
  std::int64_t frequency = 0;  // signal periods, mHz; negative: backward; 0: it stands
  std::int64_t quarters = 0;   // how far, 0: endless

  std::int64_t positionAt(Instant t) const;
};

// At position 0 both are 0; forward, A comes first.
enum class Track : std::uint8_t { A, B };

class EncoderTrack : public Signal {
 public:
  EncoderTrack(Motion motion, Track track) : motion_(motion), track_(track) {}
  bool level(Instant t) const override { return levelAt(steps(t)); }
  Instant next(Instant after) const override;
  Instant last(Instant at) const override;
  Rhythm rhythm(Instant from) const override;
  Instant later(Instant edge, std::int64_t periods) const override;

 private:
  bool stands() const { return motion_.frequency == 0; }
  std::int64_t steps(Instant t) const;
  std::int64_t mostSteps() const { return motion_.quarters == 0 ? INT64_MAX : motion_.quarters; }
  Instant stepAt(std::int64_t number) const;
  bool levelAt(std::int64_t steps) const;

  Motion motion_;
  Track track_;
};

}  // namespace merker::signal
