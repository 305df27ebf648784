#include "softplc/timer.h"

#include "base/bcd.h"

namespace merker::sinumerik {

std::uint16_t Timer::coded() const {
  return static_cast<std::uint16_t>(base() << 12 | toBcd(value(), 3));
}

// Digits above 9 count with their value (S5-TIMER-11); 999 is the most.
void Timer::begin(std::uint16_t akku, Instant now, const TimeBases& bases, std::uint16_t kept) {
  const unsigned digits = (akku >> 8 & 0xF) * 100u + (akku >> 4 & 0xF) * 10u + (akku & 0xF);
  const unsigned value = digits > 999 ? 999 : digits;
  word_ = static_cast<std::uint16_t>((word_ & (kStartEdge | kEnableEdge | kept)) | (akku & 0x3000) |
                                     value);
  set(kRunning, value > 0);
  next_ = now + bases[base()];
  if (value == 0) expire();
}

void Timer::clear() {
  word_ &= kStartEdge | kEnableEdge;
  next_ = Instant::never();
}

// The end of the time: SI and SV fall, SE and SS rise, SA falls (S5-TIMER-T1).
void Timer::expire() {
  set(kRunning, false);
  set(kOutput, kind_ == TimerKind::SE || kind_ == TimerKind::SS);
  next_ = Instant::never();
}

bool Timer::start(TimerKind kind, bool vke, std::uint16_t akku, Instant now,
                  const TimeBases& bases) {
  const bool before = (word_ & kStartEdge) != 0;
  set(kStartEdge, vke);
  if (kind == TimerKind::SA) {  // begins when VKE falls; VKE = 1 stops it
    kind_ = kind;
    if (vke) {
      clear();
      set(kOutput, true);
      return true;
    }
    if (!before) return false;
    begin(akku, now, bases);
    set(kOutput, (word_ & kRunning) != 0);
    return true;
  }
  if (vke && !before) {
    const bool again = kind == TimerKind::SS && kind_ == kind;  // 1 until R (S5-TIMER-07)
    kind_ = kind;
    begin(akku, now, bases, again ? kOutput : std::uint16_t{0});
    const bool running = (word_ & kRunning) != 0;
    if (kind == TimerKind::SI || kind == TimerKind::SV) set(kOutput, running);
    return true;
  }
  const bool stops = kind == TimerKind::SI || kind == TimerKind::SE;
  if (vke || !stops) return false;
  clear();
  return true;
}

bool Timer::reset(bool vke) {
  if (vke) clear();
  return vke;
}

bool Timer::enable(bool vke) {
  const bool rises = vke && (word_ & kEnableEdge) == 0;
  set(kEnableEdge, vke);
  if (rises) set(kStartEdge, false);  // the next start instruction sees an edge again
  return rises;
}

void Timer::count(Instant now, const TimeBases& bases) {
  while ((word_ & kRunning) != 0 && next_ <= now) {
    if (value() > 0) --word_;
    next_ = next_ + bases[base()];
    if (value() == 0) expire();
  }
}

}  // namespace merker::sinumerik
