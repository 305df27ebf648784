#include "plant/motion.h"

#include <algorithm>
#include <cmath>

#include "plant/delay.h"

namespace merker::plant {

// Puts one piece behind the other.
struct Motion::Planner {
  Planner(Motion& motion, Instant now) : pieces(motion.pieces_) {
    place = motion.place(now);
    speed = motion.speed(now);
    pieces.clear();
    motion.from_ = now;
  }

  // `rate` above 0.
  void ramp(double to, double rate) {
    const double length = std::abs(to - speed) / rate;
    if (length == 0) return;
    pieces.push_back({time, place, speed, to < speed ? -rate : rate});
    place += (speed + to) / 2 * length;
    time += length;
    speed = to;
  }
  void cruise(double way) {
    if (speed == 0 || way / speed <= 0) return;
    pieces.push_back({time, place, speed, 0});
    time += way / speed;
    place += way;
  }
  void end() { pieces.push_back({time, place, speed, 0}); }

  std::vector<Piece>& pieces;
  double time = 0, place = 0, speed = 0;
};

void Motion::toSpeed(Instant now, double speed, double acceleration) {
  Planner plan(*this, now);
  plan.ramp(speed, acceleration);
  plan.end();
}

void Motion::hold(Instant now) {
  Planner plan(*this, now);
  plan.speed = 0;
  plan.end();
}

void Motion::toPlace(Instant now, double target, const MotionLimits& limits) {
  const double up = limits.acceleration, down = limits.deceleration;
  Planner plan(*this, now);
  const auto way = [&] { return target - plan.place; };
  const auto toStop = [&] { return plan.speed * std::abs(plan.speed) / (2 * down); };
  const bool away = plan.speed * way() < 0;
  if (away || std::abs(toStop()) > std::abs(way())) plan.ramp(0, down);
  const double sign = way() < 0 ? -1 : 1, distance = std::abs(way());
  const double first = std::abs(plan.speed);
  // Where the ramp up meets the ramp down.
  const double top = std::sqrt((2 * up * down * distance + down * first * first) / (up + down));
  const double peak = sign * std::min(limits.speed, std::max(top, first));
  plan.ramp(peak, std::abs(peak) < first ? down : up);
  plan.cruise(way() - toStop());
  plan.ramp(0, down);
  plan.place = target;  // sums of floating point end near it
  plan.end();
}

const Motion::Piece& Motion::pieceAt(Instant at) const {
  const double time = seconds(from_, at);
  const auto behind = std::ranges::upper_bound(pieces_, time, {}, &Piece::start);
  return behind == pieces_.begin() ? pieces_.front() : *(behind - 1);
}

double Motion::place(Instant at) const {
  const Piece& piece = pieceAt(at);
  const double t = seconds(from_, at) - piece.start;
  return piece.place + piece.speed * t + piece.acceleration * t * t / 2;
}

double Motion::speed(Instant at) const {
  const Piece& piece = pieceAt(at);
  return piece.speed + piece.acceleration * (seconds(from_, at) - piece.start);
}

}  // namespace merker::plant
