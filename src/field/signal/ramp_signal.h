// A signal that depends on the pulse in which an axis stands while it moves by a ramp.
#pragma once

#include <memory>

#include "signal/ramp.h"
#include "signal/signal.h"

namespace merker::signal {

class RampSignal : public Signal {
 public:
  explicit RampSignal(std::shared_ptr<const Ramp> ramp) : ramp_(std::move(ramp)) {}

  bool level(Instant t) const override { return levelIn(ramp_->pulseAt(t)); }
  Instant next(Instant after) const override;
  Instant last(Instant at) const override;
  Rhythm rhythm(Instant) const override { return {}; }
  Instant later(Instant edge, std::int64_t) const override { return edge; }

  const std::shared_ptr<const Ramp>& ramp() const { return ramp_; }

 protected:
  virtual bool levelIn(std::int64_t pulse) const = 0;
  // The first pulse on the way to `to` with another level; `pulse` if there is none.
  virtual std::int64_t change(std::int64_t pulse, std::int64_t to) const = 0;

 private:
  Instant changeWithin(Instant from, Instant to, std::int64_t lastPulse) const;
  Instant lastWithin(Instant from, Instant to) const;

  std::shared_ptr<const Ramp> ramp_;
};

}  // namespace merker::signal
