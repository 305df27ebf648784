// What OB 1 learns of the cycles before (S7-OBI-02).
#pragma once

#include <cstdint>

#include "clock/instant.h"

namespace merker::cpu {

struct CycleTimes {  // ms
  std::int32_t previous = 0, shortest = 0, longest = 0;
  bool any = false;
  bool operator==(const CycleTimes&) const = default;
  void add(Duration cycle) {
    previous = static_cast<std::int32_t>(cycle.ns / 1'000'000);
    shortest = any && shortest < previous ? shortest : previous;
    longest = any && longest > previous ? longest : previous;
    any = true;
  }
};

}  // namespace merker::cpu
