// What the blocks SFB 60 to 65 have in common: start-up coordination, edges, the order and the
// earliest call of what they report (technology manual 6.5, 6.10.5; PTP-SFBG-13 to -18).
#pragma once

#include <deque>
#include <map>
#include <optional>

#include "serial/events.h"

namespace merker::serial {

// One call: DONE or NDR, ERROR and STATUS.
struct Answer {
  bool done = false, error = false;
  Event status = Event::None;
  bool operator==(const Answer&) const = default;
};
constexpr Answer kDone{true, false, Event::None};
constexpr Answer answerOf(Event event) {
  return event == Event::None ? kDone : Answer{false, !isWarning(event), event};
}

class CallState {
 public:
  // Calls from the cause to the report; the call behind a start that works again (PTP-SFBG-17).
  static constexpr unsigned kNext = 1, kReset = 2, kStartCalls = 3;

  void start();  // STOP to RUN: the next calls coordinate the start-up
  // At the beginning of each call.
  void call(std::uint32_t instance, bool request, bool reset);
  bool starting() const { return starting_ > 0; }
  // A rising edge, once; an edge while the block starts up is kept.
  bool takeRequest();
  bool takeReset();

  void report(const Answer& answer, unsigned calls = kNext);
  bool reporting() const { return !reports_.empty(); }
  std::optional<Answer> take();  // what this call shows: one report, the others wait

 private:
  struct Edges {
    bool request = false, reset = false;
  };
  struct Report {
    Answer answer;
    unsigned calls = 0;
  };
  std::map<std::uint32_t, Edges> edges_;  // by instance data block
  bool request_ = false, reset_ = false;
  unsigned starting_ = kStartCalls;
  std::deque<Report> reports_;
};

}  // namespace merker::serial
