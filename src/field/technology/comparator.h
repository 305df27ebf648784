// Comparison value, hysteresis, pulse duration and the digital output of a counting channel
// (technology manual 5.5.10, 5.5.11; CNT-CMP, CNT-HYST).
#pragma once

#include <cstdint>

#include "clock/instant.h"
#include "io/count_channel.h"

namespace merker::technology {

class Comparator {
 public:
  Comparator() = default;
  Comparator(io::CountOutput output, io::CountDirection main) : output_(output), main_(main) {}

  std::int32_t value = 0, hysteresis = 0, duration = 0;  // duration in ms

  // After each pulse; true if the comparator responds.
  bool step(std::int32_t count, int direction, Instant at);
  // The count was loaded or written, not counted.
  bool look(std::int32_t count);
  void write(std::int32_t comparison, std::int32_t count);

  void control(bool enable, bool set, std::int32_t count, Instant now);  // CTRL_DO, SET_DO
  Instant pulseEnd() const { return pulseEnd_; }
  void endPulse();
  void stop();

  bool output() const { return enabled_ && on_; }
  bool reached() const { return reached_; }  // STS_CMP
  void reset() { reached_ = on_; }
  // Whether the next pulse may change more than the count: by its distance to the next place where
  // it would.
  std::uint64_t absorbs(std::int32_t count, int direction) const;

 private:
  enum class Source : std::uint8_t { None, Comparison, Set };
  bool condition(std::int32_t count, int direction) const;
  bool filtered(std::int32_t count, bool condition, bool reaches);
  bool trigger(std::int32_t count, int direction);
  bool follow(bool result);
  bool meets(std::int32_t count);
  void turn(bool on, Source source);
  bool left(std::int32_t count) const;
  bool isMain(int direction) const;

  io::CountOutput output_ = io::CountOutput::None;
  io::CountDirection main_ = io::CountDirection::None;
  bool enabled_ = false, set_ = false;
  bool on_ = false;
  Source source_ = Source::None;
  bool reached_ = false;
  bool fresh_ = false;  // something changed since the last pulse: the next one counts alone
  bool active_ = false, result_ = false, before_ = false;
  std::int32_t range_ = 0;  // hysteresis in force while active
  int storedDirection_ = 0;
  Instant pulseEnd_ = Instant::never();
};

}  // namespace merker::technology
