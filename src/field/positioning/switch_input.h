// The input of a switch beside the axis, reference switch or length measurement: a level counts if
// it lasts for the filter time (technology manual 3.2.4; POS-PARAM-09, POS-ENC-08).
#pragma once

#include <algorithm>
#include <memory>
#include <optional>

#include "clock/instant.h"
#include "signal/signal.h"

namespace merker::positioning {

// The shortest level that an input of a maximum frequency passes: 8 us at 60 kHz.
constexpr Duration filterTime(std::uint32_t kilohertz) {
  return Duration::microseconds(480 / kilohertz);
}

class SwitchInput {
 public:
  explicit SwitchInput(Duration filter) : filter_(filter) {}

  // From now on this lies at the input; `signal` null: the level stays.
  void set(bool level, std::shared_ptr<const signal::Signal> signal, Instant now);
  // When something happens next, and what: the level that counts from then on.
  Instant next() const { return std::min(change_, due()); }
  std::optional<bool> take();
  // Of a level that was set and has not lasted for the filter time yet: since when.
  std::optional<Instant> waiting() const;

 private:
  Instant due() const { return raw_ == passed_ ? Instant::never() : since_ + filter_; }

  Duration filter_;
  std::shared_ptr<const signal::Signal> signal_;
  bool raw_ = false, passed_ = false;
  Instant since_{}, change_ = Instant::never();
};

}  // namespace merker::positioning
