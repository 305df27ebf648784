// Endless, single and periodic counting (technology manual 5.5; CNT-END, -ONCE, -PERI, -GATE,
// -LATCH, -PERIOD).
#pragma once

#include "technology/comparator.h"
#include "technology/function.h"
#include "technology/job.h"

namespace merker::technology {

class Counter : public Function {
 public:
  explicit Counter(const io::CountChannel& parameters) : p_(parameters) {}

  void start(bool gateLevel, Instant now) override;
  void stop() override;
  void gateEdge(bool level, Instant at) override;
  void latchEdge() override { latched_ = count_; }
  void pulse(int direction, Instant at) override;
  std::uint64_t absorbs(int direction) const override;
  void absorb(int direction, std::uint64_t pulses, Instant last, Instant before) override;
  Instant due() const override { return comparator_.pulseEnd(); }
  void expire(Instant) override { comparator_.endPulse(); }
  bool watched() const override;
  bool ownsOutput() const override { return p_.output != io::CountOutput::None; }
  bool output() const override { return comparator_.output(); }
  std::uint32_t inputData() const override;

  // What SFB 47 passes on and gets (CNT-IF47).
  void control(bool softwareGate, bool enableOutput, bool setOutput, Instant now);
  JobResult job(std::uint32_t id, std::int32_t value);
  void resetStatus();
  bool gateOpen() const { return gate_.open(); }
  std::int32_t count() const { return count_; }
  std::int32_t latched() const { return latched_; }
  bool down() const { return direction_ < 0; }
  bool overflow() const { return overflow_.happened; }
  bool underflow() const { return underflow_.happened; }
  bool zero() const { return zero_.happened; }
  const Comparator& comparator() const { return comparator_; }
  std::uint32_t period() const { return period_; }  // in the time base

 private:
  // An event at a place of the count: it is told again only when the hysteresis has been left
  // (CNT-HYST-07).
  struct Place {
    bool happened = false, active = false;
    std::int32_t where = 0, range = 0;
    void moved(std::int32_t count);
    bool reach(std::int32_t place, std::int32_t hysteresis);
    std::uint64_t absorbs(std::int32_t count, int direction) const;
  };
  bool main(io::CountDirection direction) const { return p_.direction == direction; }
  bool once() const { return p_.mode == io::CountMode::Once; }
  void count(int direction, Instant at);
  void limit(int direction, std::int32_t next, bool closes, std::int32_t boundary);
  void load();
  void opened(bool byHardware);
  void measure(Instant at);
  void zeroReached();
  std::int32_t farthest(int direction) const;

  io::CountChannel p_;
  Gate gate_;
  Comparator comparator_;
  EdgeMemory softwareEdge_;
  bool firstOpening_ = true;
  std::int32_t count_ = 0, loadValue_ = 0, latched_ = 0;
  int direction_ = 1;
  Place zero_, overflow_, underflow_;
  Instant lastPulse_ = Instant::never();
  std::uint32_t period_ = 0;
};

}  // namespace merker::technology
