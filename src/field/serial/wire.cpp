#include "serial/wire.h"

#include <algorithm>

#include "serial/frame.h"

namespace merker::serial {

Instant Burst::edge(unsigned index) const { return start + bitTime(index, baud); }

unsigned Burst::index(Instant t) const {
  auto i = static_cast<unsigned>((t - start).ns * baud / 1'000'000'000);
  while (edge(i + 1) <= t) ++i;  // edges are rounded
  while (i > 0 && edge(i) > t) --i;
  return i;
}

Instant Burst::boundaryAfter(Instant t) const {
  if (t < start) return start;
  return t < end() ? edge(index(t) + 1) : Instant::never();
}

bool Wire::level(Instant t, bool undriven) const {
  bool driven = holders_ > 0, low = false;
  for (const Burst& burst : bursts_) {
    if (!burst.covers(t)) continue;
    if (burst.noise) return burst.level(t);
    driven = true;
    low = low || !burst.level(t);
  }
  return driven ? !low : undriven;
}

std::optional<std::uint16_t> Wire::alone(Instant start, std::uint32_t baud, unsigned count) const {
  const Burst* found = nullptr;
  for (const Burst& burst : bursts_) {
    if (burst.start == start && burst.baud == baud && burst.count == count && !burst.noise &&
        !found)
      found = &burst;
    else if (burst.overlaps(start, start + bitTime(count, baud)))
      return std::nullopt;
  }
  return found ? std::optional(found->bits) : std::nullopt;
}

Instant Wire::boundaryAfter(Instant t) const {
  Instant next = Instant::never();
  for (const Burst& burst : bursts_) next = std::min(next, burst.boundaryAfter(t));
  return next;
}

// Ends and beginnings of neighbours are rounded: they do not overlap.
bool Burst::overlaps(Instant from, Instant to) const {
  constexpr Duration kRounding{2};
  return start + kRounding < to && end() > from + kRounding;
}

// Overlapping telegrams are corrupt (PTP-PHY-06).
bool Wire::collided(Instant from, Instant to) const {
  const auto within = [&](const Burst& b) { return !b.noise && b.overlaps(from, to); };
  const auto first = std::find_if(bursts_.begin(), bursts_.end(), within);
  return first != bursts_.end() && std::any_of(first, bursts_.end(), [&](const Burst& b) {
           return within(b) && b.sender != first->sender;
         });
}

bool Wire::overrun(Instant from, Instant to) const {
  return std::any_of(bursts_.begin(), bursts_.end(),
                     [&](const Burst& b) { return b.overrun && b.overlaps(from, to); });
}

void Wire::forget(Instant before) {
  while (!bursts_.empty() && bursts_.front().end() < before) bursts_.pop_front();
}

}  // namespace merker::serial
