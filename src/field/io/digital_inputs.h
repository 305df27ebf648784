// Digital inputs of a module: levels at the terminals, and what the input delay has let through. A
// level that lasts for the delay passes; one that returns before is not seen (S7-HWCFG-09).
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>

#include "clock/instant.h"
#include "io/configuration.h"
#include "signal/signal.h"

namespace merker::io {

class DigitalInputs {
 public:
  DigitalInputs() { due_.fill(Instant::never()); }

  bool level(std::uint32_t channel) const { return (levels_ >> channel & 1) != 0; }
  std::uint32_t delivered() const { return delivered_; }
  // What is delivered when these channels pass without delay.
  std::uint32_t passing(std::uint32_t channels) const {
    return (delivered_ & ~channels) | (levels_ & channels);
  }
  // False if the level is there already.
  bool change(std::uint32_t channel, bool level, Instant now, Duration delay);
  void skipDelay(std::uint32_t channel) { setDue(channel, Instant::never()); }
  // The module delivers this from now on. The channels whose edges interrupt.
  std::uint32_t deliver(std::uint32_t levels, const Parameters& parameters);

  // Signals that are known in advance, in place of the level.
  // `held`: since when its level has been there.
  void attach(std::uint32_t channel, std::shared_ptr<const signal::Signal> signal, Instant now,
              Instant held);
  bool attached(std::uint32_t channel) const { return signals_.contains(channel); }
  void detach(std::uint32_t channel) { signals_.erase(channel); }
  // Since when the level of a signal has been there, at `now`; `now` without a signal.
  Instant heldSince(std::uint32_t channel, Instant now) const;

  // Time: what is delivered from then on, if anything passes. `next` names the instants for
  // `advance`: an input delay ends, or a signal changes whose edges interrupt. `settle` works out
  // the other signals.
  Instant next(const Parameters& parameters) const;
  std::optional<std::uint32_t> advance(Instant at, const Parameters& parameters);
  std::optional<std::uint32_t> settle(Instant now, const Parameters& parameters);
  std::optional<std::uint32_t> settle(std::uint32_t channel, Instant now,
                                      const Parameters& parameters);

 private:
  struct Attached {
    std::shared_ptr<const signal::Signal> signal;
    Instant since, seen;  // `seen`: until when it has been looked at
    Instant held;         // since when the level of its beginning has been there
  };
  std::uint32_t settled(std::uint32_t channel, Attached& attached, Instant now,
                        const Parameters& parameters);
  static bool settled(const Attached& attached, Duration delay, Instant now, bool otherwise);

  void setDue(std::uint32_t channel, Instant due);

  std::uint32_t levels_ = 0, delivered_ = 0;
  std::array<Instant, 32> due_;                // when the delay lets the level through
  Instant soonest_ = Instant::never();         // of them
  std::map<std::uint32_t, Attached> signals_;  // by channel
};

}  // namespace merker::io
