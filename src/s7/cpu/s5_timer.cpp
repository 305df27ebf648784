#include "cpu/s5_timer.h"

#include "base/bcd.h"

namespace merker::cpu {
namespace {

constexpr Duration unit(unsigned base) {
  constexpr std::int64_t kMilliseconds[] = {10, 100, 1'000, 10'000};
  return Duration::milliseconds(kMilliseconds[base & 3]);
}

}  // namespace

bool S5Timer::run(std::uint16_t s5, Instant now) {
  const auto count = fromBcd(s5 & 0xFFFu, 3);
  if (!count) return false;
  base = static_cast<std::uint8_t>(s5 >> 12 & 3);
  end = now + unit(base) * *count;
  started = true;
  frozen = 0;
  return true;
}

// Stopping is not resetting: the rest stays readable until the next start or R.
void S5Timer::stop(Instant now) {
  frozen = units(now);
  started = false;
}

bool S5Timer::modify(std::uint16_t s5, Instant now) {
  if ((s5 & 0xFFFu) != 0) return run(s5, now);
  started = held = false;
  frozen = 0;
  return true;
}

void S5Timer::hold(Instant now) {
  if (started && !expired(now)) end = now + unit(base) * units(now);
}

bool S5Timer::start(Kind how, bool rlo, std::uint16_t s5, Instant now) {
  const bool rising = rlo && !startEdge;
  startEdge = rlo;
  const bool stays = how == Kind::StoredOnDelay && kind == how && status(now);  // S7-TMR-17
  switch (how) {
    case Kind::Pulse:    // S7-TMR-10, -11: 0 ends the pulse
    case Kind::OnDelay:  // S7-TMR-14, -15: 0 stops and takes the status back
      if (!rlo && started) stop(now);
      break;
    case Kind::ExtendedPulse:  // S7-TMR-12, -13
    case Kind::StoredOnDelay:  // S7-TMR-16, -17
      break;
    case Kind::OffDelay:  // S7-TMR-18, -19: 1 holds the status, the step to 0 starts the time
      if (rising) {
        held = true;
        started = false;
        frozen = 0;
      } else if (!rlo && held && kind == how) {
        held = false;
        return run(s5, now);
      }
      if (rlo) kind = how;
      return true;
  }
  if (!rising) return true;
  if (!run(s5, now)) return false;
  kind = how;
  held = stays;
  return true;
}

// S7-TMR-21: the next start instruction with RLO 1 counts as an edge again.
void S5Timer::enable(bool rlo) {
  if (rlo && !enableEdge) startEdge = false;
  enableEdge = rlo;
}

// S7-TMR-06: value, base and status 0. The edge memory stays, so a constant start does not run
// again.
void S5Timer::reset(bool rlo) {
  if (!rlo) return;
  started = held = false;
  frozen = 0;
  base = 0;
}

bool S5Timer::status(Instant now) const {
  switch (kind) {
    case Kind::Pulse:
    case Kind::ExtendedPulse:
      return started && !expired(now);
    case Kind::OnDelay:
      return started && expired(now);
    case Kind::StoredOnDelay:
      return held || (started && expired(now));
    case Kind::OffDelay:
      return held || (started && !expired(now));
  }
  return false;
}

std::uint16_t S5Timer::units(Instant now) const {
  if (!started) return frozen;
  if (expired(now)) return 0;
  const std::int64_t length = unit(base).ns;
  return static_cast<std::uint16_t>(((end - now).ns + length - 1) / length);
}

Instant S5Timer::nextUnit(Instant from) const {
  if (expired(from)) return end;
  return end - unit(base) * (units(from) - 1);
}

std::uint16_t S5Timer::s5time(Instant now) const {
  return static_cast<std::uint16_t>(base << 12 | toBcd(std::uint32_t{units(now)}, 3));
}

}  // namespace merker::cpu
