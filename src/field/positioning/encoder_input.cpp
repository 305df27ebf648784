#include "positioning/encoder_input.h"

#include <algorithm>
#include <cstdlib>

#include "positioning/switch_input.h"

namespace merker::positioning {
namespace {

constexpr auto A = signal::RampTrackKind::A, B = signal::RampTrackKind::B,
               N = signal::RampTrackKind::N;

}  // namespace

// 1: both tracks are of one ramp; -1: they are swapped.
int EncoderInput::commonRamp() const {
  const signal::RampTrack *a = at(A).ramp, *b = at(B).ramp;
  if (a == nullptr || b == nullptr || a->ramp() != b->ramp()) return 0;
  if (a->kind() == A && b->kind() == B) return 1;
  return a->kind() == B && b->kind() == A ? -1 : 0;
}

void EncoderInput::set(Name input, bool level, std::shared_ptr<const signal::Signal> signal,
                       Instant now, Channel& channel) {
  advance(now, channel);
  Track& track = at(input);
  track.signal = std::move(signal);
  track.ramp = dynamic_cast<const signal::RampTrack*>(track.signal.get());
  direction_ = commonRamp();
  std::array<bool, 3> levels{at(A).level, at(B).level, at(N).level};
  levels[static_cast<std::size_t>(input)] = level;
  take(levels, channel);
}

void EncoderInput::advance(Instant to, Channel& channel) {
  if (to <= now_) return;
  if (direction_ != 0)
    follow(to, channel);
  else
    takeEdges(to, channel);
  now_ = to;
}

// Faster than the inputs can follow nothing counts, as on the whole ramp so at its ends.
bool EncoderInput::tooFast(const signal::Ramp& ramp) const {
  const std::int64_t most = std::int64_t{kilohertz_} * 1000 * 4 * kThousandths;
  return std::min(std::abs(ramp.speed), std::abs(ramp.last)) > most;
}

void EncoderInput::follow(Instant to, Channel& channel) {
  const signal::Ramp& ramp = *at(A).ramp->ramp();
  if (!tooFast(ramp)) {
    std::int64_t from = ramp.pulseAt(now_);
    if (ramp.turns() && ramp.turningTime() >= now_ && ramp.turningTime() < to) {
      const std::int64_t turning = signal::pulseOf(ramp.turningPoint());
      walk(from, turning, channel);
      from = turning;
    }
    walk(from, ramp.pulseAt(to), channel);
  }
  for (Track& track : tracks_)
    if (track.signal != nullptr) track.level = track.signal->level(to);
}

// The zero mark counts where A, B and N are 1: the same pulse from both sides (POS-ENC-06).
void EncoderInput::walk(std::int64_t from, std::int64_t to, Channel& channel) const {
  const signal::ZeroMarks& marks = at(A).ramp->marks();
  const signal::RampTrack* n = at(N).ramp;
  const bool marked = n != nullptr && n->kind() == N && n->ramp() == at(A).ramp->ramp();
  const std::int64_t direction = to > from ? 1 : -1;
  while (from != to) {
    const std::int64_t rest = (direction * (marks.first - from)) % marks.distance;
    const std::int64_t mark = rest > 0 ? rest : rest + marks.distance;  // pulses to the next one
    const std::int64_t pulses = std::min(mark, direction * (to - from));
    channel.move(direction_ * direction * pulses);
    from += direction * pulses;
    if (marked && pulses == mark) channel.zeroMark();
  }
}

void EncoderInput::takeEdges(Instant to, Channel& channel) {
  for (;;) {
    Instant first = Instant::never();
    for (const Track& track : tracks_)
      if (track.signal) first = std::min(first, track.signal->next(now_));
    if (first > to) return;
    now_ = first;
    std::array<bool, 3> levels{};
    for (std::size_t i = 0; i < levels.size(); ++i) levels[i] = passed(tracks_[i]);
    take(levels, channel);
  }
}

// A level that does not last for the filter time is not seen.
bool EncoderInput::passed(const Track& track) const {
  if (track.signal == nullptr) return track.level;
  const bool level = track.signal->level(now_);
  const bool lasts = track.signal->next(now_) - filterTime(kilohertz_) >= now_;
  return lasts ? level : track.level;
}

// By the track that changes; if both do, it is not known which way (POS-ENC-07).
void EncoderInput::take(const std::array<bool, 3>& levels, Channel& channel) {
  const auto all = [this] { return at(A).level && at(B).level && at(N).level; };
  const bool before = all(), a = levels[0], b = levels[1];
  const bool ofA = a != at(A).level, ofB = b != at(B).level;
  for (std::size_t i = 0; i < levels.size(); ++i) tracks_[i].level = levels[i];
  if (ofA && !ofB) channel.move(a != b ? 1 : -1);
  if (ofB && !ofA) channel.move(b == a ? 1 : -1);
  if (!before && all()) channel.zeroMark();
}

}  // namespace merker::positioning
