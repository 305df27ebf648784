#include "cpu/scan_cycle.h"

#include <algorithm>

#include "cpu/snapshot.h"

namespace merker::cpu {

void ScanCycle::monitor(Instant from) {
  monitoring_.begin(from, Duration::milliseconds(parameters_.cycleMonitoring));
}

// A hot restart goes on with its cycle.
void ScanCycle::prepare(Restart how) {
  scan_ = isHot(how) ? 2 : isCold(how) ? 4 : 1;
  if (!isHot(how)) times_ = {};
  monitoring_.off();  // S7-STATE-11: not in STARTUP
}

void ScanCycle::enterRun(Instant now, bool resumed) {
  ++checkpoints_;
  next_ = began_ = now;
  if (resumed) monitor(now);
}

void ScanCycle::begin(Instant now) {
  if (scan_ == 3) times_.add(now - began_);
  began_ = now;
  monitor(now);
}

void ScanCycle::end(Instant now) {
  ++count_;
  ++checkpoints_;
  next_ = afterThis(now);
}

// The operating system's share, communication, and not before the minimum cycle is over
// (S7-HWCFG-08). With a communication load of p % the rest of the time has to do for the program:
// t * 100 / (100 - p), see docs/compatibility.md, "communication load".
Instant ScanCycle::afterThis(Instant now) const {
  Instant next = now + share_;
  if (communicating_) {
    const std::int64_t load = std::min(parameters_.communicationLoad, 50u);
    next = next + Duration{(next - began_).ns * load / (100 - load)};
  }
  return std::max(next, began_ + Duration::milliseconds(parameters_.minimumCycle));
}

StartInformation ScanCycle::startOfOb1(const DateAndTime& time) {
  StartInformation start = startInformation(0x11, scan_, priorityOf(1), 1, time);
  setWord(start, 6, static_cast<std::uint32_t>(times_.previous));
  setWord(start, 8, static_cast<std::uint32_t>(times_.shortest));
  setWord(start, 10, static_cast<std::uint32_t>(times_.longest));
  scan_ = 3;
  return start;
}

void ScanCycle::pass(std::uint64_t cycles, Duration by) {
  count_ += cycles;
  checkpoints_ += cycles;
  delay(by);
}

void ScanCycle::delay(Duration by) {
  monitoring_.delay(by);
  began_ = began_ + by;
  next_ = next_ + by;
}

void ScanCycle::save(Snapshot& to) const {
  to.scan = scan_;
  to.cycleTimes = times_;
  to.cycleBegan = began_.ns;
  to.nextCycle = next_.ns;
}

void ScanCycle::take(const Snapshot& from, Duration shift, Instant now) {
  constexpr Duration kLongest = Duration::seconds(60);
  scan_ = from.scan;
  times_ = from.cycleTimes;
  began_ = std::clamp(Instant{from.cycleBegan} + shift, now - kLongest, now);
  next_ = std::clamp(Instant{from.nextCycle} + shift, now, now + kLongest);
}

}  // namespace merker::cpu
