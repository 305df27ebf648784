// Frequency measurement by the time stamps of the pulses (technology manual 5.6; CNT-FREQ).
#pragma once

#include "technology/function.h"
#include "technology/job.h"

namespace merker::technology {

class Frequency : public Function {
 public:
  // `highest`: mHz that the CPU can measure.
  Frequency(const io::CountChannel& parameters, std::int32_t highest)
      : p_(parameters), highest_(highest) {}

  void start(bool gateLevel, Instant now) override;
  void stop() override;
  void gateEdge(bool level, Instant at) override;
  void pulse(int direction, Instant at) override;
  std::uint64_t absorbs(int direction) const override;
  void absorb(int direction, std::uint64_t pulses, Instant last, Instant before) override;
  Instant due() const override { return windowEnd_; }
  void expire(Instant at) override;
  bool watched() const override;
  bool ownsOutput() const override { return p_.limitOutput != io::LimitOutput::None; }
  bool output() const override { return ownsOutput() && (manual_ ? set_ : compared()); }
  std::uint32_t inputData() const override { return static_cast<std::uint32_t>(value_); }

  // What SFB 48 passes on and gets (CNT-IF48).
  void control(bool softwareGate, bool manual, bool set, Instant now);
  JobResult job(std::uint32_t id, std::int32_t value);
  void resetStatus();
  bool gateOpen() const { return gate_.open(); }
  std::int32_t value() const { return value_; }  // mHz; -1 before the first end of measurement
  std::int32_t count() const { return count_; }
  bool down() const { return direction_ < 0; }
  bool measured() const { return measured_; }
  bool overflow() const { return overflow_; }
  bool underflow() const { return underflow_; }

 private:
  void opened(Instant at);
  void gateChanged(bool before, Instant at);
  std::int32_t evaluate();
  void checkLimits();
  bool compared() const;

  io::CountChannel p_;
  std::int32_t highest_;
  Gate gate_;
  EdgeMemory softwareEdge_;
  bool manual_ = false, set_ = false;
  int direction_ = 1;
  std::int32_t value_ = -1, count_ = 0;
  bool measured_ = false, overflow_ = false, underflow_ = false;  // status bits
  bool above_ = false, below_ = false;                            // by the last measurement
  // the window
  Instant windowEnd_ = Instant::never();
  Duration window_;
  Instant reference_ = Instant::never(), last_ = Instant::never();  // pulses
  std::int64_t pulses_ = 0;                                         // after the reference
  std::int32_t lastMeasured_ = 0, emptyWindows_ = 0;
};

}  // namespace merker::technology
