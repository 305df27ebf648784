#include "technology/counter.h"

#include <algorithm>
#include <cstdlib>
#include <limits>

namespace merker::technology {
namespace {

using io::CountDirection;

constexpr std::int32_t kHighest = std::numeric_limits<std::int32_t>::max();
constexpr std::int32_t kLowest = std::numeric_limits<std::int32_t>::min();
constexpr std::uint32_t kMeasuringFrequency = 1;  // kHz (CNT-PERIOD-01)

// Modulo 2^32: across the limits as well.
std::int64_t wrapped(std::int32_t a, std::int32_t b) {
  return static_cast<std::int32_t>(static_cast<std::uint32_t>(a) - static_cast<std::uint32_t>(b));
}

}  // namespace

void Counter::Place::moved(std::int32_t count) {
  if (active && std::abs(wrapped(count, where)) >= range) active = false;
}

bool Counter::Place::reach(std::int32_t place, std::int32_t hysteresis) {
  if (active) return false;
  active = hysteresis > 1;
  where = place;
  range = hysteresis;
  happened = true;
  return true;
}

// The pulse that leaves the range counts alone.
std::uint64_t Counter::Place::absorbs(std::int32_t count, int direction) const {
  if (!active) return kUnlimited;
  const std::int64_t ahead = range - wrapped(count, where) * direction;
  return ahead > 0 ? static_cast<std::uint64_t>(ahead - 1) : 0;
}

// CNT-GATE-10, CNT-LATCH-03. A gate input that is 1 already is open (CNT-OP-06).
void Counter::start(bool gateLevel, Instant) {
  const io::CountChannel parameters = p_;
  *this = Counter(parameters);
  gate_.used = p_.hardwareGate;
  gate_.hardware = gateLevel;
  count_ = loadValue_ = latched_ = main(CountDirection::Backward) ? p_.endValue : 0;
  comparator_ = Comparator(p_.output, p_.direction);
  comparator_.value = p_.comparison;
  comparator_.hysteresis = p_.hysteresis;
  comparator_.duration = p_.pulseDuration;
  comparator_.look(count_);
}

void Counter::stop() {
  gate_.software = false;
  softwareEdge_.last = false;
  comparator_.stop();
}

bool Counter::watched() const {
  return ownsOutput() || p_.onGateOpened || p_.onGateClosed || p_.onComparator || p_.onOverflow ||
         p_.onUnderflow || p_.onCountEdge;
}

std::uint32_t Counter::inputData() const {
  return p_.showPeriod ? period_ : static_cast<std::uint32_t>(count_);
}

void Counter::zeroReached() {
  if (main(CountDirection::None) && count_ == 0) zero_.reach(0, comparator_.hysteresis);
}

// Count := load value; no pulse came.
void Counter::load() {
  count_ = loadValue_;
  for (Place* place : {&zero_, &overflow_, &underflow_}) place->moved(count_);
  zeroReached();
  raise(comparator_.look(count_) && p_.onComparator, io::kComparator);
}

// The table of CNT-GATE-04 to -07, and the restart of single counting (CNT-ONCE-03, -04).
void Counter::opened(bool byHardware) {
  const bool restart = once() && !main(CountDirection::None) && gate_.closed;
  if (byHardware || !gate_.used) gate_.closed = false;
  const bool begins = byHardware || !gate_.used;
  if (firstOpening_ ? gate_.open() : begins && gate_.software && (!p_.interruptGate || restart))
    load();
  if (gate_.open()) firstOpening_ = false;
}

void Counter::gateEdge(bool level, Instant) {
  gate_.hardware = level;
  if (!gate_.used) return;
  if (level) opened(true);
  raise(gate_.software && (level ? p_.onGateOpened : p_.onGateClosed),
        level ? io::kGateOpened : io::kGateClosed);
}

void Counter::control(bool softwareGate, bool enableOutput, bool setOutput, Instant now) {
  const bool rises = softwareEdge_.rises(softwareGate);
  if (!softwareGate) gate_.software = false;
  if (rises) {
    gate_.software = true;
    opened(false);
  }
  comparator_.control(enableOutput, setOutput, count_, now);
}

// Always measured at 1 kHz, the gate does not matter (CNT-PERIOD-01, -07); modulo 2^32.
void Counter::measure(Instant at) {
  if (p_.maxFrequency != kMeasuringFrequency) return;
  const std::int64_t tick = p_.microseconds ? 1000 : 125;  // ns
  if (lastPulse_ != Instant::never())
    period_ = static_cast<std::uint32_t>((at - lastPulse_).ns / tick);
  lastPulse_ = at;
}

void Counter::pulse(int direction, Instant at) {
  direction_ = direction;  // also with the gate closed (CNT-OP-09)
  measure(at);
  if (!gate_.open()) return;
  count(direction, at);
  raise(comparator_.step(count_, direction, at) && p_.onComparator, io::kComparator);
  raise(p_.onCountEdge, io::kCountEdge);
}

// The reference algorithm of CNT-PERI.
void Counter::count(int direction, Instant) {
  const bool none = main(CountDirection::None);
  const std::int32_t end = direction > 0 ? kHighest : kLowest;
  if (main(CountDirection::Forward) && direction > 0 && count_ == p_.endValue - 1)
    return limit(direction, loadValue_, once(), p_.endValue);
  if (main(CountDirection::Backward) && direction < 0 && count_ == 1)
    return limit(direction, loadValue_, once(), 0);
  if (count_ == end) {
    const bool loads = none && p_.mode == io::CountMode::Periodic;
    const std::int32_t other = direction > 0 ? kLowest : kHighest;
    return limit(direction, loads ? loadValue_ : other, none && once(), kLowest);
  }
  count_ += direction;
  for (Place* place : {&zero_, &overflow_, &underflow_}) place->moved(count_);
  zeroReached();
}

void Counter::limit(int direction, std::int32_t next, bool closes, std::int32_t boundary) {
  Place& event = direction > 0 ? overflow_ : underflow_;
  const bool told = event.reach(boundary, comparator_.hysteresis);
  count_ = next;
  for (Place* place : {&zero_, &overflow_, &underflow_}) place->moved(count_);
  if (closes) gate_.closed = true;
  raise(told && (direction > 0 ? p_.onOverflow : p_.onUnderflow), io::kCountLimit);
  zeroReached();
}

// The last count before something else happens on the way.
std::int32_t Counter::farthest(int direction) const {
  if (direction > 0)
    return main(CountDirection::Forward) && count_ < p_.endValue ? p_.endValue - 1 : kHighest;
  return main(CountDirection::Backward) && count_ > 0 ? 1 : kLowest;
}

std::uint64_t Counter::absorbs(int direction) const {
  if (!gate_.open()) return kUnlimited;
  if (p_.onCountEdge) return 0;
  const std::int64_t room = (std::int64_t{farthest(direction)} - count_) * direction;
  std::uint64_t least = static_cast<std::uint64_t>(std::max<std::int64_t>(room, 0));
  if (count_ != 0 && (count_ < 0) == (direction > 0))
    least = std::min(least, static_cast<std::uint64_t>(std::abs(std::int64_t{count_}) - 1));
  for (const Place* place : {&zero_, &overflow_, &underflow_})
    least = std::min(least, place->absorbs(count_, direction));
  if (p_.output == io::CountOutput::None && !p_.onComparator) return least;
  return std::min(least, comparator_.absorbs(count_, direction));
}

void Counter::absorb(int direction, std::uint64_t pulses, Instant last, Instant before) {
  direction_ = direction;
  if (p_.maxFrequency == kMeasuringFrequency) {
    lastPulse_ = before;
    measure(last);
  }
  if (gate_.open())
    count_ = static_cast<std::int32_t>(count_ + direction * static_cast<std::int64_t>(pulses));
}

// What still holds is there again at once (CNT-CMP-04).
void Counter::resetStatus() {
  comparator_.reset();
  zero_.happened = overflow_.happened = underflow_.happened = false;
}

}  // namespace merker::technology
