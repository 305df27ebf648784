#include "softplc/alarm_input.h"

namespace merker::sinumerik {

void AlarmInput::begin(std::uint8_t value, Duration delay) {
  coming_.clear();
  last_ = value;
  delay_ = delay;
}

void AlarmInput::change(std::uint8_t value, Instant now) {
  if (!coming_.empty() && coming_.back().time == now) coming_.pop_back();
  coming_.push_back({now, value});
}

Edges AlarmInput::sample(Instant now) {
  const std::uint8_t before = last_;
  while (!coming_.empty() && coming_.front().time + delay_ <= now) {
    last_ = coming_.front().value;
    coming_.pop_front();
  }
  return {static_cast<std::uint8_t>(before & ~last_), static_cast<std::uint8_t>(last_ & ~before)};
}

}  // namespace merker::sinumerik
