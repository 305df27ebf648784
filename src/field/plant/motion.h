// The way of an axis between two commands, in closed form: pieces of constant acceleration.
// Lengths in any unit, times in seconds.
#pragma once

#include <vector>

#include "clock/instant.h"

namespace merker::plant {

struct MotionLimits {
  double speed = 0, acceleration = 1, deceleration = 1;  // all above 0
  bool operator==(const MotionLimits&) const = default;
};

class Motion {
 public:
  explicit Motion(double place) { pieces_.push_back({0, place, 0, 0}); }

  // From `now` on to this speed, and on with it.
  void toSpeed(Instant now, double speed, double acceleration);
  // To this place, where it stands: as fast as the limits allow; who cannot stop before it goes
  // past it and comes back.
  void toPlace(Instant now, double place, const MotionLimits& limits);
  // It stands at once, where it is.
  void hold(Instant now);

  double place(Instant at) const;
  double speed(Instant at) const;
  double acceleration(Instant at) const { return pieceAt(at).acceleration; }

 private:
  struct Piece {
    double start = 0;  // s from `from_`
    double place = 0, speed = 0, acceleration = 0;
  };
  struct Planner;
  const Piece& pieceAt(Instant at) const;

  Instant from_;
  std::vector<Piece> pieces_;  // in the order of time; the last one has no end
};

}  // namespace merker::plant
