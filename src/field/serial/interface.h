// The sub-module PtP of a CPU: the driver of its protocol, the receive buffer, and what it tells
// the CPU. It is the driver that a line sees.
#pragma once

#include <memory>

#include "serial/parameters.h"
#include "serial/rk512.h"

namespace merker::serial {

class Interface : public Driver {
 public:
  explicit Interface(const Parameters& parameters);

  const Parameters& parameters() const { return parameters_; }
  bool linked() const { return parameters_.protocol == Protocol::ComputerLink; }

  // ASCII and 3964(R): a job, and what was received. RK 512 has its own (link()).
  void send(const Bytes& data, Instant now);
  void abort(Event why);
  Outbox& outbox();
  std::optional<Mailbox::Entry> take();
  void clear();  // the receive buffer
  Rk512* link() { return link_.get(); }

  void cpuStopped();  // running jobs end with 0501H (PTP-SFBG-19)
  void cpuStarted();
  // True, false: a BREAK has begun or ended, if that causes an interrupt (PTP-DIAG-01).
  std::optional<bool> takeWireBreak();
  bool wireBreakPending() const { return parameters_.diagnosticInterrupt && broken_ != shown_; }

  void start(Instant now) override { driver().start(now); }
  void received(const Character& character) override { driver().received(character); }
  void interrupted(Instant at) override;
  void restored(Instant at) override;
  std::optional<std::uint8_t> next(Instant now) override { return driver().next(now); }
  void sent(Instant at) override { driver().sent(at); }
  Instant due() const override { return driver().due(); }
  void expire(Instant now) override { driver().expire(now); }

 private:
  Driver& driver() const;

  Parameters parameters_;
  Mailbox mailbox_;
  std::unique_ptr<Ascii> ascii_;
  std::unique_ptr<Procedure> procedure_;
  std::unique_ptr<Rk512> link_;
  bool broken_ = false, shown_ = false;
};

}  // namespace merker::serial
