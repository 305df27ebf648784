// A counter and its pulses, for tests.
#pragma once

#include <string_view>
#include <vector>

#include "technology/counter.h"

namespace merker::technology {

constexpr std::int32_t kHighest = 2'147'483'647, kLowest = -kHighest - 1;

class Machine {
 public:
  explicit Machine(io::CountChannel parameters) : counter(parameters) { counter.start(false, {}); }
  void gate(bool open) { counter.control(open, false, false, now); }
  // The count after each pulse: "UUD".
  std::vector<std::int32_t> pulses(std::string_view text) {
    std::vector<std::int32_t> counts;
    for (const char c : text) {
      now = now + Duration::milliseconds(1);
      counter.pulse(c == 'U' ? 1 : -1, now);
      counts.push_back(counter.count());
    }
    return counts;
  }
  Counter counter;
  Instant now;
};

inline io::CountChannel mode(io::CountMode which,
                             io::CountDirection direction = io::CountDirection::None,
                             std::int32_t end = kHighest) {
  io::CountChannel parameters;
  parameters.mode = which;
  parameters.direction = direction;
  parameters.endValue = end;
  parameters.maxFrequency = 60;
  return parameters;
}

}  // namespace merker::technology
