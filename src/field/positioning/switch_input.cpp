#include "positioning/switch_input.h"

#include <utility>

namespace merker::positioning {

void SwitchInput::set(bool level, std::shared_ptr<const signal::Signal> signal, Instant now) {
  signal_ = std::move(signal);
  change_ = signal_ ? signal_->next(now) : Instant::never();
  if (level == raw_) return;
  raw_ = level;
  since_ = now;
}

std::optional<Instant> SwitchInput::waiting() const {
  return raw_ == passed_ ? std::nullopt : std::optional(since_);
}

// A signal is known in advance, so its edge counts at once; a level that was set has to wait.
std::optional<bool> SwitchInput::take() {
  if (due() <= change_) {
    passed_ = raw_;
    return passed_;
  }
  const Instant at = std::exchange(change_, signal_->next(change_));
  const bool lasts = change_ - filter_ >= at;
  if (!lasts) return std::nullopt;
  const bool before = passed_;
  raw_ = passed_ = signal_->level(at);
  return passed_ != before ? std::optional(passed_) : std::nullopt;
}

}  // namespace merker::positioning
