#include "technology/input.h"

#include <algorithm>

namespace merker::technology {

void Input::set(bool level, std::shared_ptr<const signal::Signal> signal, Instant now) {
  signal_ = std::move(signal);
  change_ = signal_ ? signal_->next(now) : Instant::never();
  if (level == raw_) return;
  raw_ = level;
  since_ = now;
}

Instant Input::next() const { return std::min(change_, due()); }

void Input::takeChange() {
  since_ = change_;
  raw_ = !raw_;
  change_ = signal_->next(change_);
}

void Input::skip(std::int64_t periods) {
  if (signal_ == nullptr) return;
  since_ = signal_->later(since_, periods);
  change_ = signal_->next(since_);
}

}  // namespace merker::technology
