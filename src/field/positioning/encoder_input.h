// The encoder at the terminals: its tracks A, B and N, evaluated four times (technology
// manual 3.8.1; POS-ENC). Tracks of one ramp are counted in closed form, others edge by edge.
#pragma once

#include <array>
#include <memory>

#include "positioning/channel.h"
#include "signal/ramp_track.h"

namespace merker::positioning {

class EncoderInput {
 public:
  using Name = signal::RampTrackKind;
  explicit EncoderInput(std::uint32_t kilohertz) : kilohertz_(kilohertz) {}

  // From now on this lies at an input; `signal` null: the level stays.
  void set(Name input, bool level, std::shared_ptr<const signal::Signal> signal, Instant now,
           Channel& channel);
  // Tells the channel what has passed until then, in its order.
  void advance(Instant to, Channel& channel);

 private:
  struct Track {
    bool level = false;
    std::shared_ptr<const signal::Signal> signal;
    const signal::RampTrack* ramp = nullptr;  // if `signal` is one
  };
  Track& at(Name name) { return tracks_[static_cast<std::size_t>(name)]; }
  const Track& at(Name name) const { return tracks_[static_cast<std::size_t>(name)]; }
  int commonRamp() const;
  bool tooFast(const signal::Ramp& ramp) const;
  void follow(Instant to, Channel& channel);
  void walk(std::int64_t from, std::int64_t to, Channel& channel) const;
  void takeEdges(Instant to, Channel& channel);
  bool passed(const Track& track) const;
  void take(const std::array<bool, 3>& levels, Channel& channel);

  std::uint32_t kilohertz_;
  std::array<Track, 3> tracks_;
  Instant now_{};
  int direction_ = 0;  // of counts for pulses of a common ramp; 0: there is none
};

}  // namespace merker::positioning
