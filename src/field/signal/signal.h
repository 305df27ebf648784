// What lies at a digital terminal, as a function of time.
#pragma once

#include <cstdint>

#include "clock/instant.h"
#include "signal/grid.h"

namespace merker::signal {

constexpr Instant kLongAgo{INT64_MIN};

// From the instant that was asked for until `until` the signal repeats itself in each period;
// `period.numerator` 0: it does not.
struct Rhythm {
  Period period;
  Instant until = Instant::never();
  explicit operator bool() const { return period.numerator > 0; }
};

class Signal {
 public:
  virtual ~Signal() = default;
  virtual bool level(Instant t) const = 0;
  virtual Instant next(Instant after) const = 0;  // first change behind it; never() if none
  virtual Instant last(Instant at) const = 0;     // last change until then; kLongAgo if none
  virtual Rhythm rhythm(Instant from) const = 0;
  // The change that is `periods` later than the one at `edge`; only within its rhythm.
  virtual Instant later(Instant edge, std::int64_t periods) const = 0;
  // Whether it is known without looking at each change that no level lasts so long in between.
  virtual bool neverLasts(Duration, Instant /*from*/, Instant /*to*/) const { return false; }
};

}  // namespace merker::signal
