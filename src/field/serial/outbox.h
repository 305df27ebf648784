// The job that a driver sends: given to it once, ended once.
#pragma once

#include <optional>
#include <utility>

#include "clock/instant.h"
#include "serial/events.h"

namespace merker::serial {

// How long a CPU works on a job of n bytes before its first character: what the times measured in
// technology manual 6.10.6 have beyond their characters (PTP-TIME-26).
struct Preparation {
  Duration fixed, perByte;
  Duration of(std::size_t bytes) const {
    return fixed + perByte * static_cast<std::int64_t>(bytes);
  }
};
constexpr Preparation kAsciiPreparation{Duration::milliseconds(5), Duration::microseconds(18)};
constexpr Preparation kProcedurePreparation{Duration::milliseconds(6), Duration::microseconds(15)};
constexpr Preparation kRk512Preparation{Duration::milliseconds(14), Duration::microseconds(195)};

class Outbox {
 public:
  bool busy() const { return busy_; }
  bool free() const { return !busy_ && !ended_; }  // nobody waits for an end either
  void begin() {
    busy_ = true;
    warning_ = Event::None;
  }
  void end(Event event) {
    busy_ = false;
    ended_ = event;
  }
  void warn(Event event) { warning_ = event; }
  // None: without error. Nothing until the job has ended, and only once.
  std::optional<Event> takeEnd() { return std::exchange(ended_, std::nullopt); }
  Event takeWarning() { return std::exchange(warning_, Event::None); }

 private:
  bool busy_ = false;
  std::optional<Event> ended_;
  Event warning_ = Event::None;
};

}  // namespace merker::serial
