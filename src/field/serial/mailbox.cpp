#include "serial/mailbox.h"

#include <algorithm>
#include <utility>

namespace merker::serial {

bool Mailbox::fits(std::size_t bytes) const { return bytes_ + bytes <= kSize && !countReached(); }

bool Mailbox::free() const { return !refusing_ && (!parameters_.preventOverwriting || fits(1)); }

void Mailbox::dropOldest() {
  const auto oldest = std::find_if(entries_.begin(), entries_.end(),
                                   [](const Entry& e) { return e.event == Event::None; });
  bytes_ -= oldest->telegram.size();
  --telegrams_;
  entries_.erase(oldest);
}

// A buffer that is full discards the new telegram, or the oldest ones without a word
// (PTP-ASCII-24, -25).
Event Mailbox::put(Bytes telegram) {
  if (refusing_) return Event::Lost;
  if (parameters_.preventOverwriting && countReached()) return Event::Lost;
  if (parameters_.preventOverwriting && !fits(telegram.size())) return Event::Overflow;
  while (!fits(telegram.size())) dropOldest();
  bytes_ += telegram.size();
  ++telegrams_;
  entries_.push_back({Event::None, std::move(telegram)});
  if (bytes_ >= kTwoThirds && !std::exchange(warned_, true)) report(Event::NearlyFull);
  return Event::None;
}

// Errors wait in the order of the telegrams, those of the buffer itself are shown at the next call;
// of each at most 16, the oldest (PTP-SFB61-10).
void Mailbox::report(Event event) {
  const bool ofBuffer = event == Event::NearlyFull || event == Event::Overflow ||
                        event == Event::Lost || event == Event::AfterXoff;
  if (!ofBuffer) {
    if (events_ == kEvents) return;
    ++events_;
    entries_.push_back({event, {}});
  } else if (std::find(urgent_.begin(), urgent_.end(), event) == urgent_.end()) {
    urgent_.push_back(event);
  }
}

std::optional<Mailbox::Entry> Mailbox::take() {
  if (!urgent_.empty()) {
    const Event event = urgent_.front();
    urgent_.pop_front();
    return Entry{event, {}};
  }
  if (entries_.empty()) return std::nullopt;
  Entry entry = std::move(entries_.front());
  entries_.pop_front();
  if (entry.event != Event::None) {
    --events_;
    return entry;
  }
  bytes_ -= entry.telegram.size();
  --telegrams_;
  warned_ = warned_ && bytes_ >= kTwoThirds;
  return entry;
}

void Mailbox::clear() {
  std::erase_if(entries_, [](const Entry& e) { return e.event == Event::None; });
  bytes_ = telegrams_ = 0;
  warned_ = false;
}

void Mailbox::start() {
  refusing_ = false;
  if (parameters_.clearAtStart) clear();
}

}  // namespace merker::serial
