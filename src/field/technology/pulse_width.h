// Pulse width modulation: an output value becomes a train of pulses at the digital output
// (technology manual 5.7; CNT-PWM).
#pragma once

#include <utility>

#include "technology/function.h"
#include "technology/job.h"

namespace merker::technology {

class PulseWidth : public Function {
 public:
  explicit PulseWidth(const io::CountChannel& parameters) : p_(parameters) { calculate(); }

  void start(bool gateLevel, Instant now) override;
  void stop() override;
  void gateEdge(bool level, Instant at) override;
  void pulse(int, Instant) override {}
  std::uint64_t absorbs(int) const override { return kUnlimited; }
  void absorb(int, std::uint64_t, Instant, Instant) override {}
  Instant due() const override;
  void expire(Instant at) override { tick(at); }
  bool steady() const override { return true; }
  bool watched() const override { return true; }
  bool ownsOutput() const override { return true; }
  bool output() const override;
  std::uint32_t inputData() const override { return 0; }

  // What SFB 49 passes on and gets (CNT-IF49).
  void control(bool enable, bool manual, bool set, std::int32_t output, Instant now);
  JobResult job(std::uint32_t id, std::int32_t value, Instant now);
  // Whether a call has changed anything since the last question.
  bool takeChanged() { return std::exchange(changed_, false); }
  bool running() const { return phase_ != Phase::Stopped; }

 private:
  enum class Phase : std::uint8_t { Stopped, Delay, Pulse, Pause };
  void calculate();
  void begin(Instant at);
  void tick(Instant at);
  Duration length() const;
  Duration unit() const { return Duration::microseconds(p_.milliseconds ? 1000 : 100); }

  io::CountChannel p_;
  EdgeMemory softwareEdge_;
  bool software_ = false, manual_ = false, set_ = false, changed_ = false;
  std::int32_t value_ = 0;
  Duration high_, low_;
  Phase phase_ = Phase::Stopped;
  Instant since_;  // the phase began
};

}  // namespace merker::technology
